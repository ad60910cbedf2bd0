#pragma once

#include "tests/support/random_numbers.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace zeroset::test {

/// A family of random formulas.
struct SurfaceFamily {
    std::string_view name;
    /// Makes a function of x, y, z, as text in the language.
    std::string (*formula)(RandomNumbers& random);
};

/// The families: polynomials of several degrees, products, trigonometric formulas, solids by min,
/// max and abs, quotients, roots, exponentials, steps.
std::span<const SurfaceFamily> surface_families();

/// An equation f - c of the family whose surface passes near a point in the middle of the cube
/// [-half_edge, half_edge]^3, so that a view of the cube is likely to show it.
std::string random_surface(const SurfaceFamily& family, double half_edge, RandomNumbers& random);

}  // namespace zeroset::test
