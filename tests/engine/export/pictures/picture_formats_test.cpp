#include "engine/export/pictures/picture_formats.hpp"

#include "engine/export/codecs/codec.hpp"
#include "engine/export/codecs/encoded_picture.hpp"
#include "engine/export/png.hpp"
#include "engine/image/gamma.hpp"
#include "tests/support/test_folder.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace zeroset::test::picture_formats_test {
namespace {

/// A frame with a hit, a part of one and misses, which keeps its planes.
Framebuffer frame_with_planes(int width, int height) {
    Framebuffer frame(width, height);
    frame.background = {.top = 0x404040, .bottom = 0x404040};
    frame.keep_planes(true);
    const float behind = light_of_channel(0x40);
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
        frame.color[i] = 0xFF404040U;
        frame.light[i] = {behind, behind, behind, 0.0F};
    }
    frame.color[1] = 0xFF0080FFU;
    frame.light[1] = {1.0F, 0.25F, 0.0F, 1.0F};
    frame.depth[1] = 2.5F;
    frame.normal[1] = {0.0F, 0.6F, 0.8F};
    frame.certificate[1] = Certificate::Certified;
    frame.surface[1] = 3;
    frame.color[2] = 0x80204060U;
    frame.light[2] = {0.5F * behind + 0.25F, 0.5F * behind, 0.5F * behind, 0.5F};
    return frame;
}

std::string content(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class PictureFormats : public ::testing::Test {
protected:
    /// Writes the frame in two bands.
    std::filesystem::path write(const std::string& name, PictureOptions options) {
        const std::filesystem::path path = folder_ / name;
        const PictureFormat* const format = picture_format_of(path);
        EXPECT_NE(format, nullptr) << name;
        options.size = {.width = 8, .height = 70};
        options.camera = default_camera(Box::cube(2));
        EXPECT_EQ(refusal(*format, options), std::nullopt) << name;
        auto writer = begin_picture(*format, path, options);
        EXPECT_TRUE(writer) << name;
        const Framebuffer first = frame_with_planes(8, 64);
        const Framebuffer second = frame_with_planes(8, 6);
        EXPECT_TRUE((*writer)->add({.frame = first, .painted = first, .row = 0}));
        EXPECT_FALSE(std::filesystem::exists(path)) << "not before it is complete";
        EXPECT_TRUE((*writer)->add({.frame = second, .painted = second, .row = 64}));
        EXPECT_TRUE((*writer)->finish());
        EXPECT_TRUE(std::filesystem::exists(path));
        return path;
    }

    TestFolder folder_;
};

TEST_F(PictureFormats, AreKnownByTheirEndings) {
    EXPECT_EQ(picture_format_of("a.png")->name, "PNG");
    EXPECT_EQ(picture_format_of("a.b.JPEG")->name, "JPEG");
    EXPECT_EQ(picture_format_of("a.TIFF")->name, "TIFF");
    EXPECT_EQ(picture_format_of("a.exr")->name, "OpenEXR");
    for (const char* name : {"a", "a.", "a.pcx", "png", ".png", "a.png/b"})
        EXPECT_EQ(picture_format_of(name), nullptr) << name;
}

TEST_F(PictureFormats, RefuseWhatTheyCannotHold) {
    const auto refused = [](const char* name, const PictureOptions& options) {
        return refusal(*picture_format_of(name), options).value_or("");
    };
    const ImageSize small{.width = 10, .height = 10};
    EXPECT_NE(refused("a.png", {.size = small, .bits = 12}), "");
    EXPECT_NE(refused("a.jpg", {.size = small, .bits = 8, .alpha = true}), "");
    EXPECT_NE(refused("a.webp", {.size = {.width = 20000, .height = 1}}), "");
    EXPECT_NE(refused("a.tif", {.size = {.width = 30000, .height = 30000}}), "");
    EXPECT_EQ(refused("a.png", {.size = {.width = 65536, .height = 65536}, .bits = 16}), "");
    EXPECT_EQ(refused("a.exr", {.size = {.width = 65536, .height = 65536}, .bits = 32}), "");
}

TEST_F(PictureFormats, PngHoldsTheSession) {
    const auto path = write("a.png", {.bits = 8, .alpha = true, .document = "{\"zeroset\": 1}"});
    const std::string file = content(path);
    const auto bytes = std::as_bytes(std::span(file));
    EXPECT_EQ(text_in_png(bytes, document_keyword), "{\"zeroset\": 1}");
    const auto image = image_from_png(bytes);
    ASSERT_TRUE(image);
    EXPECT_EQ(image->pixels[0], 0U);
    EXPECT_EQ(image->pixels[1], 0xFF0080FFU);
    EXPECT_EQ(image->pixels[2] >> 24U, 0x80U);
    EXPECT_EQ(image->pixels[64 * 8 + 1], 0xFF0080FFU) << "the second band";
}

TEST_F(PictureFormats, ExrHasLayersThatOpenExrReads) {
    const auto path = write("a.exr", {.bits = 32, .alpha = true, .document = "text"});
    Imf::InputFile file(path.c_str());
    const auto size = file.header().dataWindow();
    EXPECT_EQ(size.max.x, 7);
    EXPECT_EQ(size.max.y, 69);
    const auto* const text =
        file.header().findTypedAttribute<Imf::StringAttribute>(document_keyword);
    ASSERT_NE(text, nullptr);
    EXPECT_EQ(text->value(), "text");
    const auto plane = [&](const char* name) {
        std::vector<float> numbers(8 * 70);
        Imf::FrameBuffer planes;
        planes.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(numbers.data()),
                                       sizeof(float), 8 * sizeof(float)));
        file.setFrameBuffer(planes);
        file.readPixels(0, 69);
        return numbers;
    };
    EXPECT_EQ(plane("R")[1], 1.0F);
    EXPECT_EQ(plane("G")[1], 0.25F);
    EXPECT_EQ(plane("A")[0], 0.0F);
    EXPECT_FLOAT_EQ(plane("R")[2], 0.25F) << "multiplied by alpha, without background";
    EXPECT_EQ(plane("depth.Z")[0], std::numeric_limits<float>::infinity());
    EXPECT_EQ(plane("depth.Z")[64 * 8 + 1], 2.5F);
    EXPECT_EQ(plane("normal.Z")[1], 0.8F);
    EXPECT_EQ(plane("surface.id")[1], 3.0F);
    EXPECT_EQ(plane("certificate.id")[1], static_cast<float>(Certificate::Certified));
    const float length =
        std::hypot(plane("position.X")[1], plane("position.Y")[1], plane("position.Z")[1]);
    EXPECT_GT(length, 0.0F);
}

