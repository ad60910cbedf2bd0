#include "app/desktop/desktop.hpp"
#include "document/document.hpp"
#include "document/framing.hpp"
#include "engine/measure/extent.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/picture_request.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/window/window.hpp"

#include <glm/ext/vector_int2.hpp>

#include <algorithm>
#include <optional>
#include <utility>

// The window's view: at the start, after a reset, and to see all of the surfaces; and what the
// window waits for.

namespace zeroset {
namespace {

/// The aspect of the picture that a camera is made for: ui::fitting sees to narrower ones.
double wide_aspect(glm::ivec2 size_px) {
    return std::max(static_cast<double>(size_px.x) / static_cast<double>(size_px.y), 1.0);
}

}  // namespace

/// Looks at the whole box if the document has no camera, and on request.
void Desktop::find_view() {
    const glm::ivec2 size = state_.input.viewport_px;
    if (size.x <= 0 || size.y <= 0) return;
    const double aspect = wide_aspect(size);
    const auto look = [aspect](Document& document) {
        Camera first = default_camera(document.clip, aspect, document.up);
        if (document.camera) first.projection = document.camera->projection;
        document.camera = document.home.value_or(first);
    };
    const bool reset = std::exchange(state_.wishes.reset_view, false);
    if (reset && state_.edited.document.camera) {
        Document wished = state_.edited.document;
        look(wished);
        ui::move_view(state_, *wished.camera);
    }
    if (!state_.edited.document.camera) session_.amend(look);
    const bool typed = std::exchange(state_.wishes.frame_box, false);
    if (typed)
        ui::move_view(state_,
                      framed(*state_.edited.document.camera, state_.edited.document.clip, aspect));
}

/// Computes the surfaces' extent in the background, then looks at all of them.
void Desktop::find_surfaces() {
    if (search_.runs()) {
        if (!search_.done()) return;
        if (const auto extent = search_.take(wanted_picture())) frame(*extent);
    }
    const std::optional<PictureRequest> wanted = wanted_picture();
    if (!state_.wishes.frame_surfaces || !wanted || feed_.reads()) return;
    state_.wishes.frame_surfaces = false;
    search_.start(*wanted);
}

void Desktop::snap_marker() {
    if (!state_.wishes.snap_marker && !snap_.runs()) return;
    const bool has_read = feed_.has_read(state_.edited.document);
    if (!snap_.follow(state_, has_read ? wanted_picture() : std::nullopt)) return;
    tell_done(state_.shown.status.done);
    window_.wake();
}

void Desktop::frame(const Extent& extent) {
    const double aspect = wide_aspect(state_.input.viewport_px);
    const Framing framing =
        frame_surfaces(state_.edited.document, extent, aspect, std::exchange(fits_box_, true));
    state_.edited.document.clip = framing.document.clip;
    ui::move_view(state_, *framing.document.camera);
    state_.shown.status.framed = framing.note;
    told_s_ = now_s();
    window_.wake();
}

void Desktop::follow_waiting() {
    const double now = now_s();
    wait_notice_.follow(feed_.waits_for(), now);
    state_.shown.picture.dimmed = wait_notice_.dimmed(now);
    state_.shown.figures.hidden = wait_notice_.hides_figures(now);
    state_.shown.status.doing =
        exports_.doing().empty() ? wait_notice_.text(now) : exports_.doing();
}

}  // namespace zeroset
