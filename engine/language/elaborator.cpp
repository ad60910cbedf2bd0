// Builds the surfaces of a text's statements.

#include "engine/language/elaborator.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/vocabulary/foreign.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace zeroset {
namespace {

constexpr const char* no_surface = marked("a condition alone is no surface");

}  // namespace

std::expected<Program, ParseError> Elaborator::program() {
    if (values_.failed()) return values_.failure();
    if (auto error = error_for_parametric()) return std::unexpected(std::move(*error));
    if (!build_statements() || !build_graphs()) return values_.failure();
    if (surfaces_.empty() && !without_surface_.empty())
        return std::unexpected(no_place_error(without_surface_.front()));
    if (surfaces_.empty()) {
        return std::unexpected(ParseError{.offset = tree_.statements.back().offset,
                                          .reason = tr("there is no surface yet, only definitions"),
                                          .hint = hint_without_surface(),
                                          .unfinished = true});
    }
    return result();
}

/// A hint for a text without a surface: tann(x) = y defines tann, but may have been meant as tan.
std::string Elaborator::hint_without_surface() {
    const Definition* const last = table_.of_statement(tree_.statements.size() - 1);
    const bool is_function = last != nullptr && last->is_function;
    if (is_function && !last->is_certain && last->name.size() > 2) {
        if (const auto meant = nearest_known_name(last->name))
            return filled(tr("this defines {0}; did you mean {1}?"), {last->name, *meant});
    }
    if (is_function && last->arguments == std::vector<std::string>{"x", "y", "z"})
        return filled(tr("type {0} on the next line"), {last->name + "(x, y, z) = 0"});
    if (is_function && last->arguments == std::vector<std::string>{"x"})
        return filled(tr("type {0} on the next line"), {"y = " + last->name + "(x)"});
    return filled(tr("type an equation such as {0} on the next line"), {"x^2 + y^2 + z^2 = 1"});
}

std::expected<Expr, ParseError> Elaborator::formula() {
    if (values_.failed()) return values_.failure();
    if (tree_.statements.size() > 1) {
        fail(tree_.statements[1].offset, tr("there is a second statement"), tr("type one formula"));
        return values_.failure();
    }
    values_.keep_undefined();
    const Number root = equation(tree_.statements.front());
    if (!root) return values_.failure();
    return builder_.finish(*root, parameters_);
}

std::expected<Expr, ParseError> Elaborator::last_value() {
    if (values_.failed()) return values_.failure();
    statement_ = tree_.statements.size() - 1;
    const StatementSyntax& statement = tree_.statements.back();
    if (is_condition(tree_[statement.relation].kind) || !statement.restrictions.empty()) {
        fail(statement.offset, tr("an expression is needed here, no equation and no condition"),
             tr("type a value such as x^2 + y^2"));
        return values_.failure();
    }
    const Number root = number(statement.relation, nullptr);
    if (!root) return values_.failure();
    return builder_.finish(*root, parameters_);
}

/// The error for x = ..., y = ... and z = ... of u and v: a parametric surface.
std::optional<ParseError> Elaborator::error_for_parametric() {
    std::array<bool, 3> given{};
    std::array<bool, 2> used{};
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        const Syntax& relation = tree_[tree_.statements[i].relation];
        if (relation.kind != SyntaxKind::Compare || relation.marks != "=") continue;
        const Syntax& left = tree_[relation.operands[0]];
        const std::size_t axis = std::string_view("xyz").find(left.text);
        if (left.text.size() != 1 || axis > 2) continue;
        if (left.kind == SyntaxKind::Call && left.operands.size() == 2) used = {true, true};
        bool uses_axis = false;
        for (const NameUse& use : table_.uses(i)) {
            const std::string& name = tree_[use.at].text;
            const bool is_free = use.at != relation.operands[0] && table_.meant(use, i) == nullptr;
            uses_axis = uses_axis || (is_free && (name == "x" || name == "y" || name == "z"));
            used[0] = used[0] || (is_free && name == "u");
            used[1] = used[1] || (is_free && name == "v");
        }
        given.at(axis) = given.at(axis) || !uses_axis;
    }
    const auto all = [](const auto& flags) { return std::ranges::all_of(flags, std::identity{}); };
    if (!all(given) || !all(used)) return std::nullopt;
    return ParseError{.offset = tree_.statements.front().offset,
                      .reason = tr("x, y and z given by u and v in rows of their own are not read"),
                      .hint = filled(tr("type them as a point in one row: {0}"),
                                     {"(u cos v, u sin v, v), 0 < u < 1, 0 < v < 2 pi"})};
}

