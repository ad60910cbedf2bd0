#pragma once

#include "app/cli/options/options.hpp"
#include "pipeline/input_error.hpp"

#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// Which side of a surface is solid.
struct SolidChoice {
    std::optional<int> surface = std::nullopt;  ///< its number, from 1; nothing: all
    SolidSide side = SolidSide::Automatic;

    bool operator==(const SolidChoice&) const = default;
};

/// The values of --solid: SIDE for all surfaces or N:SIDE for number N, from 1; SIDE is f<0, f>0 or
/// auto.
OrInputError<std::vector<SolidChoice>> read_solids(const std::vector<std::string>& texts);

/// An error for a choice of a surface that the program does not have.
std::optional<InputError> check_solids(const Program& program,
                                       const std::vector<SolidChoice>& choices);

/// Sets them in the rows of the program's surfaces.
void take_solids(const std::vector<SolidChoice>& choices, const std::vector<int>& surface_rows,
                 Document& document);

}  // namespace zeroset
