#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

// Private to the words room: what each kind of plotting command says.

namespace zeroset {

enum class CommandKind : std::uint8_t {
    Equation,  ///< an equation and the ranges of x, y and z
    Graph,     ///< a height, or a point, and the ranges of two variables
    Point,     ///< a point, and the ranges of one or two variables
    Zeros,     ///< of MATLAB: a function and an interval
    Sheet,     ///< of MATLAB: a height or three functions, and an interval
    Track,     ///< of MATLAB: three functions of one variable, and an interval
    Listed,    ///< of GeoGebra: three numbers, then variables, each before its ends
};

/// A statement that a command becomes: `main`, which is a part of the text, with something before
/// it and behind it.
struct Rewritten {
    std::string before;
    std::string_view main;
    std::string behind;
};

/// The statement that a command with these arguments is, which are parts of `text`; nullopt: it
/// says what no statement does.
std::optional<Rewritten> rewritten(CommandKind kind, std::span<const std::string_view> arguments,
                                   std::string_view text);

}  // namespace zeroset
