#include "engine/language/words/words.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/nearest_word.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/words/signs.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace zeroset {
namespace {

constexpr std::string_view pi_of_c = "M_PI";

/// Whether the token is one ASCII letter, or a Greek one.
bool is_single(const Token& token) {
    return token.kind == TokenKind::Name && (token.text.size() == 1 || !is_letter(token.text[0]));
}

/// The function whose name a word and the number directly after it are, as log and 10, or Log and
/// 10; nullptr: there is none.
const Function* function_of(const Token& word, const Token& number) {
    const bool joins = word.kind == TokenKind::Name && number.kind == TokenKind::Number &&
                       adjacent(word, number) && word.subscript.empty();
    if (!joins) return nullptr;
    const std::string joined = std::string(word.text) + std::string(number.text);
    const Function* const function = find_function(joined);
    return function != nullptr ? function : find_fixed_function(in_small_letters(joined));
}

/// The known name that this one equals but for capital letters: sin for Sin, pi for PI, and for
/// AND.
std::string_view known_spelling(std::string_view name) {
    const std::string lower = in_small_letters(name);
    if (const Function* const function = find_fixed_function(lower)) return function->name;
    for (const std::string_view value : built_in_values()) {
        if (value == lower) return value;
    }
    for (const std::string_view word : {"and", "or", "not"}) {
        if (word == lower) return word;
    }
    return {};
}

/// Whether this is a function in Mathematica's notation, such as Sin[.
bool calls_as_mathematica(const Token& name, const Token& bracket) {
    if (!is_symbol(bracket, {"["}) || name.kind != TokenKind::Name) return false;
    const bool capital = name.text.size() > 1 && name.text[0] >= 'A' && name.text[0] <= 'Z';
    return capital && find_fixed_function(in_small_letters(name.text)) != nullptr;
}

/// Whether the token is a word of programs at its place, and no product of letters: float a, return
/// a, = function(a).
bool is_program_word(std::span<const Token> tokens, std::size_t at) {
    const Token& word = tokens[at];
    if (word.kind != TokenKind::Name || !word.subscript.empty() || at + 1 == tokens.size())
        return false;
    const auto behind = [&](std::initializer_list<std::string_view> symbols) {
        return at > 0 && is_symbol(tokens[at - 1], symbols);
    };
    const bool starts = at == 0 || tokens[at - 1].kind == TokenKind::Break || behind({"{"});
    if (word.text == "function")
        return behind({"=", ":="}) || (starts && is_symbol(tokens[at + 1], {"{"}));
    if (word.text == "else") return starts || behind({"}"});
    const bool behind_else = at > 0 && tokens[at - 1].text == "else";
    if (word.text == "return") return starts || behind_else || behind({"}", ")"});
    const bool behind_word = at > 0 && declares(tokens[at - 1], word);
    return declares(word, tokens[at + 1]) && (starts || behind_word || behind({"(", ","}));
}

bool is_number(std::string_view subscript) {
    return !subscript.empty() && std::ranges::all_of(subscript, is_digit);
}

/// Notes that c_1a is read as c_1*a, although it looks like one name.
void note_product(const Token& subscripted, const Token& letter, Notes& notes) {
    const bool plain = letter.text.size() == 1 && letter.subscript.empty();
    if (!plain || is_built_in_value(letter.text)) return;
    const std::string name = full_name(subscripted);
    const std::string typed = name + std::string(letter.text);
    notes.add(subscripted.offset,
              filled(tr("{0} is read as {1}; to make it one name define it, as in {2}"),
                     {typed, name + "*" + std::string(letter.text), typed + " = 2"}));
}

}  // namespace

std::string full_name(const Token& token) {
    std::string name(token.text);
    if (!token.subscript.empty()) name += "_" + subscript_text(token);
    return name;
}

std::string subscript_text(const Token& token) {
    const std::string text = plain_name(token.subscript);
    return text.starts_with('_') ? text.substr(1) : text;
}

bool is_parameter_name(std::string_view name) {
    const std::size_t bar = std::min(name.find('_'), name.size());
    const std::string_view letter = name.substr(0, bar);
    const bool has_more = name.substr(bar).find('_', 1) != std::string_view::npos;
    if (letter.empty() || has_more || name == pi_of_c) return false;
    return letter.size() == 1 || code_point_at(letter, 0).length == letter.size();
}

Words::Words(std::span<const Token> tokens, const DefinedNames& defined) : defined_(defined) {
    for (const Token& token : tokens) {
        if (token.kind == TokenKind::Name && token.text.size() == 1)
            vocabulary_.add_letter(token.text[0]);
    }
    for (const std::string& word : defined.words())
        vocabulary_.add_word(word);
    for (std::size_t i = 0; i + 1 < tokens.size() && !is_mathematica_; ++i)
        is_mathematica_ = calls_as_mathematica(tokens[i], tokens[i + 1]);
}

