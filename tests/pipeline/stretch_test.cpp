#include "document/framing.hpp"
#include "engine/measure/probe.hpp"
#include "engine/render/render.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"
#include "pipeline/probe_document.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

// Pictures with a scale for each axis: what is typed a hundred times as high and drawn a hundredth
// as high is what is typed and drawn as it is, and numbers of it are the typed ones.

namespace zeroset::test::stretch_test {
namespace {

constexpr int side = 96;
constexpr glm::dvec3 flat(1.0, 1.0, 0.01);

Document document_of(const std::string& text, const Box& box) {
    Document document = read_document_text(text).document;
    document.clip = box;
    return document;
}

Document high(const std::string& text) {
    Document document = document_of(text, {.lo = {-1, -1, -100}, .hi = {1, 1, 100}});
    document.aspect = flat;
    return document;
}

PictureRequest request_of(const Document& document) {
    ReadDocument read = read_document(document);
    const auto prepared =
        prepare(read.document, std::move(*read.rows), Preparation::Interpreted).value();
    return picture_request(prepared.formula, prepared.colors, read.document, {}, {side, side});
}

Framebuffer picture_of(const PictureRequest& request) {
    const RenderRequest frame = render_request(request);
    Framebuffer picture(side, side);
    render_frame(frame.scene, frame.camera, frame.settings, picture);
    return picture;
}

void expect_alike(const Document& stretched, const Document& plain) {
    const Framebuffer a = picture_of(request_of(stretched));
    const Framebuffer b = picture_of(request_of(plain));
    int hits = 0;
    int differ = 0;
    for (std::size_t i = 0; i < a.depth.size(); ++i) {
        const bool same = std::isfinite(a.depth[i]) == std::isfinite(b.depth[i]);
        differ += same ? 0 : 1;
        if (!same || !std::isfinite(a.depth[i])) continue;
        ++hits;
        ASSERT_NEAR(a.depth[i], b.depth[i], 1e-5F * a.depth[i]);
        for (const unsigned shift : {0U, 8U, 16U})
            ASSERT_NEAR(a.color[i] >> shift & 0xFFU, b.color[i] >> shift & 0xFFU, 3) << i;
    }
    EXPECT_GT(hits, 500);
    EXPECT_LE(differ, 3);
}

TEST(Stretch, DrawsEquationsPointsAndSections) {
    const Box cube = Box::cube(1);
    const std::array pairs{
        std::array{"z = 70 (x^2 - y^2)", "z = 0.7 (x^2 - y^2)"},
        std::array{"(u, v, 50 u v), -1 < u < 1, -1 < v < 1",
                   "(u, v, 0.5 u v), -1 < u < 1, -1 < v < 1"},
        std::array{"x^2 + y^2 + (z/100)^2 < 0.8, z < 20", "x^2 + y^2 + z^2 < 0.8, z < 0.2"}};
    for (const auto& [typed, drawn] : pairs)
        expect_alike(high(typed), document_of(drawn, cube));
    Document cut = high("x^2 + y^2 + (z/100)^2 = 0.9");
    cut.region.sections = {make_section({0.0, 1.0, 0.01}, 0.3)};
    Document plain = document_of("x^2 + y^2 + z^2 = 0.9", cube);
    plain.region.sections = {make_section({0, 1, 1}, 0.3)};
    expect_alike(cut, plain);
}

TEST(Stretch, ColorsByTypedNumbers) {
    for (const auto& [by, expression] :
         {std::pair(ColorBy::Height, ""), std::pair(ColorBy::Expression, "x + z/100")}) {
        Document document = high("z = 70 (x^2 - y^2)");
        document.coloring.by = by;
        document.coloring.expression = expression;
        document.coloring.range = by == ColorBy::Height ? ValueRange{-60, 60} : ValueRange{-1, 1};
        document.coloring.lines.contours = Contours::Height;
        document.coloring.lines.step = 10.0;
        Document plain = document_of("z = 0.7 (x^2 - y^2)", Box::cube(1));
        plain.coloring = document.coloring;
        plain.coloring.lines.step = 0.1;
        if (by == ColorBy::Height) plain.coloring.range = ValueRange{-0.6, 0.6};
        if (by == ColorBy::Expression) plain.coloring.expression = "x + z";
        expect_alike(document, plain);
    }
}

TEST(Stretch, IsFoundForVeryUnequalBoxes) {
    Document document;
    document.clip = {.lo = {-1, -1, -9}, .hi = {1, 1, 9}};
    EXPECT_EQ(stretch_of(document), glm::dvec3(1.0));
    document.clip = {.lo = {-1, 0, 0}, .hi = {1, 1, 1000}};
    EXPECT_EQ(stretch_of(document), glm::dvec3(512, 1024, 1));
    document.aspect = flat;
    EXPECT_EQ(stretch_of(document), flat);
    document.region.ball = Ball{};
    EXPECT_EQ(stretch_of(document), glm::dvec3(1.0)) << "a ball is drawn as one";
}

TEST(Stretch, FramesACameraOfAnotherOne) {
    Document document;
    document.clip = {.lo = {-1, -1, -100}, .hi = {1, 1, 100}};
    document.aspect = flat;
    document.camera = default_camera(document.clip);
    const Camera camera = camera_of(document, 1.5);
    EXPECT_EQ(camera.stretch, flat);
    const Camera usual = default_camera(document.clip, 1.5, document.up, flat);
    EXPECT_LT(glm::distance(camera.eye, usual.eye), 1e-12);
    document.camera = camera;
    EXPECT_EQ(camera_of(document, 1.0), camera);
}

TEST(Stretch, ProbesTellTypedNumbers) {
    const PictureRequest request = request_of(high("z = 70 (x^2 - y^2)"));
    // Axes and markers over the picture are projected by its camera.
    EXPECT_EQ(render_request(request).camera.stretch, flat);
    const Framebuffer frame = picture_of(request);
    const auto formulas = typed_formulas(*request.formula->program, request.formula.get(), {0});
    const Uniforms uniforms = uniforms_of(request);
    int found = 0;
    for (int col = 20; col < 76; col += 8) {
        const auto facts = probe({.frame = frame,
                                  .camera = request.camera,
                                  .formulas = formulas,
                                  .uniforms = uniforms,
                                  .tolerance = 1e-3},
                                 col, side / 2);
        if (!facts) continue;
        ++found;
        const PointFacts typed = unstretched(*facts, request.camera.stretch);
        const glm::dvec3& p = typed.point;
        EXPECT_NEAR(p.z, 70 * (p.x * p.x - p.y * p.y), 1e-9);
        const glm::dvec3 normal = glm::normalize(glm::dvec3(-140 * p.x, 140 * p.y, 1.0));
        EXPECT_NEAR(std::abs(glm::dot(typed.normal, normal)), 1.0, 1e-9);
        const glm::dvec3 seen = ViewFrame(request.camera).homogeneous(p);
        EXPECT_NEAR(0.5 * side * (1.0 + seen.x / seen.z), col + 0.5, 1e-6);
    }
    EXPECT_GT(found, 3);
}

}  // namespace
}  // namespace zeroset::test::stretch_test
