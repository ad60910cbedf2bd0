#include "ui/widgets/chord.hpp"

#include "engine/base/translation.hpp"
#include "ui/style/keys.hpp"

#include <GLFW/glfw3.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <utility>

namespace zeroset::ui {
namespace {

constexpr std::array<std::pair<std::string_view, int>, 12> named_keys{
    {{"Home", GLFW_KEY_HOME},
     {"End", GLFW_KEY_END},
     {"PageUp", GLFW_KEY_PAGE_UP},
     {"PageDown", GLFW_KEY_PAGE_DOWN},
     {"Enter", GLFW_KEY_ENTER},
     {"Esc", GLFW_KEY_ESCAPE},
     {"Space", GLFW_KEY_SPACE},
     {"Delete", GLFW_KEY_DELETE},
     {"Left", GLFW_KEY_LEFT},
     {"Right", GLFW_KEY_RIGHT},
     {"Up", GLFW_KEY_UP},
     {"Down", GLFW_KEY_DOWN}}};

constexpr int function_keys = 12;

bool is_upper(char letter) { return letter >= 'A' && letter <= 'Z'; }

/// Key number of "F1" to "F12" or of a name in the table; 0 if the name is neither.
int named_key(std::string_view name) {
    const auto* const found =
        std::ranges::find(named_keys, name, &std::pair<std::string_view, int>::first);
    if (found != named_keys.end()) return found->second;
    int number = 0;
    if (name.size() < 2 || name.front() != 'F') return 0;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
    const bool whole = error == std::errc() && end == name.data() + name.size();
    return whole && number >= 1 && number <= function_keys ? GLFW_KEY_F1 + number - 1 : 0;
}

bool take(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix) || text.size() == prefix.size()) return false;
    text.remove_prefix(prefix.size());
    return true;
}

bool was_typed(const Chord& chord) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool is_letter = chord.letter >= 'a' && chord.letter <= 'z';
    if (is_letter) return io.KeyShift == chord.shift && is_typed(chord.letter);
    const auto letter = static_cast<ImWchar>(chord.letter);
    return std::ranges::count(io.InputQueueCharacters, letter) > 0;
}

}  // namespace

std::optional<Chord> chord_of(std::string_view text) {
    Chord chord;
    chord.ctrl = take(text, "Ctrl+");
    chord.shift = take(text, "Shift+");
    chord.alt = take(text, "Alt+");
    chord.key = named_key(text);
    if (chord.key != 0) return chord;
    if (text.size() != 1 || text.front() <= ' ' || text.front() > '~') return std::nullopt;
    const char letter = text.front();
    if (chord.ctrl || chord.alt) {
        chord.key = letter;  // GLFW numbers these keys by their upper-case character
    } else {
        chord.letter = is_upper(letter) ? static_cast<char>(letter - 'A' + 'a') : letter;
    }
    return chord;
}

std::vector<Chord> chords_of(std::string_view list) {
    constexpr std::string_view between = ", ";
    std::vector<Chord> chords;
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(between), list.size());
        if (const auto chord = chord_of(list.substr(0, end))) chords.push_back(*chord);
        list.remove_prefix(std::min(end + between.size(), list.size()));
    }
    return chords;
}

std::string keys_in_language(std::string_view chords) {
    constexpr std::array names{
        marked_in("key", "Ctrl"),     marked_in("key", "Shift"),    marked_in("key", "Alt"),
        marked_in("key", "Home"),     marked_in("key", "End"),      marked_in("key", "PageUp"),
        marked_in("key", "PageDown"), marked_in("key", "Enter"),    marked_in("key", "Esc"),
        marked_in("key", "Space"),    marked_in("key", "Delete"),   marked_in("key", "Left"),
        marked_in("key", "Right"),    marked_in("key", "Up"),       marked_in("key", "Down"),
        marked_in("key", "Tab"),      marked_in("key", "Backspace")};
    std::string text;
    while (!chords.empty()) {
        const auto is_letter = [](char c) {
            return std::isalpha(static_cast<unsigned char>(c)) != 0;
        };
        const auto end =
            static_cast<std::size_t>(std::ranges::find_if_not(chords, is_letter) - chords.begin());
        const std::string_view word = chords.substr(0, end);
        const auto* const name =
            std::ranges::find(names, word, [](const char* n) { return std::string_view(n); });
        text += name != names.end() ? std::string_view(tr_in("key", *name)) : word;
        chords.remove_prefix(end);
        if (chords.empty()) break;
        text += chords.front();
        chords.remove_prefix(1);
    }
    return text;
}

bool is_pressed(const Chord& chord, bool repeats) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl != chord.ctrl || io.KeyAlt != chord.alt || io.KeySuper) return false;
    if (chord.key != 0) {
        return io.KeyShift == chord.shift && ImGui::IsKeyPressed(chord.key, repeats);
    }
    const bool elsewhere =
        io.WantTextInput || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId);
    return !elsewhere && was_typed(chord);
}

}  // namespace zeroset::ui
