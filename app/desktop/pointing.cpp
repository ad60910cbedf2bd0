#include "app/desktop/pointing.hpp"

#include "engine/annotate/hidden.hpp"
#include "engine/measure/probe.hpp"
#include "pipeline/probe_document.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {

void Pointing::follow(ui::UiState& state, const PictureRequest* shown, double now_s) {
    if (!state.pointer) {
        state.pointed.reset();
        looked_ = {};
    }
    if (shown != nullptr) {
        take_click(state, *shown, now_s);
        look(state, *shown);
    }
    if (click_ && now_s >= click_->since_s + double_click_s) keep_marker(state);
    const bool there = find_marker(state.document.markers, state.selected_marker) != nullptr;
    if (!there) state.selected_marker = 0;
}

std::optional<double> Pointing::due_s(double now_s) const {
    if (!click_) return std::nullopt;
    return std::max(click_->since_s + double_click_s - now_s, 0.0);
}

void Pointing::look(ui::UiState& state, const PictureRequest& request) {
    if (!state.pointer || state.shown.frame == nullptr) return;
    const glm::ivec2 pixel = pixel_under(*state.shown.frame, *state.pointer);
    const Looked wanted{.frame = state.shown.frame, .formula = request.formula, .pixel = pixel};
    if (wanted == looked_) return;
    looked_ = wanted;
    state.pointed = facts_at(state, request, *state.pointer);
}

void Pointing::take_click(ui::UiState& state, const PictureRequest& request, double now_s) {
    const auto click = std::exchange(state.click, std::nullopt);
    if (!click) return;
    if (click->again) {
        click_.reset();
        return;
    }
    // The previous click turns into a marker at once, because a new place was clicked in its
    // waiting time.
    if (click_) keep_marker(state);
    state.selected_marker = click->marker;
    if (click->marker != 0) return;
    const auto facts = facts_at(state, request, click->cursor);
    if (!facts) return;
    click_ =
        Click{.at = facts->facts.point, .since_s = click->at_once ? now_s - double_click_s : now_s};
}

void Pointing::keep_marker(ui::UiState& state) {
    const Click click = *std::exchange(click_, std::nullopt);
    const int number = add_marker(state.document.markers, click.at);
    if (number == 0) {
        state.note = "there are " + std::to_string(most_markers) + " markers already";
        return;
    }
    state.selected_marker = number;
    state.layout.markers_open = true;
}

std::optional<ui::PointedFacts> Pointing::facts_at(const ui::UiState& state,
                                                   const PictureRequest& request,
                                                   const glm::dvec2& cursor) {
    const ui::ShownPicture& shown = state.shown;
    if (shown.frame == nullptr) return std::nullopt;
    const ViewFrame view(shown.camera);
    const StopCriterion& stop = request.settings.stop;
    const double tolerance =
        depth_tolerance(request.clip, stop, wanted_precision(request.clip, view, stop));
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
    return ui::PointedFacts{
        .facts = *facts, .row = request.surfaces[facts->surface].row, .pixel_size = pixel_size};
}

const std::vector<Kernel>& Pointing::typed(const PictureRequest& request) {
    std::vector<std::size_t> shown = shown_indices(request);
    if (typed_of_ != request.formula || typed_shown_ != shown) {
        typed_ = typed_formulas(*request.formula->program, shown);
        typed_of_ = request.formula;
        typed_shown_ = std::move(shown);
    }
    return typed_;
}

}  // namespace zeroset
