#pragma once

#include "engine/expr/facts.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// Where an interpreter keeps the nodes' values: those of uniform nodes in slots of their own, the
/// others in slots that are used again once no later node needs the value.
struct Slots {
    std::vector<std::uint32_t> of;  ///< the slot of each node
    std::uint32_t count = 0;
};

Slots assign_slots(const Expr& expr, std::span<const Facts> facts);

}  // namespace zeroset
