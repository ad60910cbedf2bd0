#include "engine/annotate/axes.hpp"

#include "engine/annotate/axis_shapes.hpp"
#include "engine/annotate/label_font.hpp"
#include "engine/annotate/paint.hpp"
#include "engine/annotate/ticks.hpp"
#include "engine/view/image_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

// Axes, clip box and grid: where their lines are, what is hidden, and what is painted of them.

namespace zeroset::test::axes_test {
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

/// A frame with a wall across the view at this distance from the eye's plane, on the left half.
Framebuffer frame_with_wall(const AxesView& view, double distance) {
    Framebuffer frame = empty_frame(view);
    const ViewFrame rays(view.camera);
    for (int row = 0; row < view.height; ++row) {
        for (int col = 0; col < view.width / 2; ++col) {
            const auto ray = rays.direction(pixel_centre(col, row),
                                            {.width = view.width, .height = view.height});
            frame.depth[frame.index(col, row)] = static_cast<float>(distance * glm::length(ray));
        }
    }
    return frame;
}

double total_length(const Axes& axes, LineKind kind, bool hidden) {
    double length = 0.0;
    for (const AxisLine& line : axes.lines) {
        if (line.kind == kind && line.hidden == hidden) length += glm::distance(line.from, line.to);
    }
    return length;
}

TEST(ImagePlane, IsTheInverseOfTheRays) {
    const Camera camera{{5, -4, 3}, {0.5, 1, -1}, {0.1, 0, 1}, 0.8};
    const ImagePlane plane(camera, {.width = 300, .height = 200});
    const glm::dvec3 direction =
        ViewFrame(camera).direction({.col = 37.25, .row = 180.5}, {.width = 300, .height = 200});
    const glm::dvec3 point = camera.eye + 3.0 * direction;
    const auto pixel = plane.pixel_of(point);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, 37.25, 1e-9);
    EXPECT_NEAR(pixel->y, 180.5, 1e-9);
    EXPECT_NEAR(plane.distance(point), 3.0 * glm::length(direction), 1e-12);
    EXPECT_FALSE(plane.pixel_of(camera.eye - direction));
}

TEST(ImagePlane, IsTheInverseOfParallelRays) {
    Camera camera{{5, -4, 3}, {0.5, 1, -1}, {0.1, 0, 1}, 0.8};
    camera.projection = Projection::Orthographic;
    const ImagePlane plane(camera, {.width = 300, .height = 200});
    for (const double distance : {3.0, -2.0}) {
        const glm::dvec3 point = ViewFrame(camera).point({.col = 37.25, .row = 180.5},
                                                         {.width = 300, .height = 200}, distance);
        const auto pixel = plane.pixel_of(point);
        ASSERT_TRUE(pixel);
        EXPECT_NEAR(pixel->x, 37.25, 1e-9);
        EXPECT_NEAR(pixel->y, 180.5, 1e-9);
        EXPECT_NEAR(plane.distance(point), distance, 1e-12);
    }
}

TEST(Axes, DrawsTheClipBoxWhereItIs) {
    const AxesView view = front_view();
    const ImagePlane plane(view.camera, {.width = view.width, .height = view.height});
    const Axes made = make_axes(view, {.clip_box = true}, empty_frame(view));
    EXPECT_EQ(made.lines.size(), 12U);
    EXPECT_TRUE(made.labels.empty());
    const glm::dvec2 corner = *plane.pixel_of({-1, -1, -1});
    const auto meets = [&](const AxisLine& line) {
        return glm::distance(line.from, corner) < 1e-9 || glm::distance(line.to, corner) < 1e-9;
    };
    EXPECT_EQ(std::ranges::count_if(made.lines, meets), 3);
    EXPECT_EQ(total_length(made, LineKind::ClipBox, true), 0.0);
}

