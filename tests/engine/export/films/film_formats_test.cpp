#include "engine/export/codecs/codec.hpp"
#include "engine/export/films/film_writer.hpp"
#include "engine/export/films/frame_names.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace zeroset::test::film_formats_test {
namespace {

TEST(FilmFormats, AreKnownByTheirEndings) {
    EXPECT_EQ(film_format_of("a.mp4")->name, "MP4");
    EXPECT_EQ(film_format_of("a.b.GIF")->name, "GIF");
    for (const char* name : {"a", "a.png", "mp4", ".mp4", "a.mp4/b"})
        EXPECT_EQ(film_format_of(name), nullptr) << name;
}

TEST(FilmFormats, RefuseWhatTheyCannotHold) {
    const std::string missing = missing_encoder("libx264");
    if (!missing.empty()) GTEST_SKIP() << missing;
    const auto refused = [](const char* name, const FilmSettings& settings) {
        return refusal(*film_format_of(name), settings).value_or("");
    };
    const FilmSettings usual{.width = 640, .height = 480, .rate = {}};
    EXPECT_EQ(refused("a.mp4", usual), "");
    FilmSettings odd = usual;
    odd.width = 641;
    EXPECT_NE(refused("a.mp4", odd).find("642x480"), std::string::npos);
    EXPECT_EQ(refused("a.gif", odd), "");
    FilmSettings clear = usual;
    clear.alpha = true;
    EXPECT_NE(refused("a.mp4", clear), "");
    EXPECT_EQ(refused("a.webm", clear), "");
    FilmSettings quick = usual;
    quick.rate = {.frames = 60};
    EXPECT_NE(refused("a.gif", quick), "");
}

TEST(FilmFormats, EachWritesAFileWhenItIsFinished) {
    const std::string missing = missing_encoder("libx264");
    if (!missing.empty()) GTEST_SKIP() << missing;
    const TestFolder folder;
    Framebuffer frame(64, 48);
    for (const FilmFormat& format : film_formats()) {
        const std::filesystem::path path = folder / ("film" + std::string(format.ending));
        const FilmSettings settings{
            .width = 64, .height = 48, .rate = {.frames = 25}, .alpha = format.alpha};
        auto film = FilmWriter::begin(format, path, settings);
        ASSERT_TRUE(film) << film.error().message;
        for (unsigned i = 0; i < 5; ++i) {
            frame.color.assign(frame.color.size(), 0xFF000000U | 40U * i);
            frame.depth.assign(frame.depth.size(), 1.0F);
            ASSERT_TRUE((*film)->add({.frame = frame, .painted = frame}));
        }
        EXPECT_FALSE(std::filesystem::exists(path));
        ASSERT_TRUE((*film)->finish());
        EXPECT_GT(std::filesystem::file_size(path), 100U) << path;
    }
}

TEST(FilmFormats, AFilmThatIsGivenUpLeavesNothing) {
    const std::string missing = missing_encoder("libx264");
    if (!missing.empty()) GTEST_SKIP() << missing;
    const TestFolder folder;
    const FilmSettings settings{.width = 64, .height = 48, .rate = {}};
    {
        auto film = FilmWriter::begin(*film_format_of("a.mp4"), folder / "a.mp4", settings);
        ASSERT_TRUE(film);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    EXPECT_FALSE(FilmWriter::begin(*film_format_of("a.mp4"), folder / "none/a.mp4", settings));
}

TEST(FrameNames, PutTheNumberInPlaceOfTheLastRun) {
    const auto names = FrameNames::from("a##/f##_####.png");
    ASSERT_TRUE(names);
    EXPECT_EQ(names->path(7), "a##/f##_0007.png");
    EXPECT_EQ(names->path(123456), "a##/f##_123456.png");
    EXPECT_EQ(FrameNames::from("#.exr")->path(0), "0.exr");
    EXPECT_FALSE(FrameNames::from("a##/f.png"));
    EXPECT_FALSE(FrameNames::from("film.mp4"));
}

}  // namespace
}  // namespace zeroset::test::film_formats_test
