#pragma once

#include "app/cli/options/options.hpp"
#include "document/solid_choice.hpp"
#include "pipeline/input_error.hpp"

#include <vector>

namespace zeroset {

/// The values of --solid: SIDE for all surfaces or N:SIDE for number N, from 1; SIDE is f<0, f>0 or
/// auto.
OrInputError<std::vector<SolidChoice>> read_solids(const std::vector<std::string>& texts);

/// An error for a choice of a surface that the program does not have.
std::optional<InputError> check_solids(const Program& program,
                                       const std::vector<SolidChoice>& choices);

/// Sets them in the rows of surfaces; those of a text that cannot be read stay as they are.
void take_solids(const std::vector<SolidChoice>& choices, Document& document);

}  // namespace zeroset
