#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/view/camera.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace zeroset {

/// What is drawn of the space around the surfaces.
struct FurnitureChoice {
    bool axes = false;      ///< through the origin or, where the box does not hold it, beside it
    bool clip_box = false;  ///< its edges
    bool grid = false;      ///< on the box's floor

    [[nodiscard]] bool any() const { return axes || clip_box || grid; }
};

enum class FurnitureKind : std::uint8_t { AxisX, AxisY, AxisZ, ClipBox, Grid };

/// Places are in pixels of the image, columns to the right, rows downwards.
struct FurnitureLine {
    glm::dvec2 from, to;
    FurnitureKind kind;
    bool hidden;  ///< behind a surface
};

struct FurnitureLabel {
    glm::dvec2 middle;
    std::string text;  ///< UTF-8: digits, -, ., e, +, x, y, z; the minus is U+2212
    FurnitureKind kind;
    bool hidden;
};

struct Furniture {
    std::vector<FurnitureLine> lines;
    std::vector<FurnitureLabel> labels;  ///< none overlaps another or the image's edge
};

/// An image to be furnished.
struct FurnitureView {
    Box clip;
    Camera camera;
    glm::dvec3 up{0.0, 0.0, 1.0};  ///< the floor is where the box ends against the nearest axis
    int width = 0, height = 0;     ///< pixels
    double em = 12.0;              ///< size of the labels' font, pixels
};

/// Lines and labels, and which pieces of them are behind what `shown` shows: a picture of the
/// camera's of any size. Below a millisecond.
Furniture make_furniture(const FurnitureView& view, const FurnitureChoice& choice,
                         const Framebuffer& shown);

/// Of 1, 2 and 5 times the powers of ten the least that is not below `length`, above 0.
double tick_step(double length);
/// The number at a tick, with as many decimals as the step has.
std::string tick_text(double value, double step);
/// Width of a label in DejaVu Sans, in em.
double label_width_em(const std::string& text);

/// How thick a line is, in em.
double line_width_em(FurnitureKind kind);
/// Opacity of what is behind a surface, as a part of what it would be before it.
inline constexpr double hidden_opacity = 0.22;

}  // namespace zeroset
