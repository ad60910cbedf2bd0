#pragma once

#include "ui/model/ui_state.hpp"

#include <span>
#include <string>
#include <string_view>

namespace zeroset::ui {

/// A command that the user runs by its keys, from a menu or from the palette. The table of actions
/// is the only place that assigns keys; the help is generated from it.
struct Action {
    const char* section;     ///< section of the help
    const char* name;        ///< what the action does, in a few words; unique
    const char* keys = "";   ///< list of chords as for chords_of; the first one is shown
    const char* about = "";  ///< additional text for the help, if the name does not say it all
    void (*run)(UiState&) = nullptr;
    bool (*enabled)(const UiState&) = nullptr;  ///< nullptr: always
    bool (*is_on)(const UiState&) = nullptr;    ///< state of a switch or a choice; nullptr: neither
    bool repeats = false;                       ///< runs again while its keys are held
    bool chooses = false;   ///< one of several alternatives: choosing it replaces the others
    bool in_fields = true;  ///< its keys also act while a text field has the keyboard
    /// A read-only session keeps it, and all those in the section of the view.
    bool for_readers = false;
};

/// Returns all actions, section by section.
std::span<const Action> actions();

/// Returns the action with this name, which must exist.
const Action& action_named(std::string_view name);

bool is_enabled(const Action& action, const UiState& state);

/// Returns the first chord of the action's keys; empty if it has none.
std::string shown_keys(const Action& action);

/// Returns the name with the shown keys, as in "Name (Ctrl+N)".
std::string described(const Action& action);

}  // namespace zeroset::ui
