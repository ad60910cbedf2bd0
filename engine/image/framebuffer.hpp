#pragma once

#include "engine/image/background.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// Knowledge about the first root on a pixel's ray.
enum class Certificate : std::uint8_t {
    Miss,       ///< proved: no root on the ray
    Certified,  ///< proved: opposite signs around one root, and everything before it rejected
    Undecided,  ///< may hold a root where the search stopped; drawn if depth is finite
    Coarse,     ///< as Certified, but in a bracket wider than asked for, as numbers are no finer
    Jump,       ///< no root: opposite signs proved on both sides of a jump, in front of any root
};

/// Whether a root is proved.
constexpr bool is_proved(Certificate certificate) {
    return certificate == Certificate::Certified || certificate == Certificate::Coarse;
}

/// A rectangle of pixels: `cols` columns and `rows` rows from (col, row) on.
struct PixelRect {
    int col, row, cols, rows;
};

/// Value of Framebuffer::surface where no surface is hit.
inline constexpr std::uint8_t no_surface = 255;

/// A finished or growing picture. Row 0 is the top. Plain data: one writer at a time per pixel.
struct Framebuffer {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> color;  ///< RGBA, 8 bits each, R lowest; A: see blend.hpp
    std::vector<float> depth;          ///< distances as in ViewFrame; +inf: a miss
    std::vector<Certificate> certificate;
    std::vector<std::uint8_t> surface;  ///< index of the surface drawn, or no_surface
    Background background = {};         ///< that `color` is mixed with
    /// Linear red, green and blue (1: the brightest that a picture shows), mixed with the
    /// background, and how much of the pixel is not background: `color` without its rounding to 8
    /// bits. Empty unless keep_planes made room for it.
    std::vector<std::array<float, 4>> light;
    /// The normal of the surface drawn, of length 1, along the gradient of f; 0 for a miss. Empty
    /// as `light`.
    std::vector<std::array<float, 3>> normal;
    /// The cost of each pixel to the tracer: evaluations of f, of its ranges and forms, of those
    /// for many pixels a share. Empty unless TraceSettings::costs asks for it.
    std::vector<float> cost;
    /// Rows that render_frame left blank when it last drew here, so that it need not draw them
    /// again: for each of its tiles, row by row, a bit for each row of pixels, the first one
    /// lowest; set where all its pixels are misses in the background's colour. Empty: nothing is
    /// known. Any other code that changes pixels must clear it.
    std::vector<std::uint64_t> blank_rows;

    Framebuffer() = default;
    Framebuffer(int width_px, int height_px);

    /// Makes room for `light`, and for `normal` if that is wanted: render_frame fills them.
    void keep_planes(bool normals);

    [[nodiscard]] std::size_t index(int col, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(col);
    }
};

/// A picture of the certificates: certified pixels green, teal where their bracket is coarse;
/// undecided ones amber, or red where nothing is drawn; jumps violet; misses black.
Framebuffer certificate_picture(const Framebuffer& frame);

struct CertificateCounts {
    std::size_t certified = 0, undecided = 0, miss = 0;
    std::size_t coarse = 0;     ///< part of `certified`
    std::size_t not_drawn = 0;  ///< part of `undecided`: pixels that show nothing
    std::size_t jumps = 0;
};

CertificateCounts count_certificates(const Framebuffer& frame);

/// Number of pixels that show each of the first `surfaces` surfaces.
std::vector<std::size_t> count_surfaces(const Framebuffer& frame, std::size_t surfaces);

}  // namespace zeroset
