#include "pipeline/input_error.hpp"

#include "engine/base/text.hpp"

namespace zeroset {

InputError input_error(const ParseError& error, std::string_view text) {
    const std::string hint = error.hint.empty() ? "" : "; " + error.hint;
    return {.reason = error.reason + hint,
            .column = column_of(text, error.offset),
            .line = std::string(line_at(text, error.offset)),
            .offset = error.offset,
            .unfinished = error.unfinished};
}

std::string describe(const InputError& error) {
    std::string text = "error: " + printable(error.reason) + "\n";
    if (!error.column || error.line.empty()) return text;
    const auto [line, caret] = excerpt(error.line, *error.column - 1);
    return text + "  " + printable(line) + "\n  " + std::string(caret, ' ') + "^\n";
}

}  // namespace zeroset
