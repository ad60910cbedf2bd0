#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/view/camera.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace zeroset {

/// Colours of axes, box and grid; RGBA as in Framebuffer::color, with the opacity they are drawn
/// with.
struct AxisColors {
    std::array<std::uint32_t, 3> axes;  ///< of x, y and z
    std::uint32_t clip_box;
    std::uint32_t grid;
};

inline constexpr AxisColors axes_on_dark{
    .axes = {0xFF5C66F2U, 0xFF4FC072U, 0xFFF79E5CU}, .clip_box = 0xA0DCD0C8U, .grid = 0x50C9B9AEU};
inline constexpr AxisColors axes_on_light{
    .axes = {0xFF2F2FC4U, 0xFF228238U, 0xFFC8601FU}, .clip_box = 0xA042342AU, .grid = 0x4042342AU};

/// Colours between these, for pictures that are laid on anything.
inline constexpr AxisColors axes_on_anything{
    .axes = {0xFF4645DBU, 0xFF3C9A4BU, 0xFFDE7C38U}, .clip_box = 0xE08A8480U, .grid = 0x908A8480U};

/// Which of axes, clip box and grid are drawn.
struct AxesChoice {
    bool axes = false;      ///< through the origin or, where the box does not hold it, beside it;
                            ///< with numbers at outer edges of the box
    bool clip_box = false;  ///< its edges
    bool grid = false;      ///< on the box's floor

    [[nodiscard]] bool any() const { return axes || clip_box || grid; }
};

enum class LineKind : std::uint8_t { AxisX, AxisY, AxisZ, ClipBox, Grid };

/// A piece of a line. Places are in pixels of the image, columns to the right, rows downwards.
struct AxisLine {
    glm::dvec2 from, to;
    LineKind kind;
    bool hidden;  ///< behind a surface
};

/// A number at a tick, or the name of an axis.
struct AxisLabel {
    glm::dvec2 middle;
    std::string text;  ///< UTF-8: as tick_label's, or the axis's name
    LineKind kind;     ///< of its axis
    bool hidden;
};

/// Axes, clip box and grid, as far as they were chosen.
struct Axes {
    std::vector<AxisLine> lines;
    std::vector<AxisLabel> labels;  ///< none overlaps another or the image's edge
};

/// The image over which axes are drawn.
struct AxesView {
    Box clip;
    Camera camera;
    glm::dvec3 up{0.0, 0.0, 1.0};  ///< the floor is where the box ends against the nearest axis
    int width = 0, height = 0;     ///< pixels
    double em = 12.0;              ///< size of the labels' font, pixels
    std::array<std::string, 3> names{"x", "y", "z"};  ///< beside the numbers; UTF-8
    std::array<bool, 3> of_pi{};                      ///< ticks at multiples of pi
};

/// Lines and labels, and which pieces of them are behind what `shown` shows: a picture of the
/// camera's of any size. Below a millisecond.
Axes make_axes(const AxesView& view, const AxesChoice& choice, const Framebuffer& shown);

}  // namespace zeroset
