#include "ui/actions/action_functions.hpp"

#include <algorithm>
#include <cstddef>

namespace zeroset::ui {

void switch_presentation(UiState& state) {
    Edited& edited = state.edited;
    if (edited.layout.presents) return leave_presentation(state);
    edited.layout.presents = true;
    edited.full_screen_before = edited.full_screen;
    edited.full_screen = true;
}

void leave_presentation(UiState& state) {
    Edited& edited = state.edited;
    if (edited.read_only) {
        edited.full_screen = false;
        return;
    }
    edited.layout.presents = false;
    edited.full_screen = edited.full_screen_before;
}

bool can_leave_presentation(const UiState& state) {
    const Pages& pages = state.pages;
    const bool page = pages.gallery.open || pages.commands.open || pages.help.open ||
                      pages.exports.open || pages.dialogs.question || pages.dialogs.file;
    const bool there =
        state.edited.read_only ? state.edited.full_screen : state.edited.layout.presents;
    return there && !page;
}

void change_letters(Layout& layout, int steps) {
    const auto nearest = std::ranges::lower_bound(letter_sizes, layout.letters - 1e-3F);
    const auto at =
        std::min<std::ptrdiff_t>(nearest - letter_sizes.begin(), std::ssize(letter_sizes) - 1);
    const auto wanted = std::clamp<std::ptrdiff_t>(at + steps, 0, std::ssize(letter_sizes) - 1);
    layout.letters = letter_sizes.at(static_cast<std::size_t>(wanted));
}

}  // namespace zeroset::ui
