#include "engine/language/words/words_candidates.hpp"

#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/words/signs.hpp"
#include "engine/language/words/syntax_bars.hpp"
#include "engine/language/words/words_defined.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace zeroset {
namespace {

using Tokens = std::span<const Token>;

bool is_opener(const Token& token) { return is_symbol(token, {"(", "[", "{"}); }
bool is_closer(const Token& token) { return is_symbol(token, {")", "]", "}"}); }
bool defines(const Token& token) { return is_symbol(token, {"=", ":="}); }
bool is_plain_name(const Token& token) {
    return token.kind == TokenKind::Name && !is_logic_word(token.text);
}

/// Number of words before a name that belong to its declaration, such as `const float`.
std::size_t type_words_before(Tokens statement) {
    std::size_t count = 0;
    while (count + 1 < statement.size() && declares(statement[count], statement[count + 1]) &&
           is_plain_name(statement[count + 1]))
        ++count;
    return count;
}

/// Whether conditions follow the value: after a comma that is no decimal comma, or in braces.
bool is_restricted(Tokens value) {
    int open = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const bool braces = i > 0 && is_symbol(value[i], {"{"}) && ends_operand(value[i - 1]);
        if (open == 0 && braces) return true;
        open += is_opener(value[i]) ? 1 : is_closer(value[i]) ? -1 : 0;
        if (open > 0 || !is_symbol(value[i], {","})) continue;
        const bool point = i > 0 && i + 1 < value.size() &&
                           value[i - 1].kind == TokenKind::Number &&
                           value[i + 1].kind == TokenKind::Number &&
                           adjacent(value[i - 1], value[i]) && adjacent(value[i], value[i + 1]);
        if (!point) return true;
    }
    return false;
}

/// Index of the end of the first definition in `float a = 1, b = 2`: a comma after which another
/// definition begins.
std::size_t end_of_declaration(Tokens statement) {
    int open = 0;
    for (std::size_t i = 0; i < statement.size(); ++i) {
        open += is_opener(statement[i]) ? 1 : is_closer(statement[i]) ? -1 : 0;
        const bool next_defines = i + 2 < statement.size() && is_plain_name(statement[i + 1]) &&
                                  defines(statement[i + 2]);
        if (open == 0 && is_symbol(statement[i], {","}) && next_defines) return i;
    }
    return statement.size();
}

/// The arguments of NAME(a, b) = ..., and the tokens after the "=".
struct FunctionHeader {
    std::vector<std::string> arguments;
    Tokens value;
};

std::optional<FunctionHeader> function_header(Tokens from_bracket) {
    const Tokens tokens = from_bracket;
    if (tokens.empty() || !is_symbol(tokens[0], {"(", "["})) return std::nullopt;
    FunctionHeader header;
    for (std::size_t i = 1; i < tokens.size();) {
        i += type_words_before(tokens.subspan(i));
        if (i + 2 >= tokens.size() || !is_plain_name(tokens[i])) return std::nullopt;
        header.arguments.push_back(plain_name(tokens[i].text));
        if (is_symbol(tokens[i + 1], {","})) {
            i += 2;
            continue;
        }
        if (!is_symbol(tokens[i + 1], {")", "]"}) || !defines(tokens[i + 2])) return std::nullopt;
        header.value = tokens.subspan(i + 3);
        return header;
    }
    return std::nullopt;
}

/// Index of the "{" of `float f(float u, float v) {`; 0: there is none.
std::size_t program_function_brace(Tokens tokens) {
    std::size_t at = type_words_before(tokens);
    if (at == 0 || at + 1 >= tokens.size() || !is_symbol(tokens[at + 1], {"("})) return 0;
    at += 2;
    while (at < tokens.size() &&
           (tokens[at].kind == TokenKind::Name || is_symbol(tokens[at], {","})))
        ++at;
    const bool opens =
        at + 1 < tokens.size() && is_symbol(tokens[at], {")"}) && is_symbol(tokens[at + 1], {"{"});
    return opens ? at + 1 : 0;
}

/// Length of the list of instructions at the start, whose line ends do not end it; 0: there is
/// none.
std::size_t instructions_length(Tokens tokens) {
    if (!starts_instructions(tokens)) return 0;
    const auto end = std::ranges::find_if(tokens, [](const Token& token) {
        return token.kind == TokenKind::End ||
               (token.kind == TokenKind::Break && token.text == ";");
    });
    return static_cast<std::size_t>(end - tokens.begin());
}

