#include "app/desktop/extent_search.hpp"

#include "tests/support/picture_of.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>

// The search for how far surfaces reach, as the window follows it.

namespace zeroset::test::extent_search_test {
namespace {

constexpr auto patience = std::chrono::minutes(10);

bool comes_to_an_end(const ExtentSearch& search) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!search.done() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return search.done();
}

TEST(ExtentSearch, FindsHowFarTheSurfacesReach) {
    ExtentSearch search;
    EXPECT_FALSE(search.runs());
    EXPECT_FALSE(search.done());
    const PictureRequest picture = picture_of("x^2 + y^2 + z^2 = 1");
    search.start(picture);
    EXPECT_TRUE(search.runs());
    ASSERT_TRUE(comes_to_an_end(search));
    const std::optional<Extent> extent = search.take(picture);
    ASSERT_TRUE(extent && extent->whole);
    EXPECT_NEAR(extent->whole->hi.x, 1.0, 0.1);
    EXPECT_FALSE(search.runs());
}

TEST(ExtentSearch, DropsWhatBelongsToAnotherPicture) {
    const PictureRequest picture = picture_of("x^2 + y^2 + z^2 = 1");
    PictureRequest other = picture;
    other.clip = Box::cube(3);
    for (const auto& now : {std::optional(other), std::optional<PictureRequest>()}) {
        ExtentSearch search;
        search.start(picture);
        ASSERT_TRUE(comes_to_an_end(search));
        EXPECT_FALSE(search.take(now));
        EXPECT_FALSE(search.runs());
    }
}

TEST(ExtentSearch, KeepsWhatAnotherViewDoesNotChange) {
    const PictureRequest picture = picture_of("x^2 + y^2 + z^2 = 1");
    PictureRequest turned = picture;
    turned.camera.eye *= 2.0;
    ExtentSearch search;
    search.start(picture);
    ASSERT_TRUE(comes_to_an_end(search));
    EXPECT_TRUE(search.take(turned));
}

}  // namespace
}  // namespace zeroset::test::extent_search_test
