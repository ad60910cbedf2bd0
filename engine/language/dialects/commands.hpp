#pragma once

#include "engine/language/dialects/expressions.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Plotting commands of other programs: what they draw as rows, their ranges as the clip box.

namespace zeroset {

/// A call of a plotting command in a text.
struct CommandCall {
    std::string_view name;
    std::vector<std::string_view> arguments;
};

/// Facts that a command tells besides its surfaces.
struct CommandOutcome {
    std::vector<std::string_view> left_out;  ///< options that only change how it looks
    AskedBox box = {};
};

/// Whether a call is one of a plotting command; Show, display and their like are where they show
/// one.
bool is_command(const CommandCall& call);
/// The program that has this command, such as "Mathematica".
std::string_view program_of_command(std::string_view name);

/// Writes the rows that a command draws, joined by ";"; nothing where a part of it is not
/// understood: then `rows` is to be dropped.
std::optional<CommandOutcome> write_command(const CommandCall& call, ExpressionWriter& rows);

}  // namespace zeroset
