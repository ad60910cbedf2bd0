#include "engine/language/rows/definition_readings.hpp"

#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

constexpr std::size_t first_argument =
    ProgramLimits::parameters;  // first number of the parameters that stand for
                                // functions' arguments

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

}  // namespace

std::expected<std::string, ParseError> DefinitionReadings::read(Definition& definition) {
    Text text = definition.is_function ? function_text(definition) : value_text(definition);
    if (!text) return reader_.values().failure();
    return std::move(*text);
}

DefinitionReadings::Text DefinitionReadings::value_text(Definition& definition) {
    const std::vector<std::string>* const variables = variables_.names_of(definition);
    if (variables != nullptr && reader_.definitions().known(definition) == nullptr) {
        const std::vector<std::string> names = *variables;  // to which the reading may add some
        return text_by_row(definition, names);
    }
    const Context context{.statement = definition.statement};
    const auto value =
        reader_.definitions().value(definition, reader_.name_of(definition), context);
    if (!value) return std::nullopt;
    note_built_in(definition, *value);
    return definition.name + " = " + text_.of(*value);
}

/// The reading of a definition that only rows use by whose variables it goes.
DefinitionReadings::Text DefinitionReadings::text_by_row(
    Definition& definition, const std::vector<std::string>& variables) {
    RowScope row(variables_.going_by(variables));
    std::vector<std::string> names(first_argument);
    const std::vector<LocalName> locals = add_variables(variables, names);
    row.bind(&locals.back());
    if (!reader_.values().done(locals.back().value.id, offset_of(definition))) return std::nullopt;
    auto& known = by_row_[variables];
    row.known.values.swap(known);
    const auto value = reader_.definitions().value(
        definition, reader_.name_of(definition), {.statement = definition.statement, .row = &row});
    row.known.values.swap(known);
    if (!value) return std::nullopt;
    note_built_in(definition, *value);
    std::ranges::copy(reader_.names().parameters(), names.begin());
    return definition.name + " = " + text_.of(*value, names);
}

/// A parameter of its own, whose name is added to `names`.
BuiltValue DefinitionReadings::add_variable(std::string name, std::vector<std::string>& names) {
    const int number = variable_w + 1 + static_cast<int>(names.size());
    names.push_back(std::move(name));
    return {.id = reader_.values().builder().variable(number)};
}

/// Variables of rows as parameters of their own, whose names are added to `names`.
std::vector<LocalName> DefinitionReadings::add_variables(const std::vector<std::string>& variables,
                                                         std::vector<std::string>& names) {
    std::vector<LocalName> locals;
    locals.reserve(variables.size());
    for (const std::string& name : variables) {
        const LocalName* const outer = locals.empty() ? nullptr : &locals.back();
        locals.push_back({.name = name, .value = add_variable(name, names), .outer = outer});
    }
    return locals;
}

/// Notes that a definition gives a built-in name another meaning.
void DefinitionReadings::note_built_in(const Definition& definition, const BuiltValue& value) {
    const std::string& name = definition.name;
    const bool is_same =
        is_built_in_value(name) && value.is_single() && reader_.names().built_in(name) == value.id;
    if (!is_built_in_value(name) || is_same) return;
    reader_.values().note(
        offset_of(definition),
        filled(tr("{0} is this value in all statements; for the built-in {0} type {1}"),
               {name, spelled_out(name)}));
}

/// The reading of a function. Its arguments are what it is called with, else numbers, or vectors
/// where it wants such.
DefinitionReadings::Text DefinitionReadings::function_text(Definition& definition) {
    GraphValues& values = reader_.values();
    const std::size_t count = definition.arguments.size();
    const bool is_known = definition.called_with.size() == count;
    std::vector<std::size_t> sizes =
        is_known ? definition.called_with : std::vector<std::size_t>(count, 1);
    Text text = function_text_of(definition, sizes);
    constexpr std::size_t most_tried = 4;
    if (text || is_known || !values.wanted_vector() || count > most_tried) return text;
    const ParseError error = values.failure().error();
    for (std::size_t vectors = 1; vectors < std::size_t{1} << count; ++vectors) {
        for (std::size_t i = 0; i < count; ++i)
            sizes[i] = (vectors >> i & 1U) != 0 ? 3 : 1;
        text = function_text_of(definition, sizes);
        if (text) return text;
        static_cast<void>(values.failure());
    }
    return values.fail(error);
}

/// The reading of a function for arguments of these numbers of parts, which are built as parameters
/// of their own.
DefinitionReadings::Text DefinitionReadings::function_text_of(Definition& definition,
                                                              std::span<const std::size_t> sizes) {
    Context context{.statement = definition.statement, .reads_function = true};
    std::vector<std::string> names(first_argument);
    std::optional<RowScope> row;
    std::vector<LocalName> locals;
    if (const auto* const known = variables_.names_of(definition)) {
        const std::vector<std::string> variables = *known;
        row.emplace(variables_.going_by(variables));
        locals = add_variables(variables, names);
        row->bind(&locals.back());
        context.row = &*row;
    }
    BuiltValues arguments;
    std::string text = definition.name + "(";
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const std::string& name = definition.arguments[i];
        text += (i > 0 ? ", " : "") + name;
        if (sizes[i] == 1) {
            arguments.push_back(add_variable(name, names));
            continue;
        }
        constexpr std::string_view parts = "xyzw";
        if (sizes[i] > parts.size()) return definition.name + "(...) = ...";
        BuiltValues vector;
        for (std::size_t k = 0; k < sizes[i]; ++k)
            vector.push_back(add_variable(name + "." + parts[k], names));
        arguments.push_back(BuiltValue::vector(std::move(vector)));
    }
    GraphValues& values = reader_.values();
    if (!arguments.empty() && !values.done(arguments.back().part(0).id, offset_of(definition)))
        return std::nullopt;
    const auto value = reader_.definitions().value(definition, arguments, context);
    if (!value) return std::nullopt;
    std::ranges::copy(reader_.names().parameters(), names.begin());
    return text + ") = " + text_.of(*value, names);
}

}  // namespace zeroset
