#include "engine/image/background.hpp"
#include "engine/image/blend.hpp"
#include "engine/image/gamma.hpp"
#include "engine/render/render.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

// Parts of an image, and its light beside its colours.

namespace zeroset::test::band_test {
namespace {

constexpr int width = 150;
constexpr int height = 170;

TraceSettings settings_with(Antialias antialias) {
    TraceSettings settings;
    settings.antialias = antialias;
    settings.shadows = true;
    return settings;
}

Framebuffer picture(const Scene& scene, Antialias antialias, const ImageBand& band, int rows) {
    Framebuffer frame(width, rows);
    frame.keep_planes(true);
    render_band(scene, default_camera(scene.clip), settings_with(antialias), band, frame);
    return frame;
}

TEST(Band, HasThePixelsOfTheWholeImage) {
    const Scene scene = scene_of("(x^2 + y^2 + z^2 + 0.5)^2 = 2.6*(x^2 + y^2)", Box::cube(1.5));
    for (const Antialias antialias : {Antialias::None, Antialias::Beams, Antialias::Rays4}) {
        const Framebuffer whole = picture(scene, antialias, {.row = 0, .height = height}, height);
        for (const int row : {0, 64, 128}) {
            const Framebuffer band = picture(scene, antialias, {.row = row, .height = height},
                                             std::min(64, height - row));
            const std::size_t first = whole.index(0, row);
            for (std::size_t i = 0; i < band.color.size(); ++i) {
                ASSERT_EQ(band.color[i], whole.color[first + i]) << row << ": " << i;
                ASSERT_EQ(band.depth[i], whole.depth[first + i]) << row << ": " << i;
                ASSERT_EQ(band.light[i], whole.light[first + i]) << row << ": " << i;
                ASSERT_EQ(band.normal[i], whole.normal[first + i]) << row << ": " << i;
                ASSERT_EQ(band.certificate[i], whole.certificate[first + i]);
            }
        }
    }
}

TEST(Band, LightIsTheColourBeforeItsRounding) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(1.2));
    for (const Antialias antialias : {Antialias::None, Antialias::Beams, Antialias::Rays4}) {
        const Framebuffer frame = picture(scene, antialias, {.row = 0, .height = height}, height);
        for (std::size_t i = 0; i < frame.color.size(); ++i) {
            // Mixed pixels are mixed with colours that were rounded before.
            const double allowed = antialias == Antialias::None ? 1.01 : 1.6;
            for (unsigned channel = 0; channel < 3; ++channel) {
                const double shown = frame.color[i] >> 8 * channel & 0xFFU;
                const float light = std::clamp(frame.light[i][channel], 0.0F, 1.0F);
                ASSERT_NEAR(255.0 * std::sqrt(static_cast<double>(light)), shown, allowed) << i;
            }
            if (is_partly_drawn(frame.color[i])) {
                ASSERT_NEAR(frame.light[i][3] * 255.0F, frame.color[i] >> 24U, 0.6) << i;
            }
        }
    }
}

TEST(Band, NormalsAreOfLengthOne) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(1.2));
    const Framebuffer frame = picture(scene, Antialias::None, {.row = 0, .height = height}, height);
    const ViewFrame view(default_camera(scene.clip));
    std::size_t hits = 0;
    for (int row = 0; row < height; ++row) {
        for (int col = 0; col < width; ++col) {
            const std::size_t at = frame.index(col, row);
            if (!std::isfinite(frame.depth[at])) {
                ASSERT_EQ(frame.normal[at], (std::array<float, 3>{}));
                continue;
            }
            ++hits;
            const glm::dvec3 point = view.point(pixel_centre(col, row), {width, height},
                                                static_cast<double>(frame.depth[at]));
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_NEAR(frame.normal[at][static_cast<std::size_t>(axis)], point[axis], 1e-3);
        }
    }
    EXPECT_GT(hits, 1000U);
}

}  // namespace
}  // namespace zeroset::test::band_test
