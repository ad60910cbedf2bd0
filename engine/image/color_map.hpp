#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace zeroset {

/// Colour scales for numbers, perceptually even: equal steps of a number look like equal steps (in
/// OKLab). All but Cycle also differ in lightness, so that any colour vision tells numbers apart.
enum class ColorMap : std::uint8_t {
    Aurora,   ///< dark violet, teal, light yellow
    Ember,    ///< dark plum, red, pale
    Balance,  ///< blue, white in the middle, red: for numbers with a sign
    Gray,
    Cycle,  ///< all hues, the ends alike: for angles
};

std::span<const ColorMap> color_maps();
/// The name as it is typed: "aurora".
std::string_view name_of(ColorMap map);
std::optional<ColorMap> color_map_named(std::string_view name);

/// Linear reflectances of red, green and blue, 0 to 1.
using Reflectance = std::array<float, 3>;

/// The colour at `place`, from 0 at one end of the map to 1 at the other; beyond an end, that of
/// the end. NaN gives a grey that stands apart.
Reflectance color_at(ColorMap map, double place);

/// color_at(map, place) as it shows in full light, RGBA as in Framebuffer::color.
std::uint32_t shown_color_at(ColorMap map, double place);

}  // namespace zeroset
