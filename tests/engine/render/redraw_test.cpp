#include "engine/annotate/paint.hpp"
#include "engine/render/known_frame.hpp"
#include "engine/render/render.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

// A picture that is drawn where another one was shows nothing of that one.

namespace zeroset::test::redraw_test {
namespace {

constexpr int width = 205;
constexpr int height = 139;

struct Picture {
    std::string text;
    Antialias antialias;
};

void draw(const Picture& picture, Framebuffer& frame) {
    const Scene scene = scene_of(picture.text, Box::cube(1.5));
    TraceSettings settings;
    settings.antialias = picture.antialias;
    render_frame(scene, default_camera(scene.clip), settings, frame);
}

void expect_as_if_new(const Picture& picture, const Framebuffer& frame) {
    Framebuffer fresh(width, height);
    draw(picture, fresh);
    EXPECT_EQ(frame.color, fresh.color) << picture.text;
    EXPECT_EQ(frame.depth, fresh.depth) << picture.text;
    EXPECT_EQ(frame.certificate, fresh.certificate) << picture.text;
    EXPECT_EQ(frame.surface, fresh.surface) << picture.text;
}

TEST(Redraw, ShowsNothingOfThePicturesBefore) {
    Framebuffer frame(width, height);
    for (const Picture& picture : std::vector<Picture>{
             {"x^2 + y^2 + z^2 = 0.3", Antialias::None},
             {"x^2 + y^2 + z^2 = 1", Antialias::None},
             {"(x - 1)^2 + y^2 + z^2 = 0.1", Antialias::None},
             {"(x + 1)^2 + y^2 + z^2 = 0.1", Antialias::Beams},
             {"x^2 + y^2 + z^2 = 0.3", Antialias::None},
             {"x = 5", Antialias::None},
             {"1 / (x + y + z) = 0", Antialias::None},  // undecided where nothing is drawn
             {"x = 5", Antialias::None},
             {"floor(x) = 0.5", Antialias::None},
             {"x^2 + y^2 + z^2 = 0.3", Antialias::Beams},
             {"x = 5", Antialias::None}}) {
        draw(picture, frame);
        expect_as_if_new(picture, frame);
    }
}

TEST(Redraw, ShowsNothingOfWhatWasPaintedOver) {
    const Picture picture{"x^2 + y^2 + z^2 = 0.3", Antialias::None};
    Framebuffer frame(width, height);
    draw(picture, frame);
    paint_line(frame, {3.0, 5.0}, {200.0, 130.0}, 3.0, 0xFFFFFFFF);
    draw(picture, frame);
    expect_as_if_new(picture, frame);
}

TEST(Redraw, ShowsNothingOfAFrameThatWasDrawnFromItsDepths) {
    const Scene small = scene_of("x^2 + y^2 + z^2 = 0.3", Box::cube(1.5));
    const Scene large = scene_of("x^2 + y^2 + z^2 = 1.5", Box::cube(1.5));
    const Camera camera = default_camera(small.clip);
    Framebuffer other(width, height);
    render_frame(large, camera, {}, other);
    const KnownFrame known(large, camera, {}, other);
    Framebuffer frame(width, height);
    render_frame(small, camera, {}, frame);
    known.draw(frame);
    draw({"x^2 + y^2 + z^2 = 0.3", Antialias::None}, frame);
    expect_as_if_new({"x^2 + y^2 + z^2 = 0.3", Antialias::None}, frame);
}

}  // namespace
}  // namespace zeroset::test::redraw_test
