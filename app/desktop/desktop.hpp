#pragma once

#include "app/desktop/desktop_portal.hpp"
#include "app/desktop/extent_search.hpp"
#include "app/desktop/file_watch.hpp"
#include "app/desktop/histograms.hpp"
#include "app/desktop/latency_log.hpp"
#include "app/desktop/marker_snap.hpp"
#include "app/desktop/old_rows.hpp"
#include "app/desktop/picture_feed.hpp"
#include "app/desktop/point_inspector.hpp"
#include "app/desktop/preferences.hpp"
#include "app/desktop/session.hpp"
#include "app/desktop/tracer_comparison.hpp"
#include "app/desktop/wait_notice.hpp"
#include "app/exports/export_desk.hpp"
#include "app/gallery/gallery_cards.hpp"
#include "app/gallery/look_cards.hpp"
#include "app/gallery/view_cards.hpp"
#include "document/document.hpp"
#include "document/framing.hpp"
#include "document/json/collection.hpp"
#include "engine/base/language.hpp"
#include "engine/measure/extent.hpp"
#include "engine/render/render_request.hpp"
#include "engine/scene/settings.hpp"
#include "pipeline/file_access.hpp"
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
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// Everything the window starts with.
struct DesktopOptions {
    Document document;
    std::string path;                      ///< of the document's file; empty: it has none
    std::string note;                      ///< a message about the document, or empty
    std::optional<Collection> collection;  ///< to choose from first
    /// By which its documents read files, as the first one does.
    std::shared_ptr<FileAccess> files = std::make_shared<FileAccess>();
    TraceSettings settings;  ///< all settings but those that the document has
    ui::Theme theme = ui::Theme::Dark;
    bool follows_desktop = false;  ///< the theme follows the desktop's
    bool tour = false;             ///< begins with the tour of the window
    bool tour_seen = true;         ///< the tour was ended in another window
    bool on_desktop = false;       ///< the window is on a desktop, which may have a portal
    ui::Layout layout;
    Language desktop_language = Language::English;  ///< where the layout has none
    std::vector<const ui::Action*> actions;         ///< run before the first frame
    bool takes_keyboard = true;  ///< the first row has the keyboard, with its text selected
    bool keeps_files = true;     ///< see SessionOptions
    bool is_new = false;         ///< the document begins as new ones do, see ui::new_document
    bool has_new_edges = false;  ///< its edges are smooth if those of new ones are
    bool read_only = false;      ///< a session for a class, see ui::Edited
    std::string latency_log;     ///< file of a LatencyLog; empty: none
    bool opens_last = false;     ///< begins with the file used last, where there is one
    bool fit = false;            ///< looks at all of the surfaces first
    bool fits_box = true;        ///< `fit` also fits the clip box to the surfaces
    bool frames_box = false;     ///< the first view is of the whole box where that is drawn
    bool fits_itself = false;    ///< box and view follow the surfaces, see fit_by_itself
};

/// The window's content over time. The window's thread owns all of it; the jobs' threads only wake
/// that thread.
class Desktop {
public:
    /// `window` must outlive the desktop.
    Desktop(ui::Window& window, const DesktopOptions& options);

    /// Takes what the jobs have finished, draws a frame, and gives the jobs what has changed.
    void draw_frame();
    /// True if the last frame showed everything: the reading or the errors of the current rows, and
    /// the finished picture of what can be drawn. Until then the window is woken again.
    [[nodiscard]] bool settled() const;
    [[nodiscard]] bool closed() const { return session_.closed(); }
    /// Leaves the document to be restored by the next window, as this one cannot go on.
    void abandon() { session_.abandon(); }
    /// The preferences that the next window takes over.
    [[nodiscard]] Preferences preferences() const;
    /// Seconds since construction.
    [[nodiscard]] double now_s() const;
    /// Seconds until a frame must be drawn even if no event comes; nothing: none is due.
    [[nodiscard]] std::optional<double> due_s() const;

private:
    /// The part of the picture's look that the texture has.
    struct TextureLook {
        ui::Theme theme = ui::Theme::Dark;
        bool marks_undecided = false;