/// Readers that keep 255 bytes of an attribute of a kind that they do not know take longer ones for
/// the rest of the file: FFmpeg 5.
TEST_F(PictureFormats, ExrHoldsTheSessionInShortAttributes) {
    std::string session;
    for (int i = 0; i < 300; ++i)
        session += std::to_string(i) + " ";
    const Imf::InputFile file(write("a.exr", {.bits = 32, .document = session}).c_str());
    std::string read;
    for (int part = 1;; ++part) {
        const std::string name = document_keyword + (part == 1 ? "" : " " + std::to_string(part));
        const auto* const text = file.header().findTypedAttribute<Imf::StringAttribute>(name);
        if (text == nullptr) break;
        EXPECT_LE(text->value().size(), 255U);
        read += text->value();
    }
    EXPECT_EQ(read, session);
}

/// Pixels of a file, by another program's reader: stb_image. Channels from 0 to 1.
std::vector<float> pixels_of(const std::filesystem::path& path, int channels) {
    int width = 0;
    int height = 0;
    int there = 0;
    const std::string bytes = content(path);
    const std::unique_ptr<float, decltype(&std::free)> read(
        stbi_loadf_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                               static_cast<int>(bytes.size()), &width, &height, &there, channels),
        &std::free);
    EXPECT_EQ(width, 8);
    EXPECT_EQ(height, 70);
    if (read == nullptr) return std::vector<float>(8 * 70 * 4);
    return {read.get(), read.get() + 8 * 70 * channels};
}

TEST_F(PictureFormats, EveryBuildWritesWhatManyProgramsRead) {
    stbi_ldr_to_hdr_gamma(1.0F);
    const std::size_t second = 3 * (64 * 8 + 1);  // of the second band
    const auto close = [](float read, int wanted, float off) {
        EXPECT_NEAR(read, static_cast<float>(wanted) / 255.0F, off);
    };
    for (const std::string name : {"a.bmp", "a.tga", "a.jpg"}) {
        const auto pixels = pixels_of(write(name, {.quality = 100}), 3);
        const float off = name == "a.jpg" ? 0.03F : 1e-4F;
        close(pixels[0], 0x40, off);
        for (const std::size_t at : {std::size_t{3}, second}) {
            close(pixels[at], 0xFF, off);
            close(pixels[at + 1], 0x80, off);
            close(pixels[at + 2], 0x00, off);
        }
    }
    const auto transparent = pixels_of(write("b.tga", {.alpha = true}), 4);
    EXPECT_EQ(transparent[3], 0.0F);
    EXPECT_EQ(transparent[7], 1.0F);
    const auto light = pixels_of(write("a.hdr", {.bits = 32}), 3);
    EXPECT_NEAR(light[0], light_of_channel(0x40), 1e-3);
    EXPECT_NEAR(light[3], 1.0F, 1.0F / 128);
    EXPECT_NEAR(light[second + 1], 0.25F, 1.0F / 128);
}

TEST_F(PictureFormats, CodecsWriteFilesOfTheirKind) {
    const std::string missing = missing_encoder(webp_encoder);
    if (!missing.empty()) GTEST_SKIP() << missing;
    EXPECT_EQ(content(write("a.webp", {.alpha = true})).substr(8, 4), "WEBP");
    EXPECT_TRUE(content(write("a.tif", {.bits = 16})).starts_with("II*"));
}

}  // namespace
}  // namespace zeroset::test::picture_formats_test
