#pragma once

#include "engine/scene/scene.hpp"
#include "engine/trace/time_limit.hpp"
#include "engine/view/box.hpp"

#include <optional>

namespace zeroset {

/// A box that holds all that `domain` has of the scene's surfaces, or nothing where it proves that
/// there is none. It is as tight as enclosures of f tell for boxes 1/64 of its size, unless that
/// takes very many of them, or longer than `limit`. Some milliseconds; any thread.
std::optional<Box> enclosing_box(const Scene& scene, const Box& domain,
                                 const TimeLimit& limit = {});

/// Where the scene's surfaces lie.
struct Extent {
    std::optional<Box> whole;   ///< holds all of them; nothing where they go on too far to tell
    std::optional<Box> inside;  ///< holds what lies in the clip box; nothing: proved that none does
    /// Where the clip box has none, the least of the boxes twice, four times, ... as large that may
    /// have some.
    std::optional<Box> reached;
};

/// The size of the space in which surfaces are looked for, in sizes of the clip box; bounded ones
/// that begin beyond it are found, too, up to the third power of it.
inline constexpr double extent_reach = 64.0;

/// Where `limit` is over before it is found, the boxes are wider than they need be.
Extent find_extent(const Scene& scene, const TimeLimit& limit = {});

}  // namespace zeroset
