#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace zeroset {

/// How a pixel's colour is made of more than its own ray. Its depth and certificate are of that.
enum class Antialias : std::uint8_t {
    None,
    Beams,  ///< of the pixel's parts, as beams find them [Florez08, sec. 5.5.2]
    Rays4,  ///< of so many rays, evenly spread
    Rays9,
    Rays16,
    Rays64,
};

/// The way of pictures whose edges are smooth, or not.
constexpr Antialias smooth_edges(bool on) { return on ? Antialias::Beams : Antialias::None; }

/// none, iaa, 4, 9, 16 or 64; 1 is none, too.
std::string_view name_of(Antialias antialias);
std::optional<Antialias> antialias_named(std::string_view name);

/// Rays of a pixel across and down of which its colour is made.
int rays_across(Antialias antialias);

}  // namespace zeroset
