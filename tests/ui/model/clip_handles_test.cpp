#include "ui/model/clip_handles.hpp"

#include "engine/view/camera.hpp"
#include "engine/view/pixel_ray.hpp"
#include "ui/picture/clip_outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

// Tests of the places of the clip region's handles and of dragging them.

namespace zeroset::ui::clip_handles_test {
namespace {

constexpr int height_px = 800;
constexpr double stem = 0.1;

class ClipHandles : public testing::TestWithParam<Projection> {
protected:
    void SetUp() override {
        camera_.projection = GetParam();
        clipping_.region.ball = Ball{{0.5, 0, 0}, 1.25};
        clipping_.region.sections = {Section{{1, 0, 0}, 0.25, true},
                                     make_section({1, 2, 2}, 1.5, false)};
    }

    [[nodiscard]] ViewFrame view() const { return ViewFrame(camera_); }
    [[nodiscard]] std::vector<Handle> handles() const {
        return clip_handles(clipping_, view(), stem);
    }
    [[nodiscard]] Handle handle(HandlePart part, std::size_t index = 0) const {
        const auto all = handles();
        return *std::ranges::find(all, HandleId{part, index}, &Handle::id);
    }
    [[nodiscard]] ViewPoint place(const glm::dvec3& point) const {
        return place_in_view(view(), point)->place;
    }
    /// Grabs the handle slightly beside its middle and drags it to where `target` appears.
    [[nodiscard]] Clipping drag_to(const Handle& handle, const glm::dvec3& target,
                                   const DragKeys& keys = {}) const {
        const ViewShift beside{.x = 0.004, .y = -0.003};
        const HandleDrag drag = grabbed(handle, clipping_, view(), place(handle.at) + beside);
        return dragged(drag, view(), place(target) + beside, height_px, keys);
    }
    [[nodiscard]] double pixel() const { return view().pixel_at_look(height_px); }

