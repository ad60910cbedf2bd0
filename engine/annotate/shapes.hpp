#pragma once

#include "engine/image/color_map.hpp"

#include <glm/ext/vector_double2.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// Shapes that are drawn over a picture, as plain values: made once, painted into an image in memory
// by paint_shapes and onto the window by ui/picture. Places and lengths are in pixels of the
// canvas, from its left upper corner, rows downwards; a pixel's centre is at (i + 0.5, j + 0.5).
// Colours are RGBA as in Framebuffer::color, not multiplied by their alpha.

namespace zeroset {

/// A straight line with smooth edges, its ends cut straight: lines join without a seam.
struct Line {
    glm::dvec2 from, to;
    double width = 1.0;
    std::uint32_t color = 0;
};

/// A disc, or a ring where `line` is above 0: about `radius`, so thick.
struct Circle {
    glm::dvec2 middle;
    double radius = 1.0;
    std::uint32_t color = 0;
    double line = 0.0;
};

/// A rectangle with round corners, filled, or its frame where `line` is above 0: inside its edges,
/// so thick.
struct RoundedRectangle {
    glm::dvec2 lo, hi;
    double radius = 0.0;  ///< of the corners
    std::uint32_t color = 0;
    double line = 0.0;
};

/// The area within corners that turn one way all around.
struct ConvexPolygon {
    std::vector<glm::dvec2> corners;
    std::uint32_t color = 0;
};

/// The colours of a map from left to right over a rectangle.
struct MapBar {
    glm::dvec2 lo, hi;
    ColorMap map = ColorMap::Aurora;
};

/// The point of a text that stands at its place.
enum class Anchor : std::uint8_t {
    Middle,     ///< in the middle of its width, half as high as its digits
    TopLeft,    ///< of its line, which is line_height_em high
    TopMiddle,  ///< of its line
    TopRight,   ///< of its line
};

/// One line of DejaVu Sans.
struct Text {
    std::string words;  ///< UTF-8
    glm::dvec2 at;
    Anchor anchor = Anchor::Middle;
    double em = 12.0;  ///< size of the font
    std::uint32_t color = 0;
    std::uint32_t outline = 0;  ///< a thin one about the letters; 0: none
};

using Shape = std::variant<Line, Circle, RoundedRectangle, ConvexPolygon, MapBar, Text>;

/// Painted in this order, one over the other.
using Shapes = std::vector<Shape>;

/// Adds `more` behind the last of `shapes`.
void append(Shapes& shapes, Shapes more);

/// The shapes, moved by so much.
Shapes moved(Shapes shapes, const glm::dvec2& by);

/// Height of a line of DejaVu Sans, and from its top the middle of digits and the baseline.
inline constexpr double line_height_em = 1.164;
inline constexpr double digits_middle_em = 0.484 * line_height_em;
inline constexpr double baseline_em = 0.928;

/// Where the copies of a text that make its outline lie, beside it.
std::array<glm::dvec2, 8> outline_offsets(double em);

/// Width of one line of UTF-8 at a size of the font, both in pixels, as a painter will draw it.
using TextWidth = std::function<double(std::string_view words, double em)>;

/// The colour with its opacity multiplied by `opacity`, 0 to 1.
std::uint32_t faded(std::uint32_t color, double opacity);

}  // namespace zeroset
