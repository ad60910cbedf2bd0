#pragma once

#include <array>
#include <cstdint>

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

}  // namespace zeroset
