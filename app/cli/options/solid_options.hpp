#pragma once

#include "app/cli/options/options.hpp"
#include "pipeline/input_error.hpp"

#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The solid side of one surface or of all.
struct SolidChoice {
    std::optional<int> surface = std::nullopt;  ///< the surface's number, from 1; nothing: all
    SolidSide side = SolidSide::Automatic;

    bool operator==(const SolidChoice&) const = default;
};

/// Reads the values of --solid: SIDE for all surfaces or N:SIDE for number N, from 1. SIDE is f<0,
/// f>0 or auto.
OrInputError<std::vector<SolidChoice>> read_solids(const std::vector<std::string>& texts);

/// Returns an error for a choice of a surface that the program does not have.
std::optional<InputError> check_solids(const Program& program,
                                       const std::vector<SolidChoice>& choices);

/// Applies the choices to the rows of the program's surfaces.
void take_solids(const std::vector<SolidChoice>& choices, const std::vector<int>& surface_rows,
                 Document& document);

}  // namespace zeroset
