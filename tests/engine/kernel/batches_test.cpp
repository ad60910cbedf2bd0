#include "engine/kernel/batches.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/kernel/range_boxes.hpp"

#include <gtest/gtest.h>

// Batches that are filled by count: what is beyond it repeats an item, so that kernels may run on.

namespace zeroset::batches_test {
namespace {

TEST(Padded, IsTheNextMultiple) {
    EXPECT_EQ(padded(0), 0U);
    EXPECT_EQ(padded(1), batch_multiple);
    EXPECT_EQ(padded(batch_multiple), batch_multiple);
    EXPECT_EQ(padded(batch_multiple + 1), 2 * batch_multiple);
    EXPECT_EQ(padded(5, 4), 8U);
}

TEST(RangeBoxes, RepeatTheFirstBox) {
    RangeBoxes<float, 2 * batch_multiple> boxes;
    for (std::size_t axis = 0; axis < 6; ++axis) {
        for (std::size_t i = 0; i < 3; ++i)
            boxes.ends[axis][i] = static_cast<float>(10 * axis + i);
    }
    boxes.pad(3);
    for (std::size_t axis = 0; axis < 6; ++axis) {
        EXPECT_EQ(boxes.ends[axis][2], static_cast<float>(10 * axis + 2));
        EXPECT_EQ(boxes.ends[axis][3], static_cast<float>(10 * axis));
        EXPECT_EQ(boxes.ends[axis][batch_multiple - 1], static_cast<float>(10 * axis));
    }
}

TEST(RangeBoxList, RepeatsTheFirstBox) {
    RangeBoxList<double> boxes;
    boxes.reserve(3);
    for (std::size_t axis = 0; axis < 6; ++axis) {
        for (std::size_t i = 0; i < 3; ++i)
            boxes.ends[axis][i] = static_cast<double>(10 * axis + i);
    }
    const RangeBatchOf<double> batch = boxes.batch(3, nullptr);
    EXPECT_EQ(batch.size, batch_multiple);
    EXPECT_EQ(batch.neg_lo[1][2], 12.0);
    EXPECT_EQ(batch.neg_lo[1][3], 10.0);
    EXPECT_EQ(batch.hi[2][batch_multiple - 1], 50.0);
}

TEST(PointBatch, RepeatsTheLastPoint) {
    PointBatch<double> points(2);
    points.set(0, 1.0, 2.0, 3.0);
    points.set(1, 4.0, 5.0, 6.0);
    points.pad();
    const ValueBatchOf<double> batch = points.batch(nullptr);
    EXPECT_EQ(batch.size, batch_multiple);
    EXPECT_EQ(batch.x[0][0], 1.0);
    EXPECT_EQ(batch.x[2][1], 6.0);
    EXPECT_EQ(batch.x[1][batch_multiple - 1], 5.0);
    EXPECT_NE(batch.gradient[0], nullptr);
}

TEST(PointBatch, AsksForValuesOnly) {
    PointBatch<double> points(1, PointBatch<double>::Asks::Value);
    EXPECT_EQ(points.batch(nullptr).gradient[0], nullptr);
}

}  // namespace
}  // namespace zeroset::batches_test
