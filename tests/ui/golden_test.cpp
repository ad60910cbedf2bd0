// Compares the panels with small reference pictures in tests/ui/goldens, each the mean colours of
// the window in squares. ZEROSET_WRITE_GOLDENS=1 rewrites them; look at the window itself then,
// with `zeroset dev ui-shot`.

#include "engine/annotate/legend.hpp"
#include "engine/export/png.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/image/rgba_image.hpp"
#include "tests/support/long_run.hpp"
#include "tests/ui/panels.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace zeroset::ui::golden_test {
namespace {

namespace fs = std::filesystem;

constexpr int square_units =
    8;  ///< side of the square of the window that one golden pixel covers, in design units
/// Largest difference of one colour channel, of 255, and largest mean difference. A blinking caret
/// and other drivers' roundings stay below; a line of text that moves by half its height does not.
constexpr int most_of_a_pixel = 40;
constexpr double most_of_all = 0.75;

int channel(std::uint32_t color, int index) {
    return static_cast<int>(color >> (8U * static_cast<unsigned>(index)) & 0xFFU);
}

/// Returns the mean colour of each square of pixels, without incomplete ones at right and below.
RgbaImage reduced(const Framebuffer& frame, int square) {
    RgbaImage image{frame.width / square, frame.height / square, {}};
    for (int row = 0; row < image.height; ++row) {
        for (int col = 0; col < image.width; ++col) {
            std::array<int, 3> sums{};
            for (int i = 0; i < square * square; ++i) {
                const int at_col = col * square + i % square;
                const int at_row = row * square + i / square;
                for (int c = 0; c < 3; ++c)
                    sums[static_cast<std::size_t>(c)] +=
                        channel(frame.color[frame.index(at_col, at_row)], c);
            }
            std::uint32_t color = 0xFF000000U;
            for (std::size_t c = 0; c < 3; ++c)
                color |= static_cast<std::uint32_t>(sums[c] / (square * square)) << (8 * c);
            image.pixels.push_back(color);
        }
    }
    return image;
}

void write(const fs::path& path, const RgbaImage& image) {
    const std::vector<std::byte> png = png_of(image);
    std::ofstream file(path, std::ios::binary);
    for (const std::byte byte : png)
        file.put(static_cast<char>(byte));
}

class Goldens : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        if (window_ == nullptr) return;
        set_rows(state_, {"a = 0.7", "x^2 + y^2 = a z^2 + w", "x^2 + = 1", "x^2 + y^2 + z^2 = b"});
        state_.shown.reading.uses_w = true;
        state_.edited.layout.view_open = false;
        OffscreenWindow::point({-1, -1}, false);
    }

    void expect_golden(const std::string& name) {
        const RgbaImage image = reduced(draw(), px(square_units));
        const std::string file = name + "_" + name_of(GetParam()) + ".png";
        const fs::path path = fs::path(ZEROSET_SOURCE_DIR) / "tests/ui/goldens" / file;
        if (std::getenv("ZEROSET_WRITE_GOLDENS") != nullptr) {
            write(path, image);
            return;
        }
        std::ifstream in(path, std::ios::binary);
        const std::string png{std::istreambuf_iterator<char>(in), {}};
        const auto golden = image_from_png(std::as_bytes(std::span(png)));
        ASSERT_TRUE(golden) << path << " cannot be read";
        ASSERT_EQ(golden->width, image.width);
        ASSERT_EQ(golden->height, image.height);
        const fs::path seen = fs::path(testing::TempDir()) / ("seen_" + file);
        if (!expect_like(image, *golden)) {
            write(seen, image);
            ADD_FAILURE() << "compare " << seen << " with " << path;
        }
    }

    static bool expect_like(const RgbaImage& image, const RgbaImage& golden) {
        int worst = 0;
        double sum = 0.0;
        std::size_t where = 0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            for (int c = 0; c < 3; ++c) {
                const int off =
                    std::abs(channel(image.pixels[i], c) - channel(golden.pixels[i], c));
                sum += off;
                if (off > worst) where = i;
                worst = std::max(worst, off);
            }
        }
        const auto width = static_cast<std::size_t>(image.width);
        EXPECT_LE(worst, most_of_a_pixel) << "at " << where % width << ", " << where / width;
        const double mean = sum / static_cast<double>(3 * image.pixels.size());
        EXPECT_LE(mean, most_of_all);
        return worst <= most_of_a_pixel && mean <= most_of_all;
    }
};

TEST_P(Goldens, OfStatementsAndSliders) { expect_golden("statements"); }

TEST_P(Goldens, OfTheViewsSettings) {
    state_.edited.layout.view_open = true;
    state_.edited.document.shadows = true;
    expect_golden("view");
}

