#pragma once

#include <cstdint>
#include <string_view>

namespace zeroset {

/// How the arguments of a plotting command say what it draws.
enum class Draws : std::uint8_t {
    Equations,    ///< f or a = b, or a list of them, over ranges of x, y and z
    Heights,      ///< z over the ranges of two variables; or a point of three
    Points,       ///< a point in brackets over ranges
    ThreeParts,   ///< three numbers, then ranges
    Spherical,    ///< a distance over the angle from the z axis and the one around it
    AroundFirst,  ///< likewise, the angle around the z axis first
    Turned,       ///< a height, or a point of two, turned around the z axis
    Zeros,        ///< MATLAB's function of x, y and z, then [lo hi ...]
    Sheet,        ///< MATLAB's height or three functions, then [lo hi ...]
    Track,        ///< MATLAB's three functions, then [lo hi]
    Listed,       ///< three numbers, then names and ends without brackets
    FlatZeros,    ///< Maxima's equation, then names and ends without brackets
    FlatHeights,  ///< Maxima's height, likewise
    Commands,     ///< other commands
};

/// A plotting command, and the program that has it, such as "Mathematica".
struct KnownCommand {
    std::string_view name, program;
    Draws draws;
};

/// The command of this name; nullptr: there is none.
const KnownCommand* known_command(std::string_view name);

}  // namespace zeroset
