#include "ui/actions/action_functions.hpp"
#include "ui/actions/action_parts.hpp"
#include "ui/actions/view_moves.hpp"

#include <array>

// Actions of the view: where one looks from, and how.

namespace zeroset::ui {
namespace {

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

template <WheelUse use>
bool has_wheel(const UiState& state) {
    return state.edited.layout.wheel == use;
}

/// Keeps the camera as a view of the document, and shows that.
void save_view(UiState& state) {
    Document& edited = state.edited.document;
    if (edited.camera) add_view(edited.views, *edited.camera);
    state.edited.layout.camera_open = true;
}

constexpr auto view_table = std::to_array<Action>({
    {.section = section::view,
     .name = "Frame the surface",
     .keys = "F, Home",
     .about = "find how far the surface reaches, and look at all of it",
     .run = [](UiState& state) { state.wishes.frame_surfaces = true; },
     .in_fields = false},
    {.section = section::view,
     .name = "Go to a point...",
     .about = "type a point to look at; Ctrl+K takes one, too, such as 1, 2, 3",
     .run = ask_for_point,
     .enabled = [](const UiState& state) { return !state.edited.layout.presents; }},
    {.section = section::view,
     .name = "View from the front",
     .keys = "1",
     .run = look<Side::Front>},
    {.section = section::view,
     .name = "View from the right",
     .keys = "3",
     .run = look<Side::Right>},
    {.section = section::view, .name = "View from above", .keys = "7", .run = look<Side::Top>},
    {.section = section::view,
     .name = "View from behind",
     .keys = "Ctrl+1",
     .run = look<Side::Back>},
    {.section = section::view,
     .name = "View from the left",
     .keys = "Ctrl+3",
     .run = look<Side::Left>},
    {.section = section::view,
     .name = "View from below",
     .keys = "Ctrl+7",
     .run = look<Side::Bottom>},
    {.section = section::view,
     .name = "Isometric view",
     .keys = "0",
     .about = "view from a corner, all axes alike",
     .run = look<Side::Corner>},
    {.section = section::view,
     .name = "Opposite view",
     .keys = "9",
     .about = "view from the opposite side",
     .run = look_from_opposite},
    {.section = section::view, .name = "Orbit to the left", .keys = "4", .run = turn<-1, 0>},
    {.section = section::view, .name = "Orbit to the right", .keys = "6", .run = turn<1, 0>},
    {.section = section::view, .name = "Orbit up", .keys = "8", .run = turn<0, 1>},
    {.section = section::view, .name = "Orbit down", .keys = "2", .run = turn<0, -1>},
    {.section = section::view,
     .name = "Zoom in",
     .keys = "+, =",
     .run = [](UiState& state) { zoom_step(state, 1.0); }},
    {.section = section::view,
     .name = "Zoom out",
     .keys = "-",
     .run = [](UiState& state) { zoom_step(state, -1.0); }},
    {.section = section::view,
     .name = "Turn freely",
     .keys = "T",
     .about = "dragging turns as a ball (trackball), not about what is up",
     .run = [](UiState& state) { set_trackball(state, !state.edited.document.trackball); },
     .is_on = is_document<&Document::trackball>},
    {.section = section::view,
     .name = "Save view",
     .keys = "V",
     .about = "keep where one looks from under a name, in the section Camera",
     .run = save_view,
     .enabled = has_camera},
    {.section = section::view,
     .name = "Copy the camera",
     .about = "as a line of text for another window or for --camera",
     .run = give<Command::CopyCamera>,
     .enabled = has_camera},
    {.section = section::view,
     .name = "Paste the camera",
     .about = "look from where a copied line of text says",
     .run = give<Command::PasteCamera>,
     .enabled = has_camera},
    {.section = section::view,
     .name = "Wheel zooms",
     .about = "so do two fingers on a touchpad",
     .run = take_wheel<WheelUse::Zoom>,
     .is_on = has_wheel<WheelUse::Zoom>,
     .chooses = true},
    {.section = section::view,
     .name = "Two fingers orbit",
     .about = "on a touchpad; Shift: they pan, Ctrl: they zoom",
     .run = take_wheel<WheelUse::Orbit>,
     .is_on = has_wheel<WheelUse::Orbit>,
     .chooses = true},
    {.section = section::view,
     .name = "Two fingers pan",
     .about = "on a touchpad; Shift: they orbit, Ctrl: they zoom",
     .run = take_wheel<WheelUse::Pan>,
     .is_on = has_wheel<WheelUse::Pan>,
     .chooses = true},
    {.section = section::view,
     .name = "x is up",
     .run = [](UiState& state) { set_up(state, {1, 0, 0}); }},
    {.section = section::view,
     .name = "y is up",
     .run = [](UiState& state) { set_up(state, {0, 1, 0}); }},
    {.section = section::view,
     .name = "z is up",
     .run = [](UiState& state) { set_up(state, {0, 0, 1}); }},
});

}  // namespace

std::span<const Action> view_actions() { return view_table; }

}  // namespace zeroset::ui
