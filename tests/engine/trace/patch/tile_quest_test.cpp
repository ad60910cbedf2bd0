#include "engine/trace/patch/tile_quest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace zeroset::test::tile_quest_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Expects that nothing is found, and that just this is wanted on each ray.
void expect_fresh(const TileAnswer& answer, const std::vector<double>& wanted) {
    for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
        ASSERT_EQ(answer.reach(pixel), wanted[pixel]) << pixel;
        ASSERT_FALSE(answer.hit(pixel).is_hit()) << pixel;
        ASSERT_EQ(answer.found()[pixel].state, RayState::Open) << pixel;
    }
    EXPECT_EQ(answer.touched(), 0U);
}

/// Hits here and there, one of which a leaf writes down itself.
void find_some(TileAnswer& answer, const TileQuest& quest) {
    for (const std::size_t pixel : {std::size_t{0}, std::size_t{777}, tile_pixels - 1})
        answer.set(pixel, {.s = 0.5, .is_proved = true});
    const LeafRays rays = answer.rays(quest, 1e-6, {});
    rays.reach[2000] = 0.25;
    rays.found[2000] = {.normal = {0, 0, 1}, .state = RayState::Proved};
    answer.touch(std::uint64_t{1} << block_of(2000));
    EXPECT_EQ(answer.hit(2000).s, 0.25);
    EXPECT_EQ(answer.hit(777).s, 0.5);
}

TEST(TileAnswer, BeginsAnewWhateverTilesCameBefore) {
    const TileQuest whole;
    TileQuest part;
    part.cols = 30;
    part.rows = 7;
    TileQuest limited;
    limited.to.assign(tile_pixels, -infinity);
    std::fill_n(limited.to.begin(), 1000, 3.0);
    std::vector<double> wanted_of_part(tile_pixels, -infinity);
    for (int row = 0; row < part.rows; ++row)
        std::fill_n(wanted_of_part.begin() + row * tile_size, part.cols, infinity);
    const std::vector<double> all(tile_pixels, infinity);

    TileAnswer answer;
    const auto ask = [&](const TileQuest& quest, const std::vector<double>& wanted) {
        answer.begin(quest);
        expect_fresh(answer, wanted);
        find_some(answer, quest);
    };
    ask(whole, all);
    ask(whole, all);
    ask(limited, limited.to);
    ask(whole, all);
    ask(part, wanted_of_part);
    ask(whole, all);
}

TEST(TileAnswer, WantsNothingMoreOnClosedRays) {
    TileQuest quest;
    quest.wish = TileQuest::Wish::AnyHits;
    quest.to.assign(tile_pixels, 2.0);
    TileAnswer answer;
    answer.begin(quest);
    answer.set(5, {.s = 9.0});
    EXPECT_EQ(answer.reach(5), 2.0) << "a hit behind the limit changes nothing";
    answer.close(5);
    EXPECT_EQ(answer.reach(5), -infinity);
    EXPECT_EQ(answer.limit(5), -infinity);
    EXPECT_EQ(answer.limit(6), 2.0);
    EXPECT_EQ(quest.to[5], 2.0);
}

}  // namespace
}  // namespace zeroset::test::tile_quest_test
