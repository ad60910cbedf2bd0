// Writes how definitions were read, and notes on names that mean something else elsewhere.

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/elaborator.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t first_argument =
    ProgramLimits::parameters;                     // first number of the parameters that stand for
                                                   // functions' arguments
constexpr std::size_t longest_readings = 200'000;  // bytes, all definitions together

/// The formula to type for a built-in value whose name the text gives another meaning.
std::string_view spelled_out(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> spellings{
        {{"r", "sqrt(x^2 + y^2 + z^2)"},
         {"rho", "sqrt(x^2 + y^2)"},
         {"theta", "atan2(y, x)"},
         {"phi", "acos(z/sqrt(x^2 + y^2 + z^2))"},
         {"t", "w"},
         {"w", "t"},
         {"e", "exp(1)"},
         {"pi", "acos(-1)"},
         {"tau", "2 acos(-1)"},
         {"golden", "(1 + sqrt 5)/2"}}};
    for (const auto& [built_in, spelling] : spellings) {
        if (built_in == name) return spelling;
    }
    return {};
}

/// Where an expression begins, in bytes of the text.
std::size_t begin_of(const SyntaxTree& tree, SyntaxId id) {
    const Syntax* part = &tree[id];
    std::size_t begin = part->offset;
    while (!part->operands.empty()) {
        part = &tree[part->operands[0]];
        begin = std::min(begin, part->offset);
    }
    return begin;
}

}  // namespace

