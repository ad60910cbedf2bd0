// The tables of formats in a program without FFmpeg: this one is linked with without_ffmpeg.cpp.

#include "engine/export/films/film_writer.hpp"
#include "engine/export/pictures/picture_formats.hpp"
#include "pipeline/plans/export_formats.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace zeroset::test::formats_test {
namespace {

constexpr const char* reason = "this Zeroset was built without FFmpeg";

TEST(WithoutFfmpeg, TheTableSaysWhatCannotBeWritten) {
    const std::set<std::string_view> written{".png", ".jpg", ".exr", ".bmp", ".tga", ".hdr"};
    for (const ExportFormat& format : export_formats()) {
        const bool needs_none = format.kind == ExportKind::Mesh ||
                                format.kind == ExportKind::Drawing ||
                                written.contains(format.ending);
        EXPECT_EQ(format.missing, needs_none ? "" : reason) << format.ending;
    }
}

TEST(WithoutFfmpeg, OnlyEndingsThatCanBeWrittenAreOffered) {
    EXPECT_EQ(export_endings(ExportKind::Picture), ".png, .jpg, .exr, .bmp, .tga or .hdr");
    EXPECT_EQ(export_endings(ExportKind::Film), "");
    EXPECT_EQ(export_endings(ExportKind::Picture, &ExportFormat::deep), ".png");
    EXPECT_EQ(export_use(ExportKind::Picture, &ExportFormat::quality), "; it is for .jpg");
    EXPECT_EQ(export_use(ExportKind::Picture, &ExportFormat::density), "; it is for .png or .exr");
    EXPECT_EQ(missing_endings(ExportKind::Picture), "no .webp or .tif: " + std::string(reason));
    EXPECT_EQ(missing_endings(ExportKind::Mesh), "");
}

TEST(WithoutFfmpeg, OtherNamesAreThoseThatWork) {
    EXPECT_EQ(other_name(ExportKind::Picture, "a.pcx"),
              "type a name that ends in .png, .jpg, .exr, .bmp, .tga or .hdr");
    EXPECT_EQ(other_name(ExportKind::Picture, "a.mp4"),
              "type a name that ends in .png, .jpg, .exr, .bmp, .tga or .hdr");
    EXPECT_EQ(other_name(ExportKind::Film, "a.avi"),
              "no .mp4, .webm, .mov, .mkv, .gif or .apng: " + std::string(reason) +
                  "; frame####.png makes numbered pictures");
}

TEST(WithoutFfmpeg, EachFormatIsRefusedInOneLineWithAnEndingThatWorks) {
    for (const PictureFormat& format : picture_formats()) {
        const PictureOptions options{.size = {.width = 64, .height = 48}, .bits = format.bits[0]};
        const std::string refused = refusal(format, options).value_or("");
        if (format.encoder == nullptr) {
            EXPECT_EQ(refused, "") << format.name;
            continue;
        }
        EXPECT_EQ(refused, "no " + std::string(format.name) + ": " + reason +
                               "; type a name that ends in .png");
    }
    for (const FilmFormat& format : film_formats()) {
        const FilmSettings settings{.width = 64, .height = 48, .rate = {.frames = 25}};
        EXPECT_EQ(refusal(format, settings).value_or(""),
                  "no " + std::string(format.name) + ": " + reason +
                      "; numbered frames need none: type frame####.png");
    }
}

TEST(WithoutFfmpeg, NoOptionPointsToAFormatThatCannotBeWritten) {
    const PictureFormat& exr = *picture_format_of("a.exr");
    EXPECT_EQ(refusal(exr, {.size = {.width = 64, .height = 48}, .bits = 16}),
              "a OpenEXR cannot have 16 bits a channel; type a name that ends in .png");
}

TEST(WithoutFfmpeg, AFilmThatIsBegunAnywayLeavesNoFile) {
    const TestFolder folder;
    const FilmSettings settings{.width = 64, .height = 48, .rate = {}};
    const auto film = FilmWriter::begin(*film_format_of("a.mp4"), folder / "a.mp4", settings);
    ASSERT_FALSE(film);
    EXPECT_NE(film.error().message.find(reason), std::string::npos) << film.error().message;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace zeroset::test::formats_test
