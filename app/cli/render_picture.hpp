#pragma once

#include "app/cli/commands.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/timing.hpp"
#include "app/platform/process.hpp"
#include "engine/export/pictures/picture_writer.hpp"
#include "engine/image/framebuffer.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <glm/ext/vector_int2.hpp>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The work of `render` between reading its options and writing its files.

namespace zeroset {

/// The meaning of the options, checked before any work.
struct RenderPlan {
    Document document;  ///< the document with the options applied
    RowProgram rows;    ///< the document's rows
    TraceSettings settings;
    Size size{};
    int repeats = 1;
    bool warms_up = false;
    bool fits = false;                   ///< fits the view to the surfaces
    bool fits_box = false;               ///< `fits` also fits the clip box
    bool fits_itself = false;            ///< fits both where the surfaces need it
    bool smooths_itself = false;         ///< edges are smooth where that does not take long
    bool quiet = false;                  ///< no note on that
    std::vector<glm::ivec2> probes;      ///< columns and rows
    double budget_s = default_budget_s;  ///< of a picture in bands, for each of them
    PictureOptions picture;              ///< how -o is written
    bool legend = true;
    bool in_bands = false;  ///< the picture is too large to be in memory

    /// The picture's width / height.
    [[nodiscard]] double aspect() const { return static_cast<double>(size.width) / size.height; }
};

/// A picture and what it was made of; incomplete if the budget ran out.
struct RenderedPicture {
    RenderPlan plan;  ///< the plan after fitting
    std::optional<InputError> error;
    bool left_plain = false;  ///< smooth edges would have taken long
    std::string note;         ///< on what --fit could not do, or what was fitted; or empty
    PictureRequest request;   ///< without a formula if there was no time to make one
    Scene scene;              ///< the request's scene, with the range of the colours
    Framebuffer frame;        ///< empty where it is drawn in bands
    std::string write_error;  ///< why a band was not taken, or empty
    FrameTiming timing;
    bool in_time = true;  ///< everything wanted was finished
    Progress::Stage stage_at_end =
        Progress::Stage::Drawing;  ///< unless in_time: the stage that took the time
};

/// Takes the next rows of a picture that is drawn in bands, on the thread that draws it.
using TakeRows =
    std::function<std::expected<void, FileError>(const RenderedPicture&, const PictureBand&)>;

/// A drawn picture. render_picture draws the plan within its budget, which begins at `start`; it
/// asks `take_rows` if it draws in bands. If the work runs much too long, it goes on in a thread
/// and `stuck` is true: then the process must end by end_process.
struct RenderOutcome {
    std::shared_ptr<const RenderedPicture> picture;
    bool stuck = false;
};
RenderOutcome render_picture(const RenderPlan& plan, std::chrono::steady_clock::time_point start,
                             TakeRows take_rows = {});

/// One line on what the budget left undone; empty if it left nothing.
std::string budget_note(const RenderedPicture& picture);

}  // namespace zeroset
