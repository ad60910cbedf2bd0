// Tests of saved views, and of cameras as a line of text.

#include "document/views.hpp"

#include "document/camera_text.hpp"
#include "engine/view/navigation.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace zeroset::test::views_test {
namespace {

const Camera some_camera{{5, -8, 4.5}, {0.1, 0, 1.0 / 3.0}, {0, 0, 1}, 0.733};

TEST(SavedViews, GetTheFirstFreeName) {
    std::vector<SavedView> views;
    EXPECT_EQ(add_view(views, some_camera), "View 1");
    EXPECT_EQ(add_view(views, some_camera), "View 2");
    views.erase(views.begin());
    EXPECT_EQ(add_view(views, some_camera), "View 1");
    EXPECT_EQ(view_names(views), "View 2, View 1");
    ASSERT_NE(find_view(views, "View 1"), nullptr);
    EXPECT_EQ(find_view(views, "View 1")->camera, some_camera);
    EXPECT_EQ(find_view(views, "view 1"), nullptr);
    views.resize(most_views, views.front());
    EXPECT_EQ(add_view(views, some_camera), "");
    EXPECT_EQ(views.size(), most_views);
}

TEST(SavedViews, TakeNamesThatAreALineAndNoOthers) {
    std::vector<SavedView> views{{"front", some_camera}, {"hole", some_camera}};
    EXPECT_TRUE(rename_view(views, 0, "  from the left\t"));
    EXPECT_EQ(views[0].name, "from the left");
    for (const std::string& name : {std::string(), std::string("  "), std::string("hole"),
                                    std::string("a\nb"), std::string(longest_view_name + 1, 'x')})
        EXPECT_FALSE(rename_view(views, 0, name)) << name;
    EXPECT_EQ(views[0].name, "from the left");
    EXPECT_STREQ(name_defect(" x"), "it has blanks at its ends");
    EXPECT_EQ(name_defect(std::string(longest_view_name, 'x')), nullptr);
}

void expect_near(const Camera& a, const Camera& b) {
    EXPECT_EQ(a.eye, b.eye);
    EXPECT_EQ(a.look_at, b.look_at);
    EXPECT_EQ(a.up, b.up);
    EXPECT_NEAR(a.fov_rad, b.fov_rad, 1e-14);
    EXPECT_EQ(a.projection, b.projection);
}

TEST(CameraText, IsReadAsItWasWritten) {
    EXPECT_EQ(camera_text({{1, 2, -3}, {0, 0, 0.5}, {0, 0, 1}, glm::radians(45.0)}),
              "eye 1,2,-3; look-at 0,0,0.5; up 0,0,1; fov 45");
    Camera parallel = some_camera;
    parallel.projection = Projection::Orthographic;
    EXPECT_TRUE(camera_text(parallel).contains("; height "));
    for (const Camera& camera : {some_camera, parallel}) {
        const auto read = read_camera_text(camera_text(camera), Camera());
        ASSERT_TRUE(read) << read.error();
        expect_near(*read, camera);
    }
}

TEST(CameraText, TakesWhatItLeavesOutFromAnother) {
    const auto read = read_camera_text(" eye=9, 0,+1 ", some_camera);
    ASSERT_TRUE(read) << read.error();
    Camera expected = some_camera;
    expected.eye = {9, 0, 1};
    expect_near(*read, expected);
    const auto parallel = read_camera_text("height 3; eye 0,-6,0; look-at 0,0,0", some_camera);
    ASSERT_TRUE(parallel) << parallel.error();
    EXPECT_EQ(parallel->projection, Projection::Orthographic);
    EXPECT_NEAR(shown_height(*parallel), 3.0, 1e-12);
    const auto perspective = read_camera_text("eye 0,-6,0; height 3; fov 42", some_camera);
    ASSERT_TRUE(perspective) << perspective.error();
    EXPECT_EQ(perspective->projection, Projection::Perspective);
    EXPECT_NEAR(glm::degrees(perspective->fov_rad), 42.0, 1e-12);
}

TEST(CameraText, SaysWhatIsWrong) {
    const std::vector<std::pair<const char*, const char*>> wrong{
        {"", "type eye X,Y,Z"},
        {"x^2 + y^2 = 1", "type eye X,Y,Z"},
        {"eye 1,2,3; nose 1,2,3", "type eye X,Y,Z"},
        {"eye 1,2,3;", "type eye X,Y,Z"},
        {"eye 1,2", "3 numbers separated by commas are needed, not 2"},
        {"eye 1,2,b", "'b' is not a finite number"},
        {"eye 1,2,inf", "'inf' is not a finite number"},
        {"eye 1,2,1e31", "stay between -1e30 and 1e30"},
        {"look-at 1,2,3", "it says no eye X,Y,Z"},
        {"eye 1,2,3; fov 180", "from 0.01 to 170"},
        {"eye 1,2,3; height 0", "above 0"},
        {"eye 1,2,3; look-at 1,2,3", "the eye is at the point looked at"},
        {"eye 0,0,3; look-at 0,0,0; up 0,0,1", "along the view"},
        {"eye 0,0,3; look-at 0,0,0; up 0,1,0; height 1e30", "below 180 degrees"}};
    for (const auto& [text, reason] : wrong) {
        const auto read = read_camera_text(text, some_camera);
        ASSERT_FALSE(read) << text;
        EXPECT_TRUE(read.error().contains(reason)) << text << ": " << read.error();
    }
}

TEST(CameraText, IsToldFromOtherTexts) {
    EXPECT_TRUE(looks_like_camera(camera_text(some_camera)));
    EXPECT_TRUE(looks_like_camera(" fov 3"));
    for (const char* text : {"", "eye", "front", "View 1", "eyes 1,2,3"})
        EXPECT_FALSE(looks_like_camera(text)) << text;
}

}  // namespace
}  // namespace zeroset::test::views_test
