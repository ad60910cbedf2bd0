// parallel_for without oneTBB, in which ThreadSanitizer reports races that do not exist.

#include "engine/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace zeroset {

int core_count() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            body(i);
    };
    std::vector<std::jthread> helpers;
    for (int i = 1; i < (threads > 0 ? threads : core_count()); ++i)
        helpers.emplace_back(work);
    work();
}

}  // namespace zeroset
