#pragma once

#include "engine/antialias/ray_stretches.hpp"
#include "engine/antialias/square_rays.hpp"

#include <optional>

namespace zeroset {

/// A straight thread across a square. All in halves of the square's side.
struct Thread {
    SquareRay normal;   ///< of length 1, across the thread
    double offset;      ///< of its middle along the normal, from the square's middle
    double half_width;  ///< 0: f comes to 0 on its middle, as far as samples tell, not through it
    bool empty;         ///< there would be one, but f stays away from 0

    /// The share of the square that a thread of such a width covers.
    [[nodiscard]] double share(double with_half_width) const;
    /// A place on the thread, in the square where it can be.
    [[nodiscard]] SquareRay middle() const;
};

/// The thread along which f is nearest to 0, if there f goes with the square of the distance from
/// it; `half_side`: of the square, in pixels; `thinnest`: half the width from which on a thread is
/// told from none.
std::optional<Thread> fit_thread(SquareStretches stretches, double half_side, double thinnest);

}  // namespace zeroset
