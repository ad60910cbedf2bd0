#include "ui/actions/action_functions.hpp"
#include "ui/actions/action_parts.hpp"

#include <array>

// Actions of the window: its panel, pages, theme and language.

namespace zeroset::ui {
namespace {

template <bool Layout::* flag>
void toggle_layout(UiState& state) {
    flip(state.edited.layout.*flag);
}

template <bool Layout::* flag>
bool is_layout(const UiState& state) {
    return state.edited.layout.*flag;
}

void switch_theme(UiState& state) {
    state.edited.theme = state.edited.theme == Theme::Dark ? Theme::Light : Theme::Dark;
    state.edited.follows_desktop = false;
}

template <Language language>
void take_language(UiState& state) {
    state.edited.layout.language = language;
}

template <Language language>
bool has_language(const UiState& state) {
    return state.edited.layout.language == language;
}

constexpr Action language_choice(const char* name, void (*run)(UiState&),
                                 bool (*is_on)(const UiState&)) {
    return {.section = section::window,
            .name = name,
            .run = run,
            .is_on = is_on,
            .chooses = true,
            .for_readers = true};
}

constexpr auto window_table =
    std::to_array<Action>(
        {
            {.section = section::window,
             .name = "Presentation",
             .keys = "F5",
             .about = "only the picture and sliders, large, on the full screen; Esc leaves it",
             .run = switch_presentation,
             .is_on = is_layout<&Layout::presents>},
            {.section = section::window,
             .name = "Leave the presentation",
             .keys = "Esc",
             .run = leave_presentation,
             .enabled = can_leave_presentation,
             .in_fields = false,
             .for_readers = true},
            {.section = section::window,
             .name = "Full screen",
             .keys = "F11",
             .run = [](UiState& state) { flip(state.edited.full_screen); },
             .is_on = [](const UiState& state) { return state.edited.full_screen; },
             .for_readers = true},
            {.section = section::window,
             .name = "Larger letters",
             .keys = "Ctrl++, Ctrl+=, Ctrl+Shift+=",
             .about = "letters and all that is measured by them",
             .run = [](UiState& state) { change_letters(state.edited.layout, 1); },
             .repeats = true,
             .for_readers = true},
            {.section = section::window,
             .name = "Smaller letters",
             .keys = "Ctrl+-",
             .run = [](UiState& state) { change_letters(state.edited.layout, -1); },
             .repeats = true,
             .for_readers = true},
            {.section = section::window,
             .name = "Letters as usual",
             .keys = "Ctrl+0",
             .run = [](UiState& state) { state.edited.layout.letters = 1.0F; },
             .for_readers = true},
            {.section = section::window,
             .name = "Fold the panel",
             .keys = "Ctrl+B",
             .run = toggle_layout<&Layout::folded>,
             .is_on = is_layout<&Layout::folded>},
            {.section = section::window,
             .name = "Section: View",
             .run = toggle_layout<&Layout::view_open>,
             .is_on = is_layout<&Layout::view_open>},
            {.section = section::window,
             .name = "Section: Camera",
             .run = toggle_layout<&Layout::camera_open>,
             .is_on = is_layout<&Layout::camera_open>},
            {.section = section::window,
             .name = "Section: Clip",
             .run = toggle_layout<&Layout::clip_open>,
             .is_on = is_layout<&Layout::clip_open>},
            {.section = section::window,
             .name = "Section: Navigation",
             .run = toggle_layout<&Layout::space_open>,
             .is_on = is_layout<&Layout::space_open>},
            {.section = section::window,
             .name = "Section: Look",
             .run = toggle_layout<&Layout::look_open>,
             .is_on = is_layout<&Layout::look_open>},
            {.section = section::window,
             .name = "Section: Light",
             .run = toggle_layout<&Layout::light_open>,
             .is_on = is_layout<&Layout::light_open>},
            {.section = section::window,
             .name = "Section: Markers",
             .run = toggle_layout<&Layout::markers_open>,
             .is_on = is_layout<&Layout::markers_open>},
            {.section = section::window,
             .name = "Section: Details",
             .about = "the search depth, figures of the picture",
             .run = toggle_layout<&Layout::details_open>,
             .is_on = is_layout<&Layout::details_open>},
            {.section = section::window,
             .name = "Section: Expert",
             .about = "the tracer, another one beside it, what pixels cost",
             .run = toggle_layout<&Layout::advanced_open>,
             .is_on = is_layout<&Layout::advanced_open>},
            {.section = section::window,
             .name = "Light theme",
             .run = switch_theme,
             .is_on = [](const UiState& state) { return state.edited.theme == Theme::Light; },
             .for_readers = true},
            {.section = section::window,
             .name = "Begin with the last session",
             .about = "the next start opens the file used last, in place of a new document",
             .run = toggle_layout<&Layout::begins_with_last>,
             .is_on = is_layout<&Layout::begins_with_last>},
            {.section = section::window,
             .name = "Theme of the desktop",
             .run = [](UiState& state) { flip(state.edited.follows_desktop); },
             .is_on = [](const UiState& state) { return state.edited.follows_desktop; }},
            {.section = section::window,
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
            {.section = section::window,
             .name = "Gallery",
             .keys = "Ctrl+G",
             .about = "surfaces to begin with; arrows and Enter, or a click",
             .run = [](UiState& state) { flip(state.pages.gallery.open); },
             .is_on = [](const UiState& state) { return state.pages.gallery.open; }},
            {.section = section::window,
             .name = "Find a command...",
             .keys = "Ctrl+K",
             .about = "find a command, a surface or a recent file by a part of its name",
             .run = [](UiState& state) { flip(state.pages.commands.open); },
             .is_on = [](const UiState& state) { return state.pages.commands.open; }},
            {.section = section::window,
             .name = "Help",
             .keys = "F1",
             .about = "formulas and keys; again closes it",
             .run = [](UiState& state) { flip(state.pages.help.open); },
             .is_on = [](const UiState& state) { return state.pages.help.open; },
             .for_readers = true},
            {.section = section::window,
             .name = "Tour of the window",
             .run =
                 [](UiState& state) {
                     state.edited.layout.folded = false;
                     state.pages.tour.step = 0;
                 }},
            {.section = section::window,
             .name = "Quit",
             .keys = "Ctrl+Q",
             .run = give<Command::Quit>,
             .for_readers = true},
        });

}  // namespace

std::span<const Action> window_actions() { return window_table; }

}  // namespace zeroset::ui
