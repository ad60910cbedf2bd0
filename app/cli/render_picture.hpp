#pragma once

#include "app/cli/commands.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/timing.hpp"
#include "app/platform/process.hpp"
#include "engine/image/framebuffer.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <glm/ext/vector_int2.hpp>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The work of `render`, between reading its options and writing its files.

namespace zeroset {

/// What the options mean, checked before any work.
struct RenderPlan {
    Document document;  ///< with what the options say of it
    RowProgram rows;    ///< the document's
    TraceSettings settings;
    Size size{};
    int repeats = 1;
    bool warms_up = false;
    bool fits = false;               ///< the view to the surface,
    bool fits_box = false;           ///< and the clip box
    std::vector<glm::ivec2> probes;  ///< columns and rows
    double budget_s = default_budget_s;
};

/// A picture and what it was made of; after its budget, as far as it came.
struct RenderedPicture {
    RenderPlan plan;  ///< fitted
    std::optional<InputError> error;
    std::string note;        ///< what --fit could not do; a line or nothing
    PictureRequest request;  ///< no formula: there was no time for any
    Scene scene;             ///< of the request, with the range of the colours
    Framebuffer frame;
    FrameTiming timing;
    bool in_time = true;                                      ///< all that was wanted is there
    Progress::Stage stage_at_end = Progress::Stage::Drawing;  ///< else: what took the time
};

/// Draws what is planned within its budget, which begins with `start`. Where it ends much too late,
/// a thread goes on: the process must end by end_process then (`stuck`).
struct RenderOutcome {
    std::shared_ptr<const RenderedPicture> picture;
    bool stuck = false;
};
RenderOutcome render_picture(const RenderPlan& plan, std::chrono::steady_clock::time_point start);

/// One line on what the budget left; empty where it left nothing.
std::string budget_note(const RenderedPicture& picture);

}  // namespace zeroset
