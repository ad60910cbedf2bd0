#pragma once

#include "engine/expr/expr.hpp"

#include <array>
#include <cstdint>
#include <optional>

// The graph of a row that is given by a point, not by an equation: a node over the three
// coordinates whose value nothing is known of, so that whoever takes it for an f proves nothing and
// finds no root. Its text is that of the point.

namespace zeroset {

enum class PatchKind : std::uint8_t {
    Surface,  ///< a point for each x and y in [0, 1]
    Curve,    ///< a point for each x in [0, 1]
    Segment,  ///< a curve that is straight
    Arrow,    ///< a segment with a head at x = 1
    Point,
    Meeting,  ///< the points at which two functions are 0 and a condition holds
};

/// Whether something has a thickness that is not its own: curves and points.
constexpr bool has_thickness(PatchKind kind) { return kind != PatchKind::Surface; }

/// A box that a row is cut to: from and to in x, in y and in z.
using RowBox = std::array<double, 6>;

/// A parametric surface, a curve or a point: its coordinates as functions of x and y. Of a meeting
/// the two functions of x, y and z, and the condition.
struct PatchGraphs {
    std::array<Expr, 3> point;
    PatchKind kind = PatchKind::Surface;
    std::optional<RowBox> box = std::nullopt;  ///< it is drawn in this box alone; not of a meeting
};

NodeId make_patch(ExprBuilder& builder, PatchKind kind, const std::array<NodeId, 3>& point,
                  const std::optional<RowBox>& box = std::nullopt);

/// The coordinates, kind and box of a graph that `make_patch` made; nothing for other graphs.
std::optional<PatchGraphs> patch_of(const Expr& surface);
bool is_patch(const Expr& surface);

}  // namespace zeroset
