#include "ui/model/soft_wrap.hpp"

#include "engine/base/utf8.hpp"

#include <algorithm>
#include <iterator>
#include <ranges>

namespace zeroset::ui {
namespace {

/// Whether a line may well end behind this character.
bool ends_well(std::string_view character) {
    return character.size() == 1 && std::string_view(" +-*/=<>,;").contains(character.front());
}

/// The length of the common beginning of two texts.
std::size_t common_start(std::string_view a, std::string_view b) {
    return static_cast<std::size_t>(std::distance(a.begin(), std::ranges::mismatch(a, b).in1));
}

std::size_t breaks_before(const std::vector<std::size_t>& breaks, std::size_t place) {
    return static_cast<std::size_t>(
        std::distance(breaks.begin(), std::ranges::lower_bound(breaks, place)));
}

}  // namespace

WrappedText wrapped(std::string_view plain, float width,
                    const std::function<float(std::string_view)>& width_of) {
    // A break behind an operator may leave this part of the line empty.
    constexpr float most_left_empty = 0.4F;
    WrappedText shown;
    std::size_t line = 0;  // where the line begins, in the plain text
    std::size_t good = 0;  // where it may well be broken, the last such place
    float used = 0.0F;     // of the width
    float used_to_good = 0.0F;
    const auto end_line = [&](std::size_t end) {
        shown.text += plain.substr(line, end - line);
        line = end;
        used = 0.0F;
        good = line;
    };
    for (std::size_t at = 0; at < plain.size();) {
        const std::size_t end = end_of_character(plain, at);
        const std::string_view character = plain.substr(at, end - at);
        if (character == "\n") {
            end_line(end);
            at = end;
            continue;
        }
        const float wide = width_of(character);
        if (used + wide > width && at > line) {
            const bool near = good > line && used_to_good >= (1.0F - most_left_empty) * width;
            end_line(near ? good : at);
            shown.breaks.push_back(shown.text.size());
            shown.text += '\n';
            at = line;
            continue;
        }
        used += wide;
        at = end;
        if (!ends_well(character)) continue;
        good = at;
        used_to_good = used;
    }
    shown.text += plain.substr(line);
    return shown;
}

std::size_t shown_place(const WrappedText& shown, std::size_t plain) {
    std::size_t place = plain;
    for (const std::size_t at : shown.breaks) {
        if (at > place) break;
        ++place;
    }
    return std::min(place, shown.text.size());
}

std::size_t plain_place(const WrappedText& shown, std::size_t place) {
    return place - breaks_before(shown.breaks, place);
}

std::string plain_part(const WrappedText& shown, std::size_t begin, std::size_t end) {
    std::string part = shown.text.substr(begin, end - begin);
    for (const std::size_t at : std::views::reverse(shown.breaks)) {
        if (at >= begin && at < end) part.erase(at - begin, 1);
    }
    return part;
}

PlainEdit plain_edit(const WrappedText& shown, std::string_view after, std::size_t caret,
                     bool ahead) {
    const std::string_view before = shown.text;
    // One part was replaced by another.
    const std::size_t start = common_start(before, after);
    const std::size_t most = std::min(before.size(), after.size()) - start;
    std::size_t tail = 0;
    while (tail < most && before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    const std::size_t replaced_to = before.size() - tail;
    WrappedText now{.text = std::string(after), .breaks = {}};
    bool only_break = false;
    for (const std::size_t at : shown.breaks) {
        if (at < start) {
            now.breaks.push_back(at);
        } else if (at >= replaced_to) {
            now.breaks.push_back(at + after.size() - before.size());
        } else {
            only_break = replaced_to == start + 1 && after.size() + 1 == before.size();
        }
    }
    PlainEdit edit{.text = plain_part(now, 0, now.text.size()), .caret = plain_place(now, caret)};
    if (!only_break) return edit;
    const std::size_t from = ahead ? edit.caret : character_before(edit.text, edit.caret);
    const std::size_t to = ahead ? end_of_character(edit.text, edit.caret) : edit.caret;
    if (from < edit.text.size()) edit.text.erase(from, to - from);
    edit.caret = from;
    return edit;
}

}  // namespace zeroset::ui
