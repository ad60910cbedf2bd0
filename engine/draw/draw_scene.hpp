#pragma once

#include "engine/draw/drawing.hpp"
#include "engine/draw/space_function.hpp"
#include "engine/expr/expr.hpp"
#include "engine/scene/scene.hpp"
#include "engine/trace/time_limit.hpp"
#include "engine/view/camera.hpp"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace zeroset {

/// A number whose contour lines are drawn: a coordinate, or a formula's value.
struct ContourNumber {
    std::optional<int> axis;  ///< 0 to 2; nothing: `formula`
    Expr formula = {};
};

/// The choice of what a drawing shows, and how well.
struct DrawOptions {
    std::array<bool, 5> kinds{true, true, true, true, true};  ///< by CurveKind
    std::vector<ContourNumber> contours = {};
    double contour_step = 1.0;                    ///< above 0
    std::optional<double> contour_width_pt = {};  ///< none: as the style has it
    bool hidden = true;                           ///< hidden parts are kept, marked as such
    double tolerance_pt = 0.05;  ///< how far drawn curves may be from the true ones

    [[nodiscard]] bool wants(CurveKind kind) const {
        return kinds.at(static_cast<std::size_t>(kind));
    }
};

/// The scene with the graphs of its surfaces.
struct DrawnScene {
    const Scene& scene;
    std::vector<Expr> surfaces;
    Camera camera;
    PageSize page;
    KernelMaker make_kernel;
};

/// Takes a path once it is drawn; called from several threads at once.
using OnPath = std::function<void(const DrawnPath&)>;

/// Draws the scene's curves. Any thread; works on all cores. When the time is over, the drawing has
/// what is known by then.
LineDrawing draw_scene(const DrawnScene& input, const DrawOptions& options,
                       const TimeLimit& limit = {}, const OnPath& on_path = {});

}  // namespace zeroset
