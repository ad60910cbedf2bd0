// Loops in functions' braces: for (int i = 0; i < 8; i++) { ... }, written out round by round.

#include "engine/base/text.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace zeroset {
namespace {

constexpr int most_rounds = 100;  // of a loop

}  // namespace

/// Whether `for (` is next.
bool SyntaxParser::starts_loop() const {
    return next_is_word("for") && is_symbol(tokens_[at_ + 1], {"("});
}

/// Reads `for (int i = 0; i < 8; i++)` and what is done in each round.
bool SyntaxParser::loop_step(std::vector<BodyStep>& steps) {
    const Token& word = next();
    const auto loop = loop_header();
    if (!loop) {
        refuse(no_step(word));
        return false;
    }
    BodyStep all{.kind = BodyStep::Kind::Loop, .offset = word.offset};
    const std::string index = full_name(*loop->name);
    const std::size_t body = at_;
    double value = loop->first;
    for (int i = 0; i < loop->rounds; ++i, value += loop->step) {
        at_ = body;
        names_in_branches_[index].push_back(branch_ + 1);
        BodyStep round{.kind = BodyStep::Kind::Round, .offset = word.offset};
        round.then.push_back({.kind = BodyStep::Kind::Value,
                              .offset = word.offset,
                              .value = number_node(value, word.offset),
                              .name = name_in_branch(index),
                              .declares = true});
        if (!branch(round.then)) return false;
        all.then.push_back(std::move(round));
    }
    steps.push_back(std::move(all));
    return true;
}

SyntaxId SyntaxParser::number_node(double value, std::size_t offset) {
    const SyntaxId size =
        add(SyntaxKind::Number, offset, {}, {}, short_number(std::abs(value), 17));
    return value < 0 ? add(SyntaxKind::Negate, offset, {size}) : size;
}

/// Reads a loop's head; nothing, and no error, where its rounds cannot be counted.
std::optional<SyntaxParser::Loop> SyntaxParser::loop_header() {
    take();
    take();
    skip_type_words();
    Loop loop{.name = &take()};
    const auto is_name = [&](const Token& token) {
        return token.kind == TokenKind::Name && full_name(token) == full_name(*loop.name);
    };
    const auto takes = [&](std::string_view symbol) {
        const bool is_next = next_is(symbol);
        if (is_next) take();
        return is_next;
    };
    if (loop.name->kind != TokenKind::Name || !takes("=")) return std::nullopt;
    const auto first = counted_number();
    if (!first || next().text != ";") return std::nullopt;
    take();
    if (!is_name(take()) || !next_is_one_of({"<", "<=", ">", ">="})) return std::nullopt;
    const std::string_view mark = take().text;
    const auto last = counted_number();
    if (!last || next().text != ";") return std::nullopt;
    take();
    const auto step = loop_increment(*loop.name);
    if (!step || !takes(")")) return std::nullopt;
    loop.first = *first;
    loop.step = *step;
    const bool ascends = mark.front() == '<';
    if (ascends != loop.step > 0) return std::nullopt;
    const double steps = (*last - *first) / *step;
    if (!(steps < most_rounds)) return std::nullopt;
    const bool with_last = mark.size() == 2;
    loop.rounds =
        static_cast<int>(std::max(with_last ? std::floor(steps) + 1 : std::ceil(steps), 0.0));
    return loop.rounds > 0 ? std::optional(loop) : std::nullopt;
}

/// Reads `i++`, `++i`, `i--`, `i += 2` or `i = i + 2`; nothing where it is none of these.
std::optional<double> SyntaxParser::loop_increment(const Token& name) {
    const bool before = next_is_one_of({"+", "-"});
    std::string_view sign = before ? take().text : std::string_view();
    if (before && !next_is(sign)) return std::nullopt;
    if (before) take();
    const Token& changed = take();
    if (changed.kind != TokenKind::Name || full_name(changed) != full_name(name))
        return std::nullopt;
    double size = 1;
    if (!before) {
        if (!next_is_one_of({"+", "-"})) return std::nullopt;
        sign = take().text;
        if (next_is("=")) {
            take();
            const auto by = counted_number();
            if (!by) return std::nullopt;
            size = *by;
        } else if (next_is(sign)) {
            take();
        } else {
            return std::nullopt;
        }
    }
    const double step = sign == "-" ? -size : size;
    return step != 0 ? std::optional(step) : std::nullopt;
}

/// Reads a number, or the name of one that the body or the text defines before: #define STEPS 8.
std::optional<double> SyntaxParser::counted_number() {
    const bool negative = next_is("-");
    if (negative) take();
    const Token& token = take();
    std::optional<double> size;
    if (token.kind == TokenKind::Number) size = number_from<double>(token.text);
    if (token.kind == TokenKind::Name) {
        const auto local = local_numbers_.find(full_name(token));
        if (local != local_numbers_.end()) return negative ? -local->second : local->second;
        for (const StatementSyntax& statement : tree_.statements) {
            const Syntax& relation = tree_[statement.relation];
            if (relation.kind != SyntaxKind::Compare || relation.operands.size() != 2) continue;
            const Syntax& left = tree_[relation.operands[0]];
            const Syntax& right = tree_[relation.operands[1]];
            const bool is_it = left.kind == SyntaxKind::Name && left.text == full_name(token);
            if (is_it && right.kind == SyntaxKind::Number) size = number_from<double>(right.text);
        }
    }
    return size && negative ? -*size : size;
}

/// Keeps the number that a step gives a name for loops behind it.
void SyntaxParser::keep_number(const BodyStep& step, bool in_branch) {
    const Syntax& value = tree_[step.value];
    const std::string name = step.name.substr(0, step.name.find(' '));
    local_numbers_.erase(name);
    const auto number = value.kind == SyntaxKind::Number && step.declares && !in_branch
                            ? number_from<double>(value.text)
                            : std::nullopt;
    if (number) local_numbers_.emplace(name, *number);
}

/// Whether `break;` or `continue;` is next.
bool SyntaxParser::starts_leaving() const {
    const bool leaves = next_is_word("break") || next_is_word("continue");
    return leaves && tokens_[at_ + 1].kind == TokenKind::Break;
}

/// What follows the loop, or the round of it, that a step leaves; nullptr: it is in none.
const SyntaxParser::FollowingSteps* SyntaxParser::following_left(const FollowingSteps* behind,
                                                                 BodyStep::Kind leaves) {
    const auto of = leaves == BodyStep::Kind::Break ? BodyStep::Kind::Loop : BodyStep::Kind::Round;
    while (behind != nullptr && behind->of != of)
        behind = behind->next;
    return behind;
}

}  // namespace zeroset
