#pragma once

#include "engine/expr/expr.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <vector>

namespace zeroset {

/// A solid: the points of the file's box where side * function <= 0 and no bound is above 0.
struct LevelSet {
    std::string name;
    Expr function;
    double side = 1.0;
    std::vector<Expr> bounds = {};
    std::array<std::uint8_t, 3> color{200, 200, 200};
};

/// The points with dot(normal, p) <= offset.
struct LevelSetPlane {
    glm::dvec3 normal;
    double offset;
};
/// The points no farther than `radius` from the centre.
struct LevelSetBall {
    glm::dvec3 centre;
    double radius;
};

/// All that a file holds.
struct LevelSetFile {
    std::vector<LevelSet> surfaces;
    std::vector<LevelSetPlane> planes = {};  ///< they end all surfaces, as the balls do
    std::vector<LevelSetBall> balls = {};
    glm::dvec3 lo, hi;                ///< the box that they are in
    std::vector<double> values = {};  ///< of w and the parameters
    double mm_per_unit = 1.0;
    std::vector<std::string> comment = {};  ///< lines of ASCII
};

/// The bytes of a package of 3MF, and how many surfaces and nodes of functions it has.
struct EncodedLevelSets {
    std::vector<std::byte> bytes;
    std::size_t surfaces = 0;
    std::size_t nodes = 0;
};

/// Writes the surfaces as level sets of implicit functions (volumetric and implicit
/// extensions 1.0). The error is one line: the first thing that they cannot say.
std::expected<EncodedLevelSets, std::string> encode_level_sets(const LevelSetFile& file);

}  // namespace zeroset
