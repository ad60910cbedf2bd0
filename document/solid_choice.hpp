#pragma once

#include "engine/scene/scene.hpp"

#include <optional>

namespace zeroset {

/// Which side of a surface is solid.
struct SolidChoice {
    std::optional<int> surface = std::nullopt;  ///< its number, from 1; nothing: all
    SolidSide side = SolidSide::Automatic;

    bool operator==(const SolidChoice&) const = default;
};

}  // namespace zeroset
