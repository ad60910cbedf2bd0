// Tests of the panel of what is saved: tabs, formats, fields, keys, progress.

#include "tests/ui/panels.hpp"
#include "ui/actions/actions.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <string>

namespace zeroset::ui::export_page_test {
namespace {

constexpr const char* window_name = "Save as a file###export";

class ExportPages : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        if (window_ == nullptr) return;
        set_rows(state_, {"x^2 + y^2 + z^2 = a"});
        state_.shown.export_formats = {
            {.kind = ExportKind::Picture,
             .name = "PNG",
             .ending = ".png",
             .about = "all",
             .bits = {8, 16},
             .alpha = true,
             .density = true},
            {.kind = ExportKind::Picture,
             .name = "JPEG",
             .ending = ".jpg",
             .about = "small",
             .bits = {8, 0},
             .quality = true},
            {.kind = ExportKind::Film,
             .name = "MP4",
             .ending = ".mp4",
             .about = "plays",
             .quality = true,
             .even = true},
            {.kind = ExportKind::Film,
             .name = "PNG",
             .ending = ".png",
             .about = "frames",
             .alpha = true,
             .numbered = true},
            {.kind = ExportKind::Mesh, .name = "STL", .ending = ".stl", .about = "prints"},
            {.kind = ExportKind::Mesh, .name = "3MF", .ending = ".3mf", .about = "colours"},
            {.kind = ExportKind::Drawing, .name = "SVG", .ending = ".svg", .about = "web"},
        };
    }

    void open(const char* action) {
        std::ranges::find(actions(), std::string(action), &Action::name)->run(state_);
        draw();
        draw();
    }
    ExportPage& page() { return state_.pages.exports; }
    static bool is_shown() {
        const ImGuiWindow* const window = ImGui::FindWindowByName(window_name);
        return window != nullptr && window->WasActive;
    }
    /// The middle of a line of the chosen part, counted from below the preview.
    static glm::vec2 line(int number, float along) {
        const ImGuiWindow& part = *child(std::string(window_name) + "/##part");
        const float preview = std::min(em(15.0F), 0.5F * part.Size.y);
        const float top = part.DC.CursorStartPos.y + preview + ImGui::GetStyle().ItemSpacing.y;
        const float row = ImGui::GetFrameHeightWithSpacing();
        return {part.Pos.x + along * part.Size.x, top + (static_cast<float>(number) + 0.4F) * row};
    }
    /// A line of the part, which is scrolled there.
    glm::vec2 late_line(int number, float along) {
        for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
            if (!window->WasActive || !std::string(window->Name).contains("/##part_")) continue;
            const float down =
                line(number, along).y - window->Pos.y - 0.5F * window->Size.y + window->Scroll.y;
            ImGui::SetScrollY(window, std::clamp(down, 0.0F, window->ScrollMax.y));
        }
        draw();
        return line(number, along);
    }
};

TEST(FilmExport, TakesANumberOfFrames) {
    FilmExport film;
    film.take_frames(45);
    EXPECT_EQ(film.frames(), 45);
    EXPECT_DOUBLE_EQ(film.seconds, 1.5);
}

TEST_P(ExportPages, OpenAndCloseByTheirKeys) {
    draw();
    EXPECT_FALSE(is_shown());
    press_with_ctrl(GLFW_KEY_E);
    draw();
    EXPECT_TRUE(is_shown());
    EXPECT_EQ(page().wish.kind, ExportKind::Picture);
    state_.wishes.focus = RowFocus{.row = 1};
    draw();
    press(GLFW_KEY_ESCAPE);
    draw();
    EXPECT_TRUE(is_shown()) << "the field is left first";
    press(GLFW_KEY_ESCAPE);
    draw();
    EXPECT_FALSE(is_shown());
}

TEST_P(ExportPages, ChooseTheKindAndItsUsualFormat) {
    open("Save a film...");
    EXPECT_EQ(page().wish.kind, ExportKind::Film);
    EXPECT_EQ(page().endings[1], ".mp4");
    open("Save the mesh...");
    EXPECT_TRUE(is_shown());
    EXPECT_EQ(page().endings[2], ".stl");
    open("Save the mesh...");
    EXPECT_FALSE(page().open);
}

TEST_P(ExportPages, OfferNothingThatCannotBeWritten) {
    const std::string reason = "this Zeroset was built without FFmpeg";
    for (ExportFormat& format : state_.shown.export_formats)
        format.missing = format.ending == ".mp4" || format.ending == ".jpg" ? reason : "";
    page().endings[0] = ".jpg";
    open("Save a film...");
    EXPECT_EQ(page().endings[1], "####.png") << "numbered pictures need no FFmpeg";
    click_at(line(1, 0.6F));  // opens the list of formats
    draw();
    const ImGuiWindow* const popup = child("##Combo_");
    ASSERT_NE(popup, nullptr);
    EXPECT_LT(popup->ContentSize.y, 1.9F * ImGui::GetTextLineHeightWithSpacing()) << "one line";
    press(GLFW_KEY_ESCAPE);
    open("Save the picture...");
    EXPECT_EQ(page().endings[0], ".png") << "the choice of another program is given up";
}

