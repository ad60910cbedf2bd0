// Tests of auto-framing a document.

#include "document/framing.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace zeroset::test::framing_test
