#include "engine/measure/wrong_pixels.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>

// Pixels unlike those that are proved, kind by kind.

namespace zeroset::test::wrong_pixels_test {
namespace {

constexpr float none = std::numeric_limits<float>::infinity();

struct Pixel {
    Certificate certificate;
    float depth;
};

WrongPixels judged(const Pixel& shown, const Pixel& proved) {
    Framebuffer frame(1, 1);
    Framebuffer truth(1, 1);
    frame.certificate[0] = shown.certificate;
    frame.depth[0] = shown.depth;
    truth.certificate[0] = proved.certificate;
    truth.depth[0] = proved.depth;
    const Camera camera{.eye = {0, -4, 0}, .look_at = {0, 0, 0}, .fov_rad = 0.5};
    return wrong_pixels(frame, truth, camera, 0.01);
}

void expect_counts(const WrongPixels& wrong, std::size_t missed, std::size_t added,
                   std::size_t moved, std::size_t refuted) {
    EXPECT_EQ(wrong.missed, missed);
    EXPECT_EQ(wrong.added, added);
    EXPECT_EQ(wrong.moved, moved);
    EXPECT_EQ(wrong.refuted, refuted);
}

constexpr Pixel root{Certificate::Certified, 3.0F};
constexpr Pixel empty{Certificate::Miss, none};
constexpr Pixel unknown{Certificate::Undecided, 3.0F};

TEST(WrongPixels, AreNoneInTheSamePicture) {
    expect_counts(judged(root, root), 0, 0, 0, 0);
    expect_counts(judged(empty, empty), 0, 0, 0, 0);
    expect_counts(judged({Certificate::Undecided, 3.009F}, root), 0, 0, 0, 0);
    expect_counts(judged({Certificate::Undecided, none}, empty), 0, 0, 0, 0);
}

TEST(WrongPixels, AreMissedAddedOrMoved) {
    expect_counts(judged({Certificate::Undecided, none}, root), 1, 0, 0, 0);
    expect_counts(judged({Certificate::Undecided, 3.0F}, empty), 0, 1, 0, 0);
    expect_counts(judged({Certificate::Undecided, 3.02F}, root), 0, 0, 1, 0);
    expect_counts(judged({Certificate::Undecided, 2.98F}, root), 0, 0, 1, 0);
}

TEST(WrongPixels, AreRefutedWhereTheyClaimToBeProved) {
    expect_counts(judged(empty, root), 1, 0, 0, 1);
    expect_counts(judged(root, empty), 0, 1, 0, 1);
    expect_counts(judged({Certificate::Certified, 3.5F}, root), 0, 0, 1, 1);
}

TEST(WrongPixels, CountOnlyWhereSomethingIsProved) {
    expect_counts(judged(empty, unknown), 0, 0, 0, 0);
    expect_counts(judged({Certificate::Certified, 9.0F}, unknown), 0, 0, 0, 0);
}

TEST(WrongPixels, AreMarkedInAPictureInGrey) {
    Framebuffer frame(5, 5);
    Framebuffer truth(5, 5);
    for (Framebuffer* const both : {&frame, &truth})
        both->color.assign(25, 0xFF306090U);
    const Camera camera{.eye = {0, -4, 0}, .look_at = {0, 0, 0}, .fov_rad = 0.5};
    truth.certificate[0] = Certificate::Certified;
    truth.depth[0] = 3.0F;
    const auto colors = difference_colors(frame, truth, camera, 0.01);
    EXPECT_EQ(colors[0], 0xFF3B3BF0U) << "missed: red";
    EXPECT_EQ(colors[6], colors[0]) << "so are its neighbours";
    EXPECT_EQ(colors[2], 0xFF303030U) << "half of the mean of the channels";
    const auto added = difference_colors(truth, frame, camera, 0.01);
    EXPECT_EQ(added[0], 0xFFE065B0U) << "violet";
    EXPECT_EQ(difference_colors(truth, truth, camera, 0.01)[0], 0xFF303030U);
}

}  // namespace
}  // namespace zeroset::test::wrong_pixels_test
