#include "engine/expr/words.hpp"

#include "engine/expr/functions.hpp"
#include "engine/expr/nearest_word.hpp"
#include "engine/expr/signs.hpp"
#include "engine/expr/spelling.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace zeroset {
namespace {

constexpr std::array<std::string_view, 13> values{"x",     "y",   "z",  "w",   "t", "r",     "rho",
                                                  "theta", "phi", "pi", "tau", "e", "golden"};
constexpr std::string_view coordinates = "xyzwtr";
constexpr std::array<std::string_view, 3> connectives{"and", "or", "not"};
constexpr std::size_t longest_word = 24;

std::string small(std::string_view word) {
    std::string result(word);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    }
    return result;
}

/// A word that means something in every text.
bool is_built_in(std::string_view word) {
    return is_built_in_value(word) || find_function(word) != nullptr ||
           std::ranges::find(connectives, word) != connectives.end();
}

/// Whether the token is one ASCII letter, or a Greek one.
bool is_single(const Token& token) {
    return token.kind == TokenKind::Name && (token.text.size() == 1 || !is_letter(token.text[0]));
}

/// log and 10 right behind it are one name.
bool makes_name_with(const Token& word, const Token& number) {
    if (number.kind != TokenKind::Number || number.offset != word.end()) return false;
    const std::string joined = std::string(word.text) + std::string(number.text);
    return word.subscript.empty() && find_function(joined) != nullptr;
}

}  // namespace

std::string full_name(const Token& token) {
    std::string name(token.text);
    if (!token.subscript.empty()) name += "_" + token.subscript;
    return name;
}

bool is_parameter_name(std::string_view name) {
    const std::string_view letter = name.substr(0, name.find('_'));
    return letter.size() == 1 || code_point_at(letter, 0).length == letter.size();
}

bool is_built_in_value(std::string_view name) {
    return std::ranges::find(values, name) != values.end();
}

Words::Words(std::span<const Token> tokens) {
    for (const Token& token : tokens) {
        if (token.kind == TokenKind::Name && token.text.size() == 1) letters_.insert(token.text[0]);
    }
    auto rest = tokens;
    while (!rest.empty()) {
        const auto end = std::ranges::find_if(rest, [](const Token& token) {
            return token.kind == TokenKind::Break || token.kind == TokenKind::End;
        });
        const auto length = static_cast<std::size_t>(end - rest.begin());
        read_definition(rest.first(length));
        rest = rest.subspan(std::min(length + 1, rest.size()));
    }
}

/// name = ..., or name(a, b) = ...
void Words::read_definition(std::span<const Token> statement) {
    if (statement.size() < 3 || statement[0].kind != TokenKind::Name) return;
    const std::string name = full_name(statement[0]);
    if (is_built_in(name) || is_built_in(small(name))) return;
    if (!is_single(statement[0]) && !pieces(statement[0].text, false).empty()) return;
    if (is_symbol(statement[1], {"="})) {
        values_.insert(name);
        return;
    }
    if (!is_symbol(statement[1], {"("})) return;
    std::size_t at = 2;
    while (at + 1 < statement.size() && is_single(statement[at]) &&
           is_symbol(statement[at + 1], {","}))
        at += 2;
    if (at + 2 < statement.size() && statement[at].kind == TokenKind::Name &&
        is_symbol(statement[at + 1], {")"}) && is_symbol(statement[at + 2], {"="})) {
        functions_.insert(name);
    }
}

bool Words::is_known_letter(char letter) const {
    return is_built_in_value({&letter, 1}) || letters_.contains(letter);
}

bool Words::is_known_word(std::string_view word) const {
    if (std::ranges::find(connectives, word) != connectives.end()) return false;
    return is_built_in(word) || values_.contains(std::string(word)) ||
           functions_.contains(std::string(word));
}

