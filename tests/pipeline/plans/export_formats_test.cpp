#include "pipeline/plans/export_formats.hpp"

#include "engine/draw/files/formats.hpp"
#include "engine/export/films/film_formats.hpp"
#include "engine/export/pictures/picture_formats.hpp"
#include "engine/mesh/files/mesh_file.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace zeroset::export_formats_test {
namespace {

TEST(ExportFormats, HoldAllWritersOnce) {
    std::set<std::pair<ExportKind, std::string>> seen;
    std::size_t numbered = 0;
    for (const ExportFormat& format : export_formats()) {
        if (format.numbered) {
            ++numbered;
            continue;
        }
        EXPECT_TRUE(seen.emplace(format.kind, format.ending).second) << format.ending;
        EXPECT_FALSE(format.name.empty() || format.about.empty()) << format.ending;
        EXPECT_EQ(export_format_of(format.kind, "a" + std::string(format.ending)), &format);
    }
    EXPECT_EQ(numbered, picture_formats().size());
    EXPECT_EQ(seen.size(), picture_formats().size() + film_formats().size() +
                               mesh_formats().size() + drawing_formats().size());
}

TEST(ExportFormats, AreFoundByOtherSpellings) {
    EXPECT_EQ(export_format_of(ExportKind::Picture, "a.JPEG")->ending, ".jpg");
    EXPECT_EQ(export_format_of(ExportKind::Mesh, "a.STL")->ending, ".stl");
    EXPECT_EQ(export_format_of(ExportKind::Mesh, "a.png"), nullptr);
    EXPECT_EQ(export_format_of(ExportKind::Picture, "a"), nullptr);
}

TEST(ExportFormats, TellTheEndings) {
    EXPECT_EQ(export_endings(ExportKind::Picture),
              ".png, .jpg, .webp, .tif, .exr, .bmp, .tga or .hdr");
    EXPECT_EQ(export_endings(ExportKind::Film), ".mp4, .webm, .mov, .mkv, .gif or .apng");
    EXPECT_EQ(export_endings(ExportKind::Mesh), ".stl, .3mf, .ply, .obj or .glb");
    EXPECT_EQ(export_endings(ExportKind::Drawing), ".svg, .pdf or .tex");
    EXPECT_EQ(export_endings(ExportKind::Picture, &ExportFormat::deep), ".png or .tif");
    EXPECT_EQ(export_endings(ExportKind::Picture, &ExportFormat::density), ".png, .tif or .exr");
    EXPECT_EQ(export_endings(ExportKind::Film, &ExportFormat::quality), ".mp4 or .webm");
}

TEST(ExportFormats, NameTheCommandOfAnotherKindsEnding) {
    EXPECT_EQ(other_name(ExportKind::Drawing, "a.pcx"),
              "type a name that ends in .svg, .pdf or .tex");
    EXPECT_EQ(other_name(ExportKind::Drawing, "a.stl"),
              "type a name that ends in .svg, .pdf or .tex; .stl is written by `zeroset mesh`");
    EXPECT_EQ(other_name(ExportKind::Mesh, "a.mp4"),
              "type a name that ends in .stl, .3mf, .ply, .obj or .glb; .mp4 is written by "
              "`zeroset turntable`");
}

}  // namespace
}  // namespace zeroset::export_formats_test