TEST_P(Goldens, OfAFilmToBeSaved) {
    state_.shown.export_formats = {{.kind = ExportKind::Film,
                                    .name = "MP4",
                                    .ending = ".mp4",
                                    .about = "plays everywhere",
                                    .quality = true}};
    state_.pages.exports.open = true;
    state_.pages.exports.wish.kind = ExportKind::Film;
    state_.pages.exports.wish.film.plan.sweeps = {{.name = "b", .from = 0.0, .to = 2.0}};
    state_.shown.export_progress = {
        .name = "film.mp4", .share = 0.4, .text = "frame 72 of 180, 24 a second, 0:05 left"};
    draw();
    expect_golden("film");
}

TEST_P(Goldens, OfTheAxesOfSpace) {
    state_.edited.layout.space_open = true;
    state_.edited.document.axes = true;
    expect_golden("space");
}

TEST_P(Goldens, OfColorsWithTheirLegend) {
    state_.edited.layout.look_open = true;
    state_.edited.document.coloring = {ColorBy::MeanCurvature, "", ColorMap::Balance,
                                       ValueRange{-2, 2}};
    Coloring coloring;
    coloring.by = ColorBy::MeanCurvature;
    coloring.map = ColorMap::Balance;
    coloring.range = ValueRange{-2, 2};
    state_.shown.picture.legend = legend_of(coloring, "");
    expect_golden("colors");
}

TEST_P(Goldens, OfCuts) {
    state_.edited.layout.clip_open = true;
    state_.edited.document.region.ball = Ball{{0.0, 0.0, 0.0}, 1.5};
    state_.edited.document.region.sections = {make_section({1.0, 0.0, 0.0}, 0.25),
                                              make_section({1.0, 1.0, 0.0}, 0.5, false)};
    expect_golden("cuts");
}

TEST_P(Goldens, OfValuesInSections) {
    state_.edited.layout.clip_open = true;
    Section section = make_section({0.0, 0.0, 1.0}, 0.25);
    section.values = true;
    state_.edited.document.region.sections = {section};
    state_.shown.picture.section_legend =
        section_legend({.map = ColorMap::Gray, .range = {-200, 600}});
    state_.shown.picture.usual_section_range = ValueRange{-1000, 1000};
    state_.edited.document.section_values.range = ValueRange{-200, 600};
    expect_golden("section_values");
}

TEST_P(Goldens, OfMarkersAndThePointUnderThePointer) {
    state_.edited.layout.markers_open = true;
    state_.edited.document.markers = {{1, {0.5, 0.25, 0.75}}, {2, {-1.0, 0.0, 0.5}}};
    state_.edited.selected_marker = 2;
    PointedFacts pointed;
    pointed.row = 2;
    pointed.pixel_size = 0.01;
    pointed.facts.point = {0.5, 0.25, 0.75};
    pointed.facts.distance = 8.125;
    pointed.facts.normal = {0.0, 0.6, 0.8};
    pointed.facts.certificate = Certificate::Certified;
    state_.shown.pointed = pointed;
    for (int i = 0; i < 2; ++i)
        draw_frame();
    ImGuiWindow* const sections = section("markers")->ParentWindow;
    ImGui::SetScrollY(sections, sections->ScrollMax.y);
    expect_golden("markers");
}

TEST_P(Goldens, OfTheFoldedPanel) {
    state_.edited.layout.folded = true;
    expect_golden("folded");
}

TEST_P(Goldens, OfTheHelp) {
    state_.pages.help.open = true;
    state_.shown.language_help = {
        {"Numbers", {{"2, 0.5, 1e-3", "numbers"}, {"pi, e", "constants"}}}};
    expect_golden("help");
}

TEST_P(Goldens, OfTheGallery) {
    press_with_ctrl(GLFW_KEY_G);
    expect_golden("gallery");
}

TEST_P(Goldens, OfThePalette) {
    press_with_ctrl(GLFW_KEY_K);
    OffscreenWindow::type("view");
    expect_golden("palette");
}

TEST_P(Goldens, OfAQuestion) {
    state_.pages.dialogs.question =
        Question{"Save the changes?", {"Save", "Don't save", "Cancel"}, {}};
    expect_golden("question");
}

std::vector<Look> looked_at() {
    std::vector<Look> looks;
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        for (const float scale : {1.0F, 2.0F}) {
            if (test::is_long_run() || (theme == Theme::Dark) == (scale == 1.0F))
                looks.push_back({theme, {960, 640, scale}});
        }
    }
    return looks;
}

INSTANTIATE_TEST_SUITE_P(Looks, Goldens, testing::ValuesIn(looked_at()),
                         [](const auto& looks) { return name_of(looks.param); });

}  // namespace
}  // namespace zeroset::ui::golden_test
