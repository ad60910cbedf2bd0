#include "engine/blobs/blobs.hpp"

#include "engine/blobs/blob_file.hpp"
#include "engine/language/parse.hpp"
#include "tests/support/blob_reference.hpp"
#include "tests/support/field_checks.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

// Soft balls against the papers' formulas in 256 bits: values, derivatives, enclosures, the tree.

namespace zeroset::test::blobs_test {
namespace {

constexpr std::array kinds{BlobKind::Wyvill, BlobKind::Metaball, BlobKind::Blinn};

Point some_point(RandomNumbers& random) {
    Point point{};
    for (double& x : point)
        x = random.one_in(20) ? random.uniform(-40, 40) : random.uniform(-3, 3);
    return point;
}

TEST(Blobs, HaveTheDocumentedValues) {
    for (const BlobKind kind : kinds) {
        const auto field = sample_blobs(kind);
        RandomNumbers random(21);
        for (int n = 0; n < 1000; ++n) {
            const Point point = some_point(random);
            const MpfrNumber error =
                MpfrNumber(value_at(*field, point)[0]) - exact(*field, wide(point));
            EXPECT_LT(std::abs(error.nearest()), 1e-14) << field->text();
        }
        const Blob alone{.center = {1, 2, 3}, .radius = 0.5};
        const auto ball = blobs_field(kind, std::array{alone}, "alone");
        EXPECT_NEAR(value_at(*ball, {1.5, 2, 3})[0], 1, 1e-15);
        EXPECT_NEAR(value_at(*ball, {1, 2.25, 3})[0], blob_facts(kind).top, 6);
    }
}

TEST(Blobs, HaveExactDerivatives) {
    for (const BlobKind kind : kinds) {
        RandomNumbers random(22);
        for (int n = 0; n < 60; ++n)
            expect_exact_derivatives(*sample_blobs(kind), some_point(random));
    }
}

TEST(Blobs, KeepTheBoundsOfTheirKind) {
    for (const BlobKind kind : kinds) {
        const BlobFacts facts = blob_facts(kind);
        const auto ball = blobs_field(kind, std::array{Blob{}}, "one");
        for (int n = 0; n <= 4000; ++n) {
            const double d = std::sqrt(facts.reach) * n / 4000;
            const auto value = value_at(*ball, {d, 0, 0});
            EXPECT_LE(value[0], facts.top);
            EXPECT_LE(std::abs(value[1]), facts.slope);
            EXPECT_LE(std::abs(value_at(*ball, {d, 0, 0}, derivative_by(2, 0, 0))[0]), facts.bend);
        }
        EXPECT_LE(value_at(*ball, {std::sqrt(facts.reach) * (1 - 1e-9), 0, 0})[0],
                  facts.tail + 1e-16);
    }
}

template <class Real>
class BlobEnclosure : public testing::Test {};
TYPED_TEST_SUITE(BlobEnclosure, RealTypes, RealTypeNames);

TYPED_TEST(BlobEnclosure, HoldsOfValuesAndDerivatives) {
    using Real = TypeParam;
    for (const BlobKind kind : kinds) {
        const auto field = sample_blobs(kind);
        RandomNumbers random(23);
        const EnclosureCheck check{
            .boxes = 4000, .every = 4, .value_error = 1e-13, .slope_error = 1e-11};
        const auto box = [&] { return box_about<Real>(some_point(random), {-14, 3}, random); };
        EXPECT_GT(expect_enclosures<Real>(*field, check, box, random), 1500) << field->text();
    }
}

TYPED_TEST(BlobEnclosure, AnswersEachLaneAlikeAmongOthers) {
    using Real = TypeParam;
    for (const BlobKind kind : kinds) {
        RandomNumbers random(24);
        expect_lanes_alike<Real>(*sample_blobs(kind), [&] {
            return box_about<Real>(some_point(random), {-14, 3}, random);
        });
    }
}

TEST(Blobs, OfManyAreThoseThatReach) {
    RandomNumbers random(25);
    std::vector<Blob> many;
    for (int n = 0; n < 10000; ++n) {
        Blob blob{.radius = random.uniform(0.01, 0.05)};
        for (double& x : blob.center)
            x = random.uniform(-1, 1);
        many.push_back(blob);
    }
    for (const BlobKind kind : {BlobKind::Wyvill, BlobKind::Metaball}) {
        const auto field = blobs_field(kind, many, "many");
        for (int n = 0; n < 200; ++n) {
            Point point{};
            for (double& x : point)
                x = random.uniform(-1.2, 1.2);
            double sum = 0;
            for (const Blob& blob : many) {
                const auto alone = [&] {
                    double squares = 0;
                    for (std::size_t i = 0; i < 3; ++i)
                        squares += (point[i] - blob.center[i]) * (point[i] - blob.center[i]);
                    return std::sqrt(squares) / blob.radius;
                }();
                if (alone >= 2) continue;
                const double q = alone * alone;
                sum += kind == BlobKind::Wyvill
                           ? 2 - 11 * q / 9 + 17 * q * q / 72 - q * q * q / 72
                           : (q <= 4.0 / 9 ? 8.0 / 3 - 2 * q : (2 - alone) * (2 - alone));
            }
            EXPECT_NEAR(value_at(*field, point)[0], sum, 1e-12);
        }
    }
}

TEST(Blobs, AreEmptySpaceAwayFromAllBalls) {
    const auto field = sample_blobs(BlobKind::Wyvill);
    const std::array<double, 6> box{-5, -5, -5, 50, 50, 50};
    std::array<double, FieldRange::answers> range{};
    field->ranges(0, box.data(), range.data(), 1);
    EXPECT_EQ(range[0], 0);
    EXPECT_EQ(range[1], 0);
}

/// The value of a text's surface at a point, with a slider a = 1.
double value_of(const std::string& text, const Point& at) {
    const auto program = read_program(text);
    EXPECT_TRUE(program.has_value()) << text;
    const std::array<MpfrNumber, 4> point{MpfrNumber(at[0]), MpfrNumber(at[1]), MpfrNumber(at[2]),
                                          MpfrNumber(1.0)};
    return reference(program->surfaces.front(), point).value.nearest();
}

TEST(Blobs, WithSlidersAreTheSameFunction) {
    RandomNumbers random(26);
    for (const std::string word : {"blobs", "metaballs", "blinn"}) {
        for (int n = 0; n < 100; ++n) {
            const Point point = some_point(random);
            const double fixed =
                value_of(word + "([(0, 0, 0, 1), (1, -1, 0.5, 0.7), (1, 1, 1, -0.5)]) = 0", point);
            const double moved = value_of(
                word + "([(w - 1, 0, 0, 1), (w, -1, 0.5, 0.7), (1, w, 1, -w/2)]) = 0", point);
            EXPECT_NEAR(fixed, moved, 1e-13) << word;
        }
    }
}

TEST(BlobFile, IsReadInItsUsualForms) {
    const auto read = [](const std::string& text) { return blobs_of_text(text, 0.25).value(); };
    const std::vector<Blob> two{{.center = {1, 2, 3}, .radius = 0.25},
                                {.center = {-4.5, 5e-1, 6}, .radius = 0.25}};
    EXPECT_EQ(read("1 2 3\n-4.5 5e-1 6\n"), two);
    EXPECT_EQ(read("x,y,z\r\n1,2,3\r\n-4.5,0.5,6\r\n"), two);
    EXPECT_EQ(read("# points\n\n1;2;3\n// more\n-4.5\t+0.5\t6"), two);
    EXPECT_EQ(read("2\nwater, 300 K\nO 1 2 3\nH -4.5 0.5 6\n"), two);
    EXPECT_EQ(read("2\n\nO 1 2 3 -0.8\nH -4.5 0.5 6 0.4\n"), two);
    const std::vector<Blob> sized{{.center = {1, 2, 3}, .radius = 0.5},
                                  {.center = {0, 0, 0}, .radius = 2, .strength = -0.5},
                                  {.center = {0, 0, 0}, .radius = 3, .strength = -1}};
    EXPECT_EQ(read("x y z r s\n1 2 3 0.5\n0 0 0 2 -0.5\n0 0 0 -3\n"), sized);
}

TEST(BlobFile, SaysWhatIsWrong) {
    const auto reason = [](const std::string& text) {
        const auto blobs = blobs_of_text(text, 1);
        return blobs ? std::string() : blobs.error();
    };
    EXPECT_EQ(reason("1 2 3\n4 5\n"), "line 2 is not x y z, x y z r or x y z r strength");
    EXPECT_EQ(reason("1 2 3\n4 5 six\n"), "line 2 is not x y z, x y z r or x y z r strength");
    EXPECT_EQ(reason("1 2 3 0\n"), "line 1 is not x y z, x y z r or x y z r strength");
    EXPECT_EQ(reason("1 2 nan\n"), "line 1 is not x y z, x y z r or x y z r strength");
    EXPECT_EQ(reason("1 2 3 1 1 1\n"), "line 1 is not x y z, x y z r or x y z r strength");
    const std::string full =
        "line 5 has one ball more than the 2 that a list may have; split the file, and type the "
        "sum "
        "of both lists";
    const auto too_many = blobs_of_text("# three\n1 2 3\n0 0 0 1 0\n4 5 6\n7 8 9\n", 1, 2);
    ASSERT_FALSE(too_many.has_value());
    EXPECT_EQ(too_many.error(), full);
    EXPECT_EQ(blobs_of_text("1 2 3\n4 5 6\n", 1, 2).value().size(), 2U);
    EXPECT_EQ(reason(""), "it has no line x y z, x y z r or x y z r strength");
    EXPECT_EQ(reason("no numbers\n"), "it has no line x y z, x y z r or x y z r strength");
    const auto none = read_blobs("/no/such/file.xyz", 1);
    ASSERT_FALSE(none.has_value());
    EXPECT_EQ(none.error(), "it cannot be read");
}

}  // namespace
}  // namespace zeroset::test::blobs_test
