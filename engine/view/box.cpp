#include "engine/view/box.hpp"

#include <algorithm>

namespace zeroset {

double Box::size() const {
    const glm::dvec3 edges = hi - lo;
    return std::max({edges.x, edges.y, edges.z});
}

Box scaled(const Box& box, double factor) {
    const glm::dvec3 centre = box.centre();
    return {.lo = centre + factor * (box.lo - centre), .hi = centre + factor * (box.hi - centre)};
}

}  // namespace zeroset