std::vector<std::size_t> Words::pieces(std::string_view run, bool subscript) const {
    const auto unknown = std::ranges::count_if(run, [&](char c) { return !is_known_letter(c); });
    const auto places = std::ranges::count_if(run, [](char c) { return coordinates.contains(c); });
    if (unknown == 1 && places + unknown == std::ssize(run)) {
        return std::vector<std::size_t>(run.size(), 1);  // a coefficient: axy
    }
    // The fewest names: best[i] for the first i letters, the last of them last[i] long.
    constexpr std::size_t never = ~std::size_t{0};
    std::vector<std::size_t> best(run.size() + 1, never);
    std::vector<std::size_t> last(run.size() + 1, 0);
    best[0] = 0;
    for (std::size_t end = 1; end <= run.size(); ++end) {
        const bool only_letter = subscript && end == run.size();
        const std::size_t most = only_letter ? 1 : std::min(end, longest_word);
        for (std::size_t length = most; length >= 1; --length) {
            const std::size_t start = end - length;
            if (best[start] == never || best[start] + 1 >= best[end]) continue;
            const std::string_view piece = run.substr(start, length);
            if (piece == "e" && find_function(run.substr(start - last[start], last[start])))
                continue;  // "sine" is no sin(e)
            const bool known =
                length == 1 ? only_letter || is_known_letter(piece[0]) : is_known_word(piece);
            if (!known) continue;
            best[end] = best[start] + 1;
            last[end] = length;
        }
    }
    std::vector<std::size_t> lengths;
    if (best.back() == never) return lengths;
    for (std::size_t end = run.size(); end > 0; end -= last[end])
        lengths.push_back(last[end]);
    std::ranges::reverse(lengths);
    return lengths;
}

void Words::push_pieces(const Token& token, std::vector<Token>& out) const {
    const std::string_view run = token.text;
    const std::vector<std::size_t> lengths = pieces(run, !token.subscript.empty());
    if (lengths.empty()) {
        out.push_back(token);
        return;
    }
    std::size_t at = 0;
    for (const std::size_t length : lengths) {
        out.push_back({TokenKind::Name, run.substr(at, length), {}, token.offset + at, length});
        at += length;
    }
    out.back().subscript = token.subscript;
    out.back().length = token.end() - out.back().offset;
}

std::vector<Token> Words::split(std::span<const Token> tokens) const {
    std::vector<Token> out;
    out.reserve(tokens.size());
    for (const Token& token : tokens) {
        if (token.kind == TokenKind::Number && !out.empty() && makes_name_with(out.back(), token)) {
            Token& word = out.back();
            word.text = find_function(std::string(word.text) + std::string(token.text))->name;
            word.length += token.length;
            continue;
        }
        const bool run = token.kind == TokenKind::Name && is_letter(token.text[0]);
        const std::string name = run ? full_name(token) : std::string();
        if (!run || is_single(token) || is_built_in(name) || is_known_word(name) ||
            (token.text == "log" && !token.subscript.empty())) {
            out.push_back(token);
        } else if (const std::string lower = small(name); is_built_in(lower)) {
            out.push_back(token);
            const Function* const function = find_function(lower);
            const auto* const value = std::ranges::find(values, lower);
            out.back().text = function != nullptr     ? function->name
                              : value != values.end() ? *value
                                                      : *std::ranges::find(connectives, lower);
            out.back().subscript.clear();
        } else {
            push_pieces(token, out);
        }
    }
    return out;
}

std::string hint_for_unknown(std::string_view name) {
    std::vector<std::string_view> words = function_spellings();
    words.insert(words.end(), values.begin(), values.end());
    if (const auto meant = meant_word(name, words))
        return "did you mean " + std::string(*meant) + "?";
    // A letter before a known name: a coefficient that nothing else mentions.
    if (name.size() > 1 && is_built_in(name.substr(1))) {
        return "for a product type " + std::string(name.substr(0, 1)) + "*" +
               std::string(name.substr(1));
    }
    if (name.size() == 2) {
        return "for a product type " + std::string(name.substr(0, 1)) + "*" +
               std::string(name.substr(1));
    }
    if (name.size() > longest_word) return "type a product with *";
    return "define it, as in " + std::string(name) + " = 2, or type a product with *";
}

}  // namespace zeroset