TEST(Axes, IsHiddenBehindTheSurface) {
    const AxesView view = front_view();
    const Axes free = make_axes(view, {.clip_box = true}, empty_frame(view));
    const double all = total_length(free, LineKind::ClipBox, false);
    // Before the whole box, behind it, and through its middle.
    for (const auto& [distance, least, most] :
         {std::tuple{3.0, 0.49, 0.51}, {7.0, 0.0, 0.0}, {5.0, 0.15, 0.35}}) {
        const Axes made = make_axes(view, {.clip_box = true}, frame_with_wall(view, distance));
        const double hidden = total_length(made, LineKind::ClipBox, true);
        EXPECT_GE(hidden, least * all) << distance;
        EXPECT_LE(hidden, most * all) << distance;
        EXPECT_NEAR(hidden + total_length(made, LineKind::ClipBox, false), all, 1e-6);
        for (const AxisLine& line : made.lines) {
            if (line.hidden) {
                EXPECT_LE(std::max(line.from.x, line.to.x), view.width / 2 + 1.0);
            }
        }
    }
}

TEST(Axes, LeavesAWallOnWhichItLiesVisible) {
    AxesView view = front_view();
    view.clip = {{-1, 0, -1}, {1, 2, 1}};
    const Axes made = make_axes(view, {.clip_box = true}, frame_with_wall(view, 5.0));
    for (const AxisLine& line : made.lines) {
        const bool at_front = glm::distance(line.from, line.to) > 50 && line.from.x < 149 &&
                              line.to.x < 149 && std::abs(line.from.x - line.to.x) < 1e-9;
        const bool left_front = at_front && line.from.x < 90;
        if (left_front) {
            EXPECT_FALSE(line.hidden);
        }
    }
}

TEST(Axes, HasTicksAtRoundNumbers) {
    const AxesView view = front_view(600, 400);
    const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
    std::map<std::string, glm::dvec2> x_labels;
    for (const AxisLabel& label : made.labels) {
        if (label.kind == LineKind::AxisX) x_labels[label.text] = label.middle;
    }
    const ImagePlane plane(view.camera, {.width = view.width, .height = view.height});
    ASSERT_TRUE(x_labels.contains("0.5") && x_labels.contains("\xE2\x88\x92"
                                                              "0.5"));
    const glm::dvec2 tick = *plane.pixel_of({0.5, -1, -1});
    EXPECT_NEAR(x_labels["0.5"].x, tick.x, 1e-9);
    EXPECT_GT(x_labels["0.5"].y, tick.y) << "below the box";
    EXPECT_NEAR(x_labels["x"].x, 300, 1e-9) << "at the middle of the edge";
    EXPECT_GT(x_labels["x"].y, x_labels["0.5"].y) << "beyond the numbers";
    EXPECT_EQ(total_length(made, LineKind::ClipBox, false), 0.0);
}

TEST(Axes, HasLabelsThatDoNotOverlap) {
    for (const glm::dvec3 eye : {glm::dvec3(3, -4, 2), {0.2, -6, 0.1}, {0.3, 0.2, 7}}) {
        AxesView view = front_view(640, 480);
        view.camera.eye = eye;
        const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
        EXPECT_GT(made.labels.size(), 6U);
        for (const AxisLabel& a : made.labels) {
            const double half = 0.5 * view.em * label_width_em(a.text);
            EXPECT_TRUE(a.middle.x > half && a.middle.x < view.width - half);
            for (const AxisLabel& b : made.labels) {
                if (&a == &b) continue;
                const double widths = half + 0.5 * view.em * label_width_em(b.text);
                EXPECT_TRUE(std::abs(a.middle.x - b.middle.x) > widths ||
                            std::abs(a.middle.y - b.middle.y) > view.em)
                    << a.text << " " << b.text;
            }
        }
    }
}

TEST(Axes, HasFinerTicksInADeepView) {
    AxesView view = front_view();
    view.camera.look_at = {0.123456, 0, 0};
    view.camera.eye = {0.123456, -1e-5, 0};
    const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
    const auto is_deep = [](const AxisLabel& label) {
        return label.kind == LineKind::AxisX && label.text.starts_with("0.12345");
    };
    const auto deep = std::ranges::count_if(made.labels, is_deep);
    EXPECT_GE(deep, 1);
    EXPECT_LE(made.lines.size(), 40U);
}

