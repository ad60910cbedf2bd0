#pragma once

#include "engine/language/expressions/expression_reader.hpp"
#include "engine/language/parse.hpp"
#include "engine/language/rows/definition_readings.hpp"
#include "engine/language/rows/equation_reader.hpp"
#include "engine/language/rows/function_graphs.hpp"
#include "engine/language/rows/meeting_reader.hpp"
#include "engine/language/rows/patch_reader.hpp"
#include "engine/language/rows/thing_reader.hpp"

#include <map>
#include <span>
#include <string_view>
#include <vector>

// Private to parse.hpp: what a tree's statements mean, one after the other.

namespace zeroset {

/// Reads the statements of one text; one of its public functions is called once.
class Elaborator {
public:
    /// `files`: where files that the text names come from; nullptr: none are read. Text at offset
    /// `counted_end` or later does not decide whether an earlier statement is a definition. What is
    /// drawn is cut by the boxes of `cuts`. All but the numbers outlive this object.
    Elaborator(const SyntaxTree& tree, const FieldSource* files,
               std::size_t counted_end = std::string_view::npos,
               std::span<const CutText> cuts = {});

    std::expected<Program, ParseError> program();
    /// The value of the last statement, an expression.
    std::expected<Expr, ParseError> last_value();
    /// The only statement, an equation or an expression; its constants may be undefined.
    std::expected<Expr, ParseError> formula();

private:
    using Done = std::expected<void, ParseError>;

    Done read_rows();
    std::expected<std::optional<RowSurface>, ParseError> read_row(std::size_t statement);
    Done add(RowSurface surface);
    [[nodiscard]] bool defines_nothing_else(std::size_t statement, NodeId root) const;
    Done read_definitions();
    Done read_definition(Definition& definition);
    bool note_unreadable(const Definition& definition, const ParseError& error);
    [[nodiscard]] Done add_named_point(const Definition& definition, const std::string& text);
    Done keep_without_surface(std::size_t statement);
    Done add_graphs();
    std::expected<Program, ParseError> result();
    [[nodiscard]] std::size_t offset_of(std::size_t statement) const {
        return tree_.statements[statement].offset;
    }
    [[nodiscard]] Expr finished(NodeId root) {
        return values_.builder().finish(root, reader_.names().parameters());
    }

    const SyntaxTree& tree_;
    Notes notes_;
    DefinitionTable table_;
    GraphValues values_{notes_};
    ExpressionReader reader_;
    RowVariables variables_{table_};
    ReadingText text_;
    RowMaker maker_;
    EquationReader equations_{reader_};
    MeetingReader meetings_{reader_, maker_, equations_, text_};
    PatchReader patches_{reader_, maker_, variables_, text_};
    ThingReader things_{reader_, maker_, text_};
    FunctionGraphs graphs_{reader_, maker_};
    DefinitionReadings definitions_{reader_, variables_, text_};
    std::vector<RowSurface> surfaces_;
    std::vector<std::size_t> without_surface_;  ///< statements such as e = 3 whose names are not
                                                ///< used
    std::map<std::size_t, Reading> readings_;   ///< by statement
};

}  // namespace zeroset
