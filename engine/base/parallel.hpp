#pragma once

#include <cstddef>
#include <functional>

namespace zeroset {

/// Calls body(i) for 0 <= i < count, on up to `threads` threads at once (0: all cores), and
/// returns when all are done. body must not throw.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// The number of threads that parallel_for uses for `threads` 0.
int core_count();

}  // namespace zeroset