/// The names among the first two tokens of each line.
std::vector<std::string> names_of_lines(Tokens tokens) {
    std::vector<std::string> names;
    std::size_t place = 0;  // index in the line
    for (const Token& token : tokens) {
        const bool counts = token.kind == TokenKind::Name && place < 2;
        if (counts) names.push_back(plain_name(token.text));
        place = token.kind == TokenKind::Break ? 0 : place + 1;
    }
    return names;
}

/// Length of the first statement; line ends in the braces of a function do not end it.
std::size_t statement_length(Tokens tokens) {
    if (const std::size_t length = instructions_length(tokens); length > 0) return length;
    std::size_t at = program_function_brace(tokens);
    int open = 0;
    for (; at > 0 && at < tokens.size(); ++at) {
        open += is_symbol(tokens[at], {"{"}) ? 1 : is_symbol(tokens[at], {"}"}) ? -1 : 0;
        if (open == 0) return at + 1;
    }
    const auto end = std::ranges::find_if(tokens, [](const Token& token) {
        return token.kind == TokenKind::Break || token.kind == TokenKind::End;
    });
    return static_cast<std::size_t>(end - tokens.begin());
}

/// The names directly before a comma or closing bracket; words before them, such as float, are left
/// out.
std::vector<std::string> names_in_list(Tokens tokens) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (is_plain_name(tokens[i]) && is_symbol(tokens[i + 1], {",", ")"}))
            names.push_back(plain_name(tokens[i].text));
    }
    return names;
}

/// The names that are assigned values in the braces of a function.
std::vector<std::string> names_with_values(Tokens block) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i + 1 < block.size(); ++i) {
        if (is_plain_name(block[i]) && is_symbol(block[i + 1], {"="}))
            names.push_back(plain_name(block[i].text));
    }
    return names;
}

/// The names of the indices of sum(f, i, m, n) and prod(f, i, m, n).
std::vector<std::string> indices_in(Tokens statement) {
    struct Bracket {
        bool repeats;
        int commas;
    };
    std::vector<Bracket> open;
    std::vector<std::string> indices;
    for (std::size_t i = 0; i < statement.size(); ++i) {
        const Token& token = statement[i];
        if (is_opener(token)) {
            const Function* const function =
                i > 0 && statement[i - 1].kind == TokenKind::Name
                    ? find_function(in_small_letters(statement[i - 1].text))
                    : nullptr;
            open.push_back({.repeats = function != nullptr && function->repeats(), .commas = 0});
            const bool iterates = function != nullptr && function->iterates();
            if (iterates && i + 1 < statement.size() && is_plain_name(statement[i + 1]))
                indices.push_back(plain_name(statement[i + 1].text));
        } else if (open.empty()) {
            continue;
        } else if (is_closer(token)) {
            open.pop_back();
        } else if (is_symbol(token, {","})) {
            ++open.back().commas;
        } else if (is_plain_name(token) && open.back().repeats && open.back().commas == 1 &&
                   is_symbol(statement[i - 1], {","})) {
            indices.push_back(plain_name(token.text));
        }
    }
    return indices;
}

}  // namespace

bool starts_instructions(Tokens tokens) {
    if (tokens.size() < 3 || tokens[0].kind != TokenKind::Name) return false;
    if (tokens[1].kind != TokenKind::Name || adjacent(tokens[0], tokens[1])) return false;
    if (tokens[1].text == "const") {
        return tokens[2].kind == TokenKind::Number || is_symbol(tokens[2], {"+", "-"});
    }
    return tokens[1].text == "var" && is_symbol(tokens[2], {"-"}) && adjacent(tokens[1], tokens[2]);
}

Candidates::Candidates(Tokens tokens, std::size_t counted_end) {
    auto rest = tokens;
    while (!rest.empty()) {
        const std::size_t length = statement_length(rest);
        if (length > 0) read_statement(rest.first(length));
        const bool breaks = length < rest.size() && rest[length].kind != TokenKind::Name;
        rest = rest.subspan(std::min(length + (breaks || length == 0 ? 1 : 0), rest.size()));
    }
    count_uses(tokens, counted_end);
}

void Candidates::read_statement(Tokens statement) {
    if (starts_instructions(statement)) {
        candidates_.push_back({.begin = statement.front().offset,
                               .end = statement.back().end(),
                               .indices = names_of_lines(statement)});
        has_equations_ = true;
        return;
    }
    const std::size_t types = type_words_before(statement);
    if (const std::size_t brace = program_function_brace(statement); brace > 0) {
        read_program_function(statement, types, brace);
        return;
    }
    std::size_t begin = statement.front().offset;
    Tokens rest = statement.subspan(types);
    while (types > 0) {
        const std::size_t length = end_of_declaration(rest);
        if (length == rest.size()) break;
        read_definition(rest.first(length), begin, true);
        begin = rest[length].end();
        rest = rest.subspan(length + 1);
    }
    read_definition(rest, begin, types > 0);
}

