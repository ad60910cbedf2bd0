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

struct CurveTasks {
    std::vector<CurveTask> list;  ///< what matters most first
    bool in_time = true;
    bool all_seams = true;  ///< false: some jumps are left out, as there were too many
};

/// The curves that a drawing wants, as far as the time suffices to make their equations.
CurveTasks curve_tasks(const DrawnScene& input, const DrawOptions& options, const TimeLimit& limit);

}  // namespace zeroset