        bool operator==(const TextureLook&) const = default;
    };

    /// A view of the whole box, with the picture's aspect and the axes for which it was made.
    struct WholeView {
        Camera camera;
        double aspect = 1.0;
        bool axes = false;
    };
    /// The clip box that was last chosen by the surfaces, of the document whose first row this is.
    struct OwnBox {
        Box box;
        int row = 0;
    };

    /// Finds what the window waits for, for the panels to show.
    void follow_waiting();
    void take_formula();
    void show(const FormulaResult& result);
    void take_asked_box(const Program& program, Document& document);
    [[nodiscard]] bool has_own_box(const Document& document) const;
    void plan_own_fit();
    void follow_surfaces();
    void take_fit(const Framing& framing);
    void take_frame();
    void show_points();
    [[nodiscard]] TextureLook wanted_look() const;
    void upload_frame();
    void show_legend(const RenderResult& result);
    void show_contour_labels(const RenderResult& result);
    void follow_edits();
    void show_gallery_item();
    void read_rows();
    /// Says over the picture what was done; `saved`: the file, if that is one.
    void tell_done(std::string text, std::string saved = {});
    void follow_news();
    void find_view();
    void find_surfaces();
    void snap_marker();
    void frame(const Extent& extent);
    void frame_whole_box(double aspect);
    void keep_whole_box(double aspect);
    void note_whole_view(const Document& document);
    [[nodiscard]] bool shows_whole_box() const;
    void play();
    /// Has saved what is wished for, and tells of what has ended.
    void follow_exports();
    /// The source of all files that are made; nothing while the rows have an error.
    [[nodiscard]] std::optional<ExportSubject> export_subject() const;
    [[nodiscard]] bool waits_for_picture() const;
    [[nodiscard]] std::optional<PictureRequest> wanted_picture() const;
    void tell_refusals(const PictureRequest& wanted);
    void submit_picture();
    void log_submission(std::uint64_t before);

    ui::Window& window_;
    ui::Texture texture_;
    TextureLook uploaded_;
    ui::UiState state_;
    std::shared_ptr<FileAccess> files_;
    std::shared_ptr<const FieldSource> gallery_files_;  ///< that its items may name when edited
    Session session_;
    std::string told_refusals_;  ///< why chosen tracers draw nothing; empty: they draw
    Language desktop_language_;
    TraceSettings settings_;

    PointInspector inspector_;
    WaitNotice wait_notice_;
    OldRows old_rows_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double played_s_ = 0.0;         ///< when sliders were moved on last
    std::optional<Box> asked_box_;  ///< by a plotting command of the text that is shown
    ExtentSearch search_;
    MarkerSnap snap_;
    bool fits_box_;                        ///< the next search's extent also fits the clip box
    bool frames_box_;                      ///< the whole box is to be looked at, where it is drawn
    std::optional<WholeView> whole_view_;  ///< the last one
    std::optional<OwnBox> own_box_;
    std::optional<double> own_fit_due_s_;  ///< when box and view are to follow the surfaces
    int own_fit_row_ = 0;                  ///< the first row of the document that it is for
    bool search_is_own_ = false;           ///< the search that runs is for that
    bool fits_itself_;                     ///< the first text's box and view do
    double told_s_ = 0.0;  ///< when news was told last; it leaves some seconds later
    std::unique_ptr<LatencyLog> latency_;  ///< nullptr: latency is not logged
    std::optional<DesktopPortal> portal_;  ///< only for a window on a desktop

    // Their threads wake the window, so that they end first.
    GalleryCards cards_;
    LookCards look_cards_;
    ViewCards view_cards_;
    PictureFeed feed_;
    TracerComparison comparison_;
    Histograms histograms_;
    ExportDesk exports_;
    std::optional<FileWatch> watch_;  ///< only for a window on a desktop
};

/// Opens the window and runs until it is closed. Returns one sentence as error if there is no
/// display or no OpenGL, or if the driver has lost the window.
std::expected<void, std::string> run_desktop(const DesktopOptions& options);

}  // namespace zeroset
