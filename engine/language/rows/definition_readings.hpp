#pragma once

#include "engine/language/expressions/expression_reader.hpp"
#include "engine/language/rows/reading_text.hpp"
#include "engine/language/rows/row_variables.hpp"

#include <expected>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace zeroset {

/// Writes how definitions were read, and notes on built-in names that they give another meaning.
class DefinitionReadings {
public:
    /// All of these outlive this object.
    DefinitionReadings(ExpressionReader& reader, RowVariables& variables, const ReadingText& text)
        : reader_(reader), variables_(variables), text_(text) {}

    /// Builds the value, or that of a function for arguments of its own. All rows have been read.
    std::expected<std::string, ParseError> read(Definition& definition);

private:
    using Text = std::optional<std::string>;  ///< nothing is an error, which is in the values
    Text value_text(Definition& definition);
    Text text_by_row(Definition& definition, const std::vector<std::string>& variables);
    Text function_text(Definition& definition);
    Text function_text_of(Definition& definition, std::span<const std::size_t> sizes);
    BuiltValue add_variable(std::string name, std::vector<std::string>& names);
    std::vector<LocalName> add_variables(const std::vector<std::string>& variables,
                                         std::vector<std::string>& names);
    void note_built_in(const Definition& definition, const BuiltValue& value);
    [[nodiscard]] std::size_t offset_of(const Definition& definition) const {
        return reader_.tree().statements[definition.statement].offset;
    }

    ExpressionReader& reader_;
    RowVariables& variables_;
    const ReadingText& text_;
    /// The values of definitions where the variables of a row are parameters of their own, by the
    /// names of these.
    std::map<std::vector<std::string>, std::unordered_map<const Definition*, BuiltValue>> by_row_;
};

}  // namespace zeroset