    Clipping clipping_;
    Camera camera_ = default_camera(Box{});
};

TEST_P(ClipHandles, StandInTheMiddleOfWhatTheyMove) {
    EXPECT_EQ(handles().size(), 6U + 2U + 4U);
    EXPECT_EQ(handle(HandlePart::BoxFace, 0).at, glm::dvec3(-2, 0, 0));
    EXPECT_EQ(handle(HandlePart::BoxFace, 5).at, glm::dvec3(0, 0, 2));
    EXPECT_EQ(handle(HandlePart::BallCentre).at, glm::dvec3(0.5, 0, 0));
    EXPECT_NEAR(glm::distance(handle(HandlePart::BallRadius).at, glm::dvec3(0.5, 0, 0)), 1.25,
                1e-12);
    const Handle tip = handle(HandlePart::SectionTilt, 1);
    EXPECT_LT(glm::distance(tip.from, 0.5 / 3.0 * glm::dvec3(1, 2, 2)), 1e-12);
    EXPECT_NEAR(glm::distance(tip.at, tip.from), stem * 2.0 * view().homogeneous(tip.from).z,
                1e-12);
}

/// Faces and sections go where the pointer is, in typed numbers, where the picture is stretched.
TEST_P(ClipHandles, MoveInAStretchedPicture) {
    clipping_.region.ball.reset();
    clipping_.clip = {.lo = {-2, -2, -200}, .hi = {2, 2, 200}};
    clipping_.region.sections = {Section{{0, 0, 1}, 25.0, true}};
    camera_ = default_camera(clipping_.clip, 1.0, {0, 0, 1}, {1, 1, 0.01});
    camera_.projection = GetParam();
    const Clipping moved = drag_to(handle(HandlePart::BoxFace, 5), {0, 0, 120});
    EXPECT_NEAR(moved.clip.hi.z, 120, 100 * pixel());
    const Handle arrow = handle(HandlePart::SectionPlace);
    const Clipping cut = drag_to(arrow, arrow.at + glm::dvec3(0, 0, 40));
    EXPECT_NEAR(cut.region.sections[0].offset, 65, 100 * pixel());
    const Handle tip = handle(HandlePart::SectionTilt);
    EXPECT_NEAR(glm::length(camera_.stretch * (tip.at - tip.from)),
                stem * 2.0 * view().homogeneous(tip.from).z, 1e-12);
}

TEST_P(ClipHandles, MoveOneFaceAlongItsAxis) {
    for (std::size_t face = 0; face < 6; ++face) {
        const Handle grip = handle(HandlePart::BoxFace, face);
        const Clipping moved = drag_to(grip, 0.625 * grip.at);
        const int axis = static_cast<int>(face / 2);
        Clipping wanted = clipping_;
        (face % 2 == 1 ? wanted.clip.hi : wanted.clip.lo)[axis] *= 0.625;
        EXPECT_NEAR(moved.clip.lo[axis], wanted.clip.lo[axis], 0.5 * pixel());
        EXPECT_NEAR(moved.clip.hi[axis], wanted.clip.hi[axis], 0.5 * pixel());
        for (int other = 0; other < 3; ++other) {
            if (other == axis) continue;
            EXPECT_EQ(moved.clip.lo[other], wanted.clip.lo[other]);
            EXPECT_EQ(moved.clip.hi[other], wanted.clip.hi[other]);
        }
        EXPECT_EQ(moved.region, clipping_.region);
    }
}

TEST_P(ClipHandles, GiveNumbersAsFineAsPixels) {
    const Clipping moved = drag_to(handle(HandlePart::BoxFace, 1), {1.23456789, 0, 0});
    const double hi = moved.clip.hi.x;
    EXPECT_EQ(hi, std::round(hi * 1000) / 1000);
    EXPECT_NEAR(hi, 1.23456789, pixel());
}

TEST_P(ClipHandles, MoveTheOppositeFaceWithShiftAndAllWithCtrl) {
    clipping_.clip = {{-2, -1, 0}, {2, 1, 2}};
    const Handle face = handle(HandlePart::BoxFace, 5);
    const Clipping both = drag_to(face, {0, 0, 1.5}, {.shift = true});
    EXPECT_NEAR(both.clip.hi.z, 1.5, pixel());
    EXPECT_EQ(both.clip.lo.z, 2.0 - both.clip.hi.z);
    EXPECT_EQ(both.clip.lo.x, -2);
    const Clipping all = drag_to(face, {0, 0, 1.5}, {.ctrl = true});
    const double factor = both.clip.hi.z - 1.0;
    EXPECT_NEAR(all.clip.hi.z, both.clip.hi.z, 1e-12);
    EXPECT_NEAR(all.clip.lo.x, -2 * factor, 1e-12);
    EXPECT_NEAR(all.clip.hi.y, factor, 1e-12);
}

TEST_P(ClipHandles, KeepTheFacesInTheirOrder) {
    const Handle upper = handle(HandlePart::BoxFace, 1);
    EXPECT_EQ(drag_to(upper, {-3, 0, 0}).clip.hi.x, -2 + 0.004);
    EXPECT_EQ(drag_to(upper, {-3, 0, 0}, {.shift = true}).clip,
              (Box{{-0.002, -2, -2}, {0.002, 2, 2}}));
    EXPECT_EQ(drag_to(handle(HandlePart::BoxFace, 4), {0, 0, 3}).clip.lo.z, 2 - 0.004);
}

TEST_P(ClipHandles, MoveTheBallAcrossTheView) {
    const glm::dvec3 target = glm::dvec3(0.5, 0, 0) + 0.3 * view().right - 0.7 * view().up;
    const Ball ball = *drag_to(handle(HandlePart::BallCentre), target).region.ball;
    EXPECT_LT(glm::distance(ball.centre, target), pixel());
    EXPECT_EQ(ball.radius, 1.25);
}

TEST_P(ClipHandles, SizeTheBallAndNeverToNothing) {
    const Handle rim = handle(HandlePart::BallRadius);
    const glm::dvec3 centre(0.5, 0, 0);
    const Ball ball = *drag_to(rim, centre + 0.8 * view().up).region.ball;
    EXPECT_NEAR(ball.radius, 0.8, pixel());
    EXPECT_EQ(ball.centre, centre);
    EXPECT_GT(drag_to(rim, centre).region.ball->radius, 0.0);
}

TEST_P(ClipHandles, MoveASectionAlongItsNormal) {
    const Section before = clipping_.region.sections[1];
    const Handle arrow = handle(HandlePart::SectionPlace, 1);
    const Clipping moved = drag_to(arrow, arrow.at - 0.6 * before.normal);
    EXPECT_NEAR(moved.region.sections[1].offset, before.offset - 0.6, pixel());
    EXPECT_EQ(moved.region.sections[1].normal, before.normal);
    EXPECT_FALSE(moved.region.sections[1].cap);
    EXPECT_EQ(moved.region.sections[0], clipping_.region.sections[0]);
}

TEST_P(ClipHandles, TiltASectionAboutItsMiddle) {
    const Handle tip = handle(HandlePart::SectionTilt, 0);
    const double reach = glm::distance(tip.at, tip.from);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.8, -0.3, 0.2));
    const Clipping moved = drag_to(tip, tip.from + reach * normal);
    const Section& section = moved.region.sections[0];
    EXPECT_LT(glm::distance(section.normal, normal), 1e-9);
    EXPECT_NEAR(section.offset, glm::dot(normal, tip.from), pixel());

    std::vector<Handle> held = clip_handles(moved, view(), stem);
    hold(held, grabbed(tip, clipping_, view(), {}), moved);
    const auto now = *std::ranges::find(held, tip.id, &Handle::id);
    EXPECT_LT(glm::distance(now.at, tip.from + reach * normal), 1e-9) << "under the pointer";
}

TEST_P(ClipHandles, TiltToAxesNearbyAndToEvenDirectionsWithShift) {
    const Handle tip = handle(HandlePart::SectionTilt, 0);
    const auto to = [&](const glm::dvec3& direction) {
        return tip.from + glm::distance(tip.at, tip.from) * glm::normalize(direction);
    };
    const auto normal = [&](const glm::dvec3& direction, const DragKeys& keys) {
        return drag_to(tip, to(direction), keys).region.sections[0].normal;
    };
    EXPECT_EQ(normal({0.02, -1, 0.01}, {}), glm::dvec3(0, -1, 0));
    EXPECT_NE(normal({0.1, -1, 0.1}, {}), glm::dvec3(0, -1, 0));
    EXPECT_EQ(normal({0.8, -1, 0.1}, {.shift = true}), glm::normalize(glm::dvec3(1, -1, 0)));
}