/// The longest reading of one definition, in bytes; many definitions share `longest_readings`.
std::size_t Elaborator::longest_definition() {
    const std::size_t count = std::max<std::size_t>(table_.all().size(), 1);
    return std::clamp<std::size_t>(longest_readings / count, 20, 2'000);
}

std::optional<std::string> Elaborator::value_text(Definition& definition) {
    if (rows_.contains(&definition) && !definition.value) return text_by_row(definition);
    const Syntax& relation = tree_[tree_.statements[definition.statement].relation];
    if (!defined_value(definition, tree_[relation.operands[0]])) return std::nullopt;
    note_built_in(definition, *definition.value);
    return definition.name + " = " + text_of(*definition.value, parameters_);
}

/// The reading of a definition that only rows use by whose variables it goes.
std::optional<std::string> Elaborator::text_by_row(Definition& definition) {
    const std::vector<std::string> variables = rows_.at(&definition);
    const Syntax& relation = tree_[tree_.statements[definition.statement].relation];
    const Row row(*this, variables);
    std::vector<std::string> names = parameters_;
    names.resize(first_argument);
    const std::vector<Binding> bindings = variables_of_row(variables, names);
    bind_row(&bindings.back());
    const std::size_t offset = tree_.statements[definition.statement].offset;
    if (!done(bindings.back().value.id, offset)) return std::nullopt;
    row_values_.swap(values_in_readings_[variables]);
    const Built value = defined_value(definition, tree_[relation.operands[0]]);
    row_values_.swap(values_in_readings_[variables]);
    if (!value) return std::nullopt;
    note_built_in(definition, *value);
    std::ranges::copy(parameters_, names.begin());
    return definition.name + " = " + text_of(*value, names);
}

/// Variables of rows as parameters of their own, whose names are added to `names`.
std::vector<Elaborator::Binding> Elaborator::variables_of_row(
    const std::vector<std::string>& variables, std::vector<std::string>& names) {
    std::vector<Binding> bindings;
    bindings.reserve(variables.size());
    for (const std::string& name : variables) {
        const int number = variable_w + 1 + static_cast<int>(names.size());
        bindings.push_back({.name = name,
                            .value = Value{.id = builder_.variable(number)},
                            .outer = bindings.empty() ? nullptr : &bindings.back()});
        names.push_back(name);
    }
    return bindings;
}

/// Notes that a definition gives a built-in name another meaning.
void Elaborator::note_built_in(const Definition& definition, const Value& value) {
    const std::string& name = definition.name;
    const bool is_same =
        is_built_in_value(name) && value.is_single() && built_in(name)->id == value.id;
    if (!is_built_in_value(name) || is_same) return;
    notes_.add(tree_.statements[definition.statement].offset,
               filled(tr("{0} is this value in all statements; for the built-in {0} type {1}"),
                      {name, spelled_out(name)}));
}

/// Notes what r and rho are in a row that seems to go by the other of the two distances: z = r^2,
/// rho = 2 cos phi.
void Elaborator::note_distance(std::size_t statement) {
    const StatementSyntax& syntax = tree_.statements[statement];
    const Syntax& relation = tree_[syntax.relation];
    const std::size_t end =
        syntax.restrictions.empty() ? std::string::npos : begin_of(tree_, syntax.restrictions[0]);
    std::map<std::string_view, SyntaxId> said;
    const auto add = [&](const NameUse& use) {
        const Syntax& name = tree_[use.at];
        const bool is_free = name.kind == SyntaxKind::Name && name.offset < end &&
                             table_.meant(use, statement) == nullptr;
        if (is_free) said.try_emplace(name.text, use.at);
    };
    std::ranges::for_each(table_.uses(statement), add);
    if (relation.kind == SyntaxKind::Compare) add({.at = relation.operands[0], .calls = false});
    if (said.contains("x") || said.contains("y")) return;
    const auto r = said.find("r");
    const auto rho = said.find("rho");
    const bool is_spherical = said.contains("phi");
    if (r != said.end() && !is_spherical && (said.contains("z") || said.contains("theta"))) {
        notes_.add(tree_[r->second].offset,
                   filled(tr("{0} is {1}; for the distance from the z-axis type {2}"),
                          {"r", "sqrt(x^2 + y^2 + z^2)", "rho"}));
    }
    if (rho != said.end() && is_spherical) {
        notes_.add(tree_[rho->second].offset,
                   filled(tr("{0} is {1}; for the distance from the origin type {2}"),
                          {"rho", "sqrt(x^2 + y^2)", "r"}));
    }
}

/// The reading of a function. Its arguments are what it is called with, else numbers, or vectors
/// where it wants such.
std::optional<std::string> Elaborator::function_text(Definition& definition) {
    const std::size_t count = definition.arguments.size();
    const bool is_known = definition.called_with.size() == count;
    std::vector<std::size_t> sizes =
        is_known ? definition.called_with : std::vector<std::size_t>(count, 1);
    auto text = function_text_of(definition, sizes);
    constexpr std::size_t most_tried = 4;
    if (text || is_known || !values_.wanted_vector() || count > most_tried) return text;
    const ParseError error = values_.failure().error();
    for (std::size_t vectors = 1; vectors < std::size_t{1} << count; ++vectors) {
        for (std::size_t i = 0; i < count; ++i)
            sizes[i] = (vectors >> i & 1U) != 0 ? 3 : 1;
        text = function_text_of(definition, sizes);
        if (text) return text;
        (void)values_.failure();
    }
    return values_.fail(error);
}

/// The reading of a function for arguments of these numbers of parts, which are built as parameters
/// of their own.
std::optional<std::string> Elaborator::function_text_of(Definition& definition,
                                                        std::span<const std::size_t> sizes) {
    std::vector<std::string> names = parameters_;
    names.resize(first_argument);
    Values arguments;
    std::string text = definition.name + "(";
    const auto add_variable = [&](std::string name) {
        const auto number = static_cast<int>(names.size());
        names.push_back(std::move(name));
        return Value{.id = builder_.variable(variable_w + 1 + number)};
    };
    std::optional<Row> row;
    std::vector<Binding> bindings;
    if (const auto variables = rows_.find(&definition); variables != rows_.end()) {
        row.emplace(*this, variables->second);
        bindings = variables_of_row(variables->second, names);
        bind_row(&bindings.back());
    }
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const std::string& name = definition.arguments[i];
        text += (i > 0 ? ", " : "") + name;
        if (sizes[i] == 1) {
            arguments.push_back(add_variable(name));
            continue;
        }
        constexpr std::string_view parts = "xyzw";
        if (sizes[i] > parts.size()) return definition.name + "(...) = ...";
        Values vector;
        for (std::size_t k = 0; k < sizes[i]; ++k)
            vector.push_back(add_variable(name + "." + parts[k]));
        arguments.push_back(Value::vector(std::move(vector)));
    }
    const std::size_t offset = tree_.statements[definition.statement].offset;
    if (!arguments.empty() && !done(arguments.back().part(0).id, offset)) return std::nullopt;
    reads_function_ = true;
    const Built value = function_value(definition, arguments);
    reads_function_ = false;
    if (!value) return std::nullopt;
    std::ranges::copy(parameters_, names.begin());
    return text + ") = " + text_of(*value, names);
}

/// The value as it is written, each of its numbers not much longer than those of a definition.
std::string Elaborator::text_of(const Value& value, std::span<const std::string> names) {
    const std::size_t longest = longest_definition();
    if (value.is_single()) return builder_.text(value.id, names, longest);
    const bool is_list = value.is_list();
    std::string text(is_list ? "[" : "(");
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (i > 0) text += ", ";
        if (text.size() > longest) return text + "...";
        text += text_of(value.part(i), names);
    }
    return text + (is_list ? "]" : ")");
}

}  // namespace zeroset
