#include "engine/annotate/contour_labels.hpp"

#include "engine/render/render.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <string>
#include <variant>
#include <vector>

// Numbers along contour lines, by where those must be.

namespace zeroset::test::contour_labels_test {
namespace {

constexpr int side = 400;
constexpr double em = 12.0;

/// A style whose letters are all as wide.
CardStyle style() {
    return {.em = em, .width = [](std::string_view words, double size) {
                return 0.64 * size * static_cast<double>(words.size());
            }};
}

/// A plane seen from above: two units of the world across the picture.
Camera from_above() {
    return {.eye = {0, 0, 5},
            .look_at = {0, 0, 0},
            .up = {0, 1, 0},
            .fov_rad = 2.0 * std::atan(1.0 / 5.0),
            .projection = Projection::Orthographic};
}

std::vector<Text> labels_of(const SurfaceLines& lines, const std::string& surface = "z = 0") {
    const Scene scene = scene_of(surface, Box::cube(2));
    Framebuffer frame(side, side);
    render_frame(scene, from_above(), {}, frame);
    const Camera camera = from_above();
    std::vector<Text> labels;
    for (const Shape& shape : contour_label_shapes({.frame = frame,
                                                    .camera = camera,
                                                    .lines = lines,
                                                    .uniforms = scene.uniforms,
                                                    .size = {side, side}},
                                                   style()))
        labels.push_back(std::get<Text>(shape));
    return labels;
}

SurfaceLines lines_of_x(double step) {
    return {.contours = {{.along = {1, 0, 0}}}, .step = step, .labels = true};
}

/// A number as labels write it, with a minus sign of three bytes.
double number_of(std::string words) {
    if (words.starts_with("\xE2\x88\x92")) words = "-" + words.substr(3);
    return std::strtod(words.c_str(), nullptr);
}

TEST(ContourLabels, StandOnTheirLines) {
    const std::vector<Text> labels = labels_of(lines_of_x(0.25));
    ASSERT_GT(labels.size(), 6U);
    std::map<double, int> seen;
    for (const Text& label : labels) {
        const double x = (label.at.x - 0.5 * side) * 2.0 / side;
        EXPECT_NEAR(number_of(label.words), x, 0.01) << label.words;
        ++seen[number_of(label.words)];
    }
    EXPECT_GE(seen.size(), 7U) << "of each of the lines at -0.75 to 0.75";
}

TEST(ContourLabels, DoNotOverlap) {
    SurfaceLines lines = lines_of_x(0.2);
    lines.contours.push_back({.along = {0, 1, 0}});
    const std::vector<Text> labels = labels_of(lines);
    ASSERT_GT(labels.size(), 10U);
    bool of_x = false;
    bool of_y = false;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        of_x = of_x || labels[i].words.starts_with("x ");
        of_y = of_y || labels[i].words.starts_with("y ");
        for (std::size_t k = 0; k < i; ++k) {
            const glm::dvec2 off = glm::abs(labels[i].at - labels[k].at);
            const double wide =
                0.5 * (style().width(labels[i].words, em) + style().width(labels[k].words, em));
            EXPECT_TRUE(off.x > wide || off.y > em) << labels[i].words << ", " << labels[k].words;
        }
    }
    EXPECT_TRUE(of_x && of_y) << "each tells which coordinate it is of";
}

TEST(ContourLabels, AreLeftOutWhereLinesAreTooClose) {
    EXPECT_TRUE(labels_of(lines_of_x(0.05)).empty());
}

TEST(ContourLabels, AreOnTheSurfaceOnly) {
    for (const Text& label : labels_of(lines_of_x(0.25), "x^2 + y^2 + z^2 = 0.5"))
        EXPECT_LT(glm::distance(label.at, glm::dvec2(0.5 * side)), std::sqrt(0.5) * 0.5 * side);
}

TEST(ContourLabels, AreThereOnlyIfTheyAreWanted) {
    SurfaceLines lines = lines_of_x(0.25);
    lines.labels = false;
    EXPECT_TRUE(labels_of(lines).empty());
    lines.labels = true;
    lines.contours.clear();
    EXPECT_TRUE(labels_of(lines).empty());
}

}  // namespace
}  // namespace zeroset::test::contour_labels_test
