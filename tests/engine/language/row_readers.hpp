#pragma once

#include "engine/language/rows/definition_readings.hpp"
#include "engine/language/rows/equation_reader.hpp"
#include "engine/language/rows/function_graphs.hpp"
#include "engine/language/rows/meeting_reader.hpp"
#include "engine/language/rows/patch_reader.hpp"
#include "engine/language/rows/thing_reader.hpp"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// All that reads the rows of a text, which must have no error of syntax.
struct RowReaders {
    explicit RowReaders(std::string_view text, std::span<const CutText> cuts = {})
        : tree(read_syntax(text).value()), maker(reader, cuts) {}

    /// The notes so far, those on each statement after one another.
    std::vector<std::string> taken_notes() {
        std::vector<Reading> readings;
        for (const StatementSyntax& statement : tree.statements)
            readings.push_back(
                {.kind = StatementKind::Value, .offset = statement.offset, .text = {}});
        notes.hand_over(readings);
        std::vector<std::string> all;
        for (const Reading& reading : readings)
            all.insert(all.end(), reading.notes.begin(), reading.notes.end());
        return all;
    }
    std::string text_of(NodeId id) { return text.of(id); }

    SyntaxTree tree;
    Notes notes = tree.notes;
    DefinitionTable table{tree, std::string_view::npos, notes};
    GraphValues values{notes};
    ExpressionReader reader{tree, table, nullptr, values};
    RowVariables variables{table};
    ReadingText text{values, reader.names(), table.all().size()};
    RowMaker maker;
    EquationReader equations{reader};
    MeetingReader meetings{reader, maker, equations, text};
    PatchReader patches{reader, maker, variables, text};
    ThingReader things{reader, maker, text};
    FunctionGraphs graphs{reader, maker};
    DefinitionReadings definitions{reader, variables, text};
};

/// Expects an error at `offset` whose reason has these words.
template <class Result>
void expect_error(const Result& result, std::size_t offset, std::string_view words) {
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().offset, offset) << result.error().reason;
    EXPECT_TRUE(result.error().reason.contains(words)) << result.error().reason;
}

}  // namespace zeroset
