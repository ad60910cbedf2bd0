// Cases as LaTeX writes them, rewritten in braces.
//
// \begin{cases} a & x < 0 \\ b & \text{otherwise} \end{cases} is {x < 0: a, b}. The last of several
// conditions stays one: where none holds there is no value. Rows without conditions are equations,
// each a statement of its own.

#include "engine/base/translation.hpp"
#include "engine/language/words/lexer_reader.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <span>
#include <string>
#include <utility>

namespace zeroset {
namespace {

using Tokens = std::span<const Token>;

constexpr std::size_t max_open_cases = 100;  ///< each level is read anew for those around it

/// Whether the token ends a row: \\, which is 2 bytes long, and no line end.
bool ends_row(const Token& token) { return token.kind == TokenKind::Break && token.length == 2; }

bool is_word(const Token& token, std::initializer_list<std::string_view> words) {
    return token.kind == TokenKind::Name && std::ranges::find(words, token.text) != words.end();
}

/// Number of tokens of an `if` that may stand in braces; 0: there is none.
std::size_t if_length(Tokens tokens) {
    if (tokens.empty()) return 0;
    if (is_word(tokens[0], {"if", "for"})) return 1;
    const bool in_braces = tokens.size() > 2 && is_symbol(tokens[0], {"{"}) &&
                           is_word(tokens[1], {"if", "for"}) && is_symbol(tokens[2], {"}"});
    return in_braces ? 3 : 0;
}

/// The tokens without commas and line ends around them, and without `if` before them.
Tokens trimmed(Tokens tokens) {
    const auto is_around = [](const Token& token) {
        return token.kind == TokenKind::Break || is_symbol(token, {","});
    };
    while (!tokens.empty() && is_around(tokens.front()))
        tokens = tokens.subspan(1);
    while (!tokens.empty() && is_around(tokens.back()))
        tokens = tokens.first(tokens.size() - 1);
    return tokens.subspan(if_length(tokens));
}

/// Whether the token stands between a value and its condition: &, and no \land.
bool parts_row(const Token& token) { return is_symbol(token, {"&"}) && token.length == 1; }

/// Whether a row has a condition. In x &= 1 the mark only says what stands in one column.
bool has_condition(Tokens rows) {
    const auto mark = std::ranges::adjacent_find(rows, [](const Token& token, const Token& next) {
        return parts_row(token) && !is_symbol(next, {"=", "<", ">", "<=", ">="});
    });
    return mark != rows.end() || (!rows.empty() && parts_row(rows.back()));
}

/// Adds a row's condition and value.
void add_row(Tokens row, std::vector<Token>& cases) {
    const auto mark = std::ranges::find_if(row, parts_row);
    const auto length = static_cast<std::size_t>(mark - row.begin());
    const Tokens value = trimmed(row.first(length));
    const Tokens condition = trimmed(row.subspan(std::min(length + 1, row.size())));
    if (value.empty() && condition.empty()) return;
    const std::size_t offset = row.front().offset;
    const auto add_symbol = [&](std::string_view text) {
        cases.push_back({.kind = TokenKind::Symbol, .text = text, .offset = offset});
    };
    if (!cases.empty()) add_symbol(",");
    const bool is_rest = condition.size() == 1 &&
                         is_word(condition.front(), {"otherwise", "else", "sonst", "sinon"});
    if (!condition.empty() && !is_rest) {
        std::ranges::copy(condition, std::back_inserter(cases));
        add_symbol(":");
    }
    std::ranges::copy(value, std::back_inserter(cases));
}

}  // namespace

/// Reads \begin{...} or \end{...}, which mean nothing but for cases.
Done Lexer::environment(std::string_view word) {
    const std::size_t length = 1 + word.size();
    const std::string_view name = text_.substr(at_ + length);
    if (name.starts_with("{cases}") || name.starts_with("{dcases}"))
        return word == "begin" ? begin_cases(length) : end_cases(length);
    at_ += length + run_length(text_, at_ + length, [](char c) { return c != '}'; });
    at_ = std::min(at_ + 1, text_.size());
    return {};
}

Done Lexer::begin_cases(std::size_t length) {
    if (cases_.size() == max_open_cases) {
        const std::string most = std::to_string(max_open_cases);
        return std::unexpected(
            ParseError{.offset = at_,
                       .reason = filled(tr("the formula is nested more than {0} deep"), {most}),
                       .hint = {}});
    }
    const std::size_t end = text_.find('}', at_ + length);
    push(TokenKind::Symbol, "{", end + 1 - at_);
    cases_.push_back(tokens_.size());
    return {};
}

Done Lexer::end_cases(std::size_t length) {
    const std::size_t end = text_.find('}', at_ + length);
    if (cases_.empty()) {
        at_ = end + 1;
        return {};
    }
    const std::size_t begin = cases_.back();
    cases_.pop_back();
    Tokens rest = Tokens(tokens_).subspan(begin);
    if (!has_condition(rest)) {
        tokens_.erase(tokens_.begin() + static_cast<std::ptrdiff_t>(begin) - 1);
        at_ = end + 1;
        return {};
    }
    std::vector<Token> cases;
    while (!rest.empty()) {
        const auto length_of_row =
            static_cast<std::size_t>(std::ranges::find_if(rest, ends_row) - rest.begin());
        if (length_of_row > 0) add_row(rest.first(length_of_row), cases);
        rest = rest.subspan(std::min(length_of_row + 1, rest.size()));
    }
    std::erase_if(cases, [](const Token& token) { return token.kind == TokenKind::Break; });
    tokens_.resize(begin);
    tokens_.insert(tokens_.end(), cases.begin(), cases.end());
    push(TokenKind::Symbol, "}", end + 1 - at_);
    return {};
}

}  // namespace zeroset
