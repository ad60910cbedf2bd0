#include "ui/model/point_drag.hpp"

#include "engine/view/pixel_ray.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

// Tests of points that are dragged by their sliders.

namespace zeroset::ui::point_drag_test {
namespace {

constexpr int height_px = 800;

class PointDrags : public testing::TestWithParam<Projection> {
protected:
    void SetUp() override {
        camera_.projection = GetParam();
        document_.parameters["a"] = Slider{.value = 0.5, .lo = -2.0, .hi = 2.0};
        document_.parameters["b"] = Slider{.value = 0.25, .lo = -2.0, .hi = 2.0};
    }
    [[nodiscard]] ViewFrame view() const { return ViewFrame(camera_); }
    [[nodiscard]] ViewPoint place(const glm::dvec3& point) const {
        return place_in_view(view(), point)->place;
    }
    /// Grabs a point slightly beside its middle and drags it by a way in the plane of the picture.
    [[nodiscard]] Sliders drag(const ShownPoint& point, const glm::dvec2& way) const {
        const ViewShift beside{.x = 0.004, .y = -0.003};
        const PointDrag drag = grabbed(point, document_, view(), place(point.at) + beside);
        const glm::dvec3 to = point.at + way.x * view().right + way.y * view().up;
        return dragged(drag, view(), place(to) + beside, height_px);
    }
    [[nodiscard]] double pixel() const { return view().pixel_at_look(height_px); }

    Document document_ = empty_document();
    Camera camera_ = default_camera(Box{});
};

TEST_P(PointDrags, FollowThePointerInThePlaneOfThePicture) {
    const ShownPoint point{
        .row = 1, .name = "P", .at = {0.5, 0.25, 1.0}, .sliders = {"a", "b", ""}};
    const glm::dvec2 way(0.3, -0.2);
    const Sliders sliders = drag(point, way);
    const glm::dvec3 to = point.at + way.x * view().right + way.y * view().up;
    ASSERT_EQ(sliders.size(), 2U);
    EXPECT_NEAR(sliders.at("a").value, to.x, pixel());
    EXPECT_NEAR(sliders.at("b").value, to.y, pixel());
    EXPECT_EQ(document_.parameters["a"].value, 0.5) << "only take_over changes the document";
}

TEST_P(PointDrags, WidenTheSliderOrTakeItsSteps) {
    document_.parameters["a"].hi = 0.6;
    document_.parameters["b"].step = 0.5;
    const ShownPoint point{.row = 1, .name = "", .at = {0.5, 0.25, 0.0}, .sliders = {"a", "b", ""}};
    const glm::dvec2 way(1.0, 0.6);
    const glm::dvec3 to = point.at + way.x * view().right + way.y * view().up;
    const Sliders sliders = drag(point, way);
    const double wider = std::max(0.6, sliders.at("a").value);
    EXPECT_EQ(sliders.at("a").hi, wider);
    EXPECT_EQ(sliders.at("b").value, -2.0 + 0.5 * std::round((to.y + 2.0) / 0.5));
}

TEST_P(PointDrags, TakeTheMeanOfCoordinatesThatShareASlider) {
    const ShownPoint point{.row = 1, .name = "", .at = {0.5, 0.5, 0.5}, .sliders = {"a", "a", "w"}};
    const glm::dvec2 way(0.2, 0.4);
    const glm::dvec3 to = point.at + way.x * view().right + way.y * view().up;
    const Sliders sliders = drag(point, way);
    EXPECT_NEAR(sliders.at("a").value, 0.5 * (to.x + to.y), pixel());
    EXPECT_NEAR(sliders.at("w").value, to.z, pixel());
    take_over(document_, sliders);
    EXPECT_EQ(document_.w, sliders.at("w"));
    EXPECT_EQ(document_.parameters.at("a"), sliders.at("a"));
}

TEST_P(PointDrags, LeaveNoTraceOfSlidersAsTheyBegin) {
    document_.parameters.clear();
    const Document before = document_;
    Sliders moved =
        sliders_of(ShownPoint{.row = 1, .name = "P", .sliders = {"a", "", ""}}, document_);
    const Sliders first = moved;
    moved["a"].value = 2.0;
    take_over(document_, moved);
    EXPECT_EQ(document_.parameters.at("a").value, 2.0);
    take_over(document_, first);
    EXPECT_EQ(document_, before);
}

TEST_P(PointDrags, FindTheNearestPointThatMoves) {
    const std::vector<ShownPoint> points{
        {.row = 1, .name = "", .at = {0.0, 0.0, 0.0}, .sliders = {}},
        {.row = 2, .name = "", .at = {0.0, 0.0, 0.1}, .sliders = {"a", "", ""}},
        {.row = 3, .name = "", .at = {0.0, 0.0, 1.0}, .sliders = {"", "", "a"}}};
    const ShownPoint* const found = point_under(points, view(), place({0.0, 0.0, 0.0}), 0.05);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->row, 2);
    EXPECT_EQ(point_under(points, view(), place({1.5, 0.0, 0.0}), 0.05), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Projections, PointDrags,
                         testing::Values(Projection::Perspective, Projection::Orthographic));

}  // namespace
}  // namespace zeroset::ui::point_drag_test
