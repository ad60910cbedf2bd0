#pragma once

#include "app/cli/options/options.hpp"
#include "pipeline/input_error.hpp"

#include <cstdint>
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

/// How opaque one surface is, or all are.
struct OpacityChoice {
    std::optional<int> surface = std::nullopt;  ///< as in SolidChoice
    double opacity = 1.0;

    bool operator==(const OpacityChoice&) const = default;
};

/// A value that an option gives to one surface, or to all.
template <class Value>
struct SurfaceChoice {
    std::optional<int> surface = std::nullopt;  ///< as in SolidChoice
    Value value{};

    bool operator==(const SurfaceChoice&) const = default;
};

/// The choices of --color, --thickness and --surface-box.
struct SurfaceChoices {
    std::vector<SurfaceChoice<std::uint32_t>> colors;
    std::vector<SurfaceChoice<Thickness>> thicknesses;
    std::vector<SurfaceChoice<Box>> boxes;
};

/// Reads the values of --color, --thickness and --surface-box: each for all surfaces or, behind N:,
/// for number N, from 1.
OrInputError<SurfaceChoices> read_surface_choices(const SurfaceTexts& texts);

std::optional<InputError> check_surface_choices(const Program& program,
                                                const SurfaceChoices& choices);
void take_surface_choices(const SurfaceChoices& choices, const std::vector<int>& surface_rows,
                          Document& document);

/// Reads the values of --solid: SIDE for all surfaces or N:SIDE for number N, from 1. SIDE is f<0,
/// f>0 or auto.
OrInputError<std::vector<SolidChoice>> read_solids(const std::vector<std::string>& texts);

/// Reads the values of --opacity: V for all surfaces or N:V for number N; V is 0 to 1.
OrInputError<std::vector<OpacityChoice>> read_opacities(const std::vector<std::string>& texts);

/// Returns an error for a choice of a surface that the program does not have.
std::optional<InputError> check_solids(const Program& program,
                                       const std::vector<SolidChoice>& choices);

std::optional<InputError> check_opacities(const Program& program,
                                          const std::vector<OpacityChoice>& choices);

/// Applies the choices to the rows of the program's surfaces.
void take_solids(const std::vector<SolidChoice>& choices, const std::vector<int>& surface_rows,
                 Document& document);
void take_opacities(const std::vector<OpacityChoice>& choices, const std::vector<int>& surface_rows,
                    Document& document);

}  // namespace zeroset
