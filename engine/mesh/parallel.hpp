#pragma once

#include "engine/base/parallel.hpp"
#include "engine/mesh/mesh_work.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <cstddef>

namespace zeroset {

/// Calls body(first, last) for stretches of 0 to `count`, each at most `stretch` long, in upward
/// rounding, until the work is cancelled. body must not throw.
template <class Body>
void parallel_upward(std::size_t count, std::size_t stretch, const MeshWork& work,
                     const Body& body) {
    parallel_for((count + stretch - 1) / stretch, work.threads, [&](std::size_t i) {
        if (work.limit.cancelled()) return;
        const UpwardRegisters upward;
        body(i * stretch, std::min(count, (i + 1) * stretch));
    });
}

}  // namespace zeroset
