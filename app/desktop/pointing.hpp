#pragma once

#include "engine/scene/settings.hpp"
#include "pipeline/formula.hpp"
#include "ui/model/ui_state.hpp"

#include <glm/ext/vector_int2.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace zeroset {

/// The pointer over the picture, over time: what is under it, and the markers that clicks keep. A
/// click waits a moment for a second one: double clicks are about the view. The window's thread.
class Pointing {
public:
    static constexpr double double_click_s = 0.3;

    /// What is behind the picture that is shown.
    struct Behind {
        std::shared_ptr<const Formula> formula;
        std::vector<int> rows;  ///< of the formula's surfaces
        const Uniforms& uniforms;
        StopCriterion stop;
    };

    /// After each frame of the panels. Nothing behind: what was found before stays.
    void follow(ui::UiState& state, const std::optional<Behind>& behind, double now_s);
    /// Seconds until it wants to be called though nothing happens.
    [[nodiscard]] std::optional<double> due_s(double now_s) const;

private:
    struct Click {
        glm::dvec3 at;
        double since_s;
    };
    /// What the facts were looked up for.
    struct Looked {
        std::shared_ptr<const Framebuffer> frame;
        std::shared_ptr<const Formula> formula;
        glm::ivec2 pixel{-1};

        bool operator==(const Looked&) const = default;
    };

    std::optional<ui::PointedFacts> facts_at(const ui::UiState& state, const Behind& behind,
                                             const glm::dvec2& cursor);
    const std::vector<Kernel>& typed(const std::shared_ptr<const Formula>& formula,
                                     const std::vector<std::size_t>& shown);
    void look(ui::UiState& state, const Behind& behind);
    void take_click(ui::UiState& state, const Behind& behind, double now_s);
    void keep_marker(ui::UiState& state);

    Looked looked_;
    std::optional<Click> click_;
    std::shared_ptr<const Formula> typed_of_;
    std::vector<std::size_t> typed_shown_;
    std::vector<Kernel> typed_;
};

}  // namespace zeroset
