// Tests of what a click on a row's dot opens: colours, look and sides of its surface.

#include "document/colors.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/scene/lighting.hpp"
#include "tests/ui/panels.hpp"
#include "ui/model/ui_state.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace zeroset::ui::surface_popup_test {
namespace {

class SurfacePopup : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.edited.layout.view_open = false;
    }
    /// Opens the popup of the first row by a click on its color; nullptr if there is none then.
    const ImGuiWindow* row_popup() {
        state_.edited.document.statements[0].color = 0x30C0E0;
        const Framebuffer frame = draw();
        const ImRect list = child("##side/##list_")->Rect();
        const Rectangle area{static_cast<int>(list.Min.x), static_cast<int>(list.Min.y),
                             static_cast<int>(list.Max.x), static_cast<int>(list.Max.y)};
        const Rectangle dot = bounds(frame, 0xFFE0C030U, area, exact);
        click_at({static_cast<float>(dot.left + dot.right) / 2,
                  static_cast<float>(dot.top + dot.bottom) / 2});
        draw_frame();
        return child("##Popup_");
    }
};

TEST_P(SurfacePopup, ShowTheColorOfASurfaceAndLetItBeChosen) {
    set_rows(state_, {"a = 2", "x = a"});
    state_.edited.document.statements[1].color = 0x30C0E0;
    Framebuffer frame = draw();
    const ImRect list = child("##side/##list_")->Rect();
    const Rectangle area{static_cast<int>(list.Min.x), static_cast<int>(list.Min.y),
                         static_cast<int>(list.Max.x), static_cast<int>(list.Max.y)};
    const Rectangle dot = bounds(frame, 0xFFE0C030U, area, exact);
    const std::uint32_t back = back_color(0x30C0E0);
    const Rectangle other = bounds(
        frame, 0xFF000000U | (back & 0xFFU) << 16U | (back & 0xFF00U) | back >> 16U, area, exact);
    EXPECT_NEAR(other.right - dot.left, px(14), px(2)) << "both sides' colors";
    click_at({static_cast<float>(dot.left + dot.right) / 2,
              static_cast<float>(dot.top + dot.bottom) / 2});
    draw_frame();  // the popup shows all hues
    ASSERT_TRUE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
    const ImVec2 popup = child("##Popup_")->Pos;
    click_at({popup.x + static_cast<float>(px(24)), popup.y + static_cast<float>(px(24))});
    EXPECT_EQ(state_.edited.document.statements[1].color, palette_fronts()[0]);
}

TEST_P(SurfacePopup, LetTheSideThatIsSolidBeChosen) {
    set_rows(state_, {"x = 2"});
    const ImGuiWindow* const popup = row_popup();
    ASSERT_NE(popup, nullptr);
    const ImRect inside = popup->InnerClipRect;
    const float last_row = inside.Max.y - static_cast<float>(px(20));
    const auto solid = [&] { return state_.edited.document.statements[0].solid; };
    EXPECT_EQ(solid(), SolidSide::Automatic);
    // Buttons from right to left: f > 0, then f < 0.
    std::vector<SolidSide> chosen;
    for (float x = inside.Max.x - static_cast<float>(px(6)); x > inside.Min.x;
         x -= static_cast<float>(px(8))) {
        click_at({x, last_row});
        if (chosen.empty() || chosen.back() != solid()) chosen.push_back(solid());
    }
    EXPECT_NE(std::ranges::find(chosen, SolidSide::Above), chosen.end());
    EXPECT_NE(std::ranges::find(chosen, SolidSide::Below), chosen.end());
    EXPECT_EQ(chosen.back(), SolidSide::Automatic);
}

TEST_P(SurfacePopup, LetTheThicknessOfACurveBeChosen) {
    set_rows(state_, {"(cos t, sin t, t), 0 < t < 1"});
    state_.shown.reading.thick_rows = {1};
    const ImGuiWindow* const popup = row_popup();
    ASSERT_NE(popup, nullptr);
    const ImRect inside = popup->InnerClipRect;
    const float last_row = inside.Max.y - static_cast<float>(px(20));
    const Statement& row = state_.edited.document.statements[0];
    EXPECT_FALSE(row.thickness);
    // Buttons from right to left: pixels, then units.
    bool pixels = false;
    bool units = false;
    for (float x = inside.Max.x - static_cast<float>(px(6)); x > inside.Min.x;
         x -= static_cast<float>(px(8))) {
        click_at({x, last_row});
        pixels = pixels || (row.thickness && row.thickness->in_pixels);
        units = units || (pixels && row.thickness && !row.thickness->in_pixels);
    }
    EXPECT_TRUE(pixels);
    EXPECT_TRUE(units);
    EXPECT_EQ(row.solid, SolidSide::Automatic);
}

TEST_P(SurfacePopup, LetsALookBeChosenFromAList) {
    set_rows(state_, {"x = 2"});
    const ImGuiWindow* const popup = row_popup();
    ASSERT_NE(popup, nullptr);
    const ImRect inside = popup->InnerClipRect;
    const float middle = inside.GetCenter().x;
    const auto list = [] { return child("##Combo_"); };
    // The row of the list is the lowest but some whose click opens one.
    float row = inside.Max.y;
    while (row > inside.Min.y && list() == nullptr) {
        row -= static_cast<float>(px(8));
        click_at({middle, row});
        draw_frame();
    }
    ASSERT_NE(list(), nullptr);
    std::set<std::optional<zeroset::Look>> chosen;
    const ImRect lines = list()->Rect();
    const auto step = static_cast<float>(px(8));
    for (float y = lines.Min.y + step; y < lines.Max.y; y += step) {
        click_at({lines.Min.x + 2 * step, y});
        draw_frame();
        draw_frame();
        chosen.insert(state_.edited.document.statements[0].look);
        if (list() != nullptr) continue;
        click_at({middle, row});
        draw_frame();
        ASSERT_NE(list(), nullptr);
    }
    EXPECT_GE(chosen.size(), looks().size() - 1);
    EXPECT_TRUE(chosen.contains(zeroset::Look::Metal));
}

INSTANTIATE_TEST_SUITE_P(Looks, SurfacePopup, testing::ValuesIn(different_looks()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::surface_popup_test
