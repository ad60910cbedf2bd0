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
    {{marked_in("key", "Home"), GLFW_KEY_HOME},
     {marked_in("key", "End"), GLFW_KEY_END},
     {marked_in("key", "PageUp"), GLFW_KEY_PAGE_UP},
     {marked_in("key", "PageDown"), GLFW_KEY_PAGE_DOWN},
     {marked_in("key", "Enter"), GLFW_KEY_ENTER},
     {marked_in("key", "Esc"), GLFW_KEY_ESCAPE},
     {marked_in("key", "Space"), GLFW_KEY_SPACE},
     {marked_in("key", "Delete"), GLFW_KEY_DELETE},
     {marked_in("key", "Left"), GLFW_KEY_LEFT},
     {marked_in("key", "Right"), GLFW_KEY_RIGHT},
     {marked_in("key", "Up"), GLFW_KEY_UP},
     {marked_in("key", "Down"), GLFW_KEY_DOWN}}};

/// The names of keys that make no chord by themselves.
constexpr std::array<std::string_view, 5> other_names{
    marked_in("key", "Ctrl"), marked_in("key", "Shift"), marked_in("key", "Alt"),
    marked_in("key", "Tab"), marked_in("key", "Backspace")};

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

bool is_key_name(std::string_view word) {
    const auto name = &std::pair<std::string_view, int>::first;
    return std::ranges::find(named_keys, word, name) != named_keys.end() ||
           std::ranges::find(other_names, word) != other_names.end();
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
    std::string text;
    while (!chords.empty()) {
        const auto is_letter = [](char c) {
            return std::isalpha(static_cast<unsigned char>(c)) != 0;
        };
        const auto end =
            static_cast<std::size_t>(std::ranges::find_if_not(chords, is_letter) - chords.begin());
        const std::string_view word = chords.substr(0, end);
        text += is_key_name(word) ? tr_in("key", std::string(word).c_str()) : std::string(word);
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
