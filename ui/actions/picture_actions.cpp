#include "ui/actions/action_parts.hpp"
#include "ui/model/section_axis.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

// Actions on what the picture shows: markers, colours, looks, cuts, other tracers.

namespace zeroset::ui {
namespace {

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
    const bool smooth = !has_smooth_edges(state);
    state.edited.document.antialias = smooth_edges(smooth);
    state.edited.layout.smooth_edges = smooth;
}

bool is_parallel(const std::optional<Camera>& camera) {
    return camera && camera->projection == Projection::Orthographic;
}

void switch_projection(UiState& state) {
    std::optional<Camera>& camera = state.edited.document.camera;
    if (!camera) {
        const Document& document = state.edited.document;
        camera = default_camera(document.clip, 1.0, document.up, stretch_of(document));
    }
    const bool parallel = is_parallel(camera);
    camera->projection = parallel ? Projection::Perspective : Projection::Orthographic;
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

void cut_by_section(UiState& state) {
    add_section(state.edited.document);
    state.wishes.section = &Layout::clip_open;
}

bool has_ball(const UiState& state) { return state.edited.document.region.ball.has_value(); }

/// Clips to the ball in the box, or no more to any.
void switch_ball(UiState& state) {
    const Box& box = state.edited.document.clip;
    std::optional<Ball>& ball = state.edited.document.region.ball;
    ball = ball ? std::nullopt
                : std::optional(Ball{.centre = box.centre(), .radius = 0.5 * box.size()});
    if (ball) state.wishes.section = &Layout::clip_open;
}

bool has_room_for_light(const UiState& state) {
    return state.edited.document.light.lights.size() < max_lights;
}

void add_light(UiState& state) {
    std::vector<Light>& lights = state.edited.document.light.lights;
    lights.push_back({});
    if (lights.size() > 1) lights.back().towards = {0.8, -0.1, 0.45};
    state.wishes.section = &Layout::light_open;
}

bool has_soft_shadows(const UiState& state) {
    const Document& document = state.edited.document;
    const auto broad = [](const Light& light) { return light.radius_deg > 0.0; };
    return document.shadows && std::ranges::any_of(document.light.lights, broad);
}

/// Makes the shadows soft by lights with a size, or hard again.
void switch_soft_shadows(UiState& state) {
    constexpr double usual_radius_deg = 5.0;
    Document& document = state.edited.document;
    const bool soft = !has_soft_shadows(state);
    if (soft && document.light.lights.empty()) add_light(state);
    for (Light& light : document.light.lights)
        light.radius_deg = soft ? usual_radius_deg : 0.0;
    document.shadows = true;
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

/// An action that takes one of several things of which one is always taken.
constexpr Action choice(const char* name, void (*run)(UiState&), bool (*is_on)(const UiState&)) {
    return {.section = section::picture, .name = name, .run = run, .is_on = is_on, .chooses = true};
}

constexpr auto picture_table = std::to_array<Action>({
    {.section = section::picture,
     .name = "Reset the view",
     .keys = "R",
     .about = "look at the whole box again",
     .run = [](UiState& state) { state.wishes.reset_view = true; },
     .for_readers = true},
    {.section = section::picture,
     .name = "Parallel rays",
     .keys = "5",
     .about = "orthographic or perspective view",
     .run = switch_projection,
     .enabled = has_camera,
     .is_on = [](const UiState& state) { return is_parallel(state.edited.document.camera); },
     .for_readers = true},
    {.section = section::picture,
     .name = "Mark undecided pixels",
     .keys = "U",
     .run = toggle_document<&Document::mark_undecided>,
     .is_on = is_document<&Document::mark_undecided>},
    {.section = section::picture,
     .name = "Cost of each pixel",
     .about = "colors tell how often the formula was evaluated for a pixel",
     .run = [](UiState& state) { flip(state.edited.inspection.costs); },
     .is_on = [](const UiState& state) { return state.edited.inspection.costs; },
     .for_readers = true},
    {.section = section::picture,
     .name = "Another tracer beside",
     .about = "the same view by another method, with a divider to drag",
     .run = switch_comparison,
     .is_on = compares,
     .for_readers = true},
    {.section = section::picture,
     .name = "Difference of two tracers",
     .about = "marks pixels in which one shows something else than the other has proved",
     .run = switch_difference,
     .is_on = shows_difference,
     .for_readers = true},
    {.section = section::picture,
     .name = "Draw jumps in sign",
     .about = "draw also where f changes its sign in a jump, without a root",
     .run = toggle_document<&Document::jumps>,
     .is_on = is_document<&Document::jumps>},
    {.section = section::picture,
     .name = "Keep a marker",
     .keys = "M",
     .about = "keep a marker at the pointer, or in the middle; so does a click on a surface",
     .run = keep_marker,
     .in_fields = false,
     .for_readers = true},
    {.section = section::picture,
     .name = "Next marker",
     .keys = "Shift+M",
     .about = "select the next marker: Ctrl+C copies its coordinates",
     .run = select_next_marker,
     .enabled = has_markers,
     .repeats = true,
     .in_fields = false,
     .for_readers = true},
    {.section = section::picture,
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
    {.section = section::picture,
     .name = "Shadows",
     .run = toggle_document<&Document::shadows>,
     .is_on = is_document<&Document::shadows>,
     .for_readers = true},
    {.section = section::picture,
     .name = "Soft shadows",
     .about = "of lights of one's own that have a size, see the section Light",
     .run = switch_soft_shadows,
     .is_on = has_soft_shadows},
    {.section = section::picture,
     .name = "Add a light",
     .about = "up to four, in place of the look's own",
     .run = add_light,
     .enabled = has_room_for_light},
    {.section = section::picture,
     .name = "Add a section",
     .about = "cut the surfaces by a plane, to look inside",
     .run = cut_by_section,
     .enabled =
         [](const UiState& state) {
             return state.edited.document.region.sections.size() < max_sections;
         }},
    {.section = section::picture,
     .name = "Clip to a sphere",
     .about = "show only what is in a sphere",
     .run = switch_ball,
     .is_on = has_ball},
    {.section = section::picture,
     .name = "Smooth edges",
     .run = toggle_smooth_edges,
     .is_on = has_smooth_edges,
     .for_readers = true},
    {.section = section::picture,
     .name = "Snap the marker",
     .keys = "N",
     .about = "move the selected marker to the nearest singular point, top or bottom of a surface; "
              "numerical",
     .run = [](UiState& state) { state.wishes.snap_marker = true; },
     .enabled = has_selected_marker,
     .in_fields = false,
     .for_readers = true},
    {.section = section::picture,
     .name = "Axes, box and grid",
     .keys = "Shift+A",
     .about = "all three, as in a textbook; new documents begin as the last one was",
     .run = toggle_all_axes,
     .is_on = has_all_axes,
     .for_readers = true},
    {.section = section::picture,
     .name = "Axes",
     .keys = "A",
     .about = "axes with numbers",
     .run = toggle_axes<&Document::axes, &Layout::axes>,
     .is_on = is_document<&Document::axes>,
     .for_readers = true},
    {.section = section::picture,
     .name = "Clip box",
     .keys = "B",
     .about = "the edges of the clip box",
     .run = toggle_axes<&Document::clip_box, &Layout::clip_box>,
     .is_on = is_document<&Document::clip_box>,
     .for_readers = true},
    {.section = section::picture,
     .name = "Grid",
     .keys = "G",
     .about = "a grid on the floor of the clip box",
     .run = toggle_axes<&Document::grid, &Layout::grid>,
     .is_on = is_document<&Document::grid>,
     .for_readers = true},
    {.section = section::picture,
     .name = "Handles",
     .keys = "H",
     .about = "handles that move the clip box, the sphere and the sections",
     .run = switch_handles,
     .is_on = [](const UiState& state) { return has_clip_handles(state.edited.layout); }},
});

}  // namespace

std::span<const Action> picture_actions() { return picture_table; }

}  // namespace zeroset::ui
