#include "engine/language/elaborator.hpp"

#include "engine/base/translation.hpp"
#include "engine/language/rows/distance_note.hpp"
#include "engine/language/rows/letter_notes.hpp"
#include "engine/language/rows/no_surface.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace zeroset {

Elaborator::Elaborator(const SyntaxTree& tree, const FieldSource* files, std::size_t counted_end,
                       std::span<const CutText> cuts)
    : tree_(tree),
      notes_(tree.notes),
      table_(tree, counted_end, notes_),
      reader_(tree, table_, files, values_),
      text_(values_, reader_.names(), table_.all().size()),
      maker_(reader_, cuts) {}

std::expected<Program, ParseError> Elaborator::program() {
    if (table_.error()) return std::unexpected(*table_.error());
    if (auto error = error_for_parametric(tree_, table_)) return std::unexpected(std::move(*error));
    for (const auto step :
         {&Elaborator::read_rows, &Elaborator::read_definitions, &Elaborator::add_graphs}) {
        if (Done done = (this->*step)(); !done) return std::unexpected(std::move(done.error()));
    }
    if (!surfaces_.empty()) return result();
    if (without_surface_.empty()) return std::unexpected(error_without_surface(tree_, table_));
    return std::unexpected(maker_.error_without_place(without_surface_.front()));
}

std::expected<Expr, ParseError> Elaborator::formula() {
    if (table_.error()) return std::unexpected(*table_.error());
    if (tree_.statements.size() > 1) {
        return values_.failure(offset_of(1), tr("there is a second statement"),
                               tr("type one formula"));
    }
    values_.keep_undefined();
    const auto equation = equations_.read(0);
    if (!equation) return std::unexpected(equation.error());
    return finished(equation->root);
}

std::expected<Expr, ParseError> Elaborator::last_value() {
    if (table_.error()) return std::unexpected(*table_.error());
    const StatementSyntax& statement = tree_.statements.back();
    if (is_condition(tree_[statement.relation].kind) || !statement.restrictions.empty()) {
        return values_.failure(statement.offset,
                               tr("an expression is needed here, no equation and no condition"),
                               tr("type a value such as x^2 + y^2"));
    }
    const auto root =
        reader_.number(statement.relation, {.statement = tree_.statements.size() - 1});
    if (!root) return values_.failure();
    return finished(*root);
}

Elaborator::Done Elaborator::read_rows() {
    for (std::size_t i = 0; i < tree_.statements.size(); ++i) {
        if (table_.of_statement(i) != nullptr) continue;
        auto row = read_row(i);
        if (!row) return std::unexpected(std::move(row.error()));
        if (!*row) {
            without_surface_.push_back(i);
        } else if (Done added = add(std::move(**row)); !added) {
            return added;
        }
    }
    return {};
}

/// The surface of a row; nothing of one that only gives a value.
std::expected<std::optional<RowSurface>, ParseError> Elaborator::read_row(std::size_t statement) {
    if (things_.may_read(statement)) return things_.read(statement);
    if (patches_.may_read(statement)) return patches_.read(statement);
    note_distance(tree_, table_, statement, notes_);
    if (meetings_.may_read(statement)) return meetings_.read(statement);
    const auto equation = equations_.read(statement);
    if (!equation) return std::unexpected(equation.error());
    if (defines_nothing_else(statement, equation->root)) return std::nullopt;
    note_level(reader_, statement, equation->root);
    return maker_.surface(statement, equation->root, equation->solid);
}

Elaborator::Done Elaborator::add(RowSurface surface) {
    if (surfaces_.size() == ProgramLimits::surfaces) {
        return values_.failure(
            offset_of(surface.statement),
            filled(tr("there are more than {0} surfaces"), {std::to_string(surfaces_.size())}));
    }
    surfaces_.push_back(std::move(surface));
    return {};
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
    const Node& node = values_.builder().node(root);
    const bool is_axis = left.text == "x" || left.text == "y" || left.text == "z";
    return is_built_in_value(left.text) && !is_axis && node.op == Op::Subtract &&
           node.a == node.b && tree_.statements.size() > 1;
}

/// Reads the functions before the values: what these call is noted.
Elaborator::Done Elaborator::read_definitions() {
    for (const bool functions : {true, false}) {
        for (Definition& definition : table_.all()) {
            const bool stands = table_.of_statement(definition.statement) == &definition;
            if (!stands || definition.is_function != functions) continue;
            Done done = read_definition(definition);
            if (!done && !note_unreadable(definition, done.error())) return done;
        }
    }
    if (surfaces_.empty()) return {};
    for (const std::size_t statement : without_surface_) {
        if (Done kept = keep_without_surface(statement); !kept) return kept;
    }
    return {};
}

