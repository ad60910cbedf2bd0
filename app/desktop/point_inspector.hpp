#pragma once

#include "pipeline/picture_request.hpp"
#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_int2.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace zeroset {

/// Follows the pointer over the picture: finds what is under it and keeps a marker for each click.
/// A click waits a moment for a second one, because double clicks move the view instead. The
/// window's thread only.
class PointInspector {
public:
    static constexpr double double_click_s = 0.3;

    /// To be called after each frame of the panels. `shown`: request of the picture on the screen;
    /// with nullptr, facts found before stay.
    void follow(ui::UiState& state, const PictureRequest* shown, double now_s);
    /// Seconds until follow() must be called even if no event comes; nothing: not at all.
    [[nodiscard]] std::optional<double> due_s(double now_s) const;

private:
    struct Click {
        glm::dvec3 at;
        double since_s;
    };
    /// The picture, formula and pixel that the facts were looked up for.
    struct Lookup {
        std::shared_ptr<const Framebuffer> frame;
        std::shared_ptr<const Formula> formula;
        glm::ivec2 pixel{-1};

        bool operator==(const Lookup&) const = default;
    };

    std::optional<ui::PointedFacts> facts_at(const ui::ShownPicture& shown,
                                             const PictureRequest& request,
                                             const ViewPoint& cursor);
    const std::vector<Kernel>& typed(const PictureRequest& request);
    void look(ui::UiState& state, const PictureRequest& request);
    void take_click(ui::UiState& state, const PictureRequest& request, double now_s);
    void keep_marker(ui::UiState& state);

    Lookup last_lookup_;
    std::optional<Click> click_;
    std::shared_ptr<const Formula> typed_of_;
    std::vector<std::size_t> typed_shown_;
    std::vector<Kernel> typed_;
};

}  // namespace zeroset