TEST_P(ExportPages, ChooseTheFormatOfTheFormulaItself) {
    open("Save the mesh...");
    const MeshExport& wish = page().wish.mesh;
    EXPECT_EQ(page().endings[2], ".stl");
    click_at(line(1, 0.6F));  // opens the list of shapes
    draw();
    const ImGuiWindow* const popup = child("##Combo_");
    ASSERT_NE(popup, nullptr);
    const float last = popup->Pos.y + popup->Size.y - 0.7F * ImGui::GetTextLineHeightWithSpacing();
    click_at({popup->Pos.x + 0.5F * popup->Size.x, last});
    EXPECT_EQ(wish.shape, MeshExport::Shape::Formula);
    EXPECT_EQ(page().endings[2], ".3mf");
    draw();
    EXPECT_EQ(wish.shape, MeshExport::Shape::Formula);
    page().endings[2] = ".stl";
    draw();
    EXPECT_EQ(wish.shape, MeshExport::Shape::Solid) << "triangles alone can be STL";
}

TEST_P(ExportPages, TakeTypedSizes) {
    open("Save the picture...");
    click_at(line(1, 0.3F));
    OffscreenWindow::type("3840");
    draw_frame();
    press(GLFW_KEY_ENTER);
    EXPECT_EQ(page().wish.picture.size_px.x, 3840);
    EXPECT_EQ(page().wish.picture.size_px.y, 1080);
    EXPECT_FALSE(state_.wishes.command) << "Enter in a field is not Save";
}

TEST_P(ExportPages, KeepTheSidesEvenWhereFilmsWantThat) {
    open("Save a film...");
    page().wish.film.size_px = {641, 360};
    draw();
    EXPECT_EQ(page().wish.film.size_px, glm::ivec2(642, 360));
    page().endings[1] = "####.png";
    page().wish.film.size_px = {641, 360};
    draw();
    EXPECT_EQ(page().wish.film.size_px, glm::ivec2(641, 360));
}

TEST_P(ExportPages, TakeTheSavedViewsAsTheWay) {
    open("Save a film...");
    FilmExport& film = page().wish.film;
    film.turns = false;
    draw();
    // Below the timeline and the format: turn, sweep, way.
    click_at(late_line(4, 0.35F));
    EXPECT_FALSE(film.through_views) << "there are no saved views, so that this one is added";
    film.plan.path.clear();
    for (int i = 0; i < 2; ++i)
        add_view(state_.edited.document.views, *state_.edited.document.camera);
    click_at(late_line(4, 0.35F));
    EXPECT_TRUE(film.through_views);
    click_at(late_line(4, 0.35F));
    EXPECT_FALSE(film.through_views);
}

TEST_P(ExportPages, HaveAShutterWhereFramesAreMixed) {
    open("Save a film...");
    FilmExport& film = page().wish.film;
    film.turns = false;
    const auto height = [this] {
        draw();
        return child(std::string(window_name) + "/##part")->ContentSize.y;
    };
    const float without = height();
    film.plan.blur = 8;
    EXPECT_NEAR(height(), without + ImGui::GetFrameHeightWithSpacing(), 1.0F);
    // Below the format: turn, sweep, way, time, end, size, blur. In the smallest window the time
    // takes two lines.
    const int time_lines = GetParam().window.width == min_width ? 2 : 1;
    click_at(late_line(8 + time_lines, 0.5F));
    draw();
    EXPECT_NE(film.plan.shutter, 0.5);
    EXPECT_GT(film.plan.shutter, 0.0);
    EXPECT_LE(film.plan.shutter, 1.0);
}

TEST_P(ExportPages, SaveByEnter) {
    open("Save the picture...");
    state_.wishes.command.reset();
    press(GLFW_KEY_ENTER);
    EXPECT_EQ(state_.wishes.command, Command::Export);
    EXPECT_FALSE(state_.wishes.export_path);
}

TEST_P(ExportPages, SaveByEnterToTheFileThatIsProposed) {
    open("Save the picture...");
    state_.wishes.command.reset();
    state_.shown.export_target = "/home/ann/picture.png";
    draw();
    press(GLFW_KEY_ENTER);
    EXPECT_FALSE(state_.wishes.command);
    EXPECT_EQ(state_.wishes.export_path, "/home/ann/picture.png");
}

TEST_P(ExportPages, DoNotSaveWhileSomethingIsSaved) {
    open("Save the picture...");
    state_.shown.export_progress = {.name = "a.png", .share = 0.5, .text = "50 %"};
    state_.wishes.command.reset();
    draw();
    press(GLFW_KEY_ENTER);
    EXPECT_FALSE(state_.wishes.command);
}

TEST_P(ExportPages, PlayTheFilm) {
    open("Save a film...");
    click_at(line(0, 0.03F));
    EXPECT_TRUE(page().plays);
    for (int i = 0; i < 20 && page().at == 0.0; ++i)
        draw();
    EXPECT_GT(page().at, 0.0);
}

TEST_P(ExportPages, GiveRoomForThePreview) {
    open("Save the picture...");
    EXPECT_GT(page().preview_px.x, px(150));
    EXPECT_GE(page().preview_px.y, px(70));
}

INSTANTIATE_TEST_SUITE_P(Looks, ExportPages, testing::ValuesIn(different_looks()),
                         [](const auto& look) { return name_of(look.param); });

}  // namespace
}  // namespace zeroset::ui::export_page_test