bool Elaborator::build_statements() {
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        if (table_.of_statement(i) == nullptr && !build_surface(i)) return false;
    }
    for (const bool functions : {true, false}) {
        for (Definition& definition : table_.all()) {
            const bool stands = table_.of_statement(definition.statement) == &definition;
            if (!stands || definition.is_function != functions) continue;
            if (!build_definition(definition) && !note_unreadable(definition)) return false;
        }
    }
    return surfaces_.empty() || std::ranges::all_of(without_surface_, [&](std::size_t i) {
               return keep_without_surface(i);
           });
}

/// Notes instead of failing, if the text has a surface, that a definition cannot be read: no
/// surface needs it, or it is a function that has a value only for the arguments it is called with.
bool Elaborator::note_unreadable(const Definition& definition) {
    if (surfaces_.empty() || !values_.failed()) return false;
    const ParseError error = values_.failure().error();
    const std::size_t offset = tree_.statements[definition.statement].offset;
    if (!definition.is_called) {
        const std::string hint = error.hint.empty() ? "" : "; " + error.hint;
        notes_.add(offset, filled(tr("no surface needs this, and it is not read: {0}"),
                                  {error.reason + hint}));
    }
    readings_[definition.statement] = {
        .kind = definition.is_function ? StatementKind::Function : StatementKind::Value,
        .offset = offset,
        .text = definition.name + (definition.is_function ? "(...) = ..." : " = ...")};
    return true;
}

bool Elaborator::build_surface(std::size_t index) {
    statement_ = index;
    is_solid_ = false;
    const Syntax& relation = tree_[tree_.statements[index].relation];
    const bool is_call = relation.kind == SyntaxKind::Call && relation.function != nullptr;
    if (is_call && relation.function->is_thing()) return build_thing(index, *relation.function);
    if (may_be_patch(tree_.statements[index])) return build_patch(index);
    note_distance(index);
    if (is_meeting(relation)) return build_meeting(index);
    const Number root = equation(tree_.statements[index]);
    if (!root) return false;
    if (defines_nothing_else(index, *root)) {
        without_surface_.push_back(index);
        return true;
    }
    return add_surface(index, *root);
}

/// Whether a statement such as e = 3 or r = sqrt(x^2 + y^2 + z^2), whose name is not used, is no
/// surface.
bool Elaborator::defines_nothing_else(std::size_t statement, NodeId root) const {
    const StatementSyntax& syntax = tree_.statements[statement];
    const Syntax& relation = tree_[syntax.relation];
    if (relation.kind != SyntaxKind::Compare || relation.marks != "=") return false;
    if (!syntax.restrictions.empty()) return false;
    const Syntax& left = tree_[relation.operands[0]];
    if (left.kind != SyntaxKind::Name) return false;
    if (!values_.uses_space(root)) return true;
    const Node& node = builder_.node(root);
    const bool is_axis = left.text == "x" || left.text == "y" || left.text == "z";
    return is_built_in_value(left.text) && !is_axis && node.op == Op::Subtract &&
           node.a == node.b && tree_.statements.size() > 1;
}

bool Elaborator::keep_without_surface(std::size_t statement) {
    statement_ = statement;
    const Syntax& relation = tree_[tree_.statements[statement].relation];
    const Number value = number(relation.operands[1], nullptr);
    if (!value) return false;
    readings_[statement] = {.kind = StatementKind::Value,
                            .offset = tree_.statements[statement].offset,
                            .text = tree_[relation.operands[0]].text + " = " +
                                    builder_.text(*value, parameters_, longest_definition())};
    return true;
}

