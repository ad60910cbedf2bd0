#pragma once

#include "engine/algebra/operand.hpp"
#include "engine/num/beam.hpp"
#include "engine/num/enclosure.hpp"

#include <optional>

namespace zeroset {

/// f over a cell with its derivative along the ray, and what is known of the domain. An absent
/// derivative is 0, an absent mask true.
template <class Real>
struct BeamValue {
    using Mask = typename Enclosure<Real>::Mask;

    Beam<Real> f;
    /// Where f is continuous it is piecewise smooth; encloses the slopes of the pieces.
    std::optional<SlopeBeam<Real>> slope{};
    std::optional<Mask> somewhere{};  ///< as in Enclosure
    std::optional<Mask> everywhere{};
    std::optional<Mask> continuous{};
    /// Vanishes wherever f does, and is f where f is continuous; absent: f. Only the root's counts.
    std::optional<Beam<Real>> zeros{};
};

}  // namespace zeroset
