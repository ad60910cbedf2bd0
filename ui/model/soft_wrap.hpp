#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

// A text whose long lines go on in the next line of its field. ImGui's fields break lines only at
// line breaks, so that breaks are put in for them, and taken out of what was typed. All places are
// in bytes of UTF-8 text.

namespace zeroset::ui {

/// A text as its field shows it.
struct WrappedText {
    std::string text;
    std::vector<std::size_t> breaks;  ///< of the line breaks in it that were put in, ascending
};

/// Breaks lines wider than `width`, behind an operator or a blank where one is near.
/// `width_of`: of a character, a whole sequence of UTF-8, in the unit of `width`.
WrappedText wrapped(std::string_view plain, float width,
                    const std::function<float(std::string_view)>& width_of);

/// Where a place of the plain text is shown; behind a break that was put in there.
std::size_t shown_place(const WrappedText& shown, std::size_t plain);
/// The place in the plain text of one that is shown.
std::size_t plain_place(const WrappedText& shown, std::size_t place);
/// The plain text of a part of what is shown.
std::string plain_part(const WrappedText& shown, std::size_t begin, std::size_t end);

/// A plain text with a caret in it.
struct PlainEdit {
    std::string text;
    std::size_t caret = 0;
};

/// The edit that a person meant who made `after`, with its caret at `caret`, of what was shown.
/// Deleting nothing but a break that was put in takes the character beside it: the one `ahead`, or
/// before.
PlainEdit plain_edit(const WrappedText& shown, std::string_view after, std::size_t caret,
                     bool ahead);

}  // namespace zeroset::ui
