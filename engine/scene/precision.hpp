#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"

#include <cstdint>
#include <string_view>

namespace zeroset {

/// The type in which a frame is traced.
enum class Precision : std::uint8_t { Float, Double };

/// "float" or "double".
std::string_view name_of(Precision precision);

/// How finely rays are searched. A search stops at cells of the clip box's longest edge times
/// 2^-wanted near the eye: 2^-d_stop of the edge, or of the distance from the eye to the point
/// looked at where that is less by a factor of 2 or more (up to less than the double of it). Cells
/// farther away than that grow in proportion to their distance from the eye, up to 2^deeper times.
struct SearchDepth {
    int wanted = 0;  ///< halvings of the clip box; a tracer stops before where its type does
    int deeper = 0;  ///< how many of them the view adds to d_stop; 0: it is no smaller than the box
};

/// Halvings that a search may fall short of what is wanted and still certify what it finds: in
/// float the cells of a whole box at max_d_stop are a few ulp.
inline constexpr int most_missed_halvings = 2;

SearchDepth search_depth(const Box& clip, const ViewFrame& view, const StopCriterion& stop);

/// How often the clip box can be halved along a ray until its cells are a few ulp of the largest
/// coordinate (in absolute value) `reach`, for a type of `digits` bits; at least 1.
int deepest_halving(const Box& clip, double reach, int digits);

/// Double where float could not decide at the wanted cells: the box is so far from the origin, or
/// the view so deep in it, that they are near or below float's resolution there. Whole boxes near
/// the origin stay in float up to max_d_stop.
Precision wanted_precision(const Box& clip, const ViewFrame& view, const StopCriterion& stop);

/// The precision that the view wants, and double where numbers of the scene's functions leave the
/// range of float.
Precision wanted_precision(const Scene& scene, const ViewFrame& view, const StopCriterion& stop);

}  // namespace zeroset
