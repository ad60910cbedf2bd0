#pragma once

#include "document/document.hpp"
#include "document/row_program.hpp"
#include "engine/draw/draw_scene.hpp"
#include "engine/trace/time_limit.hpp"
#include "pipeline/input_error.hpp"

#include <array>
#include <expected>
#include <string>

namespace zeroset {

/// The choice of what a drawing of a document shows. Contour lines are the document's.
struct DrawingChoice {
    PageSize page;
    std::array<bool, 5> kinds{true, true, true, true, true};  ///< by CurveKind
    bool hidden = true;                                       ///< hidden parts are wanted, too
    double tolerance_pt = 0.05;
    bool fits = false;         ///< fits the view to the surfaces
    bool fits_box = false;     ///< `fits` also fits the clip box
    bool fits_itself = false;  ///< fits both where the surfaces need it, see fit_by_itself
};

/// A document made ready to be drawn in lines.
struct DrawingScene {
    Scene scene;
    std::vector<Expr> surfaces;
    Camera camera;
    PageSize page;
    DrawOptions options;
    DrawnMarks marks;  ///< axes, clip box, grid and markers
    std::string note;  ///< one line on what fitting could not do, or did by itself; or empty
};

/// Makes the code that a drawing of a document needs, and finds the view, which is that of a
/// picture of the same aspect. `rows`: the document's rows as they were read. Thread-safe.
std::expected<DrawingScene, InputError> drawing_scene(Document document, RowProgram rows,
                                                      const DrawingChoice& choice,
                                                      const TimeLimit& limit);

/// Draws it, by machine code where that pays.
LineDrawing line_drawing(const DrawingScene& scene, const TimeLimit& limit,
                         const OnPath& on_path = {});

}  // namespace zeroset
