#pragma once

#include "engine/trace/scene.hpp"

#include <optional>

namespace zeroset {

/// How many further slices a certificate looks at behind the one where the search stopped.
inline constexpr int extra_slices = 3;

/// Bisections of the clip box's longest edge down to the finest slices along an axis on which the
/// clip box reaches `k_size` from 0: as the criterion wants, but none finer than two ulp of float
/// there; at least 1.
int bisections(const Box& clip, double k_size, const StopCriterion& stop);

/// The widest bracket of a certified pixel, world units along a world axis: its first root is in it
/// and so is what is drawn. Nothing where the criterion does not bound it.
std::optional<double> certified_width(const Box& clip, const StopCriterion& stop);

}  // namespace zeroset
