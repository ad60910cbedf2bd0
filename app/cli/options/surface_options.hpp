#pragma once

#include "app/cli/options/options.hpp"
#include "pipeline/input_error.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// A value that an option gives to one surface, or to all.
template <class Value>
struct SurfaceChoice {
    std::optional<int> surface = std::nullopt;  ///< the surface's number, from 1; nothing: all
    Value value{};

    bool operator==(const SurfaceChoice&) const = default;
};

/// The values of SurfaceTexts, read.
struct SurfaceChoices {
    std::vector<SurfaceChoice<SolidSide>> solids = {};
    std::vector<SurfaceChoice<double>> opacities = {};  ///< 0 to 1
    std::vector<SurfaceChoice<Look>> looks = {};
    std::vector<SurfaceChoice<std::uint32_t>> colors = {};
    std::vector<SurfaceChoice<Thickness>> thicknesses = {};
    std::vector<SurfaceChoice<Box>> boxes = {};
};

/// Reads the options' values: each for all surfaces or, behind N:, for number N, from 1.
OrInputError<SurfaceChoices> read_surface_choices(const SurfaceTexts& texts);

/// Returns an error for a choice of a surface that the program does not have, or that has no such
/// thing.
std::optional<InputError> check_surface_choices(const Program& program,
                                                const SurfaceChoices& choices);

/// Applies the choices to the rows of the program's surfaces.
void take_surface_choices(const SurfaceChoices& choices, const std::vector<int>& surface_rows,
                          Document& document);

}  // namespace zeroset
