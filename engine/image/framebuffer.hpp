#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zeroset {

/// What is known of a pixel's ray.
enum class Certificate : std::uint8_t {
    Miss,       ///< proved empty
    Certified,  ///< one first root: opposite signs proved, everything before it rejected
    Undecided,  ///< may hold a root where the search stopped; drawn if depth is finite
    Coarse,     ///< as Certified, but in a bracket wider than asked for: numbers are no finer
    Jump,       ///< no root: opposite signs proved on both sides of a jump, in front of any root
};

/// Whether a root is proved.
constexpr bool is_proved(Certificate certificate) {
    return certificate == Certificate::Certified || certificate == Certificate::Coarse;
}

/// Some pixels of a picture: columns and rows from (col, row) on.
struct PixelRect {
    int col, row, cols, rows;
};

/// No surface is hit.
inline constexpr std::uint8_t no_surface = 255;

/// A finished or growing picture. Row 0 is the top. Plain data: one writer at a time per pixel.
struct Framebuffer {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> color;  ///< RGBA, 8 bits each, R lowest; A: 255, or see blend_finer
    std::vector<float> depth;          ///< as ViewFrame measures distances; +inf: a miss
    std::vector<Certificate> certificate;
    std::vector<std::uint8_t> surface;  ///< index of the surface that is drawn, or no_surface
    /// What render_frame knows of what it drew here last, so that it need not draw it again: for
    /// each of its tiles, row by row, a bit for each row of pixels, the first one lowest; set where
    /// all its pixels are misses in the background's colour. Empty: nothing is known. Whatever else
    /// changes pixels empties it.
    std::vector<std::uint64_t> blank_rows;

    Framebuffer() = default;
    Framebuffer(int width_px, int height_px);

    [[nodiscard]] std::size_t index(int col, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(col);
    }
};

/// The certificates in colours: certified pixels green, teal where their bracket is coarse;
/// undecided ones amber, or red where nothing is drawn; jumps violet; proved empty ones black.
Framebuffer certificate_picture(const Framebuffer& frame);

struct CertificateCounts {
    std::size_t certified = 0, undecided = 0, miss = 0;
    std::size_t coarse = 0;     ///< of the certified ones
    std::size_t not_drawn = 0;  ///< of the undecided ones, those that show nothing
    std::size_t jumps = 0;
};

CertificateCounts count_certificates(const Framebuffer& frame);

/// Pixels that show each of the first `surfaces` surfaces.
std::vector<std::size_t> count_surfaces(const Framebuffer& frame, std::size_t surfaces);

}  // namespace zeroset
