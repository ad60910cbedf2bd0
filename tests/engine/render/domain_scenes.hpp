#pragma once

#include "engine/view/camera.hpp"
#include "tests/support/rays.hpp"

#include <functional>
#include <limits>
#include <string>
#include <vector>

// Surfaces whose formula has poles, jumps or ends of its domain, as pieces on which it is smooth:
// the ray's roots from those, in double, without intervals.

namespace zeroset::test {

using Field = std::function<double(const glm::dvec3&)>;

/// f where it is smooth and defined.
struct Piece {
    Field f;
    Field inside;  ///< not below 0 on the piece; monotone where a straight line leaves it
};

struct DomainScene {
    std::string text;
    std::vector<Piece> pieces;
    /// Jumps are passed without being decided.
    bool undecided_jumps = false;
};

std::vector<DomainScene> domain_scenes();

/// The things that a ray meets in the clip box.
struct Meeting {
    double first = std::numeric_limits<double>::infinity();  ///< its first root, if any
    /// f is not near 0 on the way, at the ends of pieces neither, and the root is a simple one off
    /// the ends: nothing that would be hard to decide.
    bool clear = true;
    bool jumps = false;  ///< leaves a piece on the way
};

Meeting meeting_of(const DomainScene& scene, const Ray& ray);

/// Whether some piece has a zero within `reach` of the point along each axis.
bool is_near(const DomainScene& scene, const glm::dvec3& point, double reach);

}  // namespace zeroset::test