TEST(Axes, HasNamesOfItsOwn) {
    AxesView view = front_view(600, 400);
    view.names = {"length", "", "t"};
    const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
    const auto has = [&](const std::string& text, LineKind kind) {
        return std::ranges::any_of(made.labels, [&](const AxisLabel& label) {
            return label.text == text && label.kind == kind;
        });
    };
    EXPECT_TRUE(has("length", LineKind::AxisX) && has("t", LineKind::AxisZ));
    for (const char* name : {"x", "y", "z", ""})
        EXPECT_FALSE(has(name, LineKind::AxisX) || has(name, LineKind::AxisY)) << name;
}

TEST(Axes, HasNamesInsideTheImageWhereItsEndsAreNot) {
    AxesView view = front_view(600, 400);
    view.clip = Box::cube(50);  // the eye is inside, and looks along y
    view.names = {"a long name", "y", "z"};
    const Axes made = make_axes(view, {.axes = true}, empty_frame(view));
    int names = 0;
    for (const AxisLabel& label : made.labels) {
        if (label.text != "a long name" && label.text != "z") continue;
        ++names;
        const double half = 0.5 * view.em * label_width_em(label.text);
        EXPECT_GE(label.middle.x, half);
        EXPECT_LE(label.middle.x, view.width - half);
        EXPECT_GE(label.middle.y, 0.5 * view.em);
        EXPECT_LE(label.middle.y, view.height - 0.5 * view.em);
    }
    EXPECT_EQ(names, 2);
}

TEST(Axes, HasAGridOnTheFloor) {
    AxesView view = front_view();
    view.camera.eye = {0, -5, 3};
    const Axes made = make_axes(view, {.grid = true}, empty_frame(view));
    // A box of 2 has squares of 0.2 (2 / 16 rounded up): 11 lines each way.
    EXPECT_EQ(made.lines.size(), 22U);
    const ImagePlane plane(view.camera, {.width = view.width, .height = view.height});
    double lowest = 0.0;
    for (const AxisLine& line : made.lines)
        lowest = std::max({lowest, line.from.y, line.to.y});
    EXPECT_NEAR(lowest, plane.pixel_of({0, -1, -1})->y, 1.0);
}

TEST(AxisShapes, AreLinesThenLabels) {
    const AxesView view = front_view();
    const Axes axes = make_axes(view, {true, true, true}, frame_with_wall(view, 5.0));
    const Shapes shapes = axis_shapes(axes, {.em = view.em, .least_width = 1.25});
    ASSERT_EQ(shapes.size(), axes.lines.size() + axes.labels.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Line* line = std::get_if<Line>(&shapes[i]);
        ASSERT_EQ(line != nullptr, i < axes.lines.size());
        if (line == nullptr) continue;
        EXPECT_GE(line->width, 1.25);
        EXPECT_EQ(line->from, axes.lines[i].from);
    }
}

TEST(AxisShapes, AreFaintBehindTheSurface) {
    Axes axes;
    for (const bool hidden : {false, true}) {
        axes.lines.push_back({{0, 0}, {9, 9}, LineKind::AxisY, hidden});
        axes.labels.push_back({{5, 5}, "2", LineKind::ClipBox, hidden});
    }
    const AxisStyle style{.hidden_label = 0.5, .label_outline = 0x40000000U};
    const Shapes shapes = axis_shapes(axes, style);
    EXPECT_EQ(std::get<Line>(shapes[0]).color, style.colors.axes[1]);
    EXPECT_EQ(std::get<Line>(shapes[1]).color, faded(style.colors.axes[1], hidden_opacity));
    EXPECT_EQ(std::get<Text>(shapes[2]).outline, 0x40000000U);
    EXPECT_EQ(std::get<Text>(shapes[3]).color, faded(style.colors.clip_box, 0.5));
    EXPECT_EQ(std::get<Text>(shapes[3]).outline, 0x20000000U);
}

