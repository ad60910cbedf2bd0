#include "app/desktop/tracer_comparison.hpp"

#include "engine/image/rgba_image.hpp"
#include "engine/measure/wrong_pixels.hpp"
#include "engine/render/tracers.hpp"
#include "engine/scene/tolerance.hpp"
#include "ui/screen.hpp"

#include <limits>
#include <utility>

namespace zeroset {
namespace {

bool proves(const std::string& tracer) { return find_tracer(tracer)->proves; }

}  // namespace

TracerComparison::TracerComparison(std::function<void()> wake) : wake_(std::move(wake)) {}

void TracerComparison::show(ui::UiState& state) {
    ui::OtherPicture& other = state.shown.other;
    auto result = job_ == nullptr ? std::nullopt : job_->take();
    if (result && submitted_) {
        other.tracer = submitted_->settings.tracer;
        other.frame = std::move(result->frame);
        other.camera = result->camera;
        other.frame_ms = result->frame_ms;
        other.complete = result->complete && result->request == newest_;
        precision_ = result->precision;
    }
    if (!submitted_) {
        other = {};
        uploaded_ = {};
    }
    if (other.frame != nullptr) upload(state);
}

void TracerComparison::upload(ui::UiState& state) {
    const ui::Inspection& wanted = state.edited.inspection;
    const ui::ShownPicture& first = state.shown.picture;
    ui::OtherPicture& other = state.shown.other;
    const bool comparable = other.complete && !first.tracing && first.frame != nullptr &&
                            first.frame->width == other.frame->width &&
                            first.frame->height == other.frame->height &&
                            first.camera == other.camera;
    const Uploaded now{.first = first.frame,
                       .other = other.frame,
                       .theme = state.edited.theme,
                       .difference = wanted.difference && comparable};
    if (wanted.difference && !comparable) {
        other.texture = 0;
        other.wrong.reset();
        uploaded_ = {};
        return;
    }
    if (now == uploaded_) return;
    uploaded_ = now;
    if (!texture_) texture_.emplace();
    texture_->set_filter(ui::Filter::Nearest);
    other.texture = texture_->name();
    other.wrong.reset();
    if (now.difference) {
        upload_difference(state.shown, other, proves(wanted.tracer));
    } else {
        texture_->upload(*other.frame, ui::behind_picture(now.theme), std::nullopt);
    }
}

void TracerComparison::upload_difference(const ui::Shown& shown, ui::OtherPicture& other,
                                         bool first_proves) {
    const Framebuffer& first = *shown.picture.frame;
    const bool other_proves = proves(other.tracer);
    other.reference = first_proves   ? ui::Reference::First
                      : other_proves ? ui::Reference::Other
                                     : ui::Reference::None;
    const bool by_first = other.reference != ui::Reference::Other;
    const Framebuffer& judged = by_first ? *other.frame : first;
    const Framebuffer& proved = by_first ? first : *other.frame;
    // Both pictures may be off by as much.
    const auto width = certified_width(submitted_->clip, submitted_->settings.stop, precision_);
    const double tolerance = width ? 2.0 * *width : std::numeric_limits<double>::infinity();
    other.wrong = wrong_pixels(judged, proved, other.camera, tolerance);
    texture_->upload(
        RgbaImage{.width = judged.width,
                  .height = judged.height,
                  .pixels = difference_colors(judged, proved, other.camera, tolerance)});
}

void TracerComparison::follow(const ui::UiState& state, const PictureRequest* on_screen) {
    const auto& other = state.edited.inspection.other;
    if (!other) {
        submitted_.reset();
        return;
    }
    if (on_screen == nullptr) return;
    PictureRequest wanted = *on_screen;
    wanted.settings.tracer = *other;
    const bool preview = state.shown.picture.tracing;
    if (submitted_ == wanted && (preview || !previews_)) return;
    RenderRequest request = render_request(wanted);
    request.preview = preview;
    if (job_ == nullptr) job_ = std::make_unique<RenderJob>(wake_);
    newest_ = job_->submit(std::move(request));
    submitted_ = std::move(wanted);
    previews_ = preview;
}

}  // namespace zeroset
