#pragma once

#include "engine/draw/curve_system.hpp"
#include "engine/draw/draw_scene.hpp"
#include "engine/scene/region.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace zeroset {

/// One family of a drawing's curves, to be found by itself.
struct CurveTask {
    CurveKind kind = CurveKind::Silhouette;
    std::size_t surface = 0;
    std::optional<double> level = {};
    CurveEquations equations = {};
    Box box = {};        ///< where the curves are looked for; may be flat
    Region region = {};  ///< and kept
    /// Whether a point of the curves is on the surface as it is shown, up to rounding; empty: all
    /// are.
    std::function<bool(const CurvePoint&)> is_shown = {};
};

/// The curves that a drawing wants.
std::vector<CurveTask> curve_tasks(const DrawnScene& input, const DrawOptions& options);

}  // namespace zeroset