/// Whether the token is one name and must not be split.
bool Words::stays_whole(const Token& token) const {
    if (token.kind != TokenKind::Name || is_single(token)) return true;
    if (!is_letter(token.text[0])) return true;
    const std::string name = full_name(token);
    return is_built_in(name) || vocabulary_.knows_word(name) || defined_.find(name, token.offset) ||
           (token.text == "log" && !token.subscript.empty());
}

void Words::push_name(const Token& token, std::vector<Token>& out, Notes& notes) const {
    if (is_mathematica_ && token.text == "E" && token.subscript.empty() &&
        !defined_.defines_value("E")) {
        out.push_back(token);
        out.back().text = "e";
        notes.add(token.offset, filled(tr("{0} is {1}, as in Mathematica"), {"E", "e = 2.718..."}));
    } else if (stays_whole(token)) {
        out.push_back(token);
    } else if (const std::string_view known = known_spelling(full_name(token)); !known.empty()) {
        out.push_back(token);
        out.back().text = known;
        out.back().subscript = {};
    } else {
        push_pieces(token, out, notes);
    }
    Token& last = out.back();
    if (last.text == "M" && full_name(last) == pi_of_c) {
        last.text = "pi";
        last.subscript = {};
    }
}

void Words::push_pieces(const Token& token, std::vector<Token>& out, Notes& notes) const {
    const std::string_view run = token.text;
    std::vector<std::size_t> lengths = vocabulary_.pieces(run, !token.subscript.empty());
    const Function* const function = lengths.empty() ? capital_function(run, lengths) : nullptr;
    if (lengths.empty()) {
        out.push_back(token);
        return;
    }
    if (function != nullptr) {
        notes.add(token.offset,
                  filled(tr("{0} is read as {1}"), {run, std::string(function->name) + " " +
                                                             std::string(run.substr(lengths[0]))}));
    }
    std::size_t at = 0;
    for (const std::size_t length : lengths) {
        out.push_back({.kind = TokenKind::Name,
                       .text = run.substr(at, length),
                       .offset = token.offset + at,
                       .length = length});
        if (at == 0 && function != nullptr) out.back().text = function->name;
        at += length;
    }
    out.back().subscript = token.subscript;
    out.back().length = token.end() - out.back().offset;
}

/// The function that a run such as Siny starts with, and the lengths of the run's pieces.
const Function* Words::capital_function(std::string_view run,
                                        std::vector<std::size_t>& lengths) const {
    constexpr std::size_t longest = 64;
    if (run.size() > longest || run[0] < 'A' || run[0] > 'Z') return nullptr;
    std::string small(run);
    small[0] = static_cast<char>(small[0] + ('a' - 'A'));
    std::vector<std::size_t> found = vocabulary_.pieces(small, false);
    if (found.empty() || found[0] < 2) return nullptr;
    const Function* const function = find_function(std::string_view(small).substr(0, found[0]));
    if (function != nullptr) lengths = std::move(found);
    return function;
}

/// Whether letters that are no name make one unknown name with the token directly after them: vec3.
bool Words::joins_unknown_name(const Token& token, const std::vector<Token>& out) const {
    if (out.empty() || !adjacent(out.back(), token)) return false;
    const Token& last = out.back();
    const bool unknown = last.kind == TokenKind::Name && last.subscript.empty() &&
                         last.length == last.text.size() && !stays_whole(last);
    return unknown && token.length == token.text.size() &&
           ((token.kind == TokenKind::Number && is_number(token.text)) ||
            token.kind == TokenKind::Name);
}

std::vector<Token> Words::split(std::span<const Token> tokens, Notes& notes) const {
    std::vector<Token> out;
    out.reserve(tokens.size());
    for (const Token& token : tokens) {
        const Token* const next = &token + 1 < tokens.data() + tokens.size() ? &token + 1 : nullptr;
        const bool is_call = next != nullptr && is_symbol(*next, {"(", "["});
        const Function* const named = out.empty() ? nullptr : function_of(out.back(), token);
        if (named != nullptr && (is_call || !named->is_word())) {
            Token& word = out.back();
            word.text = named->name;
            word.length += token.length;
            continue;
        }
        if (joins_unknown_name(token, out)) {
            Token& word = out.back();
            word.length += token.length;
            word.text = {word.text.data(), word.length};
            continue;
        }
        const std::size_t size = out.size();
        if (is_program_word(tokens, static_cast<std::size_t>(&token - tokens.data()))) {
            out.push_back(token);
            continue;
        }
        const Function* const word = is_call ? find_function(full_name(token)) : nullptr;
        if (word != nullptr && word->is_word()) {
            out.push_back(token);
            continue;
        }
        push_name(token, out, notes);
        const bool behind_subscript = token.kind == TokenKind::Name && size > 0 &&
                                      is_number(out[size - 1].subscript) &&
                                      adjacent(out[size - 1], token);
        if (behind_subscript) note_product(out[size - 1], out[size], notes);
    }
    return out;
}

}  // namespace zeroset