TEST(AxisShapes, HaveHalosBeforeSurfaces) {
    Axes axes;
    axes.lines.push_back({{0, 0}, {9, 9}, LineKind::AxisX, false});
    axes.lines.push_back({{0, 0}, {9, 9}, LineKind::AxisX, true});
    axes.lines.push_back({{0, 0}, {9, 9}, LineKind::Grid, false});
    axes.lines.push_back({{0, 0}, {9, 9}, LineKind::ClipBox, false});
    const Shapes shapes = axis_shapes(axes, {.halo = 0x80FFFFFFU});
    ASSERT_EQ(shapes.size(), 6U) << "of the axis and of the box";
    for (const std::size_t i : {0U, 1U}) {
        EXPECT_EQ(std::get<Line>(shapes[i]).color, 0x80FFFFFFU);
        EXPECT_GE(std::get<Line>(shapes[i]).width, std::get<Line>(shapes[2 + 3 * i]).width + 2.0);
    }
}

TEST(AxisShapes, SuitTheirBackground) {
    const AxisStyle dark = axis_style_on(Background(), 12.0);
    const AxisStyle light = axis_style_on({.top = 0xFFFFFF, .bottom = 0xE0E8F0}, 12.0);
    EXPECT_EQ(dark.colors.axes, axes_on_dark.axes);
    EXPECT_EQ(light.colors.axes, axes_on_light.axes);
    // Halos have the colour of the background: the red channel is the lowest byte.
    EXPECT_LT(dark.halo & 0xFFU, 0x40U);
    EXPECT_GT(light.halo & 0xFFU, 0xE0U);
    EXPECT_GT(light.halo >> 24U, 0x60U);
}

TEST(PaintedAxes, ChangesColoursOnly) {
    const AxesView view = front_view();
    const Framebuffer frame = frame_with_wall(view, 5.0);
    const auto font = LabelFont::load();
    ASSERT_TRUE(font) << font.error();
    Framebuffer painted = frame;
    const Axes axes = make_axes(view, {true, true, true}, frame);
    paint_shapes(painted, axis_shapes(axes, {.em = view.em}), *font);
    EXPECT_NE(painted.color, frame.color);
    EXPECT_EQ(painted.depth, frame.depth);
    EXPECT_EQ(painted.certificate, frame.certificate);
    EXPECT_EQ(painted.surface, frame.surface);
}

TEST(PaintedAxes, IsFaintBehindTheSurface) {
    const AxesView view = front_view();
    const auto font = LabelFont::load();
    ASSERT_TRUE(font) << font.error();
    const ImagePlane plane(view.camera, {.width = view.width, .height = view.height});
    // The axis x between the ticks, on both halves; the wall hides the left one.
    const auto red_at = [&](const Framebuffer& picture, double x) {
        const glm::dvec2 at = *plane.pixel_of({x, 0, 0});
        int most = 0;
        for (const int row : {-1, 0, 1}) {
            const std::size_t pixel =
                picture.index(static_cast<int>(at.x), static_cast<int>(at.y) + row);
            most = std::max(most, static_cast<int>(picture.color[pixel] & 0xFFU));
        }
        return most;
    };
    const Framebuffer frame = frame_with_wall(view, 4.5);
    Framebuffer painted = frame;
    std::ranges::fill(painted.color, 0xFF000000U);
    const Axes axes = make_axes(view, {.axes = true}, frame);
    paint_shapes(painted, axis_shapes(axes, {.em = view.em}), *font);
    EXPECT_GT(red_at(painted, 0.77), 150);
    EXPECT_GT(red_at(painted, -0.77), 20);
    EXPECT_LT(red_at(painted, -0.77), 70);
}

}  // namespace
}  // namespace zeroset::test::axes_test
