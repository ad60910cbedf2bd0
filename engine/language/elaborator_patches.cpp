// Rows that are given by a point: parametric surfaces, curves and points.

#include "engine/base/translation.hpp"
#include "engine/expr/patch_graph.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/elaborator.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// The first number of the parameters that stand for the variables of a row while it is looked at.
constexpr int first_variable = variable_w + 1 + static_cast<int>(ProgramLimits::parameters);

constexpr const char* example = "(u cos v, u sin v, v), 0 < u < 1, 0 < v < 2 pi";

bool is_ascending(std::string_view marks) {
    return marks.find_first_not_of("<l") == std::string_view::npos;
}

bool is_descending(std::string_view marks) {
    return marks.find_first_not_of(">g") == std::string_view::npos;
}

}  // namespace

Elaborator::Row::Row(Elaborator& of, std::vector<std::string> names) : of_(of) {
    const auto [known_row, is_new] = of.going_by_.try_emplace(names);
    of.going_by_row_ = &known_row->second;
    if (!is_new) return;
    known_row->second = of.table_.going_by(names);
    for (const Definition* const definition : known_row->second) {
        std::vector<std::string>& known = of.rows_[definition];
        for (const std::string& name : names) {
            if (std::ranges::find(known, name) == known.end()) known.push_back(name);
        }
    }
}

Elaborator::Row::~Row() {
    of_.bind_row(nullptr);
    of_.going_by_row_ = nullptr;
}

/// Gives the variables of the row that is being built other values.
void Elaborator::bind_row(const Binding* variables) {
    row_ = variables;
    ++binding_;
    row_values_.clear();
    row_calls_.clear();
}

/// Whether a definition goes by variables of the row that is being built, and has a value of its
/// own there: r = 2 + cos v in (r cos u, r sin u, sin v), 0 < u < 1, 0 < v < 1.
bool Elaborator::goes_by_row(const Definition& definition) const {
    return row_ != nullptr && going_by_row_ != nullptr && going_by_row_->contains(&definition);
}

/// The point that a row shows, if it shows one: the right side of r(u, v) = (u, v, 0), 0 < u < 1,
/// 0 < v < 1; where the row has no name, all of it.
SyntaxId Elaborator::point_in(const StatementSyntax& statement) const {
    const Syntax& relation = tree_[statement.relation];
    if (statement.restrictions.empty() || relation.kind != SyntaxKind::Compare ||
        relation.marks != "=")
        return statement.relation;
    const Syntax& left = tree_[relation.operands[0]];
    const bool is_axis = left.text == "x" || left.text == "y" || left.text == "z";
    const bool names = (left.kind == SyntaxKind::Name && !is_axis) ||
                       (left.kind == SyntaxKind::Call && left.function == nullptr);
    return names ? relation.operands[1] : statement.relation;
}

/// Adds the ranges a < u < b that a condition gives; false if it says something else.
bool Elaborator::add_ranges(SyntaxId id, std::vector<Ranged>& ranges) const {
    const Syntax& syntax = tree_[id];
    if (syntax.kind == SyntaxKind::And) {
        return std::ranges::all_of(syntax.operands,
                                   [&](SyntaxId part) { return add_ranges(part, ranges); });
    }
    if (syntax.kind != SyntaxKind::Compare || syntax.operands.size() != 3) return false;
    const Syntax& middle = tree_[syntax.operands[1]];
    const bool is_axis = middle.text == "x" || middle.text == "y" || middle.text == "z";
    if (middle.kind != SyntaxKind::Name || is_axis) return false;
    const bool ascends = is_ascending(syntax.marks);
    if (!ascends && !is_descending(syntax.marks)) return false;
    ranges.push_back({.name = middle.text,
                      .lo = syntax.operands[ascends ? 0 : 2],
                      .hi = syntax.operands[ascends ? 2 : 0],
                      .offset = syntax.offset});
    return true;
}

