#pragma once

#include "engine/scene/precision.hpp"
#include "engine/scene/settings.hpp"

#include <optional>

namespace zeroset {

/// How many further slices a certificate looks at behind the one where the search stopped.
inline constexpr int extra_slices = 3;

/// The widest bracket of a certified pixel of a frame traced in this type, by whatever tracer,
/// world units along a world axis: its first root is in it and so is what is drawn. Nothing where
/// the criterion does not bound it.
std::optional<double> certified_width(const Box& clip, const StopCriterion& stop,
                                      Precision precision);

}  // namespace zeroset
