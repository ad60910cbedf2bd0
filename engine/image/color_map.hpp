#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace zeroset {

/// Scales of colours for numbers, perceptually even: equal steps of a number look like equal steps
/// (of OKLab). All but Cycle also tell numbers apart by lightness, whatever the colour vision.
enum class ColorMap : std::uint8_t {
    Aurora,   ///< dark violet, teal, light yellow
    Ember,    ///< dark plum, red, pale
    Balance,  ///< blue, white in the middle, red: for numbers with a sign
    Gray,
    Cycle,  ///< all hues, the ends alike: for angles
};

std::span<const ColorMap> color_maps();
/// As it is typed: "aurora".
std::string_view name_of(ColorMap map);
std::optional<ColorMap> color_map_named(std::string_view name);

/// Linear reflectances of red, green and blue, 0 to 1.
using Reflectance = std::array<float, 3>;

/// The colour at `place`, 0 to 1 from one end of the map to the other; beyond, that of the end. For
/// what is no number a grey that stands apart.
Reflectance color_at(ColorMap map, double place);

/// The same as it shows in full light, RGBA as in Framebuffer::color.
std::uint32_t shown_color_at(ColorMap map, double place);

}  // namespace zeroset
