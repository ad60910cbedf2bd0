#include "engine/view/navigation.hpp"
#include "tests/ui/panels.hpp"
#include "ui/actions/actions.hpp"
#include "ui/panels/sections.hpp"

#include <GLFW/glfw3.h>
#include <glm/glm.hpp>

#include <string>

// Tests of the section with saved views and the camera's numbers.

namespace zeroset::ui::camera_section_test {
namespace {

class CameraSection : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        state_.edited.layout.view_open = false;
        state_.edited.layout.camera_open = true;
    }

    std::vector<SavedView>& views() { return state_.edited.document.views; }
    Camera& camera() { return *state_.edited.document.camera; }
    float list_height() {
        draw();
        return child_of_section().Size.y;
    }
    const ImGuiWindow& child_of_section() {
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
            if (window->WasActive && std::string(window->Name).contains("/##views_"))
                return *window;
        }
        throw std::runtime_error("the views are not shown");
    }
    /// Scrolls so that all of the section is as high up as it goes.
    void show_section(float down) {
        draw();
        ImGuiWindow* const all = section("camera")->ParentWindow;
        const float top = section("camera")->Pos.y - all->Pos.y + all->Scroll.y + down;
        ImGui::SetScrollY(all, std::min(top, all->ScrollMax.y));
        draw();
    }
    /// The place of a field of the numbers: row 0 is the eye.
    glm::vec2 field(int row, float along) {
        draw();  // only then the font is known
        const float button = ImGui::GetFrameHeightWithSpacing();
        const float down = button + list_height() + ImGui::GetStyle().ItemSpacing.y +
                           (static_cast<float>(row) + 0.4F) * button;
        show_section(down - button);
        const ImGuiWindow& place = *section("camera");
        return {place.Pos.x + along * place.WorkRect.GetWidth(), place.Pos.y + down};
    }
    void type(const glm::vec2& at, const std::string& text) {
        click_at(at);
        OffscreenWindow::type(text);
        draw_frame();
        press(GLFW_KEY_ENTER);
        draw();
    }
    /// The place in the card of a view; across: 0 left, 1 right.
    glm::vec2 in_card(std::size_t index, float across) {
        draw();  // only then the font is known
        show_section(ImGui::GetFrameHeightWithSpacing());
        const ImGuiWindow& list = child_of_section();
        const float height = std::ceil(em(3.6F));
        return {list.Pos.x + across * list.WorkRect.GetWidth(),
                list.Pos.y + (static_cast<float>(index) + 0.45F) * height};
    }
};

TEST_P(CameraSection, SavesWhereOneLooksFromByAKey) {
    state_.edited.layout.camera_open = false;
    draw();
    press(GLFW_KEY_ESCAPE);
    OffscreenWindow::type("v");
    draw();
    ASSERT_EQ(views().size(), 1U);
    EXPECT_EQ(views()[0], (SavedView{"View 1", camera()}));
    EXPECT_TRUE(state_.edited.layout.camera_open) << "it is shown";
}

TEST_P(CameraSection, GoesToAViewByItsPicture) {
    views() = {{"front", camera()}, {"side", seen_from(camera(), {1, 0, 0}, {0, 0, 1})}};
    click_at(in_card(1, 0.08F));
    ASSERT_TRUE(state_.input.move);
    EXPECT_EQ(state_.input.move->to, views()[1].camera);
}

TEST_P(CameraSection, RenamesMovesAndDeletesViews) {
    views() = {{"front", camera()}, {"side", camera()}, {"top", camera()}};
    type(in_card(0, 0.5F), "the hole");
    EXPECT_EQ(views()[0].name, "the hole");
    type(in_card(0, 0.5F), "side");
    EXPECT_NE(views()[0].name, "side") << "another view has it";
    const float button = ImGui::GetFrameHeight() / section("camera")->WorkRect.GetWidth();
    const std::string first = views()[0].name;
    click_at(in_card(1, 1.0F - 1.5F * button));
    draw();
    EXPECT_EQ(view_names(views()), "side, " + first + ", top");
    click_at(in_card(1, 1.0F - 0.5F * button));
    draw();
    EXPECT_EQ(view_names(views()), "side, top");
}

