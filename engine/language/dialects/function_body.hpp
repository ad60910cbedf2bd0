#pragma once

#include "engine/language/dialects/expressions.hpp"

#include <string_view>
#include <vector>

// Private to the room: the steps of a function as the language's braces have them.

namespace zeroset {

/// Writes steps of a function one after the other.
class FunctionBody {
public:
    explicit FunctionBody(ExpressionWriter& writer) : writer_(writer) {}

    /// Writes `float f(x, y) {`; types and values of arguments are left out.
    void begin(std::string_view name, std::string_view arguments);
    void end(std::string_view near) { put("}", near); }
    /// Writes a value of `target`: a name, a part of one, or several names in a row.
    void value(std::string_view target, std::string_view sign, std::string_view value);
    void result(std::string_view value);
    /// Writes `if (condition) {`; what follows up to `close` counts where it holds.
    void choice(std::string_view condition);
    void otherwise(std::string_view near) { put("} else {", near); }
    void close(std::string_view near) { put("}", near); }
    /// Writes a step: `NAME = value`, `NAME += value`, or a value alone, which is the result.
    void step(std::string_view text);

private:
    void put(std::string_view words, std::string_view near) { writer_.put(words, near); }
    void write(std::string_view expression);
    void several(const std::vector<std::string_view>& names, std::string_view values);

    ExpressionWriter& writer_;
    std::vector<std::string_view> arguments_;
};

/// The text up to a remark that begins with `mark`.
std::string_view without_remark(std::string_view line, std::string_view mark);

}  // namespace zeroset
