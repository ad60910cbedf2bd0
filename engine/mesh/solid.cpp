#include "engine/mesh/solid.hpp"

namespace zeroset {

std::vector<SolidCut> cuts_of(const Box& box, const Region& region) {
    std::vector<SolidCut> cuts;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = 1.0;
        cuts.push_back({.place = normal, .reach = box.hi[axis]});
        cuts.push_back({.place = -normal, .reach = -box.lo[axis]});
    }
    if (region.ball) {
        cuts.push_back(
            {.is_ball = true, .place = region.ball->centre, .reach = region.ball->radius});
    }
    for (const Section& section : region.sections) {
        if (zeroset::cuts(section, box))
            cuts.push_back({.place = section.normal, .reach = section.offset});
    }
    return cuts;
}

}  // namespace zeroset