/// Whether a row may be given by a point: what it relates is no condition, and it is a vector that
/// is written out, or is restricted by ranges of its variables alone.
bool Elaborator::may_be_patch(const StatementSyntax& statement) {
    const SyntaxId point = point_in(statement);
    const SyntaxKind kind = tree_[point].kind;
    if (kind == SyntaxKind::Vector && point == statement.relation) return true;
    if (is_condition(kind) || statement.restrictions.empty()) return false;
    if (!table_.is_bundle(point)) return false;
    std::vector<Ranged> ranges;
    return std::ranges::all_of(statement.restrictions,
                               [&](SyntaxId id) { return add_ranges(id, ranges); });
}

/// The values of a row's variables: x and y of the graph run over [0, 1] for them.
std::optional<std::vector<Elaborator::Binding>> Elaborator::bind_ranges(
    const std::vector<Ranged>& ranges) {
    std::vector<Binding> bindings;
    bindings.reserve(ranges.size());
    for (const Ranged& range : ranges) {
        const Binding* const scope = bindings.empty() ? nullptr : &bindings.back();
        bind_row(scope);
        const Number lo = number(range.lo, scope);
        const Number hi = lo ? number(range.hi, scope) : std::nullopt;
        if (!hi) return std::nullopt;
        const NodeId width = make_subtract(builder_, *hi, *lo);
        const NodeId share = builder_.variable(static_cast<int>(bindings.size()));
        const NodeId value = make_add(builder_, *lo, make_multiply(builder_, width, share));
        if (!done(value, range.offset)) return std::nullopt;
        const auto& constant = values_.facts(width).constant;
        if (constant && constant->hi <= 0.0) {
            fail(range.offset, filled(tr("the range of {0} is empty"), {range.name}),
                 filled(tr("type the lower end first: {0}"), {"0 < " + range.name + " < 1"}));
            return std::nullopt;
        }
        bindings.push_back({.name = range.name, .value = Value{.id = value}, .outer = scope});
    }
    return bindings;
}

/// The variables themselves, as parameters of their own.
std::optional<std::vector<Elaborator::Binding>> Elaborator::bind_names(
    const std::vector<Ranged>& ranges) {
    std::vector<Binding> bindings;
    bindings.reserve(ranges.size());
    for (const Ranged& range : ranges) {
        const Binding* const scope = bindings.empty() ? nullptr : &bindings.back();
        const NodeId variable =
            builder_.variable(first_variable + static_cast<int>(bindings.size()));
        if (!done(variable, range.offset)) return std::nullopt;
        bindings.push_back({.name = range.name, .value = Value{.id = variable}, .outer = scope});
    }
    return bindings;
}

/// The point that a row is; nothing, and perhaps no error, where it is no vector of 3.
std::optional<std::array<NodeId, 3>> Elaborator::point_over(const StatementSyntax& statement,
                                                            const std::vector<Binding>& bindings) {
    const Binding* const scope = bindings.empty() ? nullptr : &bindings.back();
    bind_row(scope);
    const Built value = build(point_in(statement), scope);
    return value ? value->point() : std::nullopt;
}

/// The first of the usual names of variables that a row uses without saying what it is; empty:
/// there is none.
std::string Elaborator::open_variable(std::size_t statement, const std::vector<Ranged>& ranges) {
    for (const NameUse& use : table_.uses(statement)) {
        const std::string& name = tree_[use.at].text;
        const bool is_usual = name == "u" || name == "v" || name == "t";
        const bool is_ranged = std::ranges::find(ranges, name, &Ranged::name) != ranges.end();
        if (is_usual && !is_ranged && table_.meant(use, statement) == nullptr) return name;
    }
    return {};
}

