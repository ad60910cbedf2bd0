#include "engine/base/enum_names.hpp"

#include <gtest/gtest.h>

namespace zeroset::enum_names_test {
namespace {

enum class Fruit : unsigned char { Apple, Pear, Plum };

constexpr auto names = enum_names<Fruit>("apple", "pear", "plum");

TEST(EnumNames, AreFoundBothWays) {
    ASSERT_EQ(names.values().size(), 3U);
    for (const Fruit fruit : names.values())
        EXPECT_EQ(names.named(names.of(fruit)), fruit);
    EXPECT_EQ(names.of(Fruit::Pear), "pear");
}

TEST(EnumNames, OthersAreNone) {
    EXPECT_FALSE(names.named("cherry"));
    EXPECT_FALSE(names.named(""));
    EXPECT_FALSE(names.named("Pear"));
}

static_assert(names.named("plum") == Fruit::Plum);

}  // namespace
}  // namespace zeroset::enum_names_test
