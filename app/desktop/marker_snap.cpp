#include "app/desktop/marker_snap.hpp"

#include "engine/base/translation.hpp"
#include "pipeline/probe_document.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace zeroset {
namespace {

/// "z", "-x" of a direction along an axis; "the height" of others.
std::string name_of_height(const glm::dvec3& up) {
    const glm::dvec3 way = glm::normalize(up);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(way[axis]) > 1.0 - 1e-12)
            return (way[axis] < 0 ? "-" : "") + std::string(1, static_cast<char>('x' + axis));
    }
    return tr_in("a maximum of ...", "the height");
}

std::string small_numbers(const SpecialPoint& found) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "|f| = %.1g, |grad f| = %.1g", std::abs(found.f),
                  found.slope);
    return filled(tr("numerical: {0}"), {text.data()});
}

}  // namespace

std::string snap_text(const Marker& marker, const glm::dvec3& up,
                      const std::optional<SpecialPoint>& found) {
    const std::string name = name_of(marker);
    const std::string height = name_of_height(up);
    if (!found) {
        return filled(tr("no singular point and no maximum or minimum of {0} found near {1}"),
                      {height, name});
    }
    const std::string numbers = small_numbers(*found);
    if (found->kind == SpecialKind::Singular)
        return filled(tr("{0} is now at a singular point ({1})"), {name, numbers});
    const char* const place = found->kind == SpecialKind::Top
                                  ? tr("{0} is now at a local maximum of {1} ({2})")
                                  : tr("{0} is now at a local minimum of {1} ({2})");
    return filled(place, {name, height, numbers});
}

void MarkerSnap::start(const ui::UiState& state, const PictureRequest& picture) {
    const Document& document = state.edited.document;
    const Marker* const marker = find_marker(document.markers, state.edited.selected_marker);
    if (marker == nullptr) return;
    marker_ = *marker;
    up_ = document.up;
    picture_ = picture;
    found_ = std::async(std::launch::async, [picture, from = marker_.at, up = up_] {
        return special_point_of(picture, from, up);
    });
}

bool MarkerSnap::follow(ui::UiState& state, const std::optional<PictureRequest>& picture) {
    const bool wished = std::exchange(state.wishes.snap_marker, false);
    if (wished && picture && !runs()) {
        start(state, *picture);
        return false;  // what it finds is told with a later picture, however soon it is found
    }
    if (!runs() || found_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return false;
    const std::optional<SpecialPoint> found = found_.get();
    std::vector<Marker>& markers = state.edited.document.markers;
    const auto marker = std::ranges::find(markers, marker_);
    const bool same = picture && picture->formula == picture_->formula &&
                      picture->uniforms == picture_->uniforms && picture->clip == picture_->clip;
    if (marker == markers.end() || !same) return false;
    if (found) {
        marker->at = found->at;
        ++state.input.gesture;  // makes the move an undo step of its own
    }
    state.shown.status.done = snap_text(*marker, up_, found);
    return true;
}

}  // namespace zeroset