Elaborator::Number Elaborator::equation(const StatementSyntax& statement) {
    const Syntax& relation = tree_[statement.relation];
    Number f;
    if (relation.kind == SyntaxKind::Compare && relation.marks == "=") {
        const Number left = number(relation.operands[0], nullptr);
        const Number right = left ? number(relation.operands[1], nullptr) : std::nullopt;
        if (!right) return std::nullopt;
        f = make_subtract(builder_, *left, *right);
        if (!done(*f, relation.offset)) return std::nullopt;
    } else if (relation.kind == SyntaxKind::Compare && relation.marks.contains('=')) {
        return fail(relation.offset, tr("an equation and an inequality in one"),
                    tr("put the inequality behind a comma: x^2 + y^2 = 1, z < 1"));
    } else if (relation.kind == SyntaxKind::Compare && relation.marks == "n") {
        return fail(relation.offset, tr(no_surface),
                    tr("compare with = for the surface where both sides are equal"));
    } else {
        const Built value = build(statement.relation, nullptr);
        if (!value) return std::nullopt;
        if (value->condition) return solid(*value, statement);
        if (!value->is_single()) return refuse_row(*value, statement.offset);
        f = value->id;
    }
    return restricted(*f, statement);
}

/// The error for a row that is a vector or a list.
std::nullopt_t Elaborator::refuse_row(const Value& value, std::size_t offset) {
    if (value.point()) {
        return fail(offset,
                    tr("a list in brackets is a point or a parametric surface, no equation"),
                    tr("type an equation in x, y and z"));
    }
    return fail(offset, filled(tr("this is {0}, and no surface"), {value.described()}),
                tr("type an equation in x, y and z"));
}

/// The statement's restrictions as one condition; nothing, and perhaps no error, where it has none.
Elaborator::Number Elaborator::restriction_of(const StatementSyntax& statement) {
    Number all;
    for (const SyntaxId id : statement.restrictions) {
        const Syntax& syntax = tree_[id];
        const bool equates = syntax.kind == SyntaxKind::Compare &&
                             syntax.marks.find_first_of("=e") != std::string::npos;
        if (equates) {
            return fail(syntax.offset, tr("behind a comma stands an inequality, not an equation"),
                        tr("for a second surface type ';' instead of the comma"));
        }
        const Number one = condition(id, nullptr, Numbers::Refused);
        if (!one) return std::nullopt;
        all = all ? make_call(builder_, Op::And, *all, *one) : *one;
        if (!done(*all, syntax.offset)) return std::nullopt;
    }
    if (all && values_.refuses_undefined() && values_.never_holds(*all)) {
        return fail(tree_[statement.restrictions.front()].offset, tr("this never holds"));
    }
    return all;
}

Elaborator::Number Elaborator::restricted(NodeId f, const StatementSyntax& statement) {
    const Number all = restriction_of(statement);
    if (values_.failed()) return std::nullopt;
    return all ? make_call(builder_, Op::Where, f, *all) : f;
}

ParseError Elaborator::no_place_error(std::size_t statement) const {
    const bool capital = parameter_index_.contains("X") || parameter_index_.contains("Y") ||
                         parameter_index_.contains("Z");
    const StatementSyntax& syntax = tree_.statements[statement];
    std::string hint = tr("type an equation such as x^2 + y^2 + z^2 = 1");
    if (capital) hint = tr("write them as small letters");
    if (parameter_index_.contains("p"))
        hint = tr("for a point p type p = (x, y, z) in a row of its own");
    if (syntax.leading_sign != '\0')
        hint = filled(tr("to go on with the line above end that with {0}"),
                      {std::string(1, syntax.leading_sign)});
    return {.offset = syntax.offset,
            .reason = tr("there is no x, y or z in it, so it is no surface"),
            .hint = hint};
}

bool Elaborator::add_surface(std::size_t statement, NodeId root) {
    const Node& top = builder_.node(root);
    if (!values_.uses_space(top.op == Op::Where ? top.a : root)) {
        values_.fail(no_place_error(statement));
        return false;
    }
    if (top.op == Op::Where && values_.never_holds(top.b)) {
        fail(tree_.statements[statement].offset, tr("its condition never holds"));
        return false;
    }
    if (surfaces_.size() == ProgramLimits::surfaces) {
        fail(tree_.statements[statement].offset, filled(tr("there are more than {0} surfaces"),
                                                        {std::to_string(ProgramLimits::surfaces)}));
        return false;
    }
    surfaces_.push_back({.statement = statement, .root = root, .solid = is_solid_});
    return true;
}

