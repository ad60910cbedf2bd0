#include "engine/kernel/kernel.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace zeroset::test::kernel_memory_test {
namespace {

struct One {
    int value = 0;
};
struct Other {
    int value = 0;
};

TEST(KernelMemory, KeepsOneThingOfEachTypeForAllCopies) {
    const Kernel kernel;
    kernel.memory->of<One>()->value = 1;
    kernel.memory->of<Other>()->value = 2;
    const Kernel copy = kernel;
    EXPECT_EQ(copy.memory->of<One>()->value, 1);
    EXPECT_EQ(copy.without_waiting().memory->of<Other>()->value, 2);
    EXPECT_EQ(Kernel().memory->of<One>()->value, 0) << "another kernel";
}

TEST(KernelMemory, GoesWithTheLastCopy) {
    std::weak_ptr<One> kept;
    {
        Kernel copy;
        {
            const Kernel kernel;
            kept = kernel.memory->of<One>();
            copy = kernel;
        }
        EXPECT_FALSE(kept.expired());
    }
    EXPECT_TRUE(kept.expired());
}

}  // namespace
}  // namespace zeroset::test::kernel_memory_test
