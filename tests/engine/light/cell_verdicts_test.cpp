#include "engine/kernel/form_cells.hpp"
#include "engine/light/cell_verdicts-inl.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

// Verdicts on single cells, and those on vectors of them, are the same.

namespace zeroset::test::cell_verdicts_test {
namespace {

namespace at = HWY_NAMESPACE;

constexpr std::size_t count = 64;

template <class Real>
Real any_number(RandomNumbers& random) {
    if (random.one_in(20)) return std::numeric_limits<Real>::quiet_NaN();
    if (random.one_in(20)) return std::numeric_limits<Real>::infinity();
    if (random.one_in(10)) return 0;
    return static_cast<Real>(random.uniform(-1, 1));
}

template <class Real>
FormCells<Real, count> any_cells(RandomNumbers& random) {
    FormCells<Real, count> cells{};
    for (std::size_t i = 0; i < count; ++i) {
        for (auto* const column : {&cells.c, &cells.k[0], &cells.k[1], &cells.k[2], &cells.slope_hi,
                                   &cells.slope_neg_lo})
            (*column)[i] = any_number<Real>(random);
        cells.e[i] = static_cast<Real>(random.uniform(0, 0.3));
        const auto all = ~ContinuityMask<Real>{0};
        cells.continuous[i] = random.one_in(4) ? 0 : all;
        cells.nowhere[i] = random.one_in(8) ? all : 0;
    }
    return cells;
}

/// The hits of a cell: HitsOfCell.
struct Hits {
    bool behind, left_falling, left_rising, above, below;
};

Hits any_hits(RandomNumbers& random) {
    const bool behind = random.one_in(2);
    const bool above = behind && random.one_in(2);
    return {.behind = behind,
            .left_falling = !behind && random.one_in(2),
            .left_rising = !behind && random.one_in(2),
            .above = above,
            .below = behind && !above && random.one_in(2)};
}

template <class Real>
class CellVerdicts : public ::testing::Test {};
TYPED_TEST_SUITE(CellVerdicts, RealTypes, RealTypeNames);

TYPED_TEST(CellVerdicts, AreTheSameOfOneCellAndOfAVectorOfThem) {
    using One = at::OneCell<TypeParam>;
    using Many = at::VectorOfCells<TypeParam>;
    constexpr std::size_t lanes = at::lanes<TypeParam>;
    RandomNumbers random(31);
    std::array<std::size_t, 4> told{};  // free, dark, positive, negative
    for (int n = 0; n < 500; ++n) {
        const auto cells = any_cells<TypeParam>(random);
        for (std::size_t first = 0; first < count; first += lanes) {
            std::array<Hits, lanes> hits{};
            std::array<at::LaneBits, 5> bits{};
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                hits[lane] = any_hits(random);
                const bool known[] = {hits[lane].behind, hits[lane].left_falling,
                                      hits[lane].left_rising, hits[lane].above, hits[lane].below};
                for (std::size_t k = 0; k < bits.size(); ++k)
                    bits[k] |= static_cast<at::LaneBits>(known[k]) << lane;
            }
            const auto mask = [&](std::size_t k) { return at::mask_of(at::d<TypeParam>, bits[k]); };
            const auto many =
                at::verdict_of<Many>(at::line_of<Many>(cells, first), {.behind = mask(0),
                                                                       .left_falling = mask(1),
                                                                       .left_rising = mask(2),
                                                                       .above = mask(3),
                                                                       .below = mask(4)});
            const std::array found{at::bits_of(at::d<TypeParam>, many.free),
                                   at::bits_of(at::d<TypeParam>, many.dark),
                                   at::bits_of(at::d<TypeParam>, many.positive),
                                   at::bits_of(at::d<TypeParam>, many.negative)};
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const Hits& of = hits[lane];
                const auto one = at::verdict_of<One>(at::line_of<One>(cells, first + lane),
                                                     {.behind = of.behind,
                                                      .left_falling = of.left_falling,
                                                      .left_rising = of.left_rising,
                                                      .above = of.above,
                                                      .below = of.below});
                const std::array expected{one.free, one.dark, one.positive, one.negative};
                for (std::size_t k = 0; k < expected.size(); ++k) {
                    ASSERT_EQ((found[k] >> lane & 1U) != 0, expected[k]) << k << ", cell " << lane;
                    told[k] += expected[k] ? 1U : 0U;
                }
                EXPECT_FALSE(one.free && one.dark);
                EXPECT_FALSE(one.positive && one.negative);
            }
        }
    }
    for (const std::size_t times : told)
        EXPECT_GT(times, 500U);
}

}  // namespace
}  // namespace zeroset::test::cell_verdicts_test
