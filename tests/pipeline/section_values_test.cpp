#include "pipeline/section_values.hpp"

#include "engine/render/render.hpp"
#include "engine/view/pixel_ray.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

// Sections of typed surfaces show the colours of the function whose level they are.

namespace zeroset::test::section_values_test {
namespace {

Document document_of(const std::string& text) {
    Document document = read_document_text(text).document;
    document.clip = Box::cube(2);
    document.camera = Camera{{6, 0.5, 0.25}, {0, 0, 0}, {0, 0, 1}, 0.5, Projection::Orthographic};
    Section section = make_section({1, 0, 0}, 0.5);
    section.cap = false;
    section.values = true;
    document.region.sections = {section};
    return document;
}

PictureRequest request_of(const Document& document) {
    ReadDocument read = read_document(document);
    const auto prepared = prepare(document, std::move(*read.rows), Preparation::Interpreted);
    TraceSettings settings;
    settings.stop.value = 14;
    return picture_request(prepared->formula, prepared->colors, document, settings, {81, 81});
}

Framebuffer drawn(const PictureRequest& request) {
    const RenderRequest render = render_request(request);
    Framebuffer frame(render.width, render.height);
    render_frame(render.scene, render.camera, render.settings, frame);
    return frame;
}

/// The point of the section that a pixel shows.
glm::dvec3 point_at(const PictureRequest& request, int col, int row) {
    const ViewFrame view(request.camera);
    const PixelRay ray = pixel_ray(view, pixel_centre(col, row),
                                   {.width = request.size_px.x, .height = request.size_px.y});
    return ray.at((0.5 - ray.origin.x) / ray.direction.x);
}

TEST(SectionValues, AreTheColorsOfTheFunctionBesideTheConstant) {
    for (const char* const text : {"y + z/2 = 0.25", "0.25 = y + z/2", "y + z/2 = 0.25, x > -1"}) {
        Document document = document_of(text);
        document.section_values = {.map = ColorMap::Aurora, .range = ValueRange{-2, 2}};
        const PictureRequest request = request_of(document);
        const Framebuffer frame = drawn(request);
        int compared = 0;
        for (int row = 10; row < 71; row += 4) {
            for (int col = 10; col < 71; col += 4) {
                const glm::dvec3 at = point_at(request, col, row);
                const double value = at.y + 0.5 * at.z;
                if (std::abs(at.y) > 1.9 || std::abs(at.z) > 1.9) continue;
                if (std::abs(value - 0.25) < 0.2) continue;  // the surface's line
                const std::uint32_t wanted = shown_color_at(ColorMap::Aurora, (value + 2) / 4);
                const std::uint32_t seen = frame.color[frame.index(col, row)];
                for (unsigned shift = 0; shift < 24; shift += 8) {
                    EXPECT_NEAR(static_cast<int>(seen >> shift & 255U),
                                static_cast<int>(wanted >> shift & 255U), 2)
                        << text << " " << col << "," << row;
                }
                ++compared;
            }
        }
        EXPECT_GT(compared, 100) << text;
    }
}

TEST(SectionValues, HaveALineOfTheSurfacesColorWhereItIsCut) {
    Document document = document_of("y = 0.25");
    document.section_values.range = ValueRange{10, 11};  // all black
    const PictureRequest request = request_of(document);
    const Framebuffer frame = drawn(request);
    int lit = 0;
    for (int col = 10; col < 71; ++col) {
        const std::uint32_t seen = frame.color[frame.index(col, 40)];
        const bool is_lit = (seen & 255U) > 60 || (seen >> 8U & 255U) > 60;
        if (!is_lit) continue;
        EXPECT_NEAR(point_at(request, col, 40).y, 0.25, 0.12);
        ++lit;
    }
    EXPECT_GE(lit, 1);
    EXPECT_LE(lit, 3);
}

TEST(SectionValues, HaveARangeThatHoldsMostAndStaysWhileTheSectionMoves) {
    Document document = document_of("x + 3 y = a");
    const auto range_of = [&] { return scene_of(request_of(document)).section_values->range; };
    const ValueRange range = range_of();
    EXPECT_LT(range.lo, -4);
    EXPECT_GT(range.hi, 4);
    EXPECT_GE(range.lo, -8);
    EXPECT_LE(range.hi, 8);
    document.region.sections.front().offset = -1;
    EXPECT_EQ(range_of(), range);
}

TEST(SectionValues, AreNothingWhereNoSectionShowsThem) {
    Document document = document_of("x = 0");
    document.region.sections.front().values = false;
    EXPECT_FALSE(scene_of(request_of(document)).section_values);
}

}  // namespace
}  // namespace zeroset::test::section_values_test
