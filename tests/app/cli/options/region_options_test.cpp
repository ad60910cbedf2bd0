#include "app/cli/options/view_options.hpp"
#include "pipeline/input_error.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

// Tests of --sphere, --section and --projection: their meaning, and that every wrong text is
// refused with a line that names the option.

namespace zeroset::test::region_options_test {
namespace {

constexpr glm::dvec3 eye{3, -5, 2};

OrInputError<Region> region_of(const std::vector<std::string>& sections) {
    ViewText view;
    view.sections = sections;
    return read_region(view, {}, eye);
}

Section section_of(const std::string& text) {
    const auto region = region_of({text});
    EXPECT_TRUE(region) << region.error().reason;
    return region && region->sections.size() == 1 ? region->sections[0] : Section{{0, 0, 0}, 0.0};
}

OrInputError<Region> ball_of(const std::string& text) {
    ViewText view;
    view.sphere = text;
    return read_region(view, {}, eye);
}

TEST(ReadSection, KeepsTheSideThatIsTyped) {
    EXPECT_EQ(section_of("x<0.3"), (Section{{1, 0, 0}, 0.3}));
    EXPECT_EQ(section_of(" y > -2 "), (Section{{0, -1, 0}, 2}));
    EXPECT_EQ(section_of("z<=1e-3"), (Section{{0, 0, 1}, 1e-3}));
    EXPECT_EQ(section_of("0,3,-4,10"), (Section{{0, 0.6, -0.8}, 2}));
}

TEST(ReadSection, KeepsTheSideAwayFromTheEye) {
    EXPECT_EQ(section_of("x=1"), (Section{{1, 0, 0}, 1}));
    EXPECT_EQ(section_of("x=4"), (Section{{-1, 0, 0}, -4}));
    EXPECT_EQ(section_of("y=0.5"), (Section{{0, -1, 0}, -0.5}));
}

TEST(ReadSection, TakesSeveralAndLeavesThemHollow) {
    ViewText view;
    view.sections = {"x<1", "y<2", "z<3"};
    view.hollow = true;
    const auto region = read_region(view, {}, eye);
    ASSERT_TRUE(region);
    ASSERT_EQ(region->sections.size(), 3U);
    EXPECT_EQ(region->sections[2], (Section{{0, 0, 1}, 3, false}));
}

TEST(ReadSection, RefusesWhatIsNoPlane) {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"u<1", "'u' is none of x, y and z"},
        {"x<", "not a finite number"},
        {"x<a", "'a' is not a finite number"},
        {"0.3", "type x<0.3"},
        {"1,2,3", "type x<0.3"},
        {"0,0,0,1", "must not be 0,0,0"},
        {"1,0,0,nan", "not a finite number"},
        {"x<1e10", "between -1e9 and 1e9"}};
    for (const auto& [text, reason] : wrong) {
        const auto region = region_of({text});
        ASSERT_FALSE(region) << text;
        EXPECT_NE(region.error().reason.find("--section"), std::string::npos);
        EXPECT_NE(region.error().reason.find(reason), std::string::npos) << region.error().reason;
        EXPECT_EQ(region.error().reason.find('\n'), std::string::npos);
    }
    EXPECT_FALSE(region_of(std::vector<std::string>(7, "x<1")));
    EXPECT_TRUE(region_of(std::vector<std::string>(6, "x<1")));
}

TEST(ReadSphere, IsAboutTheOriginOrAnyPoint) {
    EXPECT_EQ(ball_of("1.5")->ball, (Ball{{0, 0, 0}, 1.5}));
    EXPECT_EQ(ball_of("1,-2,3,0.25")->ball, (Ball{{1, -2, 3}, 0.25}));
    for (const char* text : {"0", "-1", "1,2,3", "1,2,3,0", "x", "1e10"}) {
        const auto region = ball_of(text);
        ASSERT_FALSE(region) << text;
        EXPECT_NE(region.error().reason.find("--sphere"), std::string::npos);
    }
}

TEST(ReadSurface, TakesTheProjectionAndTheRegion) {
    ViewText view;
    view.projection = "orthographic";
    view.sections = {"x=0"};
    const auto input = read_document("x^2 + y^2 + z^2 = 1", view);
    ASSERT_TRUE(input);
    ASSERT_TRUE(input->document.camera);
    EXPECT_EQ(input->document.camera->projection, Projection::Orthographic);
    EXPECT_EQ(input->document.region.sections, (std::vector{Section{{1, 0, 0}, 0}}));
    view.projection = "isometric";
    EXPECT_NE(read_document("x", view).error().reason.find("--projection isometric"),
              std::string::npos);
}

}  // namespace
}  // namespace zeroset::test::region_options_test