/// How the row is read: the vector and the ranges, with every operator written out.
std::string Elaborator::patch_text(const std::array<NodeId, 3>& point,
                                   const std::vector<Ranged>& ranges,
                                   const std::vector<Binding>& bindings) {
    std::vector<std::string> names = parameters_;
    names.resize(ProgramLimits::parameters);
    for (const Ranged& range : ranges)
        names.push_back(range.name);
    const std::size_t longest = longest_definition();
    std::string text = "(";
    for (std::size_t i = 0; i < point.size(); ++i)
        text += (i > 0 ? ", " : "") + builder_.text(point.at(i), names, longest);
    text += ")";
    for (const Ranged& range : ranges) {
        const Binding* const scope = bindings.empty() ? nullptr : &bindings.back();
        const Number lo = number(range.lo, scope);
        const Number hi = lo ? number(range.hi, scope) : std::nullopt;
        if (!hi) break;
        text += ", " + builder_.text(*lo, names, longest) + " < " + range.name + " < " +
                builder_.text(*hi, names, longest);
    }
    return text;
}

bool Elaborator::check_ranges(const StatementSyntax& statement, std::vector<Ranged>& ranges) {
    for (const SyntaxId id : statement.restrictions) {
        if (add_ranges(id, ranges)) continue;
        fail(tree_[id].offset, tr("only ranges of its variables stand behind a point"),
             filled(tr("type {0}, and cut it by the clip box or a section"), {example}));
        return false;
    }
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const bool again =
            std::any_of(ranges.begin(), ranges.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const Ranged& other) { return other.name == ranges[i].name; });
        if (again) {
            fail(ranges[i].offset, filled(tr("{0} has two ranges"), {ranges[i].name}));
            return false;
        }
    }
    if (ranges.size() > 2) {
        fail(ranges[2].offset, tr("a surface has two variables, and a curve one"),
             filled(tr("type {0}"), {example}));
        return false;
    }
    return true;
}

/// Whether each range goes by variables of ranges before it alone; `names`: as from bind_names.
bool Elaborator::check_order(const std::vector<Ranged>& ranges, const std::vector<Binding>& names) {
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        for (const SyntaxId end : {ranges[i].lo, ranges[i].hi}) {
            const Number value = number(end, &names.back());
            if (!value) return false;
            for (std::size_t later = i; later < ranges.size(); ++later) {
                const int variable = first_variable + static_cast<int>(later);
                if (!builder_.finish(*value).uses_variable(variable)) continue;
                fail(ranges[i].offset,
                     filled(tr("the range of {0} goes by {1}"),
                            {ranges[i].name, ranges[later].name}),
                     later == i ? filled(tr("type {0}"), {example})
                                : filled(tr("type the range of {0} first"), {ranges[later].name}));
                return false;
            }
        }
    }
    return true;
}

/// Builds a row that is given by a point.
bool Elaborator::build_patch(std::size_t index) {
    const StatementSyntax& statement = tree_.statements[index];
    statement_ = index;
    std::vector<Ranged> ranges;
    if (!check_ranges(statement, ranges)) return false;
    std::vector<std::string> variables;
    variables.reserve(ranges.size());
    for (const Ranged& range : ranges)
        variables.push_back(range.name);
    const Row row(*this, std::move(variables));
    const auto names = bind_names(ranges);
    if (!names) return false;
    const auto typed = point_over(statement, *names);
    if (!typed && !values_.failed()) {
        fail(statement.offset, tr("a row with ranges of variables is a point of three numbers"),
             filled(tr("type {0}"), {example}));
    }
    if (!typed) return false;
    if (std::ranges::any_of(*typed, [&](NodeId id) { return values_.uses_space(id); })) {
        fail(statement.offset,
             tr("a point is given by numbers and variables with a range, not by "
                "x, y and z"),
             filled(tr("type {0}"), {example}));
        return false;
    }
    if (!check_order(ranges, *names)) return false;
    const std::string open = ranges.size() < 2 ? open_variable(index, ranges) : std::string();
    if (!open.empty()) {
        fail(statement.offset, filled(tr("{0} has no range"), {open}),
             filled(tr("type {0}"), {example}));
        return false;
    }
    std::string text = patch_text(*typed, ranges, *names);
    const auto shares = bind_ranges(ranges);
    const auto point = shares ? point_over(statement, *shares) : std::nullopt;
    if (!point) return false;
    constexpr std::array kinds{PatchKind::Point, PatchKind::Curve, PatchKind::Surface};
    return add_patch(index, kinds.at(ranges.size()), *point, std::move(text));
}

