// Tests of auto-framing a document.

#include "document/framing.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace zeroset::test::framing_test {
namespace {

Document document_with(double half) {
    Document document = empty_document();
    document.clip = Box::cube(half);
    return document;
}

TEST(Framing, KeepsAClipBoxThatFits) {
    const Box sphere = Box::cube(1.01);
    const Framing framing = frame_surfaces(document_with(2), {sphere, sphere, {}}, 1.5);
    EXPECT_TRUE(framing.found);
    EXPECT_EQ(framing.document.clip, Box::cube(2));
    EXPECT_EQ(framing.note, "framed the surface");
    const Camera expected = framed(default_camera(Box::cube(2), 1.5), sphere, 1.5);
    EXPECT_EQ(framing.document.camera, expected);
}

TEST(Framing, KeepsTheDirectionOfTheView) {
    Document document = document_with(2);
    document.camera = Camera{{0, -9, 0}, {0, 1, 0}, {0, 0, 1}, 0.5};
    const Box seen{{-1, -1, -1}, {1, 2, 1}};
    const Framing framing = frame_surfaces(document, {seen, seen, {}}, 1.0);
    const ViewFrame view(*framing.document.camera);
    EXPECT_LT(glm::distance(view.forward, glm::dvec3(0, 1, 0)), 1e-12);
    EXPECT_EQ(framing.document.camera->look_at, seen.centre());
    EXPECT_EQ(framing.document.camera->fov_rad, 0.5);
}

TEST(Framing, GrowsTheClipBoxAroundAllOfABoundedSurface) {
    const Framing framing =
        frame_surfaces(document_with(2), {Box::cube(30), Box::cube(2), {}}, 1.0);
    EXPECT_EQ(framing.document.clip, Box::cube(31));
    EXPECT_EQ(framing.note,
              "framed the whole surface: clip box \u00B1"
              "31");
}

TEST(Framing, ShrinksTheClipBoxToASmallSurface) {
    const Box small{{0.9, -0.1, 0.4}, {1.1, 0.1, 0.6}};
    const Framing framing = frame_surfaces(document_with(2), {small, small, {}}, 1.0);
    EXPECT_LT(glm::distance(framing.document.clip.centre(), small.centre()), 1e-12);
    EXPECT_NEAR(framing.document.clip.size(), 0.22, 1e-12);
}

TEST(Framing, LeavesAClipBoxThatMustStay) {
    const Framing framing =
        frame_surfaces(document_with(2), {Box::cube(30), Box::cube(2), {}}, 1.0, false);
    EXPECT_EQ(framing.document.clip, Box::cube(2));
    EXPECT_TRUE(framing.found);
}

TEST(Framing, ShowsWhatTheClipBoxHoldsOfAnUnboundedSurface) {
    const Box slab{{-2, -2, 0}, {2, 2, 0.1}};
    const Framing framing = frame_surfaces(document_with(2), {{}, slab, {}}, 1.0);
    EXPECT_EQ(framing.document.clip, Box::cube(2));
    EXPECT_EQ(framing.document.camera->look_at, slab.centre());
    EXPECT_EQ(framing.note, "framed what the clip box shows: the surface goes on");
}

TEST(Framing, GrowsAnEmptyClipBox) {
    const Framing framing = frame_surfaces(document_with(1), {{}, {}, Box::cube(8)}, 1.0);
    EXPECT_EQ(framing.document.clip, Box::cube(8));
    const Framing kept = frame_surfaces(document_with(1), {{}, {}, Box::cube(8)}, 1.0, false);
    EXPECT_FALSE(kept.found);
    EXPECT_EQ(kept.note, "the clip box holds nothing of the surface");
}

TEST(Framing, SaysThatThereIsNoSurface) {
    const Framing framing = frame_surfaces(document_with(1), {}, 1.0);
    EXPECT_FALSE(framing.found);
    EXPECT_EQ(framing.document, document_with(1));
    EXPECT_EQ(framing.note, "no surface: f vanishes nowhere near the clip box");
}

/// Whether all corners of the box are in the picture, at least `room` of its half height or width
/// within its edges.
bool is_in_view(const Camera& camera, const Box& box, double aspect, double room) {
    for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 point = box.lo;
        for (int i = 0; i < 3; ++i)
            if ((corner >> i & 1) != 0) point[i] = box.hi[i];
        const glm::dvec3 place = ViewFrame(camera).homogeneous(point);
        if (std::abs(place.x / place.z) > aspect * (1.0 - room)) return false;
        if (std::abs(place.y / place.z) > 1.0 - room) return false;
    }
    return true;
}

TEST(WholeView, HasTheDrawnBoxAndItsNumbersInPicturesOfAnyShape) {
    Document document = document_with(2);
    document.clip = {{-1, -3, 0}, {2, 3, 1}};
    const Camera camera{{9, -3, 2}, {1, 1, 0}, {0, 0, 1}, 0.7};
    for (const double aspect : {0.4, 1.0, 1.6, 3.0}) {
        document.axes = false;
        EXPECT_TRUE(is_in_view(whole_view(camera, document, aspect), document.clip, aspect, 0.0));
        document.axes = true;
        EXPECT_TRUE(is_in_view(whole_view(camera, document, aspect), document.clip, aspect, 0.1));
    }
}

TEST(Framing, LooksAtTheBoxWhereItIsDrawn) {
    const Box sphere = Box::cube(1.01);
    Document document = document_with(2);
    document.clip_box = true;
    const Framing framing = frame_surfaces(document, {sphere, sphere, {}}, 1.5);
    EXPECT_TRUE(is_in_view(*framing.document.camera, document.clip, 1.5, 0.0));
}

TEST(Framing, OfItselfFollowsABoundedSurfaceBeyondTheUsualBoxAndBack) {
    const Document usual = document_with(2);
    EXPECT_FALSE(frame_by_itself(usual, {Box::cube(1.5), Box::cube(1.5), {}}, 1.0));
    EXPECT_FALSE(frame_by_itself(usual, {{}, Box::cube(2), {}}, 1.0)) << "it goes on";
    const auto framing = frame_by_itself(usual, {Box::cube(5), Box::cube(2), {}}, 1.0);
    ASSERT_TRUE(framing);
    EXPECT_LT(glm::distance(framing->document.clip.hi, glm::dvec3(5.1)), 1e-12);
    EXPECT_FALSE(frame_by_itself(framing->document, {Box::cube(5), Box::cube(5), {}}, 1.0));
    const auto back = frame_by_itself(framing->document, {Box::cube(1), Box::cube(1), {}}, 1.0);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->document.clip, Box());
}

}  // namespace
}  // namespace zeroset::test::framing_test
