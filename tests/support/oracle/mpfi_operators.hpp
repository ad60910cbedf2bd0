#pragma once

#include "engine/expr/expr.hpp"
#include "tests/support/oracle/mpfi_interval.hpp"

// The meaning of each operator of op.def over intervals of MPFI, written from the meaning that
// op.def states, not from the algebra under test.

namespace zeroset::test {

/// An enclosure over a box, with its claims about the domain there.
struct MpfiEnclosure {
    MpfiInterval range;      ///< encloses the values where there are any
    bool somewhere = true;   ///< false: proved undefined on the whole box; the range says nothing
    bool everywhere = true;  ///< proved defined everywhere
    bool continuous = true;  ///< proved continuous where defined
};

/// The operator's enclosure at its operands, of which those that it does not have are ignored.
/// Fails the running test for an unknown operator.
MpfiEnclosure enclosed(const Node& node, const MpfiEnclosure& a, const MpfiEnclosure& b,
                       const MpfiEnclosure& c);

/// A value along a line with its derivative.
struct MpfiDual {
    MpfiEnclosure value;
    /// Encloses all slopes (g(s) - g(t)) / (s - t) between points s, t of a piece of the line on
    /// which g is proved defined and continuous; means nothing elsewhere.
    MpfiInterval slope;
};

/// A value and slope of a function that is defined and continuous everywhere.
MpfiDual dual(MpfiInterval range, MpfiInterval slope);

/// The slope of the operator at its operands, where its value is `value`.
MpfiInterval slope_of(const Node& node, const MpfiEnclosure& value, const MpfiDual& a,
                      const MpfiDual& b, const MpfiDual& c);

}  // namespace zeroset::test