/// The box that a document cuts the row of a statement to.
std::optional<RowBox> Elaborator::box_of(std::size_t statement) const {
    const std::size_t offset = tree_.statements[statement].offset;
    const auto found = std::ranges::find_if(
        cuts_, [&](const CutText& cut) { return cut.begin <= offset && offset < cut.end; });
    return found == cuts_.end() ? std::nullopt : std::optional(found->box);
}

/// Whether (x, y, z) is in a box.
NodeId Elaborator::cut_condition(const RowBox& box) {
    std::optional<NodeId> all;
    for (std::size_t k = 0; k < 3; ++k) {
        const NodeId at = builder_.variable(static_cast<int>(k));
        for (const NodeId one :
             {make_call(builder_, Op::LessEqual, builder_.constant(box.at(2 * k)), at),
              make_call(builder_, Op::LessEqual, at, builder_.constant(box.at(2 * k + 1)))})
            all = all ? make_call(builder_, Op::And, *all, one) : one;
    }
    return *all;
}

/// Cuts a surface that is an equation by the box of its row. It is read as if there were none.
bool Elaborator::cut_surface(Surface& surface) {
    const auto box = box_of(surface.statement);
    const Node root = builder_.node(surface.root);
    if (!box || root.op == Op::Field) return true;
    if (surface.text.empty())
        surface.text = equation_text(builder_.finish(surface.root, parameters_));
    NodeId condition = cut_condition(*box);
    const bool is_restricted = root.op == Op::Where;
    if (is_restricted) condition = make_call(builder_, Op::And, root.b, condition);
    surface.root = make_call(builder_, Op::Where, is_restricted ? root.a : surface.root, condition);
    return done(surface.root, tree_.statements[surface.statement].offset).has_value();
}

bool Elaborator::build_definition(Definition& definition) {
    statement_ = definition.statement;
    const auto text = definition.is_function ? function_text(definition) : value_text(definition);
    if (!text) return false;
    readings_[definition.statement] = {
        .kind = definition.is_function ? StatementKind::Function : StatementKind::Value,
        .offset = tree_.statements[definition.statement].offset,
        .text = *text};
    return draws_nothing(definition) || add_named_point(definition, *text);
}

std::expected<Program, ParseError> Elaborator::result() {
    for (Surface& surface : surfaces_) {
        if (!cut_surface(surface)) return values_.failure();
    }
    std::ranges::sort(surfaces_, {}, &Surface::statement);
    Program program;
    std::size_t nodes = 0;
    // The time for writing readings is shared by all surfaces.
    const std::size_t longest = std::min<std::size_t>(longest_text, 1'000'000 / surfaces_.size());
    for (const Surface& surface : surfaces_) {
        Expr expr = builder_.finish(surface.root, parameters_);
        nodes += expr.nodes().size();
        if (nodes > ProgramLimits::nodes) {
            fail(tree_.statements[surface.statement].offset,
                 filled(tr("the surfaces up to here have more than {0} operations"),
                        {std::to_string(ProgramLimits::nodes)}));
            return values_.failure();
        }
        readings_[surface.statement] = {
            .kind = StatementKind::Surface,
            .offset = tree_.statements[surface.statement].offset,
            .text = surface.text.empty() ? equation_text(expr, longest) : surface.text};
        program.surfaces.push_back(std::move(expr));
        program.solids.push_back(surface.solid);
        program.sheets.push_back(surface.sheet);
        program.names.push_back(surface.name);
    }
    for (auto& [statement, reading] : readings_)
        program.readings.push_back(std::move(reading));
    notes_.hand_over(program.readings);
    program.parameters = std::move(parameters_);
    program.calls_w_t = says_t_ && !says_w_;
    return program;
}

}  // namespace zeroset
