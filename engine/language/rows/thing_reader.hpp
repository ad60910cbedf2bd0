#pragma once

#include "engine/expr/vector_nodes.hpp"
#include "engine/language/rows/reading_text.hpp"
#include "engine/language/rows/row_maker.hpp"

#include <string>
#include <vector>

namespace zeroset {

/// Reads rows that are made of points: segments, vectors and polygons.
class ThingReader {
public:
    /// All of these outlive this object.
    ThingReader(ExpressionReader& reader, RowMaker& maker, const ReadingText& text)
        : reader_(reader), values_(reader.values()), maker_(maker), text_(text) {}

    [[nodiscard]] bool may_read(std::size_t statement) const;
    RowResult read(std::size_t statement);

private:
    using Corners = std::vector<VectorNodes>;

    std::optional<Corners> corners_of(const Syntax& call, std::size_t statement, std::string& text);
    bool check_corner(const BuiltValue& value, const Syntax& call, std::size_t place);
    RowResult straight(std::size_t statement, const Corners& ends, std::string text);
    bool is_zero(const VectorNodes& way, std::size_t offset);

    // thing_reader_polygon.cpp
    RowResult polygon(std::size_t statement, const Corners& corners, std::string text);
    bool check_plane(const Corners& corners, const VectorNodes& normal, const Syntax& call);
    [[nodiscard]] bool is_convex(const Corners& corners, const VectorNodes& normal) const;
    NodeId inside_polygon(const Corners& corners, const VectorNodes& normal, bool convex);

    ExpressionReader& reader_;
    GraphValues& values_;
    RowMaker& maker_;
    const ReadingText& text_;
};

}  // namespace zeroset
