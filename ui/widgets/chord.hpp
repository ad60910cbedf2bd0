#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::ui {

/// A key with modifiers, written as "Ctrl+Shift+Z", "F1", "R" or "+".
struct Chord {
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    int key = 0;  ///< GLFW's number of the key, a letter key by what it types; 0: see `letter`
    char letter = '\0';  ///< typed character, lower case, of a key that types text
    bool operator==(const Chord&) const = default;
};

/// Parses one chord; nothing if the text names no key.
std::optional<Chord> chord_of(std::string_view text);

/// Parses a list of chords such as "Ctrl+Shift+Z, Ctrl+Y"; entries that name no key are left out.
std::vector<Chord> chords_of(std::string_view list);

/// The chords, with the names that their keys have on keyboards of the user's language.
std::string keys_in_language(std::string_view chords);

/// True if the chord went down in this frame or, with `repeats`, repeated by being held. A typed
/// character does not count while a text field has the keyboard or a popup is open.
bool is_pressed(const Chord& chord, bool repeats);

}  // namespace zeroset::ui
