#include "engine/image/framebuffer.hpp"
#include "engine/render/render.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/view/pixel_ray.hpp"
#include "pipeline/mesh_document.hpp"
#include "pipeline/patch_surface.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"
#include "pipeline/shown_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

// Things made of points, thickness and boxes of rows, from their text to pixels.

namespace zeroset::test::things_test {
namespace {

constexpr int side = 128;

/// A text with what single rows have beside it, as a picture.
class Drawn {
public:
    explicit Drawn(
        const std::string& text, const std::function<void(Document&)>& change = [](Document&) {}) {
        document = read_document_text(text).document;
        change(document);
        auto rows = read_rows(document);
        EXPECT_TRUE(rows) << text << ": " << rows.error().reason;
        const auto prepared = prepare(document, std::move(*rows), Preparation::Interpreted);
        EXPECT_TRUE(prepared);
        request = picture_request(prepared->formula, prepared->colors, document, {}, {side, side});
        const RenderRequest all = render_request(request);
        render_frame(all.scene, all.camera, all.settings, frame);
    }

    [[nodiscard]] int hits() const {
        int count = 0;
        for (const float depth : frame.depth)
            count += std::isfinite(depth) ? 1 : 0;
        return count;
    }
    [[nodiscard]] int undecided() const {
        int count = 0;
        for (const Certificate certificate : frame.certificate)
            count += certificate == Certificate::Undecided ? 1 : 0;
        return count;
    }

