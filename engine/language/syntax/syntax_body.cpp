// Functions' braces as programs write them: values one after the other, choices and results.
//
// A body becomes one expression: `float a = u; return a;` an expression in which a is u, and `if
// (c) return a; return b;` the choice c ? a : b. Where a choice only changes values, each of them
// is a choice by itself, so that what follows is read once.

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {
namespace {

constexpr int most_read = 2'000;  // steps of a body, each counted as often as it is read

}  // namespace

/// Reads a function's braces, up to its result.
SyntaxParser::Parsed SyntaxParser::block() {
    const Token& opener = take();
    std::vector<BodyStep> steps;
    if (!steps_in_braces(opener, steps)) return std::nullopt;
    if (!may_nest(static_cast<int>(steps.size()))) return std::nullopt;
    const std::size_t closer = at_ - 1;
    steps_read_ = 0;
    return result_of(steps, nullptr, closer);
}

/// Reads the steps behind a "{" that is taken, and the "}".
bool SyntaxParser::steps_in_braces(const Token& opener, std::vector<BodyStep>& steps) {
    for (;;) {
        skip_breaks();
        const bool returns = !steps.empty() && steps.back().kind == BodyStep::Kind::Return;
        if (returns && !next_is("}")) {
            refuse({.offset = opener.offset,
                    .reason = tr("this '{' is not closed behind 'return'"),
                    .hint = tr("add a '}'"),
                    .unfinished = next().kind == TokenKind::End});
            return false;
        }
        if (next_is("}")) break;
        if (!step(steps)) return false;
    }
    take();
    return true;
}

/// Reads `return a;`, a choice, or values.
bool SyntaxParser::step(std::vector<BodyStep>& steps) {
    const Level level(depth_);
    if (!may_nest()) return false;
    if (next_is_word("if") && is_symbol(tokens_[at_ + 1], {"("})) return choice_step(steps);
    if (!next_is_word("return")) return local_value(steps);
    const std::size_t offset = take().offset;
    while (next().kind == TokenKind::Break && next().text != ";")
        take();
    const Parsed value = choice();
    if (!value) return false;
    steps.push_back({.kind = BodyStep::Kind::Return, .offset = offset, .value = *value});
    return true;
}

/// Reads `if (c) a = 1; else { ... }`.
bool SyntaxParser::choice_step(std::vector<BodyStep>& steps) {
    BodyStep choice{.kind = BodyStep::Kind::Choice, .offset = take().offset};
    const Parsed condition = group(take());
    if (!condition) return false;
    choice.value = *condition;
    if (!branch(choice.then)) return false;
    const std::size_t behind = at_;
    skip_breaks();
    if (next_is_word("else")) {
        take();
        if (!branch(choice.otherwise)) return false;
    } else {
        at_ = behind;
    }
    steps.push_back(std::move(choice));
    return true;
}

/// Reads one step, or several in braces. The names that they declare end there.
bool SyntaxParser::branch(std::vector<BodyStep>& steps) {
    while (next().kind == TokenKind::Break && next().text != ";")
        take();
    ++branch_;
    if (!(next_is("{") ? steps_in_braces(take(), steps) : step(steps))) return false;
    for (const BodyStep& ended : steps) {
        if (ended.declares)
            names_in_branches_[ended.name.substr(0, ended.name.find(' '))].pop_back();
    }
    --branch_;
    return true;
}

/// The name in the tree for a name of the text: one that a branch declares has a space behind it
/// for each branch around it, so that it differs from names declared outside.
std::string SyntaxParser::name_in_branch(std::string name) const {
    const auto declared = names_in_branches_.find(name);
    if (declared == names_in_branches_.end() || declared->second.empty()) return name;
    return name.append(declared->second.back(), ' ');
}

void SyntaxParser::skip_breaks() {
    while (next().kind == TokenKind::Break)
        take();
}

/// The result of a body from these steps on, then of what follows them; `closer`: index of the
/// body's "}".
SyntaxParser::Parsed SyntaxParser::result_of(std::span<const BodyStep> steps,
                                             const FollowingSteps* behind, std::size_t closer) {
    if (++steps_read_ > most_read) {
        return fail(tokens_[closer], tr("the sums and functions here ask for too many operations"),
                    tr("use fewer terms"));
    }
    if (steps.empty() && behind != nullptr) return result_of(behind->steps, behind->next, closer);
    if (steps.empty()) return refuse(no_step(tokens_[closer]));
    const BodyStep& first = steps.front();
    const std::span<const BodyStep> rest = steps.subspan(1);
    if (first.kind == BodyStep::Kind::Return) return first.value;
    if (first.kind == BodyStep::Kind::Value) {
        const Parsed result = result_of(rest, behind, closer);
        if (!result) return result;
        return add(SyntaxKind::Let, first.offset, {first.value, *result}, {}, first.name);
    }
    if (!returns_within(first)) return result_behind_values(first, rest, behind, closer);
    const FollowingSteps following{.steps = rest, .next = behind};
    const Parsed then = result_of(first.then, &following, closer);
    const Parsed otherwise = then ? result_of(first.otherwise, &following, closer) : then;
    if (!otherwise) return otherwise;
    return add(SyntaxKind::Cases, first.offset, {first.value, *then, *otherwise}, "?");
}

bool SyntaxParser::returns_within(const BodyStep& step) {
    return step.kind == BodyStep::Kind::Return || std::ranges::any_of(step.then, returns_within) ||
           std::ranges::any_of(step.otherwise, returns_within);
}

/// Adds the names whose values steps change; those declared in them end there.
void SyntaxParser::add_changed(std::span<const BodyStep> steps, std::vector<std::string>& names) {
    std::vector<std::string> declared;
    const auto has = [](const std::vector<std::string>& list, const std::string& name) {
        return std::ranges::find(list, name) != list.end();
    };
    for (const BodyStep& step : steps) {
        std::vector<std::string> changed;
        if (step.kind == BodyStep::Kind::Value) changed.push_back(step.name);
        add_changed(step.then, changed);
        add_changed(step.otherwise, changed);
        if (step.declares) declared.push_back(step.name);
        for (std::string& name : changed) {
            if (!has(declared, name) && !has(names, name)) names.push_back(std::move(name));
        }
    }
}

/// The result behind a choice that only changes values. All of them are found before any takes the
/// place of its old value.
SyntaxParser::Parsed SyntaxParser::result_behind_values(const BodyStep& step,
                                                        std::span<const BodyStep> rest,
                                                        const FollowingSteps* behind,
                                                        std::size_t closer) {
    std::vector<std::string> names;
    add_changed(step.then, names);
    add_changed(step.otherwise, names);
    std::vector<SyntaxId> values;
    for (const std::string& name : names) {
        const SyntaxId old = add(SyntaxKind::Name, step.offset, {}, {}, name);
        const BodyStep result{.kind = BodyStep::Kind::Return, .offset = step.offset, .value = old};
        const FollowingSteps following{.steps = std::span(&result, 1), .next = nullptr};
        const Parsed then = result_of(step.then, &following, closer);
        const Parsed otherwise = then ? result_of(step.otherwise, &following, closer) : then;
        if (!otherwise) return otherwise;
        values.push_back(add(SyntaxKind::Cases, step.offset, {step.value, *then, *otherwise}, "?"));
    }
    Parsed result = result_of(rest, behind, closer);
    if (!result) return result;
    const auto later = [](const std::string& name) { return name + " later"; };
    for (const std::string& name : names) {
        const SyntaxId value = add(SyntaxKind::Name, step.offset, {}, {}, later(name));
        result = add(SyntaxKind::Let, step.offset, {value, *result}, {}, name);
    }
    for (std::size_t i = 0; i < names.size(); ++i)
        result = add(SyntaxKind::Let, step.offset, {values[i], *result}, {}, later(names[i]));
    return result;
}

/// The value that a local name has behind `p.xy *= value`; without a part or a sign they are empty.
SyntaxId SyntaxParser::new_value(const Token& name, std::string_view part, std::string_view sign,
                                 SyntaxId value) {
    const auto old = [&] {
        return add(SyntaxKind::Name, name.offset, {}, {}, name_in_branch(full_name(name)));
    };
    if (!sign.empty()) {
        const bool adds = sign == "+" || sign == "-";
        SyntaxId before = old();
        if (!part.empty()) before = add(SyntaxKind::Part, name.end(), {before}, {}, part);
        value =
            add(adds ? SyntaxKind::Sum : SyntaxKind::Product, name.offset, {before, value}, sign);
    }
    if (part.empty()) return value;
    return add(SyntaxKind::Replace, name.end(), {old(), value}, {}, part);
}

/// The error for what is none of the steps of a body.
ParseError SyntaxParser::no_step(const Token& at) {
    return {.offset = at.offset,
            .reason = tr("only values, 'if' and 'return' are read in a function's braces"),
            .hint = tr("type NAME = value; and return value;"),
            .unfinished = at.kind == TokenKind::End};
}

/// Reads `float a = 1, b = 2;`, what changes a value, as `p.xy *= 2;`, and `vec3 q;`, whose parts
/// are 0 until they are given values.
bool SyntaxParser::local_value(std::vector<BodyStep>& steps) {
    const bool is_certain = skip_type_words();
    const std::string_view type = is_certain ? tokens_[at_ - 1].text : std::string_view();
    for (;;) {
        if (!named_value(type, steps)) return false;
        if (next().kind == TokenKind::Break) return true;
        if (!is_certain || !next_is(",") || tokens_[at_ + 1].kind != TokenKind::Name) break;
        take();
    }
    fail(next(), tr("';' is missing behind a value in a function's braces"),
         tr("type NAME = value;"));
    return false;
}

/// The value of a name that is declared without one.
SyntaxId SyntaxParser::zero_of(std::string_view type, std::size_t offset) {
    const auto zero = [&] { return add(SyntaxKind::Number, offset, {}, {}, "0"); };
    if (type != "vec2" && type != "vec3" && type != "vec4") return zero();
    std::vector<SyntaxId> parts;
    for (char i = '0'; i < type.back(); ++i)
        parts.push_back(zero());
    return add(SyntaxKind::Vector, offset, std::move(parts));
}

/// Reads a name, perhaps with a part, and its value; `type`: the word before it, such as float;
/// empty: the name is not new.
bool SyntaxParser::named_value(std::string_view type, std::vector<BodyStep>& steps) {
    const bool declares = !type.empty();
    const Token& name = next();
    const bool is_name = name.kind == TokenKind::Name;
    const bool has_part = is_name && tokens_[at_ + 1].kind == TokenKind::Part;
    const std::size_t at = at_ + (has_part ? 2 : 1);
    const bool changes = is_name && is_symbol(tokens_[at], {"+", "-", "*", "/"}) &&
                         is_symbol(tokens_[at + 1], {"="}) &&
                         adjacent(tokens_[at], tokens_[at + 1]);
    const bool is_open = declares && is_name && !has_part &&
                         (tokens_[at].kind == TokenKind::Break || is_symbol(tokens_[at], {","}));
    if (!is_name || (!changes && !is_open && !is_symbol(tokens_[at], {"="}))) {
        refuse(no_step(name));
        return false;
    }
    at_ = at + (changes ? 2 : is_open ? 0 : 1);
    Parsed value = is_open ? zero_of(type, name.offset) : choice();
    if (!value) return false;
    const auto part = has_part ? tokens_[at - 1].text : std::string_view();
    value = new_value(name, part, changes ? tokens_[at].text : std::string_view(), *value);
    if (declares && branch_ > 0) names_in_branches_[full_name(name)].push_back(branch_);
    steps.push_back({.kind = BodyStep::Kind::Value,
                     .offset = name.offset,
                     .value = *value,
                     .name = name_in_branch(full_name(name)),
                     .declares = declares});
    return true;
}

}  // namespace zeroset
