#pragma once

#include "document/import/script_tokens.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Formulas of other programs as trees: read by their own precedence, changed, and written for the
// language.

namespace zeroset {

/// The differences between the programs' formulas.
struct Dialect {
    bool minus_before_power = false;  ///< -x^2 is (-x)^2, as in surf
    bool power_from_left = false;     ///< x^y^z is (x^y)^z
    bool equals_is_condition = true;  ///< a single = compares
    bool parts_of_calls = false;      ///< f(x).gray is a part of the value of f
};

enum class TermKind : std::uint8_t {
    Number,
    Name,
    Call,    ///< text(operands); text is "f.part" for a part of the value
    Prefix,  ///< text is - or !
    Power,   ///< operands[0]^operands[1]
    Chain,   ///< operands with signs of one precedence between them
};

/// A formula or a part of one. Its depth is bounded by most_depth.
struct ForeignTerm {
    TermKind kind = TermKind::Number;
    std::string text = {};  ///< the digits, the name, the function, the prefix
    std::vector<ForeignTerm> operands = {};
    std::vector<std::string> signs = {};  ///< of a Chain: that before each operand; the first empty
    std::size_t line = 0;
};
/// Deeper formulas are refused.
inline constexpr int most_depth = 200;

struct TermError {
    std::size_t line;
    std::string reason;
};

/// Reads the formula that is next, up to the first token that cannot belong to it.
std::expected<ForeignTerm, TermError> read_term(TokenReader& tokens, const Dialect& dialect);
/// Reads a text that is one formula as a whole.
std::expected<ForeignTerm, TermError> read_whole_term(std::string_view text,
                                                      const Dialect& dialect);

/// The formula in the language, with no more parentheses than it needs.
std::string text_of(const ForeignTerm& term);

/// Calls `change` with each part of the formula, operands first.
void for_each_part(ForeignTerm& term, const std::function<void(ForeignTerm&)>& change);

/// The formula's value; nothing where it has names that `value_of` does not know, or functions that
/// are not known here. Functions are those of C; log is natural.
using ValueOfName = std::function<std::optional<double>(std::string_view)>;
std::optional<double> value_of(const ForeignTerm& term, const ValueOfName& value_of_name);

/// A name of the language's own or of two operands as a call: fmod(a, b).
ForeignTerm call_of(std::string function, std::vector<ForeignTerm> operands, std::size_t line);
ForeignTerm number_term(double value, std::size_t line);

}  // namespace zeroset
