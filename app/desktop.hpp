#pragma once

#include "app/formula.hpp"
#include "app/formula_job.hpp"
#include "app/options.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/trace/camera.hpp"
#include "engine/trace/render_job.hpp"
#include "engine/trace/scene.hpp"
#include "ui/texture.hpp"
#include "ui/ui_state.hpp"
#include "ui/window.hpp"

#include <glm/ext/vector_int2.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace zeroset {

/// What the window starts with.
struct DesktopOptions {
    Surface surface;
    TraceSettings settings;
    ui::Theme theme = ui::Theme::Dark;
    bool takes_keyboard = true;  ///< the equation can be typed over at once
    bool mark_undecided = false;
};

/// The gallery's first surface where `equation` is empty; a d_stop for interaction where no stop is
/// given. The formula may have errors: the window shows them.
OrInputError<DesktopOptions> read_desktop_options(const std::string& equation, const ViewText& view,
                                                  const TraceText& trace);

/// The window's content over time. Everything here belongs to the window's thread; the jobs'
/// threads only wake it.
class Desktop {
public:
    /// `window` outlives it.
    Desktop(ui::Window& window, const DesktopOptions& options);

    /// Takes what the jobs have finished, draws, and gives the jobs what has changed.
    void draw_frame();
    /// Whether the last frame showed all there is: the reading or the error of the equation as it
    /// stands, and the finished picture of the last good one. Until then the window is woken again.
    [[nodiscard]] bool settled() const;

private:
    /// All that the picture depends on and that the window can change.
    struct Wanted {
        std::shared_ptr<const Formula> formula;
        Box clip;
        Camera camera;
        double w = 0.0;
        ParameterValues parameters;
        StopCriterion stop;
        glm::ivec2 size_px{0};
    };
    static bool same_picture(const Wanted& a, const Wanted& b);

    void take_formula();
    void show(std::shared_ptr<const Formula> formula);
    void show_parameters(const ParameterValues& opened);
    void take_double();
    void take_frame();
    void upload_frame();
    void follow_edits();
    void reset_view();
    [[nodiscard]] std::optional<Wanted> wanted_picture() const;
    void submit_picture();

    ui::Window& window_;
    ui::Texture texture_;
    ui::UiState state_;
    TraceSettings settings_;

    std::string submitted_text_;
    std::optional<std::string> answered_text_;  ///< what the newest reading or error is of
    std::optional<Surface> opening_;            ///< was picked, waits for its formula
    std::optional<Camera> home_;  ///< what Reset view goes back to, if it is not the default
    std::map<std::string, ui::ParameterSlider> known_sliders_;  ///< of every text so far
    std::shared_ptr<const Formula> shown_;                      ///< the last good one
    std::shared_ptr<const Formula> deepening_;  ///< `shown_`, when it waits for code in double
    std::optional<Wanted> submitted_;
    std::uint64_t request_ = 0;
    ui::Theme uploaded_theme_ = ui::Theme::Dark;
    bool uploaded_marks_ = false;

    FormulaJob formulas_;
    RenderJob pictures_;
};

/// Opens the window and runs until it is closed; returns the process's exit code. Without a display
/// or OpenGL it says so in one line on stderr and returns 1.
int run_desktop(const DesktopOptions& options);

}  // namespace zeroset
