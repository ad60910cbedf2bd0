#include "pipeline/gallery.hpp"
#include "pipeline/mesh_document.hpp"
#include "pipeline/prepare.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/mesh_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

// The topology of all surfaces of the gallery that are closed in their boxes and without singular
// points, so that they have a genus, as far as it is known without a mesh.
//   Left out: those that the box ends, whose genus depends on it; those with nodes, pinches,
//   self-intersections or cusps, whose solid has none (chubs and quartdef have nodes at the values
//   given); blobby, chair and kusner_schmitt, whose genus stands in no source; mitchell,
//   linked_tori and trefoil_knot, which take 15 to 50 s (they are right, too: 3 components of genus
//   1 in all, 2 tori, 1 torus).

namespace zeroset::test::mesh_gallery_test {
namespace {

struct KnownSurface {
    const char* name = "";
    std::size_t components = 1;
    long long genus = 0;  ///< of all components together
    std::optional<double> volume = std::nullopt;
    double tolerance = 0.005;  ///< in edges of the box
    bool is_smooth = true;     ///< so that all cells are proved
    bool takes_long = false;
};

class MeshOfGallery : public testing::TestWithParam<KnownSurface> {};

TEST_P(MeshOfGallery, HasTheGenusAndTheVolume) {
    const KnownSurface& known = GetParam();
    const auto item = gallery_item(known.name);
    ASSERT_TRUE(item);
    const ReadDocument read = read_document(*item);
    const auto prepared = prepare(read.document, *read.rows, Preparation::Interpreted);
    ASSERT_TRUE(prepared);
    const PictureRequest request =
        picture_request(prepared->formula, prepared->colors, read.document, {}, {64, 64});
    const auto meshes =
        mesh_document(request, {.tolerance = known.tolerance * request.clip.size()});
    ASSERT_TRUE(meshes);
    ASSERT_EQ(meshes->surfaces.size(), 1U);
    const SurfaceMesh& surface = meshes->surfaces[0];
    const TriangleMesh& mesh = meshes->file.objects[0].mesh;
    EXPECT_EQ(defect_of(mesh), "");
    EXPECT_EQ(surface.facts.components, known.components);
    EXPECT_EQ(surface.facts.genus(), known.genus);
    EXPECT_EQ(euler_characteristic(mesh),
              2 * static_cast<long long>(known.components) - 2 * known.genus);
    EXPECT_GT(enclosed_volume(mesh), 0);
    EXPECT_TRUE(surface.report.unproved == 0 || !known.is_smooth) << proof_line(surface.report);
    EXPECT_FALSE(surface.report.cut || surface.report.dense);
    const double volume = known.volume.value_or(enclosed_volume(mesh));
    EXPECT_NEAR(enclosed_volume(mesh), volume, 1e-3 * volume);
}

INSTANTIATE_TEST_SUITE_P(
    Surfaces, MeshOfGallery,
    testing::ValuesIn(cases_to_try<KnownSurface>(
        {KnownSurface{"sphere", 1, 0}, KnownSurface{"torus", 1, 1},
         // Eight balls at the minima, joined by twelve bridges: 8 - 12 = 1 - 5.
         KnownSurface{"tangle", 1, 5},
         // Tubes about three rings that meet in six points: 12 edges - 6 points + 1.
         KnownSurface{.name = "orthocircle", .components = 1, .genus = 7, .takes_long = true},
         // A ring cyclide, as c < mu < a.
         KnownSurface{"dupin_cyclide", 1, 1}, KnownSurface{"double_torus", 1, 2},
         // Two rings above each other, melted into one, as |w| is above 0.4.
         KnownSurface{"tiger", 1, 1},
         // f grows along all rays from the middle; its spikes are thinner than cells.
         KnownSurface{.name = "distel", .components = 1, .genus = 0, .is_smooth = false},
         // Three tunnels that meet: six mouths.
         KnownSurface{.name = "machined_cube", .components = 1, .genus = 5, .is_smooth = false},
         KnownSurface{.name = "steinmetz",
                      .components = 1,
                      .genus = 0,
                      .volume = 8 * (2 - std::sqrt(2.0)),
                      .tolerance = 3e-4,
                      .is_smooth = false}})),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace zeroset::test::mesh_gallery_test
