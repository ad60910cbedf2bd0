#pragma once

#include "engine/view/box.hpp"
#include "engine/view/image_plane.hpp"

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace zeroset {

/// A part of a straight line in the world.
struct Segment {
    glm::dvec3 from, to;

    [[nodiscard]] glm::dvec3 at(double t) const { return from + t * (to - from); }
};

/// For each axis the edge of the box beside which its numbers stand: one of the box's outline in
/// the image, so that nothing in the box is behind them; along `up` the one at the left, along the
/// others the lowest. Nothing for an axis that is seen end on, or from within the box.
std::array<std::optional<Segment>, 3> outer_edges(const Box& box, const ImagePlane& plane, int up);

}  // namespace zeroset
