#pragma once

#include "document/document.hpp"
#include "document/play.hpp"
#include "document/sheet.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/language/help.hpp"
#include "engine/measure/probe.hpp"
#include "engine/scene/coloring.hpp"
#include "engine/scene/precision.hpp"
#include "engine/view/camera.hpp"
#include "ui/model/clip_handles.hpp"
#include "ui/model/dialog_state.hpp"
#include "ui/model/theme.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_int2.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {

/// A surface of the gallery.
struct GalleryEntry {
    std::string title;
    std::string equation;
    std::string about;  ///< one sentence
    std::string group = {};
    std::string source = {};
};

/// A popup with a field to type into. Keys that come before the field has the keyboard wait for it.
struct TypingPopup {
    bool open = false;
    int frames = 0;             ///< for which it has been drawn
    bool has_keyboard = false;  ///< the field had it in the last frame
};

/// The page on which the gallery is looked through.
struct GalleryPage : TypingPopup {
    std::string search;        ///< words that are looked for
    std::size_t selected = 0;  ///< a line of the gallery
    bool follow = false;       ///< the selection is to be scrolled into sight

    // Set by the page for the owner of the pictures.
    std::vector<std::size_t> visible;  ///< lines of the gallery whose pictures are in sight
    glm::ivec2 picture_px{0};
    /// Set by that owner: OpenGL's name of a line's picture, where it is there.
    std::map<std::size_t, unsigned int> pictures;
};

/// The field in which commands are found by a part of their name.
struct CommandPalette : TypingPopup {
    std::string typed;
    std::size_t selected = 0;  ///< of the lines found
    bool follow = false;       ///< the selection is to be scrolled into sight
};

/// What the status line says of the picture. The figures are those of the last full picture.
struct PictureStatus {
    bool tracing = false;  ///< a finer picture than the one shown is on its way
    int width_px = 0;      ///< 0: no full picture yet
    int height_px = 0;
    double frame_ms = 0.0;
    CertificateCounts counts;
    Precision precision = Precision::Float;
};

/// The picture that is shown, fine or coarse, and the camera that it was taken with; no frame
/// before the first.
struct ShownPicture {
    std::shared_ptr<const Framebuffer> frame;
    Camera camera;
};

/// What is known of the point under the pointer.
struct PointedFacts {
    PointFacts facts;
    int row = 0;              ///< of the list, whose surface it is
    double pixel_size = 0.0;  ///< how far apart neighbouring pixels are there, world units
};

/// A press of the button over the picture that was no drag.
struct PictureClick {
    glm::dvec2 cursor{0.0};  ///< see PointerMotion
    int marker = 0;          ///< number of the one that was clicked; 0: none
    bool again = false;      ///< the second of a double click
    bool at_once = false;    ///< no second one follows: it came from the keyboard
};

/// What is done to the document as a whole; the owner does it.
enum class Command : std::uint8_t { New, Open, Save, SaveAs, Undo, Redo, Copy, Paste, Quit };

/// The keyboard goes to a row.
struct RowFocus {
    enum class Caret : std::uint8_t { All, Start, End };
    int row = 0;  ///< its id
    Caret caret = Caret::End;
};

/// A short smooth move of the document's camera, see ui/view_moves.
struct ViewMove {
    Camera from, to;
    Camera last;  ///< what it made of the document's camera
    double elapsed_s = 0.0;
    bool begun = false;
};

/// How the window is laid out.
struct Layout {
    float panel_em = 27.0F;  ///< width of the left panel, as far as the window has room
    bool folded = false;
    bool view_open = true;  ///< the section of the view's settings
    bool look_open = false;
    bool markers_open = false;
    bool space_open = false;
    bool clip_open = false;
    bool edges_open = false;  ///< of the clip box, each by itself
    bool handles = true;      ///< in the picture, while the section of the clip box is open

    bool operator==(const Layout&) const = default;
};

inline bool has_clip_handles(const Layout& layout) { return layout.handles && layout.clip_open; }

/// The name of w among the sliders; no parameter is called so.
inline constexpr const char* w_name = "w";

/// Everything the panels show and edit. Plain data, used by the window's thread only.
struct UiState {
    // Edited by the panels.
    Document document = empty_document();
    std::map<std::string, PlayState> playing;  ///< the sliders that play, by name
    std::optional<ViewMove> move;              ///< while one is under way
    std::optional<HandleDrag> handle_drag;     ///< while a handle of the clip region is held
    unsigned gesture = 0;                      ///< grows with each press of a button
    bool held = false;                         ///< a button is down
    Layout layout;
    Theme theme = Theme::Dark;
    bool follows_desktop = true;  ///< the theme is the desktop's wish, where there is one
    bool show_help = false;
    std::string help_filter;
    GalleryPage gallery_page;
    CommandPalette command_palette;

    // Wishes: set by a panel, cleared by whoever fulfils them.
    std::optional<RowFocus> focus;       ///< by the list of statements
    std::optional<int> reload;           ///< a row whose field must show a text set elsewhere
    bool frame_surfaces = false;         ///< fulfilled by the owner, which has the formula
    bool reset_view = false;             ///< fulfilled by the owner, which knows the first view
    std::optional<std::size_t> surface;  ///< a line of `gallery` was picked
    std::optional<Command> command;
    std::optional<PictureClick> click;     ///< by the owner: it knows what is under it
    std::optional<std::string> open_path;  ///< a recent file was picked
    Dialogs dialogs;

    // Shown by the panels, set by the owner.
    std::vector<GalleryEntry> gallery;
    std::vector<HelpSection> language_help;
    std::map<int, RowReport> reports;     ///< how each row was read, by its id
    std::vector<int> surface_rows;        ///< the row of each surface of the last reading
    std::vector<std::string> parameters;  ///< that have a slider
    std::string name;                     ///< of the document
    bool unsaved = false;
    bool can_undo = false;
    bool can_redo = false;
    std::vector<std::string> recent;  ///< paths of recent documents, the newest first
    std::string note;  ///< for the status line: what is not as it should be; or empty
    std::string done;  ///< for the status line: what was just done; or empty
    bool uses_w = false;
    /// The picture is of another text than the rows', and so little of it is seen: 0 (all) to 1.
    float dimmed = 0.0F;
    bool hides_figures = false;  ///< `picture`'s are of another text
    std::string doing;           ///< for the status line: what is going on with the text; or empty
    PictureStatus picture;
    ShownPicture shown;

    /// Size of the area the picture fills, framebuffer pixels; set by draw_viewport.
    glm::ivec2 viewport_px{0};
    /// Where the pointer rests over the picture, see PointerMotion; set by draw_viewport.
    std::optional<glm::dvec2> pointer;
    std::optional<PointedFacts> pointed;  ///< what is there; set by the owner
    int selected_marker = 0;              ///< its number; 0: none
    std::optional<Legend> legend;         ///< of the picture that is shown; set by the owner
    std::string color_error;  ///< what is wrong with the expression of the colours; or empty
    int typing_row = 0;       ///< the row whose field has the keyboard; 0: none. Set by the list.
};

}  // namespace zeroset::ui
