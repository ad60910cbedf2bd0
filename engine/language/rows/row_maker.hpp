#pragma once

#include "engine/expr/patch_graph.hpp"
#include "engine/language/expressions/expression_reader.hpp"
#include "engine/language/rows/cut_text.hpp"

#include <array>
#include <expected>
#include <optional>
#include <span>
#include <string>

namespace zeroset {

/// A surface that a row shows.
struct RowSurface {
    std::size_t statement;
    NodeId root;
    bool solid = false;     ///< the root is below 0 where a condition holds
    bool sheet = false;     ///< neither side of it is solid
    std::string text = {};  ///< how the row was read; empty: as the equation that it is
    std::string name = {};  ///< of a point
};
using RowResult = std::expected<RowSurface, ParseError>;

/// Makes surfaces of the graphs of rows, and cuts them to the boxes of a document.
class RowMaker {
public:
    /// `cuts` outlive this object.
    RowMaker(ExpressionReader& reader, std::span<const CutText> cuts)
        : reader_(reader), cuts_(cuts) {}

    /// The surface root = 0, or a solid; an error where the root does not depend on the point or
    /// its condition never holds.
    RowResult surface(std::size_t statement, NodeId root, bool solid = false);
    /// The surface, curve or point of a graph over its variables.
    RowResult patch(std::size_t statement, PatchKind kind, const std::array<NodeId, 3>& point,
                    std::string text);
    /// Cuts a surface that is an equation by the box of its row. It is read as if there were none.
    std::expected<void, ParseError> cut(RowSurface& surface);
    /// Whether (x, y, z) is in the box of a row; nothing where it has none.
    std::optional<NodeId> inside_box(std::size_t statement);
    /// The error for a row without x, y and z.
    [[nodiscard]] ParseError error_without_place(std::size_t statement) const;

private:
    [[nodiscard]] std::size_t offset_of(std::size_t statement) const {
        return reader_.tree().statements[statement].offset;
    }
    [[nodiscard]] std::optional<RowBox> box_of(std::size_t statement) const;

    ExpressionReader& reader_;
    std::span<const CutText> cuts_;
};

}  // namespace zeroset
