#include "engine/kernel/surface_facts.hpp"
#include "engine/render/render.hpp"
#include "tests/support/alike_frames.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

// Functions that leave the range of floats, or of doubles, jump where they are 0, or are 0 in a
// wall of the clip box: their pictures are those of plain functions with the same zeros.

namespace zeroset::test::extreme_values_test {
namespace {

struct Lights {
    Antialias antialias = Antialias::None;
    bool shadows = false;
};
std::ostream& operator<<(std::ostream& out, const Lights& lights) {
    return out << (lights.antialias == Antialias::Beams ? "smooth" : "plain")
               << (lights.shadows ? ", with shadows" : "");
}
const std::vector<Lights> all_lights{
    {}, {.antialias = Antialias::Beams}, {.shadows = true}, {Antialias::Beams, true}};

void set_defined_everywhere(Kernel& kernel, bool is) {
    kernel.facts = std::make_shared<const SurfaceFacts>(SurfaceFacts{.defined_everywhere = is});
}

Framebuffer picture_of(const std::string& text, double half, const Lights& lights) {
    Scene scene = scene_of(text, Box::cube(half));
    // Whether f is defined everywhere, as the program finds it for these formulas.
    set_defined_everywhere(scene.surfaces.front().kernel, text.starts_with("sign"));
    Framebuffer frame(96, 96);
    TraceSettings settings;
    settings.antialias = lights.antialias;
    settings.shadows = lights.shadows;
    render_frame(scene, default_camera(scene.clip), settings, frame);
    return frame;
}

/// Expects the picture of one text to be that of another but for so many pixels.
void expect_same_pictures(const std::string& text, const std::string& plain, double half,
                          std::size_t most = 0) {
    for (const Lights& lights : all_lights) {
        SCOPED_TRACE(testing::Message() << text << ", " << lights);
        const Framebuffer expected = picture_of(plain, half, lights);
        EXPECT_LE(different_pixels(picture_of(text, half, lights), expected, 16), most);
    }
}

const std::string ball = "x^2 + y^2 + z^2 = 1";

TEST(ExtremeValues, OfAnySizeShowTheSame) {
    for (const std::string factor :
         {"1e20", "1e37", "2e38", "1e40", "1e140", "1e-20", "1e-40", "1e-140"}) {
        expect_same_pictures(factor + " (x^2 + y^2 + z^2 - 1) = 0", ball, 1.5);
    }
}

TEST(ExtremeValues, BeyondFloatsAndDoublesCastNoShadowsAndLeaveNoDebris) {
    // 12^50 is beyond floats; exp(2700) is beyond doubles.
    expect_same_pictures("(x^2 + y^2 + z^2)^50 = 1", ball, 2.0, 10);
    expect_same_pictures("exp(x^2 + y^2 + z^2) = exp(400)", "x^2 + y^2 + z^2 = 400", 30.0, 40);
    expect_same_pictures("cosh(50 (x^2 + y^2 + z^2)) = cosh(50)", ball, 2.0, 10);
    expect_same_pictures("exp(150 (x^2 + y^2 + z^2)) = exp(150)", ball, 1.5, 10);
    expect_same_pictures("x^200 + y^200 + z^200 = 1", "max(abs(x), abs(y), abs(z)) = 1", 2.0, 300);
}

TEST(ExtremeValues, AreZeroInAWallOfTheBox) {
    for (const std::string wall :
         {"y = -2", "y = 2", "x^2 = 4", "y = -1.99999999", "y = -1.9999998"}) {
        SCOPED_TRACE(wall);
        const Framebuffer one_ray = picture_of(wall, 2.0, {});
        const Framebuffer smooth = picture_of(wall, 2.0, {.antialias = Antialias::Beams});
        // Only pixels at borders are others.
        EXPECT_LT(different_pixels(smooth, one_ray, 16), 450U);
    }
}

TEST(ExtremeValues, LeaveNoHolesAtWalls) {
    // Small parts are cut by walls; between the ends of a stretch f comes to 0 and goes away again.
    for (const std::string text :
         {"sin(15 x) sin(15 y) sin(15 z) = 0.2", "sin(20 x) + sin(20 y) + sin(20 z) = 0"}) {
        SCOPED_TRACE(text);
        const Scene scene = scene_of(text, Box::cube(2.0));
        Framebuffer one_ray(200, 150);
        render_frame(scene, default_camera(scene.clip), {}, one_ray);
        Framebuffer smooth(200, 150);
        TraceSettings settings;
        settings.antialias = Antialias::Beams;
        render_frame(scene, default_camera(scene.clip), settings, smooth);
        const auto is_hit_around = [&](int col, int row) {
            for (int i = 0; i < 9; ++i) {
                const std::size_t at = one_ray.index(col + i % 3 - 1, row + i / 3 - 1);
                if (one_ray.surface[at] == no_surface) return false;
            }
            return true;
        };
        for (int row = 1; row + 1 < smooth.height; ++row) {
            for (int col = 1; col + 1 < smooth.width; ++col) {
                const std::uint32_t alpha = smooth.color[smooth.index(col, row)] >> 24U;
                if (is_hit_around(col, row)) {
                    EXPECT_GT(alpha, 100U) << col << ", " << row;
                }
            }
        }
    }
}

TEST(ExtremeValues, EndWhereFEnds) {
    // Searches of edges once stayed where f ends.
    expect_same_pictures("x^2 + y^2 + z^2 = 1 + 0 sqrt(0.5 - z)",
                         "if(z < 0.5, x^2 + y^2 + z^2 - 1, 1) = 0", 1.5, 40);
    const Framebuffer smooth = picture_of("floor(x) = y", 1.9, {.antialias = Antialias::Beams});
    const Framebuffer one_ray = picture_of("floor(x) = y", 1.9, {});
    EXPECT_LT(different_pixels(smooth, one_ray, 60), 150U);
    EXPECT_GT(different_pixels(smooth, Framebuffer(96, 96), 60), 1000U);
}

TEST(ExtremeValues, CloseWhereASignTimesARootIsZero) {
    expect_same_pictures(
        "sign(x^2 + y^2 + z^2 - 1) sqrt(min((sqrt(x^2 + y^2 + z^2) - 1)^2, 4)) = 0", ball, 1.5, 8);
    // A jump that keeps a height shows nothing.
    for (const std::string text : {"sign(x) (1 + y^2) = 0", "sign(x) (abs(x)^0.5 + 0.01) = 0",
                                   "sign(x) (0.001 + abs(x)) = 0"}) {
        Scene jump = scene_of(text, Box::cube(1.5));
        set_defined_everywhere(jump.surfaces.front().kernel, true);
        Framebuffer frame(48, 48);
        render_frame(jump, default_camera(jump.clip), {}, frame);
        EXPECT_TRUE(std::ranges::all_of(frame.surface, [](auto of) { return of == no_surface; }))
            << text;
    }
}

}  // namespace
}  // namespace zeroset::test::extreme_values_test