TEST_P(CameraSection, AsksForPicturesOfTheViewsInSight) {
    for (int i = 0; i < 20; ++i)
        add_view(views(), camera());
    in_card(0, 0.1F);
    ASSERT_TRUE(state_.wishes.view_pictures);
    const ViewPictureWish& wish = *state_.wishes.view_pictures;
    EXPECT_GE(wish.cameras.size(), 1U);
    EXPECT_LE(wish.cameras.size(), 5U) << "not of those out of sight";
    EXPECT_NEAR(static_cast<double>(wish.size_px.x) / wish.size_px.y, 4.0 / 3.0, 0.05);
    Texture texture;
    texture.upload(RgbaImage{1, 1, {0xFF0000FFU}});
    state_.shown.view_pictures = {{.camera = camera(), .texture = texture.name()}};
    const Framebuffer frame = draw();
    EXPECT_GT(count(frame, 0xFF0000FFU, child_of_section().Rect()),
              wish.size_px.x * wish.size_px.y / 2);
    state_.edited.layout.camera_open = false;
    state_.wishes.view_pictures.reset();
    draw();
    EXPECT_FALSE(state_.wishes.view_pictures) << "the section is closed";
}

TEST_P(CameraSection, TakesTypedNumbers) {
    camera() = {{1, -6, 2}, {0, 0, 0}, {0, 0, 1}, 0.7};
    type(field(0, 0.4F), "2.5");
    EXPECT_EQ(camera().eye, glm::dvec3(2.5, -6, 2));
    type(field(1, 0.95F), "-1");
    EXPECT_EQ(camera().look_at, glm::dvec3(0, 0, -1));
    type(field(3, 0.8F), "60");
    EXPECT_NEAR(glm::degrees(camera().fov_rad), 60.0, 1e-9);
    type(field(3, 0.8F), "190");
    EXPECT_LE(glm::degrees(camera().fov_rad), 170.0);
}

TEST_P(CameraSection, KeepsTheHeightOfParallelRaysAsTheEyeMoves) {
    camera() = {{1, -6, 2}, {0, 0, 0}, {0, 0, 1}, 0.7, Projection::Orthographic};
    type(field(3, 0.8F), "4");
    EXPECT_NEAR(shown_height(camera()), 4.0, 1e-9);
    type(field(0, 0.65F), "-12");
    EXPECT_EQ(camera().eye.y, -12.0);
    EXPECT_NEAR(shown_height(camera()), 4.0, 1e-9);
}

TEST_P(CameraSection, SaysWhyACameraWouldSeeNothing) {
    camera() = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.7};
    const Camera before = camera();
    click_at(field(0, 0.95F));
    OffscreenWindow::type("0");
    draw_frame();
    EXPECT_EQ(camera(), before);
    EXPECT_TRUE(state_.input.camera_error.starts_with("the eye is at the point looked at"));
    draw();
    press(GLFW_KEY_ESCAPE);
    draw();
    EXPECT_EQ(camera(), before);
    EXPECT_EQ(state_.input.camera_error, "");
}

TEST_P(CameraSection, HasNoNumbersBeforeThereIsACamera) {
    state_.edited.document.camera.reset();
    draw();
    EXPECT_FALSE(is_enabled(action_named("Save view"), state_));
    EXPECT_FALSE(is_enabled(action_named("Copy the camera"), state_));
}

INSTANTIATE_TEST_SUITE_P(Looks, CameraSection, testing::ValuesIn(different_looks()),
                         [](const auto& look) { return name_of(look.param); });

}  // namespace
}  // namespace zeroset::ui::camera_section_test
