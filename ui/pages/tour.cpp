#include "engine/base/translation.hpp"
#include "ui/actions/actions.hpp"
#include "ui/pages/pages_drawn.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/keys.hpp"
#include "ui/style/screen_areas.hpp"
#include "ui/style/theme.hpp"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdint>
#include <string>

namespace zeroset::ui {
namespace {

enum class WindowPart : std::uint8_t { Statements, Picture, Header };

/// A part of the window, and what the user can do there.
struct Step {
    WindowPart part;
    const char* title;
    std::string (*text)(const UiState&);
};

/// The shown keys of an action.
std::string keys_of(const char* name) { return shown_keys(action_named(name)); }

const std::array<Step, tour_steps> steps{{
    {.part = WindowPart::Statements,
     .title = "Type an equation",
     .text =
         [](const UiState&) {
             return std::string(
                 tr("Any equation in x, y and z, such as x^2 + y^2 + z^2 = 4. The surface follows "
                    "every key. Enter begins another row, for another surface or a definition."));
         }},
    {.part = WindowPart::Picture,
     .title = "Look around",
     .text =
         [](const UiState&) {
             return filled(tr("Drag to turn, with the right button to move; the wheel zooms to the "
                              "pointer. A click keeps a marker with its coordinates. {0} brings "
                              "all of the surface into view."),
                           {keys_of("Frame the surface")});
         }},
    {.part = WindowPart::Statements,
     .title = "Move what varies",
     .text =
         [](const UiState&) {
             return std::string(
                 tr("Every other letter is a number that you choose: x^2 + y^2 = a z brings a "
                    "slider for a. The triangle beside it lets it run by itself."));
         }},
    {.part = WindowPart::Header,
     .title = "Begin with a surface",
     .text =
         [](const UiState& state) {
             const std::size_t count = state.shown.gallery.size();
             return filled(tr("The gallery ({0}) has {1} surfaces, from quadrics to records of "
                              "singular points, each with its equation to change."),
                           {keys_of("Gallery"), std::to_string(count)});
         }},
    {.part = WindowPart::Header,
     .title = "Take it away",
     .text =
         [](const UiState&) {
             return filled(
                 tr("{0} saves pictures, films, meshes for printing and drawings for "
                    "papers. {1} finds everything by a part of its name; {2} explains "
                    "formulas and keys."),
                 {keys_of("Save the picture..."), keys_of("Find a command..."), keys_of("Help")});
         }},
}};

/// Returns the part of the window in window coordinates.
ImRect area_of(WindowPart part, const Layout& layout) {
    const float width = side_panel_width(layout);
    const PictureArea picture = viewport_area(layout);
    const float header = em(3.0F);
    switch (part) {
        case WindowPart::Statements:
            return {0.0F, header, width, std::min(em(12.0F), picture.hi.y)};
        case WindowPart::Picture: return {picture.lo, picture.hi};
        case WindowPart::Header: return {0.0F, 0.0F, width, header};
    }
    return {};
}

/// Returns where the card of a size stands: to the right of its part, in the picture's middle, or
/// wherever there is room.
ImVec2 place_of(const ImVec2& size, const ImRect& area, WindowPart part) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float margin = em(0.8F);
    ImVec2 at(area.Max.x + margin, area.Min.y + margin);
    if (part == WindowPart::Picture)
        at = ImVec2(area.GetCenter().x - 0.5F * size.x, area.Min.y + margin);
    if (at.x + size.x > window.x) at.y = std::max(at.y, area.Max.y + margin);
    return {std::clamp(at.x, 0.0F, std::max(window.x - size.x, 0.0F)),
            std::clamp(at.y, 0.0F, std::max(window.y - size.y, 0.0F))};
}

/// Whether something is open that the user has to do with first.
bool is_covered(const Pages& pages) {
    return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup) || pages.help.open ||
           pages.exports.open;
}

void draw_dots(std::size_t step, const Palette& colors) {
    const float radius = em(0.22F);
    const float gap = em(0.8F);
    const ImVec2 lo = ImGui::GetCursorScreenPos();
    ImDrawList& canvas = *ImGui::GetWindowDrawList();
    const float row = lo.y + 0.5F * ImGui::GetFrameHeight();
    for (std::size_t i = 0; i < tour_steps; ++i) {
        const ImVec2 at(lo.x + radius + gap * static_cast<float>(i), row);
        canvas.AddCircleFilled(at, radius, i == step ? colors.accent : colors.border);
    }
    ImGui::Dummy(ImVec2(gap * tour_steps, ImGui::GetFrameHeight()));
}

