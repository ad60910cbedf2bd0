#pragma once

#include "engine/language/dialects/parts.hpp"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace zeroset {

inline constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};

/// Ranges and options behind the formulas of a plotting command.
struct CommandArguments {
    std::vector<NamedRange> ranges;
    std::vector<std::string_view> levels;      ///< of f, where the command gives any
    std::optional<UnnamedFunction> condition;  ///< where it is drawn
    std::string_view coordinates;              ///< Maple's coords = spherical
    std::vector<std::string_view> left_out;    ///< options that only change how it looks
};

/// Reads ranges and options `name -> value` or `name = value`; nothing where something else stands
/// there, or an option that changes what is drawn in a way that is not read.
std::optional<CommandArguments> ranges_and_options(std::span<const std::string_view> arguments);
/// Reads names and ends without brackets: u, 0, 6, v, 0, 1.
std::optional<CommandArguments> flat_ranges(std::span<const std::string_view> arguments);
/// Reads MATLAB's [lo hi] or [lo hi lo hi ...] for these variables; from quotation marks on stands
/// how it looks. Without them the ends are -5 and 5.
std::optional<CommandArguments> interval_ranges(std::span<const std::string_view> arguments,
                                                std::span<const std::string_view> names);

/// The parts of what is in a call's brackets; commas of Python's lambda x, y: part none.
std::vector<std::string_view> arguments_in(std::string_view inside);

}  // namespace zeroset