    Document document;
    PictureRequest request;
    Framebuffer frame{side, side};
};

/// Both show the same pixels at the same depths, but for some at edges.
void expect_alike(const Drawn& a, const Drawn& b, int edges = 4, int least = 60) {
    int hits = 0;
    int differ = 0;
    for (std::size_t i = 0; i < a.frame.depth.size(); ++i) {
        const bool same = std::isfinite(a.frame.depth[i]) == std::isfinite(b.frame.depth[i]);
        differ += same ? 0 : 1;
        if (!same || !std::isfinite(a.frame.depth[i])) continue;
        ++hits;
        EXPECT_NEAR(a.frame.depth[i], b.frame.depth[i], 1e-5F * a.frame.depth[i]);
    }
    EXPECT_GT(hits, least);
    EXPECT_LE(differ, edges);
}

void set_thickness(Document& document, double width, bool in_pixels = false) {
    for (Statement& row : document.statements)
        row.thickness = Thickness{.width = width, .in_pixels = in_pixels};
}

TEST(ThingPictures, SegmentsAreClosedCylinders) {
    const Drawn segment("segment((-1, 0, 0.5), (1, 0, 0.5))",
                        [](Document& document) { set_thickness(document, 0.4); });
    const Drawn solid("max(y^2 + (z - 0.5)^2 - 0.04, abs(x) - 1) = 0");
    expect_alike(segment, solid);
    EXPECT_LE(segment.undecided(), 4);
}

TEST(ThingPictures, VectorsHaveACone) {
    // The head takes nine radii, and has three of them at its base.
    const Drawn vector("vector((0, 0, -1), (0, 0, 2))",
                       [](Document& document) { set_thickness(document, 0.2); });
    const Drawn solid(
        "min(max(sqrt(x^2 + y^2) - 0.1, abs(z + 0.45) - 0.55), "
        "max(sqrt(x^2 + y^2) - (1 - z)/3, 0.1 - z)) = 0");
    expect_alike(vector, solid);
    EXPECT_LE(vector.undecided(), 8);
}

TEST(ThingPictures, ShortVectorsAreHeadsByHalf) {
    const Drawn vector("vector((0.3, 0, 0), (0.8, 0, 0))",
                       [](Document& document) { set_thickness(document, 1.0); });
    const Drawn solid(
        "min(max(sqrt(y^2 + z^2) - 0.8/18, abs(x - 0.5) - 0.2), "
        "max(sqrt(y^2 + z^2) - (1.1 - x)/3, 0.7 - x)) = 0");
    expect_alike(vector, solid, 4, 25);
}

TEST(ThingPictures, PolygonsAreCutOutOfPlanes) {
    const Drawn polygon("polygon((-1, -1, 0), (1, -1, 0), (1, 1, 1), (-1, 1, 1))");
    const Drawn restricted("y = 2 z - 1, -1 < x < 1, -1 < y < 1");
    expect_alike(polygon, restricted);
    EXPECT_LE(polygon.undecided(), 4);
}

TEST(ThingPictures, PolygonsAreNotFilledBySections) {
    const std::string text = "polygon((-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0))";
    const auto cut = [](Document& document) {
        document.region.sections = {make_section({1.0, 0.0, 0.0}, 0.25)};
    };
    const Drawn half(text, cut);
    expect_alike(half, Drawn("z = 0, -1 < x < 0.25, -1 < y < 1"));
}

TEST(ThingMeshes, PolygonsAreSheets) {
    const Drawn drawn("polygon((-1, -1, 0), (1, -1, 0), (1, 1, 1), (-1, 1, 1))");
    const auto meshes = mesh_document(drawn.request, {.tolerance = 0.02});
    ASSERT_TRUE(meshes);
    ASSERT_EQ(meshes->surfaces.size(), 1U);
    EXPECT_GT(meshes->surfaces[0].facts.open_edges, 0U);
    const TriangleMesh& mesh = meshes->file.objects.at(0).mesh;
    double area = 0.0;
    for (const auto& triangle : mesh.triangles) {
        const auto corner = [&](std::size_t i) { return mesh.vertices[triangle[i]].point; };
        area += 0.5 * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
    EXPECT_NEAR(area, 2.0 * std::sqrt(5.0), 0.05);
}

TEST(Thicknesses, InUnitsAreWidths) {
    expect_alike(Drawn("(cos t, sin t, 0), 0 < t < 2 pi",
                       [](Document& document) { set_thickness(document, 0.3); }),
                 Drawn("(sqrt(x^2 + y^2) - 1)^2 + z^2 = 0.15^2"));
    expect_alike(Drawn("(0.5, 0, 0.25)", [](Document& document) { set_thickness(document, 0.6); }),
                 Drawn("(x - 0.5)^2 + y^2 + (z - 0.25)^2 = 0.09"));
    // Where a plane meets another one, the tube is exact.
    expect_alike(Drawn("x = 0 and z = 0", [](Document& document) { set_thickness(document, 0.3); }),
                 Drawn("x^2 + z^2 = 0.15^2"));
}

/// The widest row of hits of a frame around an image row.
int width_at(const Framebuffer& frame, int row) {
    int width = 0;
    for (int col = 0; col < frame.width; ++col)
        width += std::isfinite(frame.depth[frame.index(col, row)]) ? 1 : 0;
    return width;
}

TEST(Thicknesses, InPixelsAreAsWideNearAndFar) {
    // A line that leads away from the eye, seen from above it, in perspective.
    const auto look = [](Document& document) {
        set_thickness(document, 12.0, true);
        document.camera = Camera{.eye = {0.0, -6.0, 1.5},
                                 .look_at = {0.0, 0.0, 0.0},
                                 .up = {0.0, 0.0, 1.0},
                                 .fov_rad = 0.7};
    };
    for (const char* const text :
         {"segment((0, -2, 0), (0, 2, 0))", "(0, t, 0), -2 < t < 2", "x = 0 and z = 0"}) {
        const Drawn drawn(text, look);
        const ViewFrame view(*drawn.document.camera);
        for (const double y : {-1.5, 0.0, 1.5}) {
            const auto seen = place_in_view(view, {0.0, y, 0.0});
            ASSERT_TRUE(seen);
            const int row = static_cast<int>((0.5 - seen->place.y) * side);
            EXPECT_NEAR(width_at(drawn.frame, row), 12, 1) << text << " at y = " << y;
        }
    }
}

TEST(Thicknesses, InPixelsArePixelsOfParallelRays) {
    const Drawn drawn("segment((0, 0, -1), (0, 0, 1))", [](Document& document) {
        set_thickness(document, 9.0, true);
        document.camera = Camera{.eye = {0.0, -6.0, 0.0},
                                 .look_at = {0.0, 0.0, 0.0},
                                 .up = {0.0, 0.0, 1.0},
                                 .fov_rad = 0.7,
                                 .projection = Projection::Orthographic};
    });
    EXPECT_NEAR(width_at(drawn.frame, side / 2), 9, 1);
}

TEST(Thicknesses, OfOneRowLeaveTheOthersAlone) {
    const Drawn both("(1, 0, 0)\n(-1, 0, 0)", [](Document& document) {
        document.statements.at(0).thickness = Thickness{.width = 0.8};
    });
    const std::vector<double> uniforms = uniform_values(both.request);
    ASSERT_EQ(uniforms.size(), 1U + 2 * thickness_uniforms);
    EXPECT_EQ(uniforms[1], 0.4);
    EXPECT_NEAR(uniforms[1 + thickness_uniforms], 0.012 * 4.0, 1e-12);
}

/// The tree of a surface in a scene.
std::shared_ptr<const PatchTree> tree_in(const Scene& scene, std::size_t surface) {
    return patch_tree(scene.surfaces.at(surface).kernel, scene.uniforms);
}

/// Expects that of two surfaces this one alone has another tree when the picture changes.
void expect_new_tree_only_of(std::size_t surface, const PictureRequest& first,
                             const PictureRequest& moved) {
    const Scene before = scene_of(first);
    const auto changed = tree_in(before, surface);
    const auto kept = tree_in(before, 1 - surface);
    const Scene after = scene_of(moved);
    EXPECT_NE(tree_in(after, surface), changed);
    EXPECT_EQ(tree_in(after, 1 - surface), kept);
}

TEST(Thicknesses, InPixelsLeaveTheTreesOfOthersAloneWhenTheViewMoves) {
    const Drawn drawn(
        "(cos t, sin t, 0), 0 < t < 6\n(u, v, 0), 0 < u < 1, 0 < v < 1", [](Document& document) {
            document.statements.at(0).thickness = Thickness{.width = 3.0, .in_pixels = true};
        });
    PictureRequest moved = drawn.request;
    moved.camera.eye *= 1.25;
    expect_new_tree_only_of(0, drawn.request, moved);
}

TEST(PatchTrees, StayWhileParametersOfOthersMove) {
    const Drawn drawn("(a cos t, a sin t, 0), 0 < t < 6\n(u, v, b), 0 < u < 1, 0 < v < 1");
    const auto& names = drawn.request.formula->program->parameters;
    const auto place = std::ranges::find(names, "b") - names.begin();
    PictureRequest moved = drawn.request;
    moved.uniforms.at(static_cast<std::size_t>(1 + place)) += 0.25;
    expect_new_tree_only_of(1, drawn.request, moved);
}

const Box half_box{.lo = {-0.5, -1.0, -0.25}, .hi = {0.75, 0.5, 1.0}};

void cut_rows(Document& document) {
    for (Statement& row : document.statements)
        row.box = half_box;
}

TEST(RowBoxPictures, AreThoseOfTheClipBox) {
    for (const char* const text :
         {"x^2 + y^2 + z^2 = 1",
          "(cos u cos v, cos u sin v, sin u), -pi/2 < u < pi/2, 0 < v < 2 pi", "z > x^2 + y^2"}) {
        const Drawn own(text, cut_rows);
        const Drawn whole(text, [&](Document& document) {
            document.camera = default_camera(document.clip, 1.0);
            document.clip = half_box;
        });
        expect_alike(own, whole, 12);
        EXPECT_LT(own.hits(), Drawn(text).hits());
        EXPECT_LE(own.undecided(), whole.undecided() + 12) << text;
    }
}

TEST(RowBoxPictures, LeaveOtherRowsAlone) {
    const std::string squares = "(u, v, 1), -1 < u < 1, -1 < v < 1";
    const Drawn drawn("x^2 + y^2 + (z + 1.5)^2 = 0.01\n" + squares,
                      [](Document& document) { document.statements.at(0).box = half_box; });
    expect_alike(drawn, Drawn(squares), 0);
}

TEST(ShownPoints, AreWhereTheSlidersTakeThem) {
    const Drawn drawn("P = (1, b, a)\n(0.5, w, 2a)\nQ = (9, 0, 0)\nz = x", [](Document& document) {
        document.parameters["a"].value = -0.5;
        document.parameters["b"].value = 0.25;
        document.w.value = 0.75;
    });
    const auto points =
        shown_points(drawn.request.formula.get(), drawn.document, drawn.request.camera, side);
    ASSERT_EQ(points.size(), 2U) << "Q is outside of the clip box";
    EXPECT_EQ(points[0].name, "P");
    EXPECT_EQ(points[0].at, glm::dvec3(1.0, 0.25, -0.5));
    EXPECT_EQ(points[0].sliders, (std::array<std::string, 3>{"", "b", "a"}));
    EXPECT_NEAR(points[0].radius, 0.012 * 4.0, 1e-12);
    EXPECT_EQ(points[1].name, "");
    EXPECT_EQ(points[1].at, glm::dvec3(0.5, 0.75, -1.0));
    EXPECT_EQ(points[1].sliders, (std::array<std::string, 3>{"", "w", ""}));
}

}  // namespace
}  // namespace zeroset::test::things_test
