#pragma once

#include "engine/scene/scene.hpp"

#include <optional>

namespace zeroset {

/// The side that is solid, of one surface or of all.
struct SolidChoice {
    std::optional<int> surface = std::nullopt;  ///< number of the surface, from 1; nothing: all
    SolidSide side = SolidSide::Automatic;

    bool operator==(const SolidChoice&) const = default;
};

}  // namespace zeroset
