#pragma once

#include "ui/model/ui_state.hpp"

#include <span>
#include <string>
#include <string_view>

namespace zeroset::ui {

/// Something that a person does by its name: with its keys, in a menu, in the palette. The table
/// of all actions is the one place that says which keys there are; the help shows it, too.
struct Action {
    const char* section;     ///< of the help
    const char* name;        ///< what it does, in a few words; each has its own
    const char* keys = "";   ///< as for chords_of; the first are shown
    const char* about = "";  ///< for the help, where the name does not say it all
    void (*run)(UiState&) = nullptr;
    bool (*enabled)(const UiState&) = nullptr;  ///< absent: always
    bool (*is_on)(const UiState&) = nullptr;    ///< of a switch or a choice
    bool repeats = false;                       ///< while its keys are held
    bool chooses = false;   ///< one of several: it is taken in place of the others
    bool in_fields = true;  ///< its keys act while a field has the keyboard, too
};

/// All of them, section by section.
std::span<const Action> actions();

/// The one with this name, which there must be.
const Action& action_named(std::string_view name);

bool is_enabled(const Action& action, const UiState& state);

/// The keys of `action` that are shown; empty: none.
std::string shown_keys(const Action& action);

/// "Name (Ctrl+N)".
std::string described(const Action& action);

}  // namespace zeroset::ui
