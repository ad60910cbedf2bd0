#pragma once

#include "engine/volume/volume.hpp"
#include "tests/support/oracle/ray_question.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace zeroset::test {

/// The sign of f that is known on a stretch of a ray.
enum class StretchSign : std::uint8_t { Unknown, Above, Below };

/// A cell of a volume and the numbers that a level may be.
struct CellLevel {
    const Volume& volume;
    std::array<std::uint64_t, 3> cell;
    /// The place in the cell along an axis, where it does not go by the ray: beyond the grid.
    std::array<std::optional<double>, 3> fixed;
    double lo, hi;
};

/// Whether the volume is surely above or below the level on the stretch of the ray from `from` to
/// `to`, both in the cell or on its border: by the Bernstein coefficients of the cell's polynomial
/// along the ray, in long double, with a bound of what is rounded. Where that does not tell,
/// exact numbers must.
StretchSign sign_in_cell(const CellLevel& of, const RayQuestion& ray, double from, double to);

}  // namespace zeroset::test
