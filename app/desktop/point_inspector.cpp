#include "app/desktop/point_inspector.hpp"

#include "engine/annotate/hidden.hpp"
#include "engine/base/translation.hpp"
#include "engine/measure/probe.hpp"
#include "pipeline/probe_document.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {

void PointInspector::follow(ui::UiState& state, const PictureRequest* shown, double now_s) {
    if (!state.input.pointer) {
        state.shown.pointed.reset();
        last_lookup_ = {};
    }
    if (shown != nullptr) {
        take_click(state, *shown, now_s);
        look(state, *shown);
    }
    if (click_ && now_s >= click_->since_s + double_click_s) keep_marker(state);
    const bool there =
        find_marker(state.edited.document.markers, state.edited.selected_marker) != nullptr;
    if (!there) state.edited.selected_marker = 0;
}

std::optional<double> PointInspector::due_s(double now_s) const {
    if (!click_) return std::nullopt;
    return std::max(click_->since_s + double_click_s - now_s, 0.0);
}

void PointInspector::look(ui::UiState& state, const PictureRequest& request) {
    if (!state.input.pointer || state.shown.picture.frame == nullptr) return;
    const glm::ivec2 pixel = pixel_under(*state.shown.picture.frame, *state.input.pointer);
    const Lookup wanted{
        .frame = state.shown.picture.frame, .formula = request.formula, .pixel = pixel};
    if (wanted == last_lookup_) return;
    last_lookup_ = wanted;
    state.shown.pointed = facts_at(state.shown.picture, request, *state.input.pointer);
}

void PointInspector::take_click(ui::UiState& state, const PictureRequest& request, double now_s) {
    const auto click = std::exchange(state.wishes.click, std::nullopt);
    if (!click) return;
    if (click->again) {
        click_.reset();
        return;
    }
    // The previous click turns into a marker at once, because a new place was clicked in its
    // waiting time.
    if (click_) keep_marker(state);
    state.edited.selected_marker = click->marker;
    if (click->marker != 0) return;
    const auto facts = facts_at(state.shown.picture, request, click->cursor);
    if (!facts) return;
    click_ =
        Click{.at = facts->facts.point, .since_s = click->at_once ? now_s - double_click_s : now_s};
}

void PointInspector::keep_marker(ui::UiState& state) {
    const Click click = *std::exchange(click_, std::nullopt);
    const int number = add_marker(state.edited.document.markers, click.at);
    if (number == 0) {
        state.shown.status.note =
            filled(tr("there are {0} markers already"), {std::to_string(most_markers)});
        return;
    }
    state.edited.selected_marker = number;
    state.edited.layout.markers_open = true;
}

std::optional<ui::PointedFacts> PointInspector::facts_at(const ui::ShownPicture& shown,
                                                         const PictureRequest& request,
                                                         const ViewPoint& cursor) {
    if (shown.frame == nullptr) return std::nullopt;
    const ViewFrame view(shown.camera);
    const StopCriterion& stop = request.settings.stop;
    const Box clip = stretched(request.clip, request.formula->stretch);
    const double tolerance = depth_tolerance(clip, stop, wanted_precision(clip, view, stop));
    const Uniforms uniforms = uniforms_of(request);
    const ProbedPicture picture{.frame = *shown.frame,
                                .camera = shown.camera,
                                .formulas = typed(request),
                                .uniforms = uniforms,
                                .tolerance = tolerance};
    const glm::ivec2 pixel = pixel_under(*shown.frame, cursor);
    const auto facts = probe(picture, pixel.x, pixel.y);
    if (!facts || facts->surface >= request.surfaces.size()) return std::nullopt;
    const double pixel_size = view.pixel_width(shown.frame->height, facts->distance);
    return ui::PointedFacts{.facts = unstretched(*facts, request.formula->stretch),
                            .row = request.surfaces[facts->surface].row,
                            .pixel_size = pixel_size};
}

const std::vector<Kernel>& PointInspector::typed(const PictureRequest& request) {
    std::vector<std::size_t> shown = shown_indices(request);
    if (typed_of_ != request.formula || typed_shown_ != shown) {
        typed_ = typed_formulas(*request.formula->program, request.formula.get(), shown);
        typed_of_ = request.formula;
        typed_shown_ = std::move(shown);
    }
    return typed_;
}

}  // namespace zeroset