void end_tour(UiState& state) {
    state.pages.tour.step.reset();
    state.edited.tour_seen = true;
}

/// Shows the next step; after the last one the tour ends.
void go_on(UiState& state, std::size_t step) {
    if (step + 1 == tour_steps) {
        end_tour(state);
    } else {
        state.pages.tour.step = step + 1;
    }
}

/// Draws the buttons that go through the tour, right-aligned.
void draw_buttons(UiState& state, std::size_t step) {
    const bool last = step + 1 == tour_steps;
    const char* const next = last ? tr("Done") : tr("Next");
    const ImGuiStyle& style = ImGui::GetStyle();
    const auto width = [&](const char* name) {
        return ImGui::CalcTextSize(name).x + 2.0F * style.FramePadding.x;
    };
    float needed = width(next) + (step > 0 ? width(tr("Back")) + style.ItemSpacing.x : 0.0F);
    if (!last) needed += width(tr("Skip")) + style.ItemSpacing.x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - needed);
    if (!last) {
        if (ImGui::Button(tr("Skip"))) end_tour(state);
        ImGui::SameLine();
    }
    if (step > 0) {
        if (ImGui::Button(tr("Back"))) state.pages.tour.step = step - 1;
        ImGui::SameLine();
    }
    const Palette& colors = palette(state.edited.theme);
    ImGui::PushStyleColor(ImGuiCol_Button, colors.selection);
    if (ImGui::Button(next)) go_on(state, step);
    ImGui::PopStyleColor();
}

void draw_frame_around(const ImRect& area, const Palette& colors) {
    const float inset = em(0.15F);
    ImDrawList& canvas = *ImGui::GetForegroundDrawList();
    canvas.AddRect(ImVec2(area.Min.x + inset, area.Min.y + inset),
                   ImVec2(area.Max.x - inset, area.Max.y - inset), colors.accent, em(0.3F), 0,
                   em(0.12F));
}

void draw_card(UiState& state, std::size_t step, const ImVec2& at, float width) {
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoFocusOnAppearing |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
    const Palette& colors = palette(state.edited.theme);
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0F), ImVec2(width, FLT_MAX));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colors.popup);
    ImGui::PushStyleColor(ImGuiCol_Border, colors.accent);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(em(1.0F), em(0.8F)));
    if (ImGui::Begin("##tour", nullptr, flags)) {
        ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
        ImGui::PushStyleColor(ImGuiCol_Text, colors.accent);
        ImGui::TextUnformatted(tr(steps[step].title));
        ImGui::PopStyleColor();
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(steps[step].text(state).c_str());
        ImGui::PopTextWrapPos();
        ImGui::Dummy(ImVec2(0.0F, em(0.2F)));
        draw_dots(step, colors);
        draw_buttons(state, step);
    }
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
}

}  // namespace

void follow_tour_keys(UiState& state) {
    const bool is_for_others = is_covered(state.pages) || state.input.handle_drag.has_value();
    if (!state.pages.tour.step || is_for_others) return;
    const bool enter = is_pressed_once(ImGuiKey_Enter) || is_pressed_once(ImGuiKey_KeyPadEnter);
    if (enter && !ImGui::GetIO().WantTextInput) return go_on(state, *state.pages.tour.step);
    const int escape = ImGui::GetKeyIndex(ImGuiKey_Escape);
    if (escape < 0 || !ImGui::IsKeyPressed(escape, false)) return;
    end_tour(state);
    // Mark Escape as no longer just pressed: otherwise the text field would discard what was typed.
    ImGui::GetIO().KeysDownDuration[escape] = FLT_MIN;
}

void draw_tour(UiState& state) {
    if (!state.pages.tour.step || is_covered(state.pages)) return;
    const std::size_t step = *state.pages.tour.step;
    const ImRect area = area_of(steps[step].part, state.edited.layout);
    const float width = std::min(em(24.0F), ImGui::GetIO().DisplaySize.x);
    const ImGuiWindow* const drawn = ImGui::FindWindowByName("##tour");
    const float height = drawn != nullptr ? drawn->Size.y : em(9.0F);
    draw_frame_around(area, palette(state.edited.theme));
    draw_card(state, step, place_of(ImVec2(width, height), area, steps[step].part), width);
}

}  // namespace zeroset::ui