/// Whether a definition is no point that is drawn: those have a capital letter as their name, so
/// that other vectors, which rows are made of, are not seen.
bool Elaborator::draws_nothing(const Definition& definition) {
    const bool is_capital = definition.name.front() >= 'A' && definition.name.front() <= 'Z';
    return definition.is_function || !is_capital || !definition.value || !definition.value->point();
}

/// Draws a definition such as P = (1, 2, a), unless its point is one of x, y and z.
bool Elaborator::add_named_point(const Definition& definition, const std::string& text) {
    const auto point = definition.value->point();
    if (std::ranges::any_of(*point, [&](NodeId id) { return values_.uses_space(id); })) return true;
    if (!add_patch(definition.statement, PatchKind::Point, *point, text)) return false;
    surfaces_.back().name = definition.name;
    return true;
}

/// Whether a relation is two equations joined by `and`: the curve where their surfaces meet.
bool Elaborator::is_meeting(const Syntax& relation) const {
    return relation.kind == SyntaxKind::And && relation.operands.size() == 2 &&
           std::ranges::all_of(relation.operands, [&](SyntaxId id) {
               return tree_[id].kind == SyntaxKind::Compare && tree_[id].marks == "=";
           });
}

/// Builds a row of two equations.
bool Elaborator::build_meeting(std::size_t index) {
    const StatementSyntax& statement = tree_.statements[index];
    std::array<NodeId, 2> functions{};
    std::string text;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const Syntax& equation = tree_[tree_[statement.relation].operands[i]];
        const Number left = number(equation.operands[0], nullptr);
        const Number right = left ? number(equation.operands[1], nullptr) : std::nullopt;
        if (!right) return false;
        functions.at(i) = make_subtract(builder_, *left, *right);
        if (!done(functions.at(i), equation.offset)) return false;
        if (!values_.uses_space(functions.at(i))) {
            values_.fail(no_place_error(index));
            return false;
        }
        text += (i > 0 ? " and " : "") +
                builder_.text(functions.at(i), parameters_, longest_definition()) + " = 0";
    }
    const Number condition = restriction_of(statement);
    if (values_.failed()) return false;
    NodeId where = condition.value_or(builder_.constant(1.0));
    if (condition) text += ", " + builder_.text(where, parameters_, longest_definition());
    if (const auto box = box_of(index)) {
        const NodeId inside = cut_condition(*box);
        where = condition ? make_call(builder_, Op::And, where, inside) : inside;
    }
    return add_patch(index, PatchKind::Meeting, {functions[0], functions[1], where},
                     std::move(text));
}

bool Elaborator::add_patch(std::size_t index, PatchKind kind, const std::array<NodeId, 3>& point,
                           std::string text) {
    const std::size_t offset = tree_.statements[index].offset;
    // The condition of a meeting holds the box.
    const auto box = kind == PatchKind::Meeting ? std::nullopt : box_of(index);
    const NodeId root = make_patch(builder_, kind, point, box);
    if (!done(root, offset)) return false;
    if (surfaces_.size() == ProgramLimits::surfaces) {
        fail(offset, filled(tr("there are more than {0} surfaces"),
                            {std::to_string(ProgramLimits::surfaces)}));
        return false;
    }
    surfaces_.push_back(
        {.statement = index, .root = root, .solid = false, .text = std::move(text)});
    return true;
}

}  // namespace zeroset
