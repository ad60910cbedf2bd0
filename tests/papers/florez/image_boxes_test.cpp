#include "papers/florez/image_boxes.hpp"

#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "papers/florez/box_tally.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

// Boxes of an image by beams: each pixel is in one; what they say of rays holds on each of them.

namespace zeroset::test::image_boxes_test {
namespace {

/// The boxes of a picture of one tile.
struct TileBoxes {
    Scene scene;
    Camera camera;
    ImageSize image;
    Counters counters;
    std::vector<ImageBox> boxes;

    TileBoxes(const std::string& text, const ImageSize& size, const Camera* from = nullptr,
              BoxTests tests = BoxTests::RejectionAndInclusion)
        : scene(scene_of(text, Box::cube(2))),
          camera(from != nullptr ? *from : default_camera(scene.clip)),
          image(size) {
        const UpwardRounding upward;
        const TraceFrame frame =
            trace_frame(scene, scene.surfaces[0], ViewFrame(camera), image, StopCriterion());
        const Tile tile{.col = 0, .row = 0, .cols = image.width, .rows = image.height};
        const TileRays rays(frame, tile);
        ImageBoxes<float> finder;
        boxes = finder.find(frame, tile, rays, tests, counters);
        for (ImageBox& box : boxes) {  // as distances from the eye's plane
            box.from += rays.look_distance();
            box.to += rays.look_distance();
        }
    }
    [[nodiscard]] std::size_t count(ImageBox::Kind kind) const {
        return static_cast<std::size_t>(std::ranges::count(boxes, kind, &ImageBox::kind));
    }
    void expect_each_pixel_once() const {
        std::vector<int> times(static_cast<std::size_t>(image.width * image.height));
        for (const ImageBox& box : boxes) {
            for (int row = box.row; row < box.row + box.rows; ++row) {
                for (int col = box.col; col < box.col + box.cols; ++col)
                    ++times[static_cast<std::size_t>(row * image.width + col)];
            }
        }
        EXPECT_EQ(std::ranges::count(times, 1), image.width * image.height);
    }
};

/// A camera that the unit sphere fills most of the picture of.
const Camera near_camera{{2.2, -1.2, 0.8}, {0, 0, 0}, {0, 0, 1}, 1.1};

Camera parallel_camera() {
    Camera camera = default_camera(Box::cube(2));
    camera.projection = Projection::Orthographic;
    return camera;
}

/// The depth along the view axis at which a ray enters the unit sphere; NaN where it does not.
double sphere_depth(const TileBoxes& tile, int col, int row) {
    const Framebuffer frame(tile.image.width, tile.image.height);
    const Ray ray(tile.camera, tile.scene.clip, col, row, frame);
    const double middle = -glm::dot(ray.eye, ray.direction);
    const double square = 1.0 - glm::dot(ray.eye, ray.eye) + middle * middle;
    return (middle - std::sqrt(square)) * glm::dot(ray.direction, ViewFrame(tile.camera).forward);
}

TEST(ImageBoxes, SayOfEachRayOfASphereWhatIsSo) {
    const Camera parallel = parallel_camera();
    for (const Camera* const camera : {&near_camera, &parallel}) {
        for (const ImageSize& size : {ImageSize{64, 64}, ImageSize{37, 50}, ImageSize{1, 9}}) {
            const TileBoxes tile("x^2 + y^2 + z^2 = 1", size, camera);
            tile.expect_each_pixel_once();
            for (const ImageBox& box : tile.boxes) {
                for (int row = box.row; row < box.row + box.rows; ++row) {
                    for (int col = box.col; col < box.col + box.cols; ++col) {
                        const double depth = sphere_depth(tile, col, row);
                        if (box.kind == ImageBox::Kind::Rejected) {
                            EXPECT_TRUE(std::isnan(depth)) << col << "," << row;
                        } else if (box.kind == ImageBox::Kind::Included) {
                            EXPECT_LE(box.from, depth + 1e-9) << col << "," << row;
                            EXPECT_GE(box.to, depth - 1e-9) << col << "," << row;
                        }
                    }
                }
            }
        }
    }
}

TEST(ImageBoxes, RejectAndIncludeMostOfASphere) {
    const TileBoxes tile("x^2 + y^2 + z^2 = 1", {64, 64}, &near_camera);
    EXPECT_GT(tile.count(ImageBox::Kind::Rejected), 3U);
    EXPECT_GT(tile.count(ImageBox::Kind::Included), 3U);
    EXPECT_LT(tile.count(ImageBox::Kind::Undefined), 40U);
    EXPECT_GT(tile.counters.range, tile.boxes.size());
    for (const ImageBox& box : tile.boxes) {
        if (box.kind == ImageBox::Kind::Undefined) {
            EXPECT_LE(std::max(box.cols, box.rows), 8);
        }
    }
}

TEST(ImageBoxes, IncludeNothingByRejectionAlone) {
    const TileBoxes tile("x^2 + y^2 + z^2 = 1", {64, 64}, nullptr, BoxTests::Rejection);
    EXPECT_EQ(tile.count(ImageBox::Kind::Included), 0U);
    EXPECT_GT(tile.count(ImageBox::Kind::Rejected), 3U);
}

/// A pole changes the sign of f on each ray, and is no root.
TEST(ImageBoxes, IncludeNoPole) {
    const TileBoxes pole("1/(x + 0.1*y + 0.01*z)", {64, 64});
    EXPECT_EQ(pole.count(ImageBox::Kind::Included), 0U);
    const TileBoxes jump("floor(x) + 0.5", {64, 64});
    EXPECT_EQ(jump.count(ImageBox::Kind::Included), 0U);
}

/// A root that the region cuts away is none.
TEST(ImageBoxes, IncludeOnlyRootsThatAreShown) {
    const TileBoxes tile("x = 5", {32, 32});
    EXPECT_EQ(tile.count(ImageBox::Kind::Rejected), tile.boxes.size());
    const TileBoxes far("(x + 2.5) (x - 2.5)", {32, 32});
    EXPECT_EQ(far.count(ImageBox::Kind::Rejected), far.boxes.size());
}

TEST(FlorezBoxes, CountTheirBoxes) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    for (const std::string tracer : {"florez-boxes", "florez-trimming"}) {
        SCOPED_TRACE(tracer);
        Framebuffer frame(100, 90);
        render_frame(scene, near_camera, settings_at(tracer, 20), frame);
        const auto tally = scene.surfaces[0].kernel.memory->of<BoxTally>();
        const ImageBoxCounters boxes = tally->take();
        EXPECT_EQ(tally->take().rejected.boxes, 0U);
        EXPECT_EQ(boxes.rejected.pixels + boxes.included.pixels + boxes.undefined.pixels, 9000U);
        const CertificateCounts counts = count_certificates(frame);
        EXPECT_LE(boxes.rejected.pixels, counts.miss);
        EXPECT_LE(boxes.included.pixels, counts.certified);
        EXPECT_GT(2 * boxes.rejected.pixels, counts.miss);
        EXPECT_EQ(tracer == "florez-boxes", 3 * boxes.included.pixels > counts.certified);
        EXPECT_GT(boxes.ms, 0.0);
        EXPECT_GT(boxes.undefined.ms, 0.0);
    }
}

}  // namespace
}  // namespace zeroset::test::image_boxes_test
