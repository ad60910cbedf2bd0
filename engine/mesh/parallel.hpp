#pragma once

#include "engine/base/parallel.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <cstddef>

namespace zeroset {

/// Calls body(first, last) for stretches of 0 to `count`, each at most `stretch` long, in upward
/// rounding on up to `threads` threads. body must not throw.
template <class Body>
void parallel_upward(std::size_t count, std::size_t stretch, int threads, const Body& body) {
    parallel_for((count + stretch - 1) / stretch, threads, [&](std::size_t i) {
        const UpwardRegisters upward;
        body(i * stretch, std::min(count, (i + 1) * stretch));
    });
}

}  // namespace zeroset
