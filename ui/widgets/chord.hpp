#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace zeroset::ui {

/// Keys that are pressed together, written as "Ctrl+Shift+Z", "F1", "R" or "+".
struct Chord {
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    int key = 0;         ///< GLFW's number, letters by what they type; 0: `letter` says it
    char letter = '\0';  ///< what is typed, in lower case: a key that is no command of a field
    bool operator==(const Chord&) const = default;
};

/// Nothing where the text names no keys.
std::optional<Chord> chord_of(std::string_view text);

/// Of a list such as "Ctrl+Shift+Z, Ctrl+Y"; what names no keys is left out.
std::vector<Chord> chords_of(std::string_view list);

/// Whether it went down in this frame, or with `repeats` is held. A typed letter is left to the
/// field that has the keyboard and to an open popup.
bool is_pressed(const Chord& chord, bool repeats);

}  // namespace zeroset::ui
