#pragma once

#include "engine/expr/expr.hpp"
#include "engine/volume/spline.hpp"
#include "engine/volume/volume.hpp"
#include "tests/support/mpfr_number.hpp"

#include <memory>
#include <vector>

namespace zeroset::test {

/// The field of the tables of operators: 6 x 5 x 4 numbers about -1 to 1 in a turned, unequally
/// spaced grid about the origin, that goes on beyond it as at its edge. The same object each time.
const std::shared_ptr<const Volume>& sample_field();

/// Fields of all kinds, that among them. The same objects each time.
const std::vector<std::shared_ptr<const zeroset::Field>>& sample_fields();

/// The value of a field of any kind at a point, but for the rounding of MpfrNumber.
Reference field_reference(const zeroset::Field& field, const MpfrNumber& x, const MpfrNumber& y,
                          const MpfrNumber& z);
/// The value of a volume at a point, but for the rounding of MpfrNumber.
Reference field_reference(const Volume& volume, const MpfrNumber& x, const MpfrNumber& y,
                          const MpfrNumber& z);

/// The number of a grid as a double.
inline double stored_number(const Samples& grid, std::uint64_t i, std::uint64_t j,
                            std::uint64_t k) {
    return visit_samples(grid, [&](const auto* samples) {
        return static_cast<double>(samples[(k * grid.size[1] + j) * grid.size[0] + i]);
    });
}
/// The sample as a double.
inline double sample_at(const VolumeData& data, std::uint64_t i, std::uint64_t j, std::uint64_t k) {
    return stored_number(data.samples(), i, j, k);
}
/// The coefficient of a spline; (1, 1, 1) belongs to the first sample.
inline double coefficient_at(const SplineData& spline, std::uint64_t i, std::uint64_t j,
                             std::uint64_t k) {
    return stored_number(spline.coefficients(), i, j, k);
}

/// The operator; a field is `sample_field`.
NodeId applied(ExprBuilder& builder, Op op, NodeId a, NodeId b = 0, NodeId c = 0, int number = 0);
/// A node of the operator without operands; that of a field asks `sample_field`.
Node node_of(Op op, int number = 0);

}  // namespace zeroset::test