TEST_P(ClipHandles, StayAtTheRimWhereThePointerIsBeyond) {
    const Handle tip = handle(HandlePart::SectionTilt, 0);
    const glm::dvec3 far = tip.from + 1.5 * glm::distance(tip.at, tip.from) * view().up;
    const glm::dvec3 normal = drag_to(tip, far).region.sections[0].normal;
    EXPECT_NEAR(glm::length(normal), 1.0, 1e-12);
    EXPECT_GT(glm::dot(normal, view().up), 0.98);
}

TEST_P(ClipHandles, AreLeftOutWhereTheirLineIsSeenEndOn) {
    camera_.eye = {10, 0, 0};
    std::vector<std::size_t> faces;
    for (const Handle& each : handles()) {
        if (each.id.part == HandlePart::BoxFace) faces.push_back(each.id.index);
    }
    EXPECT_EQ(faces, (std::vector<std::size_t>{2, 3, 4, 5}));
    EXPECT_EQ(std::ranges::count(handles(), HandleId{HandlePart::SectionPlace, 0}, &Handle::id), 0);
    EXPECT_EQ(std::ranges::count(handles(), HandleId{HandlePart::SectionTilt, 0}, &Handle::id), 1);
}

TEST_P(ClipHandles, AreFoundNearThePointer) {
    const auto all = handles();
    const Handle face = handle(HandlePart::BoxFace, 3);
    const ViewPoint at = place(face.at);
    EXPECT_EQ(handle_under(all, view(), at + ViewShift{.x = 0.005}, 0.01), face);
    EXPECT_EQ(handle_under(all, view(), at + ViewShift{.x = 0.02}, 0.01), std::nullopt);
    const Handle arrow = handle(HandlePart::SectionPlace, 1);
    EXPECT_EQ(handle_under(all, view(), place(0.5 * (arrow.from + arrow.at)), 0.01), arrow);
}

TEST_P(ClipHandles, ShowWhatTheyMove) {
    const auto face = outline_of({HandlePart::BoxFace, 1}, clipping_, view());
    ASSERT_EQ(face.size(), 4U);
    for (const glm::dvec3& corner : face)
        EXPECT_EQ(glm::abs(corner), glm::dvec3(2, 2, 2));
    const auto cut = outline_of({HandlePart::SectionPlace, 0}, clipping_, view());
    ASSERT_EQ(cut.size(), 4U);
    for (const glm::dvec3& corner : cut)
        EXPECT_EQ(corner.x, 0.25);
    clipping_.region.sections[0].offset = 5;
    EXPECT_TRUE(outline_of({HandlePart::SectionPlace, 0}, clipping_, view()).empty());
}

TEST_P(ClipHandles, SayWhatTheyAreAt) {
    const auto text = [&](HandlePart part, std::size_t index = 0) {
        return handle_text(handle(part, index), clipping_, view(), height_px);
    };
    EXPECT_EQ(text(HandlePart::BoxFace, 4), "z = -2");
    EXPECT_EQ(text(HandlePart::BallCentre), "(0.5, 0, 0)");
    EXPECT_EQ(text(HandlePart::BallRadius), "radius 1.25");
    EXPECT_EQ(text(HandlePart::SectionPlace), "x < 0.25");
    EXPECT_EQ(text(HandlePart::SectionPlace, 1), "distance 0.5");
    EXPECT_EQ(text(HandlePart::SectionTilt), "normal (1, 0, 0)");
}

TEST(ClipHandlesInPerspective, StayWhereThePointerIsBeyondTheHorizon) {
    // A line that leads away from the eye ends at a vanishing point of the picture.
    Camera camera;
    camera.eye = {-10, -1, 0};
    camera.look_at = {0, 0, 0};
    camera.fov_rad = 1.0;
    const ViewFrame view(camera);
    const Clipping clipping;
    const Handle face{{HandlePart::BoxFace, 1}, {2, 0, 0}, {2, 0, 0}, {1, 0, 0}};
    HandleDrag drag = grabbed(face, clipping, view, place_in_view(view, face.at)->place);
    drag.last.clip.hi.x = 7;
    EXPECT_EQ(dragged(drag, view, {3.5, 0.0}, height_px, {}).clip.hi.x, 7) << "as it was";
    EXPECT_EQ(dragged(drag, view, {-3.0, 0.0}, height_px, {}).clip.hi.x, -2 + 0.004);
}

INSTANTIATE_TEST_SUITE_P(Projections, ClipHandles,
                         testing::Values(Projection::Perspective, Projection::Orthographic),
                         [](const auto& each) {
                             return each.param == Projection::Perspective ? "perspective"
                                                                          : "orthographic";
                         });

}  // namespace
}  // namespace zeroset::ui::clip_handles_test
