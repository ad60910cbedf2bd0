#pragma once

#include "tests/support/oracle/mpfi_operators.hpp"

namespace zeroset::test {

/// The enclosure of a volume over a box.
MpfiEnclosure enclosed_field(const Field& field, const MpfiEnclosure& a, const MpfiEnclosure& b,
                             const MpfiEnclosure& c);
/// Its slope, from the slopes of the operands.
MpfiInterval slope_of_field(const Field& field, const MpfiDual& a, const MpfiDual& b,
                            const MpfiDual& c);

}  // namespace zeroset::test
