#include "engine/base/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

// The loop over tiles: each index once, on no more threads than asked for.

namespace zeroset::test::parallel_test {
namespace {

TEST(ParallelFor, CallsEachIndexOnce) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
        for (const int threads : {0, 1, 2, 5}) {
            std::vector<std::atomic<int>> calls(count);
            parallel_for(count, threads, [&](std::size_t i) { ++calls.at(i); });
            for (std::size_t i = 0; i < count; ++i)
                EXPECT_EQ(calls[i], 1) << i << " of " << count;
        }
    }
}

TEST(ParallelFor, KeepsToItsThreads) {
    for (const int threads : {1, 2, 3}) {
        std::atomic<int> running{0};
        std::atomic<int> most{0};
        parallel_for(60, threads, [&](std::size_t) {
            const int now = ++running;
            for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
            }
            std::this_thread::sleep_for(std::chrono::microseconds(300));
            --running;
        });
        EXPECT_GE(most, 1);
        EXPECT_LE(most, threads);
    }
}

TEST(ParallelFor, OneThreadIsTheCallers) {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    parallel_for(50, 1, [&](std::size_t) {
        const std::scoped_lock lock(mutex);
        seen.insert(std::this_thread::get_id());
    });
    EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

TEST(ParallelFor, RunsWithinItself) {
    std::atomic<int> calls{0};
    parallel_for(4, 2, [&](std::size_t) { parallel_for(8, 2, [&](std::size_t) { ++calls; }); });
    EXPECT_EQ(calls, 32);
}

TEST(CoreCount, IsAtLeastOne) { EXPECT_GE(core_count(), 1); }

}  // namespace
}  // namespace zeroset::test::parallel_test
