#pragma once

#include "engine/measure/special_point.hpp"
#include "pipeline/picture_request.hpp"
#include "ui/model/ui_state.hpp"

#include <future>
#include <optional>

namespace zeroset {

/// Moves the selected marker to a special point nearby when that is wished, which is searched in
/// the background. The window's thread owns it and looks every poll_s whether a search is done.
class MarkerSnap {
public:
    static constexpr double poll_s = 0.01;

    /// To be called after each frame of the panels, with the picture that is wanted, if any. Tells
    /// the outcome in `state.shown.status.done`; returns true if it has just done that.
    bool follow(ui::UiState& state, const std::optional<PictureRequest>& picture);
    [[nodiscard]] bool runs() const { return found_.valid(); }

private:
    void start(const ui::UiState& state, const PictureRequest& picture);

    std::future<std::optional<SpecialPoint>> found_;
    std::optional<PictureRequest> picture_;  ///< in which it is searched
    Marker marker_;                          ///< as it was when the search began
    glm::dvec3 up_{0.0, 0.0, 1.0};
};

/// The line that tells where a search has moved a marker, or that nothing was found: "3 is now at a
/// singular point (numerical: ...)".
std::string snap_text(const Marker& marker, const glm::dvec3& up,
                      const std::optional<SpecialPoint>& found);

}  // namespace zeroset