Elaborator::Done Elaborator::read_definition(Definition& definition) {
    auto text = definitions_.read(definition);
    if (!text) return std::unexpected(std::move(text.error()));
    readings_[definition.statement] = {
        .kind = definition.is_function ? StatementKind::Function : StatementKind::Value,
        .offset = offset_of(definition.statement),
        .text = *text};
    return add_named_point(definition, *text);
}

/// Notes instead of failing, if the text has a surface, that a definition cannot be read: no
/// surface needs it, or it is a function that has a value only for the arguments it is called with.
bool Elaborator::note_unreadable(const Definition& definition, const ParseError& error) {
    if (surfaces_.empty()) return false;
    const std::size_t offset = offset_of(definition.statement);
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

/// Draws a definition such as P = (1, 2, a), unless its point is one of x, y and z. Points that are
/// drawn have a capital letter as their name, so that other vectors, which rows are made of, are
/// not seen.
Elaborator::Done Elaborator::add_named_point(const Definition& definition,
                                             const std::string& text) {
    const bool is_capital = definition.name.front() >= 'A' && definition.name.front() <= 'Z';
    const BuiltValue* const value = reader_.definitions().known(definition);
    if (definition.is_function || !is_capital || value == nullptr) return {};
    const auto point = value->point();
    if (!point) return {};
    if (std::ranges::any_of(*point, [&](NodeId id) { return values_.uses_space(id); })) return {};
    RowResult surface = maker_.patch(definition.statement, PatchKind::Point, *point, text);
    if (!surface) return std::unexpected(std::move(surface.error()));
    surface->name = definition.name;
    return add(std::move(*surface));
}

Elaborator::Done Elaborator::keep_without_surface(std::size_t statement) {
    const Syntax& relation = tree_[tree_.statements[statement].relation];
    const auto value = reader_.number(relation.operands[1], {.statement = statement});
    if (!value) return values_.failure();
    readings_[statement] = {.kind = StatementKind::Value,
                            .offset = offset_of(statement),
                            .text = tree_[relation.operands[0]].text + " = " + text_.of(*value)};
    return {};
}

Elaborator::Done Elaborator::add_graphs() {
    if (!surfaces_.empty() || !without_surface_.empty()) return {};
    for (Definition& definition : table_.all()) {
        if (!graphs_.may_read(definition)) continue;
        auto graph = graphs_.read(definition);
        if (!graph) return std::unexpected(std::move(graph.error()));
        if (!*graph) continue;
        if (Done added = add(std::move(**graph)); !added) return added;
    }
    return {};
}

std::expected<Program, ParseError> Elaborator::result() {
    for (RowSurface& surface : surfaces_) {
        if (Done cut = maker_.cut(surface); !cut) return std::unexpected(std::move(cut.error()));
    }
    std::ranges::sort(surfaces_, {}, &RowSurface::statement);
    Program program;
    std::size_t nodes = 0;
    // The time for writing readings is shared by all surfaces.
    const std::size_t longest = std::min<std::size_t>(longest_text, 1'000'000 / surfaces_.size());
    for (const RowSurface& surface : surfaces_) {
        const std::size_t offset = offset_of(surface.statement);
        Expr expr = finished(surface.root);
        nodes += expr.nodes().size();
        if (nodes > ProgramLimits::nodes) {
            return values_.failure(
                offset, filled(tr("the surfaces up to here have more than {0} operations"),
                               {std::to_string(ProgramLimits::nodes)}));
        }
        readings_[surface.statement] = {
            .kind = StatementKind::Surface,
            .offset = offset,
            .text = surface.text.empty() ? equation_text(expr, longest) : surface.text};
        program.surfaces.push_back(std::move(expr));
        program.solids.push_back(surface.solid);
        program.sheets.push_back(surface.sheet);
        program.names.push_back(surface.name);
    }
    for (auto& [statement, reading] : readings_)
        program.readings.push_back(std::move(reading));
    note_euler(reader_);
    notes_.hand_over(program.readings);
    program.parameters = reader_.names().parameters();
    program.calls_w_t = reader_.names().calls_w_t();
    return program;
}

}  // namespace zeroset
