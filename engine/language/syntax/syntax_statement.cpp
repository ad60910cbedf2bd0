// Statements of a text, and definitions as programs write them.

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/dialects/dialects.hpp"
#include "engine/language/syntax/syntax_floats.hpp"
#include "engine/language/syntax/syntax_marks.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/words/syntax_bars.hpp"
#include "engine/language/words/words.hpp"
#include "engine/language/words/words_candidates.hpp"

#include <array>
#include <span>
#include <vector>

namespace zeroset {

std::expected<SyntaxTree, ParseError> SyntaxParser::text() {
    while (next().kind == TokenKind::Break)
        take();
    if (next().kind == TokenKind::End) {
        ParseError error{.offset = next().offset,
                         .reason = tr("there is no formula yet"),
                         .hint = filled(tr("type one, for example {0}"), {"x^2 + y^2 + z^2 = 1"}),
                         .unfinished = true};
        return std::unexpected(std::move(error));
    }
    while (next().kind != TokenKind::End) {
        if (!statement()) return std::unexpected(*error_);
        while (next().kind == TokenKind::Break)
            take();
    }
    return std::move(tree_);
}

/// Reads a statement. After words such as `const float` a definition follows, or several separated
/// by commas.
bool SyntaxParser::statement() {
    std::size_t offset = next().offset;
    skip_label();
    if (next_is_word("function") && is_symbol(tokens_[at_ + 1], {"{"})) take();
    if (next_is_word("return") && begins_operand(tokens_[at_ + 1])) take();
    const bool is_certain = skip_type_words();
    while (part_of_statement(is_certain, offset)) {
        if (!is_certain || !declares_more()) return true;
        take();
        offset = next().offset;
    }
    return false;
}

/// Skips the name of an equation: e1: x + y = 1.
void SyntaxParser::skip_label() {
    for (std::size_t at = at_; at <= at_ + 2 && at < tokens_.size(); ++at) {
        if (is_symbol(tokens_[at], {label_mark})) at_ = at + 1;
    }
}

bool SyntaxParser::skip_type_words() {
    bool skips = false;
    while (next().kind != TokenKind::End && declares(next(), tokens_[at_ + 1]) &&
           !is_logic_word(tokens_[at_ + 1].text)) {
        take();
        skips = true;
    }
    return skips;
}

/// Whether a comma and `NAME =` are next.
bool SyntaxParser::declares_more() const {
    return next_is(",") && tokens_[at_ + 1].kind == TokenKind::Name &&
           is_symbol(tokens_[at_ + 2], {"=", ":="});
}

bool SyntaxParser::part_of_statement(bool is_certain, std::size_t offset) {
    statement_start_ = at_;
    if (tree_.statements.size() == ProgramLimits::statements) {
        const std::string most = std::to_string(ProgramLimits::statements);
        refuse({.offset = next().offset,
                .reason = filled(tr("there are more than {0} statements"), {most}),
                .hint = {}});
        return false;
    }
    StatementSyntax statement{
        .relation = 0, .restrictions = {}, .offset = offset, .is_certain = is_certain};
    const bool below = at_ > 0 && is_symbol(next(), {"+", "-"});
    if (below && tokens_[at_ - 1].text == "\n") statement.leading_sign = next().text.front();
    const Parsed relation = relation_of_statement(is_certain);
    if (!relation) return false;
    statement.relation = *relation;
    Syntax& root = tree_.nodes[*relation];
    if (root.kind == SyntaxKind::Compare && root.marks == ":") statement.is_certain = true;
    if (root.kind == SyntaxKind::Compare && (root.marks == ":" || root.marks == "e"))
        root.marks = "=";
    const bool is_block = before() == "}" && is_certain && root.marks == "=";
    while (!at_break() && !is_block && !(is_certain && declares_more())) {
        if (next_is("{")) {
            if (!restrictions_in_braces(statement)) return false;
            continue;
        }
        if (!next_is(",")) {
            refuse(surplus());
            return false;
        }
        take();
        const Parsed restriction = choice();
        if (!restriction) return false;
        statement.restrictions.push_back(*restriction);
    }
    tree_.statements.push_back(std::move(statement));
    return true;
}

SyntaxParser::Parsed SyntaxParser::relation_of_statement(bool is_certain) {
    if (starts_instructions(std::span(tokens_).subspan(at_))) return instructions();
    if (is_certain && starts_program_function()) return program_function();
    if (is_certain && starts_pov_function()) return pov_function();
    const Parsed relation = choice();
    if (!relation) return relation;
    return with_equation_outside(*relation);
}

/// Moves the "=" of an equation to the top of the tree, since it binds less than all else: z = x <
/// 0 ? 1 : 2 and f(u) = u < 1.
SyntaxId SyntaxParser::with_equation_outside(SyntaxId root) {
    std::optional<SyntaxId> parent;
    SyntaxId at = root;
    const auto goes_left = [&] {
        const Syntax& here = tree_[at];
        return here.kind == SyntaxKind::And || here.kind == SyntaxKind::Or ||
               (here.kind == SyntaxKind::Cases && here.marks == "?");
    };
    while (goes_left()) {
        parent = at;
        at = tree_[at].operands[0];
    }
    const Syntax compared = tree_[at];
    const bool equates = compared.kind == SyntaxKind::Compare &&
                         (compared.marks[0] == '=' || compared.marks[0] == ':');
    if (!equates || (!parent && compared.marks.size() == 1)) return root;
    const Syntax& left = tree_[compared.operands[0]];
    const bool is_axis = left.text == "x" || left.text == "y" || left.text == "z";
    const bool defines = (left.kind == SyntaxKind::Name && !is_axis) ||
                         (left.kind == SyntaxKind::Call && left.function == nullptr);
    if (!defines && tree_[root].marks != "?") return root;
    SyntaxId rest = compared.operands[1];
    if (compared.marks.size() > 1) {
        rest = add(SyntaxKind::Compare, compared.offset,
                   {compared.operands.begin() + 1, compared.operands.end()},
                   std::string_view(compared.marks).substr(1));
    }
    if (parent) tree_.nodes[*parent].operands[0] = rest;
    const SyntaxId right = parent ? root : rest;
    return add(SyntaxKind::Compare, compared.offset, {compared.operands[0], right},
               compared.marks.substr(0, 1));
}

bool SyntaxParser::restrictions_in_braces(StatementSyntax& statement) {
    const Token& opener = next();
    const List conditions = arguments();
    if (!conditions) return false;
    statement.restrictions.insert(statement.restrictions.end(), conditions->begin(),
                                  conditions->end());
    return close(opener);
}

/// Whether `f(float u, float v) {` is next.
bool SyntaxParser::starts_program_function() const {
    if (next().kind != TokenKind::Name || !is_symbol(tokens_[at_ + 1], {"("})) return false;
    std::size_t at = at_ + 2;
    while (tokens_[at].kind == TokenKind::Name || is_symbol(tokens_[at], {","}))
        ++at;
    return is_symbol(tokens_[at], {")"}) && is_symbol(tokens_[at + 1], {"{"});
}

/// Reads `f(float u, float v) { float a = u*v; return a + 1; }`.
SyntaxParser::Parsed SyntaxParser::program_function() {
    const Token& name = take();
    std::vector<SyntaxId> arguments;
    take();
    while (!next_is(")")) {
        skip_type_words();
        const Token& argument = take();
        if (argument.kind == TokenKind::Name)
            arguments.push_back(
                add(SyntaxKind::Name, argument.offset, {}, {}, full_name(argument)));
    }
    take();
    const SyntaxId call =
        add(SyntaxKind::Call, name.offset, std::move(arguments), {}, full_name(name));
    const Parsed body = block();
    if (!body) return body;
    return add(SyntaxKind::Compare, name.offset, {call, *body}, "=");
}

/// Whether `F = function(u, v) {` or `F = function {` is next.
bool SyntaxParser::starts_pov_function() const {
    return next().kind == TokenKind::Name && is_symbol(tokens_[at_ + 1], {"="}) &&
           tokens_[at_ + 2].kind == TokenKind::Name && tokens_[at_ + 2].text == "function" &&
           is_symbol(tokens_[at_ + 3], {"(", "{"});
}

SyntaxParser::Parsed SyntaxParser::pov_function() {
    const Token& name = take();
    take();
    take();
    std::vector<SyntaxId> arguments;
    const auto add_argument = [&](std::size_t offset, std::string_view text) {
        arguments.push_back(add(SyntaxKind::Name, offset, {}, {}, text));
    };
    if (next_is("(")) {
        while (!next_is("{") && !at_break()) {
            const Token& token = take();
            if (token.kind == TokenKind::Name) add_argument(token.offset, full_name(token));
        }
    } else {
        for (const std::string_view axis : {"x", "y", "z"})
            add_argument(name.offset, axis);
    }
    const SyntaxId call =
        add(SyntaxKind::Call, name.offset, std::move(arguments), {}, full_name(name));
    if (!next_is("{")) return refuse(missing_operand());
    const Parsed body = group(take());
    if (!body) return body;
    return add(SyntaxKind::Compare, name.offset, {call, *body}, "=");
}

namespace {

/// The brackets of the statement around an offset, and of all behind it, that no token closes.
/// Within braces a Break ends no statement: they may hold a function's lines.
std::vector<const Token*> unclosed_brackets(std::span<const Token> tokens, std::size_t offset) {
    constexpr std::array<std::string_view, 3> openers{"(", "[", "{"};
    constexpr std::array<std::string_view, 3> closers{")", "]", "}"};
    std::array<std::vector<const Token*>, 3> open;  // of each kind
    for (const Token& token : tokens) {
        const bool ends = token.kind == TokenKind::Break && open[2].empty();
        for (std::size_t kind = 0; kind < open.size(); ++kind) {
            if (ends && token.offset <= offset) open[kind].clear();
            if (is_symbol(token, {openers[kind]})) open[kind].push_back(&token);
            if (is_symbol(token, {closers[kind]}) && !open[kind].empty()) open[kind].pop_back();
        }
    }
    std::vector<const Token*> unclosed;
    for (const auto& of_kind : open)
        unclosed.insert(unclosed.end(), of_kind.begin(), of_kind.end());
    return unclosed;
}

/// The error for a bracket that is not closed on the lines before an error, which may stand in what
/// was meant as the next row.
std::optional<ParseError> error_for_open_bracket(std::string_view text,
                                                 std::span<const Token> tokens,
                                                 const ParseError& error) {
    const std::size_t before = text.substr(0, error.offset).find_last_of("\n\v");
    if (before == std::string_view::npos) return std::nullopt;
    const Token* last = nullptr;
    for (const Token* const token : unclosed_brackets(tokens, error.offset)) {
        const bool is_later = last == nullptr || token->offset > last->offset;
        if (token->offset < before && is_later) last = token;
    }
    if (last == nullptr) return std::nullopt;
    const std::string closer = last->text == "(" ? ")" : last->text == "[" ? "]" : "}";
    return ParseError{.offset = last->offset,
                      .reason = filled(tr("this {0} is not closed"), {quoted(last->text)}),
                      .hint = filled(tr("add a {0}"), {quoted(closer)})};
}

/// Reads a text in the words of the language.
std::expected<SyntaxTree, ParseError> read_plain(std::string_view text, std::size_t counted_end) {
    Notes notes;
    Notes unused;
    auto tokens = tokenize(text, nullptr, unused);
    if (!tokens) return std::unexpected(tokens.error());
    const DefinedNames defined(*tokens, counted_end, notes);
    tokens = tokenize(text, &defined, notes);
    if (!tokens) return std::unexpected(tokens.error());
    tokens = Words(*tokens, defined).split(*tokens, notes);
    tokens = without_float_suffixes(std::move(*tokens), defined, notes);
    tokens = with_plain_marks(std::move(*tokens), defined, notes);
    SyntaxParser parser(std::move(*tokens), defined, std::move(notes));
    auto tree = parser.text();
    if (tree) return tree;
    auto error = error_for_open_bracket(text, parser.tokens(), tree.error());
    return error ? std::unexpected(std::move(*error)) : tree;
}

/// Reads a text of another program; offsets are those of the text as typed.
std::expected<SyntaxTree, ParseError> read_dialect(const DialectText& dialect,
                                                   std::size_t counted_end) {
    const SourceText& text = dialect.text;
    const auto typed = [&](std::size_t place) { return text.typed_offset(place); };
    auto tree = read_plain(text.words(), text.place_of(counted_end));
    if (!tree) {
        tree.error().offset = typed(tree.error().offset);
        return tree;
    }
    for (Syntax& node : tree->nodes)
        node.offset = typed(node.offset);
    for (StatementSyntax& statement : tree->statements)
        statement.offset = dialect.statement_offset(statement.offset);
    tree->notes.move_offsets(typed);
    tree->notes.add(dialect.notes);
    tree->box = dialect.box;
    tree->box_offset = dialect.box_offset;
    return tree;
}

}  // namespace

std::expected<SyntaxTree, ParseError> read_syntax(std::string_view text, std::size_t counted_end) {
    if (text.size() > ProgramLimits::text) {
        const std::string most = std::to_string(ProgramLimits::text);
        return std::unexpected(
            ParseError{.offset = ProgramLimits::text,
                       .reason = filled(tr("the text is longer than {0} bytes"), {most}),
                       .hint = {}});
    }
    const auto dialect = read_dialects(text);
    if (!dialect) return std::unexpected(dialect.error());
    return *dialect ? read_dialect(**dialect, counted_end) : read_plain(text, counted_end);
}

}  // namespace zeroset
