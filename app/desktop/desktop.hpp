#pragma once

#include "app/desktop/desktop_portal.hpp"
#include "app/desktop/gallery_cards.hpp"
#include "app/desktop/latency_log.hpp"
#include "app/desktop/pointing.hpp"
#include "app/desktop/preferences.hpp"
#include "app/desktop/session.hpp"
#include "app/desktop/waiting.hpp"
#include "document/document.hpp"
#include "engine/measure/extent.hpp"
#include "engine/render/render_job.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/formula_job.hpp"
#include "pipeline/picture_request.hpp"
#include "ui/actions/actions.hpp"
#include "ui/model/ui_state.hpp"
#include "ui/window/texture.hpp"
#include "ui/window/window.hpp"

#include <glm/ext/vector_int2.hpp>

#include <chrono>
#include <cstdint>
#include <expected>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// What the window starts with.
struct DesktopOptions {
    Document document;
    std::string path;        ///< of the document's file; empty: none
    std::string note;        ///< what is to be said of the document; or empty
    TraceSettings settings;  ///< but for what the document says
    ui::Theme theme = ui::Theme::Dark;
    bool follows_desktop = false;  ///< the theme is the desktop's wish
    bool on_desktop = false;       ///< there may be one to ask
    ui::Layout layout;
    std::vector<const ui::Action*> actions;  ///< run before the first frame
    bool takes_keyboard = true;              ///< the first row can be typed over at once
    bool keeps_files = true;                 ///< as in SessionOptions
    std::string latency_log;                 ///< the file of a LatencyLog; empty: none
    bool fit = false;                        ///< looks at all of the surfaces first
    bool fits_box = true;                    ///< and fits the clip box to them
};

/// The window's content over time. Everything here belongs to the window's thread; the jobs'
/// threads only wake it.
class Desktop {
public:
    /// `window` outlives it.
    Desktop(ui::Window& window, const DesktopOptions& options);

    /// Takes what the jobs have finished, draws, and gives the jobs what has changed.
    void draw_frame();
    /// Whether the last frame showed all there is: the reading or the errors of the rows as they
    /// stand, and the finished picture of what can be drawn. Until then the window is woken again.
    [[nodiscard]] bool settled() const;
    [[nodiscard]] bool closed() const { return session_.closed(); }
    /// The window cannot go on: the document is left to be restored by the next.
    void abandon() { session_.abandon(); }
    /// What the next window takes over.
    [[nodiscard]] Preferences preferences() const;
    /// Seconds since it was made.
    [[nodiscard]] double now_s() const;
    /// Seconds until there is something to draw or to do though nothing happens.
    [[nodiscard]] std::optional<double> due_s() const;

private:
    /// Finds what the window waits for, for the panels to tell.
    void follow_waiting();
    void take_formula();
    void show(const FormulaResult& result);
    void take_double();
    void take_frame();
    void upload_frame();
    void show_legend(const RenderResult& result);
    /// What is behind the picture that is shown, unless another is on its way.
    [[nodiscard]] const PictureRequest* behind_picture() const;
    void follow_edits();
    void show_gallery_item();
    void find_view();
    void find_surfaces();
    void frame(const Extent& extent);
    void submit_rows();
    void play();
    [[nodiscard]] bool waits_for_picture() const;
    [[nodiscard]] std::optional<PictureRequest> wanted_picture() const;
    void submit_picture();
    void log_submission(std::uint64_t before);

    ui::Window& window_;
    ui::Texture texture_;
    ui::UiState state_;
    Session session_;
    TraceSettings settings_;

    std::optional<Sheet> submitted_rows_;
    ColorChoice submitted_choice_;
    ColorChoice answered_choice_;
    std::shared_ptr<const ColorFormulas> colors_;  ///< for `shown_`
    Pointing pointing_;
    std::optional<Sheet> answered_rows_;        ///< what the newest reading is of
    std::shared_ptr<const Formula> shown_;      ///< of the newest reading
    std::shared_ptr<const Formula> deepening_;  ///< `shown_`, when it waits for code in double
    std::optional<PictureRequest> submitted_;
    std::uint64_t request_ = 0;
    std::uint64_t pictured_request_ = 0;  ///< the newest of which a pass was shown
    bool pictured_fully_ = false;
    // Of the formula of which a picture was shown last, and a full one.
    std::string pictured_text_, figures_text_;
    Waiting waiting_;
    ui::Theme uploaded_theme_ = ui::Theme::Dark;
    bool uploaded_marks_ = false;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double played_s_ = 0.0;

    /// Where the surfaces of `measured_` lie, while that is being found.
    std::future<Extent> extent_;
    std::optional<PictureRequest> measured_;
    bool fits_box_;
    unsigned done_gesture_ = 0;            ///< after which the note on what was done goes
    std::unique_ptr<LatencyLog> latency_;  ///< where one is wanted
    std::optional<DesktopPortal> portal_;  ///< of a window on a desktop

    GalleryCards cards_;
    FormulaJob formulas_;
    RenderJob pictures_;
};

/// Opens the window and runs until it is closed. Without a display or OpenGL, and when the driver
/// has lost the window, one sentence that says so.
std::expected<void, std::string> run_desktop(const DesktopOptions& options);

}  // namespace zeroset