/// Reads `float f(float u, float v) { float a = u*v; return a + 1; }`.
void Candidates::read_program_function(Tokens statement, std::size_t name, std::size_t brace) {
    Candidate candidate{.name = plain_name(statement[name].text),
                        .is_function = true,
                        .is_certain = true,
                        .name_offset = statement[name].offset,
                        .begin = statement.front().offset,
                        .end = statement.back().end()};
    candidate.arguments = names_in_list(statement.subspan(name + 2, brace - name - 2));
    candidate.indices = names_with_values(statement.subspan(brace));
    candidate.value = statement.subspan(brace);
    uses_.try_emplace(candidate.name);
    candidates_.push_back(std::move(candidate));
}

/// Reads `F = function(u, v) { u + v }`; without a list the arguments are x, y and z.
void read_pov_function(Candidate& candidate) {
    const Tokens value = candidate.value;
    if (!candidate.is_certain || value.size() < 2 || value[0].text != "function") return;
    candidate.is_function = true;
    candidate.arguments = {"x", "y", "z"};
    if (!is_symbol(value[1], {"("})) return;
    const auto brace =
        std::ranges::find_if(value, [](const Token& token) { return is_symbol(token, {"{"}); });
    candidate.arguments =
        names_in_list(value.first(static_cast<std::size_t>(brace - value.begin())));
}

void Candidates::read_definition(Tokens statement, std::size_t begin, bool is_certain) {
    Candidate candidate{.begin = begin, .end = statement.back().end()};
    candidate.indices = indices_in(statement);
    bool is_definition = false;
    if (statement.size() > 2 && is_plain_name(statement[0])) {
        candidate.name = plain_name(statement[0].text);
        candidate.name_offset = statement[0].offset;
        candidate.is_certain = is_certain;
        if (defines(statement[1]) && (is_certain || !is_restricted(statement.subspan(2)))) {
            is_definition = true;
            candidate.is_certain = is_certain || is_symbol(statement[1], {":="});
            candidate.value = statement.subspan(2);
            read_pov_function(candidate);
        } else if (auto header = function_header(statement.subspan(1))) {
            is_definition = true;
            candidate.is_function = true;
            const Token& sign = *(header->value.data() - 1);
            candidate.is_certain = is_certain || is_symbol(sign, {":="});
            candidate.arguments = std::move(header->arguments);
            candidate.value = header->value;
        }
    }
    const std::string& name = candidate.name;
    const bool is_axis = name == "x" || name == "y" || name == "z";
    if (!is_definition || is_axis) has_equations_ = true;
    if (!is_definition) candidate.name.clear();
    if (is_definition) uses_.try_emplace(name);
    if (is_definition || !candidate.indices.empty()) candidates_.push_back(std::move(candidate));
}

/// Counts the uses of each name outside of the statements that define it.
void Candidates::count_uses(Tokens tokens, std::size_t counted_end) {
    auto candidate = candidates_.begin();
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        if (token.kind != TokenKind::Name) continue;
        const auto uses = find_plain(uses_, token.text);
        if (uses == uses_.end() || token.text.size() == 1) read_letters(token.text);
        while (candidate != candidates_.end() && candidate->end <= token.offset)
            ++candidate;
        if (uses == uses_.end() || token.offset >= counted_end) continue;
        const bool is_inside = candidate != candidates_.end() && candidate->begin <= token.offset;
        if (is_inside && candidate->name == uses->first) continue;
        ++uses->second.all;
        if (is_symbol(tokens[i + 1], {"(", "["})) ++uses->second.calls;
    }
}

/// Adds the letters of a run that have no letter next to them.
void Candidates::read_letters(std::string_view run) {
    for (std::size_t at = 0; at < run.size();) {
        if (!is_letter(run[at])) {
            ++at;
            continue;
        }
        const std::size_t begin = at;
        while (at < run.size() && is_letter(run[at]))
            ++at;
        if (at - begin == 1) vocabulary_.add_letter(run[begin]);
        if (at + 1 >= run.size() || run[at] != '_') continue;
        ++at;
        const bool number = is_digit(run[at]);
        const auto in_subscript = [&](char c) { return is_digit(c) || (!number && is_letter(c)); };
        while (at < run.size() && in_subscript(run[at]))
            ++at;
    }
}

NameUses Candidates::uses(std::string_view name) const {
    const auto uses = uses_.find(name);
    return uses == uses_.end() ? NameUses{} : uses->second;
}

}  // namespace zeroset
