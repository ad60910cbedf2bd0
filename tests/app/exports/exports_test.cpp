#include "app/exports/exports.hpp"

#include "app/exports/make_preview.hpp"
#include "document/import/import.hpp"
#include "engine/export/codecs/codec.hpp"
#include "engine/export/pictures/picture_writer.hpp"
#include "engine/export/png.hpp"
#include "pipeline/prepare.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace zeroset::exports_test {
namespace {

ExportSubject subject_of(const std::string& text) {
    ReadDocument read = read_document_text(text);
    auto prepared = prepare(read.document, *read.rows, Preparation::Interpreted);
    read.document.camera = default_camera(read.document.clip);
    return {.document = read.document,
            .formula = prepared->formula,
            .colors = prepared->colors,
            .settings = {}};
}

class Exports : public testing::Test {
protected:
    std::string bytes_of(const std::string& name) {
        std::ifstream file(folder_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    [[nodiscard]] std::size_t files() const {
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& entry :
             std::filesystem::directory_iterator(folder_.path()))
            ++count;
        return count;
    }

    test::TestFolder folder_;
    ExportSubject ball_ = subject_of("x^2+y^2+z^2=1");
    ExportNews news_{[] {}};
};

TEST_F(Exports, WriteAPictureWithItsSession) {
    const ui::PictureExport wish{.size_px = {40, 30}};
    const auto outcome = picture_work(ball_, wish, folder_ / "a.png")(news_);
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_EQ(*outcome, "saved a.png (40x30)");
    const std::string png = bytes_of("a.png");
    const auto size = size_of_png(std::as_bytes(std::span(png)));
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 40U);
    EXPECT_TRUE(text_in_png(std::as_bytes(std::span(png)), document_keyword));
    EXPECT_TRUE(news_.take_picture());
}

TEST_F(Exports, WriteNumberedPicturesOfAFilm) {
    const ui::FilmExport wish{.size_px = {24, 18}, .seconds = 0.1};
    const auto outcome = film_work(ball_, wish, folder_ / "f##.png")(news_);
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_EQ(*outcome, "saved f##.png (3 frames)");
    EXPECT_FALSE(bytes_of("f00.png").empty());
    EXPECT_FALSE(bytes_of("f02.png").empty());
    EXPECT_EQ(files(), 3U);
}

TEST_F(Exports, WriteAFilm) {
    const std::string missing = missing_encoder("libx264");
    if (!missing.empty()) GTEST_SKIP() << missing;
    const ui::FilmExport wish{.size_px = {32, 32}, .seconds = 0.2};
    const auto outcome = film_work(ball_, wish, folder_ / "a.mp4")(news_);
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_EQ(bytes_of("a.mp4").substr(4, 4), "ftyp");
}

TEST_F(Exports, WriteMeshesAndDrawings) {
    const ui::MeshExport wish{.tolerance_mm = 1.25};
    const auto meshes = make_meshes(ball_, wish, news_);
    ASSERT_TRUE(meshes) << meshes.error();
    const auto outcome = mesh_work(ball_, wish, folder_ / "a.stl", *meshes)(news_);
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_EQ(bytes_of("a.stl").size(), 84 + 50 * (*meshes)->surfaces[0].facts.triangles);
    const auto drawn = drawing_work(ball_, {}, folder_ / "a.svg", nullptr)(news_);
    ASSERT_TRUE(drawn) << drawn.error();
    EXPECT_NE(bytes_of("a.svg").find("<svg"), std::string::npos);
}

TEST_F(Exports, SayWhatIsWrongAndLeaveNothing) {
    EXPECT_EQ(picture_work(ball_, {}, folder_ / "a.stl")(news_).error(),
              "the picture was not saved: type a name that ends in .png, .jpg, .webp, .tif, .exr, "
              ".bmp, .tga or .hdr; .stl is written by `zeroset mesh`");
    EXPECT_FALSE(film_work(ball_, {}, folder_ / "a.xyz")(news_));
    EXPECT_FALSE(mesh_work(ball_, {.tolerance_mm = 2.5}, folder_ / "a.xyz", nullptr)(news_));
    EXPECT_FALSE(drawing_work(ball_, {}, folder_ / "a.xyz", nullptr)(news_));
    EXPECT_FALSE(picture_work(ball_, {}, folder_ / "none" / "a.png")(news_));
    EXPECT_EQ(files(), 0U);
}

TEST_F(Exports, LeaveNothingWhereTheyAreStopped) {
    news_.cancel = true;
    EXPECT_FALSE(picture_work(ball_, {}, folder_ / "a.png")(news_));
    EXPECT_FALSE(film_work(ball_, {}, folder_ / "f##.png")(news_));
    EXPECT_FALSE(mesh_work(ball_, {}, folder_ / "a.stl", nullptr)(news_));
    EXPECT_FALSE(drawing_work(ball_, {}, folder_ / "a.svg", nullptr)(news_));
    EXPECT_EQ(files(), 0U);
}

TEST_F(Exports, CopyThePictureAsAPng) {
    const auto png = std::make_shared<std::vector<std::byte>>();
    ASSERT_TRUE(copy_work(ball_, {50, 40}, png)(news_));
    EXPECT_EQ(size_of_png(*png)->height, 40U);
}

TEST_F(Exports, PreviewsFitTheirRoom) {
    PreviewRequest request;
    request.subject = ball_;
    request.wish.picture.size_px = {4000, 1000};
    request.space_px = {200, 100};
    const Preview preview = make_preview(request, std::nullopt, news_);
    ASSERT_TRUE(preview.image);
    EXPECT_EQ(preview.image->width, 200);
    EXPECT_EQ(preview.image->height, 50);
    EXPECT_EQ(preview.image->pixels[25 * 200 + 100] >> 24U, 0xFFU);
}

TEST_F(Exports, PreviewsOfMeshesAreMadeOnce) {
    PreviewRequest request;
    request.subject = ball_;
    request.wish.kind = ExportKind::Mesh;
    request.wish.mesh.tolerance_mm = 1.25;
    request.camera = *ball_.document.camera;
    request.space_px = {60, 40};
    const Preview first = make_preview(request, std::nullopt, news_);
    ASSERT_NE(first.meshes, nullptr);
    // 100 mm across; the triangles cut off a little on both sides.
    EXPECT_TRUE(std::ranges::any_of(first.shown.facts, [](const std::string& fact) {
        return fact.starts_with("thinnest wall 9") && fact.ends_with(" mm, but for rims");
    }));
    EXPECT_EQ(first.shown.verdict, "Can be printed: closed on all sides.");
    EXPECT_TRUE(first.shown.is_good);
    EXPECT_FALSE(first.shown.facts.empty() || first.shown.details.empty());
    request.camera.eye = {3, 3, 3};
    request.camera.look_at = {0.5, 0, 0};
    request.camera.projection = Projection::Orthographic;
    const Preview second = make_preview(request, first, news_);
    EXPECT_EQ(second.meshes, first.meshes);
    EXPECT_NE(second.image->pixels, first.image->pixels);
    request.wish.mesh.tolerance_mm = 2.5;
    EXPECT_NE(make_preview(request, second, news_).meshes, first.meshes);
}

TEST_F(Exports, WriteTheFormulaItself) {
    const ui::MeshExport wish{.shape = ui::MeshExport::Shape::Formula, .size_mm = 50};
    const auto outcome = mesh_work(ball_, wish, folder_ / "a.3mf", nullptr)(news_);
    ASSERT_TRUE(outcome) << outcome.error();
    EXPECT_TRUE(outcome->starts_with("saved a.3mf (") && outcome->ends_with(" nodes)")) << *outcome;
    const auto read = read_import("a.3mf", bytes_of("a.3mf"));
    ASSERT_TRUE(read) << read.error();
    ASSERT_EQ(read->documents.size(), 1U);
    EXPECT_EQ(read->documents[0].refusal, "");
    EXPECT_NEAR(read->documents[0].document.clip.size(), 50, 2) << "millimetres, with a margin";
}

TEST_F(Exports, SayWhyTheFormulaItselfIsNotWritten) {
    const ui::MeshExport wish{.shape = ui::MeshExport::Shape::Formula};
    EXPECT_EQ(mesh_work(ball_, wish, folder_ / "a.stl", nullptr)(news_).error(),
              "the mesh was not saved: the formula itself is written as 3MF alone: type a name "
              "that ends in .3mf, or choose another shape");
    const auto error_of = [&](const std::string& text) {
        return mesh_work(subject_of(text), wish, folder_ / "a.3mf", nullptr)(news_).error();
    };
    EXPECT_EQ(error_of("noise(x, y, z) = 0"),
              "the mesh was not saved: 3MF's implicit functions have no node for volumes, noise, "
              "soft balls and special functions; a mesh can be saved instead");
    EXPECT_EQ(error_of("(u, v, u v), 0 < u < 1, 0 < v < 1"),
              "the mesh was not saved: an implicit function is made of equations, not of "
              "parametric surfaces, curves and points: hide their rows");
    news_.cancel = true;
    EXPECT_FALSE(mesh_work(ball_, wish, folder_ / "a.3mf", nullptr)(news_));
    EXPECT_EQ(files(), 0U);
}

TEST_F(Exports, PreviewTheFormulaItself) {
    PreviewRequest request;
    request.subject = subject_of("x^2+y^2+z^2=1\nx=z");
    request.subject.document.clip.hi.z =
        request.subject.document.clip.lo.z + 0.5 * request.subject.document.clip.size();
    request.wish.kind = ExportKind::Mesh;
    request.wish.mesh = {.shape = ui::MeshExport::Shape::Formula, .size_mm = 80};
    request.camera = *ball_.document.camera;
    request.space_px = {60, 40};
    const Preview preview = make_preview(request, std::nullopt, news_);
    EXPECT_TRUE(preview.shown.warnings.empty());
    ASSERT_EQ(preview.shown.facts.size(), 2U);
    EXPECT_TRUE(preview.shown.facts[0].starts_with("2 surfaces of ") &&
                preview.shown.facts[0].ends_with(" nodes, without triangles"))
        << preview.shown.facts[0];
    EXPECT_EQ(preview.shown.facts[1], "in a box of 80 × 80 × 40 mm");
    ASSERT_TRUE(preview.image);
    EXPECT_EQ(preview.image->width, 60);
    request.subject = subject_of("noise(x, y, z) = 0");
    const Preview refused = make_preview(request, std::nullopt, news_);
    EXPECT_EQ(refused.shown.warnings.size(), 1U);
    EXPECT_FALSE(refused.image);
}

TEST_F(Exports, FilmsTurnAboutTheAxis) {
    ui::FilmExport wish{.seconds = 2.0, .degrees = 90.0, .axis = 2};
    const FilmPlan plan = plan_of(wish, ball_.document);
    EXPECT_EQ(plan.frames, 60);
    ASSERT_TRUE(plan.turn);
    EXPECT_EQ(plan.turn->axis, glm::dvec3(0, 1, 0));
    wish.turns = false;
    EXPECT_FALSE(plan_of(wish, ball_.document).turn);
}

TEST_F(Exports, FilmsGoThroughTheSavedViewsAsTheyAreNow) {
    ui::FilmExport wish{.through_views = true};
    wish.plan.path = {*ball_.document.camera, *ball_.document.camera, *ball_.document.camera};
    Document document = ball_.document;
    add_view(document.views, *document.camera);
    EXPECT_TRUE(plan_of(wish, document).path.empty()) << "one view is no way";
    Camera other = *document.camera;
    other.eye = -other.eye;
    add_view(document.views, other);
    EXPECT_EQ(plan_of(wish, document).path, (std::vector<Camera>{*document.camera, other}));
    wish.through_views = false;
    EXPECT_EQ(plan_of(wish, document).path.size(), 3U);
}

}  // namespace
}  // namespace zeroset::exports_test
