#include "ui/actions/actions.hpp"

#include "engine/base/translation.hpp"
#include "ui/actions/errors.hpp"
#include "ui/actions/marker_moves.hpp"
#include "ui/actions/presentation.hpp"
#include "ui/actions/view_moves.hpp"
#include "ui/widgets/chord.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <vector>

namespace zeroset::ui {
namespace {

void flip(bool& flag) { flag = !flag; }

template <Command command>
void give(UiState& state) {
    state.wishes.command = command;
}

template <bool Layout::* flag>
void toggle_layout(UiState& state) {
    flip(state.edited.layout.*flag);
}

template <bool Layout::* flag>
bool is_layout(const UiState& state) {
    return state.edited.layout.*flag;
}

template <bool Document::* flag>
void toggle_document(UiState& state) {
    flip(state.edited.document.*flag);
}

template <bool Document::* flag>
bool is_document(const UiState& state) {
    return state.edited.document.*flag;
}

/// Switches one of axes, box and grid; new documents follow.
template <bool Document::* shown, bool Layout::* first>
void toggle_axes(UiState& state) {
    flip(state.edited.document.*shown);
    state.edited.layout.*first = state.edited.document.*shown;
}

bool has_all_axes(const UiState& state) {
    const Document& document = state.edited.document;
    return document.axes && document.clip_box && document.grid;
}

void toggle_all_axes(UiState& state) {
    Document& document = state.edited.document;
    Layout& layout = state.edited.layout;
    const bool on = !has_all_axes(state);
    document.axes = document.clip_box = document.grid = on;
    layout.axes = layout.clip_box = layout.grid = on;
}

bool has_smooth_edges(const UiState& state) {
    return state.edited.document.antialias != Antialias::None;
}

void toggle_smooth_edges(UiState& state) {
    state.edited.document.antialias = smooth_edges(!has_smooth_edges(state));
}

bool is_parallel(const std::optional<Camera>& camera) {
    return camera && camera->projection == Projection::Orthographic;
}

void switch_projection(UiState& state) {
    std::optional<Camera>& camera = state.edited.document.camera;
    if (!camera) camera = default_camera(state.edited.document.clip);
    const bool parallel = is_parallel(camera);
    camera->projection = parallel ? Projection::Perspective : Projection::Orthographic;
}

void switch_theme(UiState& state) {
    state.edited.theme = state.edited.theme == Theme::Dark ? Theme::Light : Theme::Dark;
    state.edited.follows_desktop = false;
}

template <Side side>
void look(UiState& state) {
    look_from(state, side);
}

template <int right, int up>
void turn(UiState& state) {
    orbit_step(state, {right, up});
}

template <WheelUse use>
void take_wheel(UiState& state) {
    state.edited.layout.wheel = use;
}

template <Language language>
void take_language(UiState& state) {
    state.edited.layout.language = language;
}

template <Language language>
bool has_language(const UiState& state) {
    return state.edited.layout.language == language;
}

template <WheelUse use>
bool has_wheel(const UiState& state) {
    return state.edited.layout.wheel == use;
}

template <ColorBy by>
void color_by(UiState& state) {
    ColorChoice& coloring = state.edited.document.coloring;
    coloring = {.by = by, .expression = coloring.expression, .lines = coloring.lines};
    if (by == ColorBy::Expression) state.edited.layout.look_open = true;
}

template <Look look>
void take_look(UiState& state) {
    state.edited.document.light.look = look;
}

template <Look look>
bool has_look(const UiState& state) {
    return state.edited.document.light.look == look;
}

template <Contours contours>
void take_contours(UiState& state) {
    state.edited.document.coloring.lines.contours = contours;
}

template <Contours contours>
bool has_contours(const UiState& state) {
    return state.edited.document.coloring.lines.contours == contours;
}

template <ColorBy by>
bool is_colored_by(const UiState& state) {
    return state.edited.document.coloring.by == by;
}

/// Shows or hides the clip handles. They are shown only while the clip section is open, so that
/// showing them opens it.
void switch_handles(UiState& state) {
    Layout& layout = state.edited.layout;
    layout.handles = !has_clip_handles(layout);
    layout.clip_open = layout.clip_open || layout.handles;
}

/// Shows another tracer beside the picture's.
void begin_comparison(UiState& state) {
    Inspection& wanted = state.edited.inspection;
    state.edited.layout.advanced_open = true;
    if (wanted.other) return;
    for (const TracerChoice& tracer : state.shown.tracers) {
        if (tracer.name == wanted.tracer) continue;
        wanted.other = tracer.name;
        return;
    }
}

bool compares(const UiState& state) { return state.edited.inspection.other.has_value(); }

void switch_comparison(UiState& state) {
    if (compares(state)) {
        state.edited.inspection.other.reset();
    } else {
        begin_comparison(state);
    }
}

bool shows_difference(const UiState& state) {
    return compares(state) && state.edited.inspection.difference;
}

void switch_difference(UiState& state) {
    state.edited.inspection.difference = !shows_difference(state);
    begin_comparison(state);
}

/// Asks for a marker at the pointer or, if that is elsewhere, at the middle of the picture.
void keep_marker(UiState& state) {
    state.wishes.click =
        PictureClick{.cursor = state.input.pointer.value_or(ViewPoint()), .at_once = true};
}

void select_next_marker(UiState& state) {
    const std::vector<Marker>& markers = state.edited.document.markers;
    auto next = std::ranges::find(markers, state.edited.selected_marker, &Marker::number);
    if (next != markers.end()) ++next;
    state.edited.selected_marker = (next == markers.end() ? markers.front() : *next).number;
    state.edited.layout.markers_open = true;
}

bool has_markers(const UiState& state) { return !state.edited.document.markers.empty(); }
bool has_selected_marker(const UiState& state) { return state.edited.selected_marker != 0; }

/// Keeps the camera as a view of the document, and shows that.
void save_view(UiState& state) {
    Document& edited = state.edited.document;
    if (edited.camera) add_view(edited.views, *edited.camera);
    state.edited.layout.camera_open = true;
}

bool has_camera(const UiState& state) { return state.edited.document.camera.has_value(); }

/// Opens the export page for a kind of file, or closes it if it shows that.
template <ExportKind kind>
void open_exports(UiState& state) {
    ExportPage& page = state.pages.exports;
    page.open = !(page.open && page.wish.kind == kind);
    page.begins = true;
    page.wish.kind = kind;
}

template <ExportKind kind>
bool has_exports(const UiState& state) {
    return state.pages.exports.open && state.pages.exports.wish.kind == kind;
}

constexpr const char* picture = marked("Picture");
constexpr const char* view = marked("View");
constexpr const char* document = marked("Document");
constexpr const char* window = marked("Window");

/// An action that takes one of several things of which one is always taken.
constexpr Action choice(const char* name, void (*run)(UiState&), bool (*is_on)(const UiState&)) {
    return {.section = picture, .name = name, .run = run, .is_on = is_on, .chooses = true};
}

constexpr Action language_choice(const char* name, void (*run)(UiState&),
                                 bool (*is_on)(const UiState&)) {
    return {.section = window,
            .name = name,
            .run = run,
            .is_on = is_on,
            .chooses = true,
            .for_readers = true};
}

// All actions: the sections in the order of the help, in each section the most used actions first.
constexpr auto table = std::to_array<Action>({
    {.section = picture,
     .name = "Reset the view",
     .keys = "R",
     .about = "look at the whole box again",
     .run = [](UiState& state) { state.wishes.reset_view = true; },
     .for_readers = true},
    {.section = picture,
     .name = "Parallel rays",
     .keys = "5",
     .about = "orthographic or perspective view",
     .run = switch_projection,
     .enabled = has_camera,
     .is_on = [](const UiState& state) { return is_parallel(state.edited.document.camera); },
     .for_readers = true},
    {.section = picture,
     .name = "Mark undecided pixels",
     .keys = "U",
     .run = toggle_document<&Document::mark_undecided>,
     .is_on = is_document<&Document::mark_undecided>},
    {.section = picture,
     .name = "Cost of each pixel",
     .about = "colors tell how often the formula was evaluated for a pixel",
     .run = [](UiState& state) { flip(state.edited.inspection.costs); },
     .is_on = [](const UiState& state) { return state.edited.inspection.costs; },
     .for_readers = true},
    {.section = picture,
     .name = "Another tracer beside",
     .about = "the same view by another method, with a divider to drag",
     .run = switch_comparison,
     .is_on = compares,
     .for_readers = true},
    {.section = picture,
     .name = "Difference of two tracers",
     .about = "marks pixels in which one shows something else than the other has proved",
     .run = switch_difference,
     .is_on = shows_difference,
     .for_readers = true},
    {.section = picture,
     .name = "Draw jumps in sign",
     .about = "draw also where f changes its sign in a jump, without a root",
     .run = toggle_document<&Document::jumps>,
     .is_on = is_document<&Document::jumps>},
    {.section = picture,
     .name = "Keep a marker",
     .keys = "M",
     .about = "keep a marker at the pointer, or in the middle; so does a click on a surface",
     .run = keep_marker,
     .in_fields = false,
     .for_readers = true},
    {.section = picture,
     .name = "Next marker",
     .keys = "Shift+M",
     .about = "select the next marker: Ctrl+C copies its coordinates",
     .run = select_next_marker,
     .enabled = has_markers,
     .repeats = true,
     .in_fields = false,
     .for_readers = true},
    {.section = picture,
     .name = "Remove the marker",
     .keys = "Delete",
     .about = "remove the selected marker",
     .run =
         [](UiState& state) {
             remove_marker(state.edited.document.markers, state.edited.selected_marker);
         },
     .enabled = has_selected_marker,
     .in_fields = false,
     .for_readers = true},
    choice("Color by surface and side", color_by<ColorBy::Plain>, is_colored_by<ColorBy::Plain>),
    choice("Color by normal", color_by<ColorBy::Normal>, is_colored_by<ColorBy::Normal>),
    choice("Color by height", color_by<ColorBy::Height>, is_colored_by<ColorBy::Height>),
    choice("Color by distance from the eye", color_by<ColorBy::Depth>,
           is_colored_by<ColorBy::Depth>),
    choice("Color by mean curvature", color_by<ColorBy::MeanCurvature>,
           is_colored_by<ColorBy::MeanCurvature>),
    choice("Color by Gaussian curvature", color_by<ColorBy::GaussianCurvature>,
           is_colored_by<ColorBy::GaussianCurvature>),
    choice("Color by length of the gradient", color_by<ColorBy::Gradient>,
           is_colored_by<ColorBy::Gradient>),
    choice("Color by an expression", color_by<ColorBy::Expression>,
           is_colored_by<ColorBy::Expression>),
    choice("Look: standard", take_look<Look::Standard>, has_look<Look::Standard>),
    choice("Look: Phong", take_look<Look::Phong>, has_look<Look::Phong>),
    choice("Look: matte", take_look<Look::Matte>, has_look<Look::Matte>),
    choice("Look: porcelain", take_look<Look::Porcelain>, has_look<Look::Porcelain>),
    choice("Look: metal", take_look<Look::Metal>, has_look<Look::Metal>),
    choice("Look: glass", take_look<Look::Glass>, has_look<Look::Glass>),
    choice("Look: clay", take_look<Look::Clay>, has_look<Look::Clay>),
    choice("Look: technical", take_look<Look::Technical>, has_look<Look::Technical>),
    choice("No contour lines", take_contours<Contours::None>, has_contours<Contours::None>),
    choice("Contour lines of height", take_contours<Contours::Height>,
           has_contours<Contours::Height>),
    choice("Contour lines of x, y and z", take_contours<Contours::Coordinates>,
           has_contours<Contours::Coordinates>),
    {.section = picture,
     .name = "Shadows",
     .run = toggle_document<&Document::shadows>,
     .is_on = is_document<&Document::shadows>,
     .for_readers = true},
    {.section = picture,
     .name = "Smooth edges",
     .run = toggle_smooth_edges,
     .is_on = has_smooth_edges,
     .for_readers = true},
    {.section = picture,
     .name = "Snap the marker",
     .keys = "N",
     .about = "move the selected marker to the nearest singular point, top or bottom of a surface; "
              "numerical",
     .run = [](UiState& state) { state.wishes.snap_marker = true; },
     .enabled = has_selected_marker,
     .in_fields = false,
     .for_readers = true},
    {.section = picture,
     .name = "Axes, box and grid",
     .keys = "Shift+A",
     .about = "all three, as in a textbook; new documents begin as the last one was",
     .run = toggle_all_axes,
     .is_on = has_all_axes,
     .for_readers = true},
    {.section = picture,
     .name = "Axes",
     .keys = "A",
     .about = "axes with numbers",
     .run = toggle_axes<&Document::axes, &Layout::axes>,
     .is_on = is_document<&Document::axes>,
     .for_readers = true},
    {.section = picture,
     .name = "Clip box",
     .keys = "B",
     .about = "the edges of the clip box",
     .run = toggle_axes<&Document::clip_box, &Layout::clip_box>,
     .is_on = is_document<&Document::clip_box>,
     .for_readers = true},
    {.section = picture,
     .name = "Grid",
     .keys = "G",
     .about = "a grid on the floor of the clip box",
     .run = toggle_axes<&Document::grid, &Layout::grid>,
     .is_on = is_document<&Document::grid>,
     .for_readers = true},
    {.section = picture,
     .name = "Handles",
     .keys = "H",
     .about = "handles that move the clip box, the sphere and the sections",
     .run = switch_handles,
     .is_on = [](const UiState& state) { return has_clip_handles(state.edited.layout); }},
    {.section = view,
     .name = "Frame the surface",
     .keys = "F, Home",
     .about = "find how far the surface reaches, and look at all of it",
     .run = [](UiState& state) { state.wishes.frame_surfaces = true; },
     .in_fields = false},
    {.section = view,
     .name = "Go to a point...",
     .about = "type a point to look at; Ctrl+K takes one, too, such as 1, 2, 3",
     .run = ask_for_point,
     .enabled = [](const UiState& state) { return !state.edited.layout.presents; }},
    {.section = view, .name = "View from the front", .keys = "1", .run = look<Side::Front>},
    {.section = view, .name = "View from the right", .keys = "3", .run = look<Side::Right>},
    {.section = view, .name = "View from above", .keys = "7", .run = look<Side::Top>},
    {.section = view, .name = "View from behind", .keys = "Ctrl+1", .run = look<Side::Back>},
    {.section = view, .name = "View from the left", .keys = "Ctrl+3", .run = look<Side::Left>},
    {.section = view, .name = "View from below", .keys = "Ctrl+7", .run = look<Side::Bottom>},
    {.section = view,
     .name = "Isometric view",
     .keys = "0",
     .about = "view from a corner, all axes alike",
     .run = look<Side::Corner>},
    {.section = view,
     .name = "Opposite view",
     .keys = "9",
     .about = "view from the opposite side",
     .run = look_from_opposite},
    {.section = view, .name = "Orbit to the left", .keys = "4", .run = turn<-1, 0>},
    {.section = view, .name = "Orbit to the right", .keys = "6", .run = turn<1, 0>},
    {.section = view, .name = "Orbit up", .keys = "8", .run = turn<0, 1>},
    {.section = view, .name = "Orbit down", .keys = "2", .run = turn<0, -1>},
    {.section = view,
     .name = "Zoom in",
     .keys = "+, =",
     .run = [](UiState& state) { zoom_step(state, 1.0); }},
    {.section = view,
     .name = "Zoom out",
     .keys = "-",
     .run = [](UiState& state) { zoom_step(state, -1.0); }},
    {.section = view,
     .name = "Turn freely",
     .keys = "T",
     .about = "dragging turns as a ball (trackball), not about what is up",
     .run = [](UiState& state) { set_trackball(state, !state.edited.document.trackball); },
     .is_on = is_document<&Document::trackball>},
    {.section = view,
     .name = "Save view",
     .keys = "V",
     .about = "keep where one looks from under a name, in the section Camera",
     .run = save_view,
     .enabled = has_camera},
    {.section = view,
     .name = "Copy the camera",
     .about = "as a line of text for another window or for --camera",
     .run = give<Command::CopyCamera>,
     .enabled = has_camera},
    {.section = view,
     .name = "Paste the camera",
     .about = "look from where a copied line of text says",
     .run = give<Command::PasteCamera>,
     .enabled = has_camera},
    {.section = view,
     .name = "Wheel zooms",
     .about = "so do two fingers on a touchpad",
     .run = take_wheel<WheelUse::Zoom>,
     .is_on = has_wheel<WheelUse::Zoom>,
     .chooses = true},
    {.section = view,
     .name = "Two fingers orbit",
     .about = "on a touchpad; Shift: they pan, Ctrl: they zoom",
     .run = take_wheel<WheelUse::Orbit>,
     .is_on = has_wheel<WheelUse::Orbit>,
     .chooses = true},
    {.section = view,
     .name = "Two fingers pan",
     .about = "on a touchpad; Shift: they orbit, Ctrl: they zoom",
     .run = take_wheel<WheelUse::Pan>,
     .is_on = has_wheel<WheelUse::Pan>,
     .chooses = true},
    {.section = view, .name = "x is up", .run = [](UiState& state) { set_up(state, {1, 0, 0}); }},
    {.section = view, .name = "y is up", .run = [](UiState& state) { set_up(state, {0, 1, 0}); }},
    {.section = view, .name = "z is up", .run = [](UiState& state) { set_up(state, {0, 0, 1}); }},
    {.section = document,
     .name = "Undo",
     .keys = "Ctrl+Z",
     .about = "undo anything, the view included",
     .run = give<Command::Undo>,
     .enabled = [](const UiState& state) { return state.shown.document.can_undo; },
     .repeats = true,
     .for_readers = true},
    {.section = document,
     .name = "Redo",
     .keys = "Ctrl+Shift+Z, Ctrl+Y",
     .run = give<Command::Redo>,
     .enabled = [](const UiState& state) { return state.shown.document.can_redo; },
     .repeats = true,
     .for_readers = true},
    {.section = document, .name = "New", .keys = "Ctrl+N", .run = give<Command::New>},
    {.section = document,
     .name = "Open...",
     .keys = "Ctrl+O",
     .about =
         "open a file, also one of SURFER, MathMod or POV-Ray; it can be dropped on the window",
     .run = give<Command::Open>},
    {.section = document,
     .name = "Open a folder...",
     .about = "the sessions and the files of other programs in it, to choose from like the gallery",
     .run = give<Command::OpenFolder>},
    {.section = document, .name = "Save", .keys = "Ctrl+S", .run = give<Command::Save>},
    {.section = document,
     .name = "Save as...",
     .keys = "Ctrl+Shift+S",
     .run = give<Command::SaveAs>},
    {.section = document,
     .name = "Save the picture...",
     .keys = "Ctrl+E",
     .about = "of any size; a PNG opens again as a session",
     .run = open_exports<ExportKind::Picture>,
     .is_on = has_exports<ExportKind::Picture>},
    {.section = document,
     .name = "Save a film...",
     .about = "a turn, changing parameters, a way of the camera",
     .run = open_exports<ExportKind::Film>,
     .is_on = has_exports<ExportKind::Film>},
    {.section = document,
     .name = "Save the mesh...",
     .about = "triangles, for printing and for 3D programs",
     .run = open_exports<ExportKind::Mesh>,
     .is_on = has_exports<ExportKind::Mesh>},
    {.section = document,
     .name = "Save a drawing...",
     .about = "lines for papers, SVG or PDF",
     .run = open_exports<ExportKind::Drawing>,
     .is_on = has_exports<ExportKind::Drawing>},
    {.section = document,
     .name = "Go to the error",
     .keys = "F8",
     .about = "the caret goes to where a row is wrong; again: the next one",
     .run = go_to_next_error,
     .enabled = has_errors},
    {.section = document,
     .name = "Stop saving",
     .about = "give up what is being saved",
     .run = [](UiState& state) { state.wishes.stop_export = true; },
     .enabled = [](const UiState& state) { return !state.shown.export_progress.name.empty(); }},
    {.section = document,
     .name = "Copy the picture",
     .keys = "Ctrl+Shift+C",
     .about = "the picture on the screen, to be pasted elsewhere",
     .run = [](UiState& state) { state.wishes.copy_picture = true; },
     .for_readers = true},
    {.section = document,
     .name = "Copy as text",
     .keys = "Ctrl+C",
     .about = "outside a row: copy all as text, or the selected marker's coordinates",
     .run = give<Command::Copy>,
     .in_fields = false},
    {.section = document,
     .name = "Copy as one line",
     .about = "copy the session as a line of text to be sent; paste it to open it",
     .run = give<Command::Share>},
    {.section = document,
     .name = "Paste",
     .keys = "Ctrl+V",
     .about = "outside a row: paste a document or statements",
     .run = give<Command::Paste>,
     .in_fields = false},
    {.section = window,
     .name = "Presentation",
     .keys = "F5",
     .about = "only the picture and sliders, large, on the full screen; Esc leaves it",
     .run = switch_presentation,
     .is_on = is_layout<&Layout::presents>},
    {.section = window,
     .name = "Leave the presentation",
     .keys = "Esc",
     .run = leave_presentation,
     .enabled = can_leave_presentation,
     .in_fields = false,
     .for_readers = true},
    {.section = window,
     .name = "Full screen",
     .keys = "F11",
     .run = [](UiState& state) { flip(state.edited.full_screen); },
     .is_on = [](const UiState& state) { return state.edited.full_screen; },
     .for_readers = true},
    {.section = window,
     .name = "Larger letters",
     .keys = "Ctrl++, Ctrl+=, Ctrl+Shift+=",
     .about = "letters and all that is measured by them",
     .run = [](UiState& state) { change_letters(state.edited.layout, 1); },
     .repeats = true,
     .for_readers = true},
    {.section = window,
     .name = "Smaller letters",
     .keys = "Ctrl+-",
     .run = [](UiState& state) { change_letters(state.edited.layout, -1); },
     .repeats = true,
     .for_readers = true},
    {.section = window,
     .name = "Letters as usual",
     .keys = "Ctrl+0",
     .run = [](UiState& state) { state.edited.layout.letters = 1.0F; },
     .for_readers = true},
    {.section = window,
     .name = "Fold the panel",
     .keys = "Ctrl+B",
     .run = toggle_layout<&Layout::folded>,
     .is_on = is_layout<&Layout::folded>},
    {.section = window,
     .name = "Section: View",
     .run = toggle_layout<&Layout::view_open>,
     .is_on = is_layout<&Layout::view_open>},
    {.section = window,
     .name = "Section: Camera",
     .run = toggle_layout<&Layout::camera_open>,
     .is_on = is_layout<&Layout::camera_open>},
    {.section = window,
     .name = "Section: Clip",
     .run = toggle_layout<&Layout::clip_open>,
     .is_on = is_layout<&Layout::clip_open>},
    {.section = window,
     .name = "Section: Space",
     .run = toggle_layout<&Layout::space_open>,
     .is_on = is_layout<&Layout::space_open>},
    {.section = window,
     .name = "Section: Look",
     .run = toggle_layout<&Layout::look_open>,
     .is_on = is_layout<&Layout::look_open>},
    {.section = window,
     .name = "Section: Light",
     .run = toggle_layout<&Layout::light_open>,
     .is_on = is_layout<&Layout::light_open>},
    {.section = window,
     .name = "Section: Markers",
     .run = toggle_layout<&Layout::markers_open>,
     .is_on = is_layout<&Layout::markers_open>},
    {.section = window,
     .name = "Section: Details",
     .about = "the search depth, figures of the picture",
     .run = toggle_layout<&Layout::details_open>,
     .is_on = is_layout<&Layout::details_open>},
    {.section = window,
     .name = "Section: Advanced",
     .about = "the tracer, another one beside it, what pixels cost",
     .run = toggle_layout<&Layout::advanced_open>,
     .is_on = is_layout<&Layout::advanced_open>},
    {.section = window,
     .name = "Light theme",
     .run = switch_theme,
     .is_on = [](const UiState& state) { return state.edited.theme == Theme::Light; },
     .for_readers = true},
    {.section = window,
     .name = "Theme of the desktop",
     .run = [](UiState& state) { flip(state.edited.follows_desktop); },
     .is_on = [](const UiState& state) { return state.edited.follows_desktop; }},
    {.section = window,
     .name = "Language of the desktop",
     .about = "of the window's texts; formulas are the same in all languages",
     .run = [](UiState& state) { state.edited.layout.language.reset(); },
     .is_on = [](const UiState& state) { return !state.edited.layout.language; },
     .chooses = true,
     .for_readers = true},
    language_choice("Language: English", take_language<Language::English>,
                    has_language<Language::English>),
    language_choice("Language: German", take_language<Language::German>,
                    has_language<Language::German>),
    language_choice("Language: French", take_language<Language::French>,
                    has_language<Language::French>),
    language_choice("Language: Spanish", take_language<Language::Spanish>,
                    has_language<Language::Spanish>),
    {.section = window,
     .name = "Gallery",
     .keys = "Ctrl+G",
     .about = "surfaces to begin with; arrows and Enter, or a click",
     .run = [](UiState& state) { flip(state.pages.gallery.open); },
     .is_on = [](const UiState& state) { return state.pages.gallery.open; }},
    {.section = window,
     .name = "Find a command...",
     .keys = "Ctrl+K",
     .about = "find a command, a surface or a recent file by a part of its name",
     .run = [](UiState& state) { flip(state.pages.commands.open); },
     .is_on = [](const UiState& state) { return state.pages.commands.open; }},
    {.section = window,
     .name = "Help",
     .keys = "F1",
     .about = "formulas and keys; again closes it",
     .run = [](UiState& state) { flip(state.pages.help.open); },
     .is_on = [](const UiState& state) { return state.pages.help.open; },
     .for_readers = true},
    {.section = window,
     .name = "Tour of the window",
     .run =
         [](UiState& state) {
             state.edited.layout.folded = false;
             state.pages.tour.step = 0;
         }},
    {.section = window,
     .name = "Quit",
     .keys = "Ctrl+Q",
     .run = give<Command::Quit>,
     .for_readers = true},
});

}  // namespace

std::span<const Action> actions() { return table; }

const Action& action_named(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Action::name);
    assert(found != table.end());
    return *found;
}

bool is_enabled(const Action& action, const UiState& state) {
    const bool is_for_readers = action.for_readers || action.section == view;
    if (state.edited.read_only && !is_for_readers) return false;
    return action.enabled == nullptr || action.enabled(state);
}

std::string shown_keys(const Action& action) {
    const std::string keys = action.keys;
    return keys_in_language(keys.substr(0, keys.find(", ")));
}

std::string described(const Action& action) {
    const std::string keys = shown_keys(action);
    return keys.empty() ? tr(action.name) : tr(action.name) + (" (" + keys + ")");
}

}  // namespace zeroset::ui
