#pragma once

#include "engine/antialias/cover_search.hpp"
#include "engine/antialias/edge_fit.hpp"
#include "engine/antialias/edge_lines.hpp"
#include "engine/antialias/front.hpp"
#include "engine/antialias/ray_stretches.hpp"
#include "engine/image/framebuffer.hpp"

#include <cstdint>
#include <optional>
#include <variant>

// Verdicts on squares whose fronts are at an edge of a surface. They change nothing: SquareEdges
// acts by them.

namespace zeroset {

/// A square at an edge, as its rays tell it.
struct EdgeSquare {
    const CoverSquare& square;
    const Front& front;
    SquareStretches stretches;  ///< that the front leaves open, within the clip region
    EdgeSamples samples;        ///< of these

    /// Whether all rays are within the clip region there.
    [[nodiscard]] bool is_inside() const { return front.is_inside(front.at, front.to); }
    [[nodiscard]] bool all_have_roots() const { return samples.roots() == square_ray_count; }
};

/// A share of the square that the surface covers; the search goes on beside it.
struct EdgeCover {
    SquareRay place;  ///< of the sample that stands for it
    double share;     ///< 0: nothing stands for it
    double from, to;  ///< the depths between which the sample's root is
    Certificate certificate;
    SquareRest rest;
};

/// Another way to go on with a square.
enum class EdgeStep : std::uint8_t {
    Pass,            ///< nothing of the surface is seen at the edge: behind it
    LeavePlain,      ///< the pixel's own hit stands for it
    Divide,          ///< with its quarters
    DivideIntoRays,  ///< with its rays
    SeekCreases,     ///< by the sheets that its roots make up
    Rough,           ///< rough_verdict tells
};
using EdgeVerdict = std::variant<EdgeStep, EdgeCover>;

/// The rules for lines in a square of this size.
LineRules line_rules(const CoverSquare& square, bool is_inside);

/// Judges a square within the clip region where f is continuous; `has_own_hit`: the hit of the
/// pixel's own ray is between the ends of the front, and stands for all of the square.
EdgeVerdict inside_verdict(const EdgeSquare& edge, bool has_own_hit);

/// The line that an edge is at walls of the clip region, if it is one.
std::optional<LinearOnSquare> line_at_walls(const EdgeSquare& edge);
/// The samples of a square at walls of the clip region.
EdgeSamples samples_at_walls(const CoverSquare& square, const Front& front,
                             SquareStretches stretches);

/// Judges a square whose edge is this line, or that it is all below, or above.
EdgeVerdict line_verdict(const EdgeSquare& edge, const LinearOnSquare& line);
EdgeVerdict thread_verdict(const EdgeSquare& edge, const Thread& thread);

/// Whether it matters to rough_verdict that f comes to 0 on all rays near to where it is least.
bool may_be_touched(const EdgeSquare& edge);
/// Judges a square whose edge has no name. `is_sheet`: f comes to 0 on all rays, and on none goes
/// through it.
EdgeVerdict rough_verdict(const EdgeSquare& edge, bool is_sheet);

}  // namespace zeroset
