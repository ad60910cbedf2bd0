#include "engine/image/frame_pool.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

// Framebuffers that come back.

namespace zeroset::test::frame_pool_test {
namespace {

TEST(FramePool, GivesFramesOfTheSizeAskedFor) {
    FramePool pool;
    const auto frame = pool.take(7, 5);
    EXPECT_EQ(frame->width, 7);
    EXPECT_EQ(frame->height, 5);
    EXPECT_EQ(frame->color.size(), 35U);
    EXPECT_EQ(frame->depth.size(), 35U);
}

TEST(FramePool, GivesBackWhatNobodyHolds) {
    FramePool pool;
    auto frame = pool.take(7, 5);
    const Framebuffer* const first = frame.get();
    const auto held = pool.take(7, 5);
    EXPECT_NE(held.get(), first);
    frame.reset();
    EXPECT_NE(pool.take(5, 7).get(), first);  // another size
    EXPECT_EQ(pool.take(7, 5).get(), first);
}

TEST(FramePool, ItsFramesOutliveIt) {
    std::optional<FramePool> pool(std::in_place);
    const auto frame = pool->take(2, 2);
    pool.reset();
    frame->depth[3] = 1.0F;
    EXPECT_EQ(frame->depth[3], 1.0F);
}

}  // namespace
}  // namespace zeroset::test::frame_pool_test
