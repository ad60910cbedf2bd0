#include "engine/language/vocabulary/field_source.hpp"

#include "engine/base/text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace zeroset {
namespace {

constexpr std::string_view spaces = " \t\r\n";

std::size_t after_spaces(std::string_view text, std::size_t at) {
    const std::size_t next = text.find_first_not_of(spaces, at);
    return next == std::string_view::npos ? text.size() : next;
}

/// The pair of quotes of which the first one starts at `at`.
constexpr std::array quotes{std::pair<std::string_view, std::string_view>{"\"", "\""},
                            std::pair<std::string_view, std::string_view>{"\u201C", "\u201D"},
                            std::pair<std::string_view, std::string_view>{"\u201E", "\u201C"}};

/// The words before a file's name.
constexpr std::array<std::string_view, 4> field_words{"volume", "blobs", "metaballs", "blinn"};

}  // namespace

FieldCallStart read_field_call(std::string_view text) {
    FieldCallStart start;
    const auto* const found = std::ranges::find_if(
        field_words, [&](std::string_view candidate) { return text.starts_with(candidate); });
    if (found == field_words.end()) return start;
    const std::string_view word = *found;
    start.call.word = word;
    std::size_t at = after_spaces(text, word.size());
    if (at == text.size() || text[at] != '(') return start;
    at = after_spaces(text, at + 1);
    for (const auto& [open, close] : quotes) {
        if (!text.substr(at).starts_with(open)) continue;
        at += open.size();
        const std::size_t end = text.find(close, at);
        const std::size_t line = text.find_first_of("\n\v", at);
        start.call.text = text.substr(0, at);
        start.quotes_closed = end != std::string_view::npos && end < line;
        if (!start.quotes_closed) return start;
        start.call.file = text.substr(at, end - at);
        at = end + close.size();
        break;
    }
    if (start.call.text.empty()) return start;
    const std::size_t end = text.find_first_of(")\n\v", at);
    start.closed = end != std::string_view::npos && text[end] == ')';
    const std::size_t last = start.closed ? end : std::min(end, text.size());
    start.call.text = text.substr(0, last + (start.closed ? 1 : 0));
    std::string_view rest = trimmed(text.substr(at, last - at));
    while (!rest.empty()) {
        if (rest.starts_with(',')) rest.remove_prefix(1);
        const std::size_t comma = std::min(rest.find(','), rest.size());
        start.call.arguments.push_back(trimmed(rest.substr(0, comma)));
        rest.remove_prefix(comma);
    }
    return start;
}

}  // namespace zeroset
