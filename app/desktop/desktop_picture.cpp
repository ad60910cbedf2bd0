#include "app/desktop/desktop.hpp"
#include "engine/annotate/contour_labels.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/render/render_request.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/shown_points.hpp"
#include "ui/picture/draw_shapes.hpp"
#include "ui/screen.hpp"
#include "ui/style/theme.hpp"
#include "ui/window/texture.hpp"
#include "ui/window/window.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

// The picture of the document: asked for, taken when it is there, and what is drawn over it.

namespace zeroset {
namespace {

/// Two tracers are compared by what they do themselves.
void leave_only_tracing(TraceSettings& settings) {
    settings.shadows = false;
    settings.antialias = Antialias::None;
    settings.reflections = 0;
    settings.soft_light = false;
}

/// Why the chosen tracers cannot draw a picture.
std::vector<std::string> tracer_refusals(const ui::Inspection& chosen,
                                         const PictureRequest& wanted) {
    std::vector<std::string> refusals;
    if (auto refusal = tracer_refusal(chosen.tracer, chosen.tracer, wanted))
        refusals.push_back(std::move(*refusal));
    if (!chosen.other) return refusals;
    if (auto refusal = tracer_refusal(*chosen.other, *chosen.other, wanted))
        refusals.push_back(std::move(*refusal));
    return refusals;
}

}  // namespace

std::optional<PictureRequest> Desktop::wanted_picture() const {
    TraceSettings settings = settings_;
    settings.tracer = state_.edited.inspection.tracer;
    settings.costs = state_.edited.inspection.costs;
    auto wanted = feed_.wanted(state_.edited.document, settings, state_.input.viewport_px);
    if (wanted && state_.edited.inspection.other) leave_only_tracing(wanted->settings);
    return wanted;
}

/// Says once why chosen tracers cannot draw what is wanted.
void Desktop::tell_refusals(const PictureRequest& wanted) {
    std::string text;
    for (const std::string& refusal : tracer_refusals(state_.edited.inspection, wanted))
        text += (text.empty() ? "" : "; ") + refusal;
    if (text == told_refusals_) return;
    told_refusals_ = text;
    if (!text.empty()) session_.tell(text);
}

void Desktop::submit_picture() {
    std::optional<PictureRequest> wanted = wanted_picture();
    if (wanted) tell_refusals(*wanted);
    if (!wanted || !feed_.submit(std::move(*wanted))) return;
    state_.shown.picture.tracing = true;
    window_.wake();
}

void Desktop::take_frame() {
    const std::optional<RenderResult> result = feed_.take_picture();
    ui::ShownPicture& picture = state_.shown.picture;
    if (!result) {
        if (picture.frame != nullptr && uploaded_ != wanted_look()) upload_frame();
        return;
    }
    picture.frame = result->frame;
    picture.camera = result->camera;
    if (latency_ != nullptr) {
        latency_->taken(result->request, result->frame->width, result->frame->height,
                        result->complete);
    }
    show_legend(*result);
    show_contour_labels(*result);
    upload_frame();
    feed_.note_shown(*result);
    picture.tracing = feed_.tracing();
    if (!result->complete) return;
    state_.shown.figures = {.width_px = result->frame->width,
                            .height_px = result->frame->height,
                            .frame_ms = result->frame_ms,
                            .counts = result->counts,
                            .precision = result->precision};
}

void Desktop::show_legend(const RenderResult& result) {
    std::optional<Legend>& legend = state_.shown.picture.legend;
    legend.reset();
    state_.shown.picture.section_legend = result.section_values.transform(section_legend);
    state_.shown.picture.usual_section_range =
        result.section_values.transform([](const SectionValues& of) { return of.usual_range; });
    if (!result.frame->cost.empty()) legend = cost_legend();
    if (legend || result.coloring.by == ColorBy::Plain) return;
    legend = legend_of(result.coloring, feed_.colors().expression);
}

void Desktop::show_contour_labels(const RenderResult& result) {
    ui::ShownPicture& picture = state_.shown.picture;
    const SurfaceLines& lines = result.coloring.lines;
    picture.contour_step = lines.contours.empty() ? std::nullopt : std::optional(lines.step);
    picture.contour_labels = contour_label_shapes({.frame = *result.frame,
                                                   .camera = result.camera,
                                                   .lines = lines,
                                                   .uniforms = result.uniforms,
                                                   .size = state_.input.viewport_px},
                                                  ui::card_style(state_.edited.theme));
}

Desktop::TextureLook Desktop::wanted_look() const {
    return {.theme = state_.edited.theme, .marks_undecided = state_.edited.document.mark_undecided};
}

void Desktop::upload_frame() {
    const LatencyLog::InOpenGl uploading(latency_.get());
    uploaded_ = wanted_look();
    const auto tint = uploaded_.marks_undecided ? std::optional(ui::undecided_tint(uploaded_.theme))
                                                : std::nullopt;
    texture_.upload(*state_.shown.picture.frame, ui::behind_picture(uploaded_.theme), tint);
}

/// Shows where the points among the rows are for the sliders as they are.
void Desktop::show_points() {
    const auto& formula = feed_.formula();
    const std::optional<Camera>& camera = state_.edited.document.camera;
    state_.shown.points.clear();
    if (formula == nullptr || !camera || state_.input.viewport_px.y <= 0) return;
    state_.shown.points = shown_points(formula.get(), state_.edited.document,
                                       state_.shown.picture.camera, state_.input.viewport_px.y);
}

}  // namespace zeroset
