#pragma once

#include "engine/expr/expr.hpp"
#include "engine/language/rows/cut_text.hpp"
#include "engine/language/vocabulary/reading.hpp"

#include <array>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

class FieldSource;

/// The meaning of a text. All surfaces share the numbering of the parameters.
struct Program {
    std::vector<Expr> surfaces;  ///< f of each equation f = 0, restricted by Op::Where; at least
                                 ///< one
    std::vector<bool> solids;    ///< of each surface: f < 0 is where its conditions hold
    std::vector<bool> sheets;    ///< of each surface: it has no inside, whatever f is beside it
    std::vector<std::string> names;  ///< of each surface: of the point that it is, or empty
    std::vector<Reading> readings;
    std::vector<std::string> parameters;  ///< single letters without a definition
    /// The ends in x, y and z that a plotting command of another program gives.
    std::array<std::optional<std::array<double, 2>>, 3> box = {};
    bool calls_w_t = false;  ///< it says t for the fourth coordinate, and never w
};

/// Reads the statements of a text (resources/docs/language.md). Time and memory are bounded for any
/// text. `files`: where files that it names come from; nullptr: it must not name any. `cuts` do not
/// overlap.
std::expected<Program, ParseError> read_program(std::string_view text,
                                                const FieldSource* files = nullptr,
                                                std::span<const CutText> cuts = {});

/// Reads an expression that may use the functions and values of a program (its text, which must be
/// readable) and the given parameters, in their order; another parameter is an error. Offsets of
/// errors count from the start of the expression. `files`: as for read_program, of both texts.
std::expected<Expr, ParseError> read_value(std::string_view expression, std::string_view program,
                                           std::span<const std::string> parameters,
                                           const FieldSource* files = nullptr);

/// Reads a text of one formula, which may also be constant, even undefined (1/0), and names no
/// files.
std::expected<Expr, ParseError> parse(std::string_view text);

}  // namespace zeroset
