#include "app/desktop/desktop.hpp"
#include "document/document.hpp"
#include "document/framing.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/measure/extent.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/fit_view.hpp"
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

/// The aspect of the picture that a camera is made for: fitting sees to narrower ones.
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
        Camera first =
            default_camera(box_in_view(document), aspect, document.up, stretch_of(document));
        if (document.camera) first.projection = document.camera->projection;
        document.camera = document.home.value_or(first);
    };
    const bool reset = std::exchange(state_.wishes.reset_view, false);
    if (reset && state_.edited.document.camera) {
        Document wished = state_.edited.document;
        look(wished);
        if (!wished.home) note_whole_view(wished);
        ui::move_view(state_, *wished.camera);
    }
    if (!state_.edited.document.camera) {
        session_.amend(look);
        if (!state_.edited.document.home) note_whole_view(state_.edited.document);
    }
    if (state_.edited.document.camera->stretch != stretch_of(state_.edited.document))
        session_.amend(
            [aspect](Document& document) { document.camera = camera_of(document, aspect); });
    if (std::exchange(frames_box_, false) && draws_box(state_.edited.document))
        frame_whole_box(aspect);
    keep_whole_box(aspect);
    const bool typed = std::exchange(state_.wishes.frame_box, false);
    if (!typed) return;
    Document wished = state_.edited.document;
    wished.camera = whole_view(*wished.camera, wished, aspect);
    note_whole_view(wished);
    ui::move_view(state_, *wished.camera);
}

/// Moves the view, and the one that is gone back to, so that the whole box is seen.
void Desktop::frame_whole_box(double aspect) {
    session_.amend([&](Document& document) {
        const bool is_home = document.camera == document.home;
        document.camera = whole_view(*document.camera, document, aspect);
        if (is_home) document.home = document.camera;
    });
    note_whole_view(state_.edited.document);
}

void Desktop::note_whole_view(const Document& document) {
    whole_view_ = {.camera = *document.camera,
                   .aspect = wide_aspect(state_.input.viewport_px),
                   .axes = document.axes};
}

bool Desktop::shows_whole_box() const {
    return whole_view_ && state_.edited.document.camera == whole_view_->camera;
}

/// Lets a view of the whole box that nobody has changed follow the shape of the window, and what is
/// drawn beside the box.
void Desktop::keep_whole_box(double aspect) {
    if (!shows_whole_box() || state_.input.move) return;
    const bool axes = state_.edited.document.axes;
    if (aspect == whole_view_->aspect && axes == whole_view_->axes) return;
    frame_whole_box(aspect);
}

/// Computes the surfaces' extent in the background, then looks at all of them.
void Desktop::find_surfaces() {
    if (search_.runs()) {
        if (!search_.done()) return;
        const auto extent = search_.take(wanted_picture());
        const bool own = std::exchange(search_is_own_, false);
        if (extent && own) {
            const double aspect = wide_aspect(state_.input.viewport_px);
            const auto framing = frame_by_itself(state_.edited.document, *extent, aspect);
            if (framing) take_fit(*framing);
        } else if (extent) {
            frame(*extent);
        }
    }
    const std::optional<PictureRequest> wanted = wanted_picture();
    if (!wanted || feed_.reads()) return;
    if (std::exchange(state_.wishes.frame_surfaces, false)) {
        own_fit_due_s_.reset();
        search_.start(*wanted);
    } else if (own_fit_due_s_ && now_s() >= *own_fit_due_s_ && !feed_.tracing()) {
        own_fit_due_s_.reset();
        follow_surfaces();
    }
}

/// Lets box and view follow the surfaces a moment after the last letter of a text was typed, unless
/// the person has chosen another box.
void Desktop::plan_own_fit() {
    constexpr double rest_s = 0.6;
    const Document& document = state_.edited.document;
    const bool is_first = std::exchange(fits_itself_, false);
    const bool had_own = own_box_ && own_box_->row == document.statements.front().id;
    const bool is_free = document.clip == (had_own ? own_box_->box : Box());
    if (asked_box_ || !is_free || state_.edited.read_only) return own_fit_due_s_.reset();
    const int row = document.statements.front().id;
    if (row != std::exchange(own_fit_row_, row)) own_fit_due_s_.reset();
    if (is_first) own_fit_due_s_ = now_s();
    if (state_.input.typing_row != 0) own_fit_due_s_ = now_s() + rest_s;
}

void Desktop::follow_surfaces() {
    Document fitted = state_.edited.document;
    if (const auto box = graph_box(*feed_.formula()->program, fitted)) {
        if (*box == fitted.clip) return;
        fitted.clip = *box;
        fitted.camera = whole_view(*fitted.camera, fitted, wide_aspect(state_.input.viewport_px));
        return take_fit({.document = fitted, .note = graph_note(*box)});
    }
    search_is_own_ = true;
    search_.start(*wanted_picture());
}

/// Takes box and view in one step, which one Ctrl+Z takes back.
void Desktop::take_fit(const Framing& framing) {
    ++state_.input.gesture;
    told_s_ = now_s();
    Document& document = state_.edited.document;
    document.clip = framing.document.clip;
    own_box_ = {.box = document.clip, .row = document.statements.front().id};
    document.camera = framing.document.camera;
    state_.input.move.reset();
    if (draws_box(document)) note_whole_view(document);
    state_.shown.status.framed = framing.note + "  \u00B7  " + tr("Ctrl+Z: back");
    window_.wake();
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
    if (framing.found && draws_box(framing.document)) note_whole_view(framing.document);
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
