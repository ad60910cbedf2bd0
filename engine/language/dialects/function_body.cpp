#include "engine/language/dialects/function_body.hpp"

#include "engine/base/text.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

using Words = std::string_view;

/// Words before a name that tell of its type only.
constexpr std::array<Words, 8> declaring{"let",   "mut",   "const",  "var",
                                         "local", "float", "double", "auto"};

/// A target without words such as `let mut`, and without its type behind a colon.
Words bare_name(Words target) {
    target = trimmed(target);
    for (;;) {
        const Words word = target.substr(0, word_length(target));
        if (word.size() == target.size() || std::ranges::find(declaring, word) == declaring.end())
            break;
        target = trimmed(target.substr(word.size()));
    }
    return trimmed(target.substr(0, target.find(':')));
}

/// The letter of a vector's part for its number in brackets: p[0].
std::optional<Words> letter_of_part(Words index) {
    constexpr Words letters = "xyzw";
    if (index.size() != 1 || index[0] < '0' || index[0] > '3') return std::nullopt;
    return letters.substr(static_cast<std::size_t>(index[0] - '0'), 1);
}

}  // namespace

std::string_view without_remark(std::string_view line, std::string_view mark) {
    char quote = '\0';
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (quote == '\0' && line.substr(i).starts_with(mark)) return trimmed(line.substr(0, i));
        if (quote == '\0' && line[i] == '"')
            quote = line[i];
        else if (line[i] == quote)
            quote = '\0';
    }
    return trimmed(line);
}

void FunctionBody::begin(std::string_view name, std::string_view arguments) {
    put("float ", name);
    writer_.text().keep(name);
    put("(", arguments);
    bool is_first = true;
    for (const Words argument : split_outside(arguments, ',')) {
        if (argument.empty()) continue;
        const Words bare = trimmed(argument.substr(0, argument.find_first_of(":=")));
        // Go's and C's types stand beside the name: x float64, double x.
        const auto words = split_outside(bare, ' ');
        const bool is_typed_before =
            words.size() > 1 && std::ranges::find(declaring, words[0]) != declaring.end();
        const Words plain = words.empty() ? bare : is_typed_before ? words.back() : words.front();
        put(is_first ? "" : ", ", argument);
        writer_.text().keep(plain);
        arguments_.push_back(plain);
        is_first = false;
    }
    put(") {", arguments.substr(arguments.size()));
}

/// Writes an expression; p[0] of an argument is its part p.x.
void FunctionBody::write(std::string_view expression) {
    std::size_t kept = 0;
    for (std::size_t at = 0; at < expression.size();) {
        const Words rest = expression.substr(at);
        const std::size_t length = word_length(rest);
        const bool is_argument =
            length > 0 && std::ranges::find(arguments_, rest.substr(0, length)) != arguments_.end();
        const Words behind = rest.substr(length);
        const auto closer = is_argument && behind.starts_with('[') ? behind.find(']') : Words::npos;
        const auto letter = closer == Words::npos
                                ? std::nullopt
                                : letter_of_part(trimmed(behind.substr(1, closer - 1)));
        if (letter) {
            writer_.write(expression.substr(kept, at + length - kept));
            put(".", behind);
            put(*letter, behind);
            at += length + closer + 1;
            kept = at;
            continue;
        }
        at += std::max<std::size_t>(length, 1);
    }
    if (kept < expression.size()) writer_.write(expression.substr(kept));
}

void FunctionBody::value(std::string_view target, std::string_view sign, std::string_view value) {
    const auto names = split_outside(bare_name(target), ',');
    if (names.size() > 1) return several(names, value);
    write(names[0]);
    put(" ", value);
    put(sign, value);
    put(" ", value);
    write(value);
    put("; ", value.substr(value.size()));
}

/// Writes a, b = c, d: all values are found before any takes its place; and x, y, z = p.
void FunctionBody::several(const std::vector<std::string_view>& names, std::string_view values) {
    constexpr Words letters = "xyzw";
    auto parts = split_outside(values, ',');
    if (parts.size() == 1) {
        if (const auto inside = in_brackets(values)) parts = split_outside(*inside, ',');
    }
    const bool is_point = parts.size() == 1;
    const bool fits = is_point ? names.size() <= letters.size() : parts.size() == names.size();
    for (std::size_t i = 0; fits && i < names.size(); ++i) {
        writer_.text().keep(names[i]);
        put("_new = ", names[i]);
        if (is_point) put("(", values);
        write(is_point ? values : parts[i]);
        if (is_point) put(").", values);
        if (is_point) put(letters.substr(i, 1), values);
        put("; ", values);
    }
    for (const Words name : names) {
        writer_.text().keep(name);
        put(" = ", name);
        writer_.text().keep(name);
        put("_new; ", name);
    }
}

void FunctionBody::result(std::string_view value) {
    put("return ", value);
    write(value);
    put("; ", value.substr(value.size()));
}

void FunctionBody::choice(std::string_view condition) {
    put("if (", condition);
    write(in_brackets(condition).value_or(condition));
    put(") {", condition.substr(condition.size()));
}

void FunctionBody::step(std::string_view text) {
    text = trimmed(text);
    if (text.empty()) return;
    for (const Words sign : {"+=", "-=", "*=", "/="}) {
        const std::size_t at = find_outside(text, sign);
        if (at != Words::npos) return value(text.substr(0, at), sign, trimmed(text.substr(at + 2)));
    }
    for (const Words sign : {":=", "<-", "="}) {
        const std::size_t at = find_outside(text, sign);
        if (at == Words::npos || at == 0) continue;
        const bool compares = sign == "=" && (Words("<>=!:").contains(text[at - 1]) ||
                                              text.substr(at).starts_with("=="));
        if (!compares)
            return value(text.substr(0, at), "=", trimmed(text.substr(at + sign.size())));
    }
    result(text);
}

}  // namespace zeroset
