#include "engine/annotate/axes.hpp"
#include "engine/view/image_plane.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// The numbers of axes: where they stand, and which ones.

namespace zeroset::test::axis_numbers_test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// From the front: x to the right, z up.
AxesView front_view(int width = 300, int height = 200) {
    return {Box::cube(1), {{0, -5, 0}, {0, 0, 0}, {0, 0, 1}, 0.6}, {0, 0, 1}, width, height, 12.0};
}

Framebuffer empty_frame(const AxesView& view) {
    Framebuffer frame(view.width, view.height);
    std::ranges::fill(frame.depth, infinity);
    return frame;
}

/// Whether a point of the image lies in the outline of a convex body's corners, or near it.
bool is_within(const glm::dvec2& point, const std::vector<glm::dvec2>& corners, double near) {
    for (double angle = 0.0; angle < 6.28; angle += 0.01) {
        const glm::dvec2 out(std::cos(angle), std::sin(angle));
        double reach = -1e9;
        for (const glm::dvec2& corner : corners)
            reach = std::max(reach, glm::dot(out, corner));
        if (glm::dot(out, point) > reach + near) return false;
    }
    return true;
}

TEST(AxisNumbers, StandOutsideOfTheBox) {
    AxesView view = front_view(640, 480);
    for (const glm::dvec3 eye : {glm::dvec3(4, -6, 3), {-4, 6, 3}, {5, 5, -3}, {0.2, -8, 0.1}}) {
        view.camera.eye = eye;
        const ImagePlane plane(view.camera, {.width = view.width, .height = view.height});
        std::vector<glm::dvec2> corners;
        for (int i = 0; i < 8; ++i)
            corners.push_back(*plane.pixel_of({i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1}));
        const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
        EXPECT_GT(made.labels.size(), 6U);
        for (const AxisLabel& label : made.labels)
            EXPECT_FALSE(is_within(label.middle, corners, 0.3 * view.em)) << label.text;
    }
}

/// The numbers at an axis, in their order.
std::vector<double> numbers_at(const Axes& axes, LineKind kind) {
    std::vector<double> numbers;
    for (const AxisLabel& label : axes.labels) {
        const bool below_0 = label.text.starts_with("\xE2\x88\x92");
        const std::string digits = below_0 ? label.text.substr(3) : label.text;
        if (label.kind != kind || digits.find_first_not_of("0123456789.") != std::string::npos)
            continue;
        numbers.push_back(below_0 ? -std::stod(digits) : std::stod(digits));
    }
    std::ranges::sort(numbers);
    return numbers;
}

TEST(AxisNumbers, HaveOneStepForAllUnlessAnAxisIsTooShort) {
    AxesView view = front_view(900, 700);
    view.clip = {{-3, -2, -0.2}, {3, 2, 0.3}};
    view.camera.eye = {8, -9, 5};
    const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
    EXPECT_EQ(numbers_at(made, LineKind::AxisX), (std::vector<double>{-3, -2, -1, 0, 1, 2, 3}));
    EXPECT_EQ(numbers_at(made, LineKind::AxisY), (std::vector<double>{-1, 0, 1, 2})) << "a corner";
    EXPECT_GE(numbers_at(made, LineKind::AxisZ).size(), 1U) << "with a step of its own";
}

TEST(AxisNumbers, AreThreeInASmallPicture) {
    AxesView view = front_view(160, 120);
    view.clip = Box::cube(4);
    view.camera.eye = {0, -20, 0};
    const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
    EXPECT_EQ(numbers_at(made, LineKind::AxisX), (std::vector<double>{-4, 0, 4}));
}

TEST(AxisNumbers, StandAtTheAxisWhereTheBoxIsOutOfSight) {
    AxesView view = front_view(640, 480);
    view.clip = Box::cube(20);
    const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
    EXPECT_GE(numbers_at(made, LineKind::AxisX).size(), 2U);
}

TEST(AxisNumbers, AreMultiplesOfPi) {
    AxesView view = front_view(900, 600);
    view.clip = Box::cube(3.5);
    view.camera.eye = {0, -16, 0};
    view.of_pi = {true, false, false};
    const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
    const auto has = [&](const std::string& text, LineKind kind) {
        return std::ranges::any_of(made.labels, [&](const AxisLabel& label) {
            return label.text == text && label.kind == kind;
        });
    };
    EXPECT_TRUE(has("\u03C0", LineKind::AxisX) && has("\u2212\u03C0/2", LineKind::AxisX));
    EXPECT_FALSE(has("\u03C0", LineKind::AxisZ));
}

}  // namespace
}  // namespace zeroset::test::axis_numbers_test
