#include "engine/image/framebuffer.hpp"
#include "engine/render/render.hpp"
#include "pipeline/mesh_document.hpp"
#include "pipeline/patch_surface.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"
#include "tests/support/picture_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

// Rows that are given by a point, from their text to pixels.

namespace zeroset::test::patches_test {
namespace {

Framebuffer picture(const PictureRequest& request, int side) {
    const RenderRequest frame = render_request(request);
    Framebuffer out(side, side);
    render_frame(frame.scene, frame.camera, frame.settings, out);
    return out;
}

/// A surface shows the same pixels at the same depths by an equation and by a point, but for those
/// at its edges.
void expect_alike(const std::string& equation, const std::string& point) {
    constexpr int side = 128;
    const Framebuffer a = picture(picture_of(equation), side);
    const Framebuffer b = picture(picture_of(point), side);
    int hits = 0;
    int differ = 0;
    for (std::size_t i = 0; i < a.depth.size(); ++i) {
        const bool same = std::isfinite(a.depth[i]) == std::isfinite(b.depth[i]);
        differ += same ? 0 : 1;
        if (!same || !std::isfinite(a.depth[i])) continue;
        ++hits;
        EXPECT_NEAR(a.depth[i], b.depth[i], 1e-5F * a.depth[i]);
    }
    EXPECT_GT(hits, 60) << point;
    EXPECT_LE(differ, 2) << point;
}

TEST(PatchPictures, AreThoseOfEquations) {
    expect_alike("x^2 + y^2 + z^2 = 1",
                 "(cos u cos v, cos u sin v, sin u), -pi/2 < u < pi/2, 0 < v < 2 pi");
    expect_alike("x sin z = y cos z, x cos z + y sin z > 0, x^2 + y^2 < 1, -1 < z < 1",
                 "(u cos v, u sin v, v), 0 < u < 1, -1 < v < 1");
    expect_alike("z = x^2 - y^2, -1 < x < 1, -1 < y < 1",
                 "(u, v, u^2 - v^2), -1 < u < 1, -1 < v < 1");
}

/// Where a surface has jumps, or edges without a slope, most of it is certified by its point all
/// the same, at the depths of its equation.
void expect_certified(const std::string& equation, const std::string& point, double least) {
    constexpr int side = 96;
    const Framebuffer a = picture(picture_of(equation), side);
    const Framebuffer b = picture(picture_of(point), side);
    int hits = 0;
    int certified = 0;
    for (std::size_t i = 0; i < a.depth.size(); ++i) {
        if (!std::isfinite(a.depth[i])) continue;
        ++hits;
        if (!is_proved(b.certificate[i]) || !std::isfinite(b.depth[i])) continue;
        ++certified;
        EXPECT_NEAR(a.depth[i], b.depth[i], 1e-5F * a.depth[i]);
    }
    EXPECT_GT(hits, 60) << point;
    EXPECT_GE(certified, least * hits) << point;
}

TEST(PatchPictures, AreCertifiedBesideJumpsAndEdges) {
    expect_certified("z = sin(3x)/(2x), -1 < x < 1, -1 < y < 1",
                     "(u, v, sin(3u)/(2u)), -1 < u < 1, -1 < v < 1", 0.97);
    expect_certified("x^4 + y^4 + z^4 = 1",
                     "(sgn(cos u) |cos u|^0.5 |cos v|^0.5, sgn(sin u) |sin u|^0.5 |cos v|^0.5, "
                     "sgn(sin v) |sin v|^0.5), 0 < u < 2 pi, -pi/2 < v < pi/2",
                     0.95);
    expect_certified("z = floor(x)/2, -1.5 < x < 1.5, -1 < y < 1",
                     "(u, v, floor(u)/2), -1.5 < u < 1.5, -1 < v < 1", 0.5);
}

TEST(PatchPictures, FollowParameters) {
    const std::string text =
        "(a cos u cos v, a cos u sin v, a sin u), -pi/2 < u < pi/2, 0 < v < 2 pi";
    PictureRequest request = picture_of(text);
    ASSERT_EQ(request.uniforms.size(), 2U);
    request.uniforms[1] = 0.5;
    const Framebuffer small = picture(request, 64);
    request.uniforms[1] = 1.0;
    const Framebuffer large = picture(request, 64);
    const auto hits = [](const Framebuffer& frame) {
        return std::count_if(frame.depth.begin(), frame.depth.end(),
                             [](float depth) { return std::isfinite(depth); });
    };
    EXPECT_GT(hits(large), 3 * hits(small));
}

/// A tube about a circle is a torus.
TEST(PatchPictures, ShowCurvesAsTubes) {
    const double radius = 0.006 * picture_of("(cos t, sin t, 0), 0 < t < 2 pi").clip.size();
    expect_alike("(sqrt(x^2 + y^2) - 1)^2 + z^2 = " + std::to_string(radius * radius),
                 "(cos t, sin t, 0), 0 < t < 2 pi");
}

TEST(PatchPictures, AreRefusedByWhatKnowsOnlyEquations) {
    const PictureRequest request = picture_of("(u, v, 0), 0 < u < 1, 0 < v < 1");
    const auto mesh = mesh_document(request, {});
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.error().reason.find("parametric"), std::string::npos);
}

}  // namespace
}  // namespace zeroset::test::patches_test
