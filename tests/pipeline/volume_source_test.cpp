#include "pipeline/volume_source.hpp"

#include "engine/language/parse.hpp"
#include "engine/volume/files/write_nrrd.hpp"
#include "engine/volume/made_volumes.hpp"
#include "pipeline/sample_grid.hpp"
#include "pipeline/volume_document.hpp"
#include "tests/support/sample_field.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace zeroset::test::volume_source_test {
namespace {

/// A folder with the volume of `sample_field` as sample.nrrd, from which texts are read.
class VolumeTexts : public ::testing::Test {
protected:
    VolumeTexts() {
        const auto& data = sample_field()->data();
        bytes_ = nrrd_bytes(data.samples(), data.geometry(), "test");
        write("sample.nrrd");
        use({.folder = folder_.path()});
    }

    void use(const VolumeFolder& folder) { files_ = volume_source(folder, access_); }
    [[nodiscard]] std::expected<Program, ParseError> read(const std::string& text) const {
        return read_program(text, files_.get());
    }

    void write(const std::string& name) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes_.data()),
                   static_cast<std::streamsize>(bytes_.size()));
    }
    /// "OFFSET: REASON; HINT" of the error in a text.
    [[nodiscard]] std::string error_of(const std::string& text) const {
        const auto program = read(text);
        if (program) return "no error";
        const ParseError& error = program.error();
        return std::to_string(error.offset) + ": " + error.reason +
               (error.hint.empty() ? "" : "; " + error.hint);
    }
    static const Volume& volume_in(const Program& program) {
        return dynamic_cast<const Volume&>(*fields_of(program.surfaces.front()).front());
    }

    TestFolder folder_;
    std::shared_ptr<FileAccess> access_ = std::make_shared<FileAccess>();
    std::shared_ptr<const FieldSource> files_;
    std::vector<std::byte> bytes_;
};

TEST_F(VolumeTexts, AVolumeIsAFunctionOfAPoint) {
    const auto program = read("scan = volume(\"sample.nrrd\"); scan(x, y + 1, 2z) = 0.4");
    ASSERT_TRUE(program.has_value()) << program.error().reason;
    EXPECT_EQ(program->surfaces.front().canonical(),
              "volume(\"sample.nrrd\")(x, y + 1, 2*z) - 0.4");
    EXPECT_EQ(program->readings.front().text, "scan(x, y, z) = volume(\"sample.nrrd\")(x, y, z)");
    const auto again = read(program->surfaces.front().canonical());
    ASSERT_TRUE(again.has_value()) << again.error().reason;
    EXPECT_EQ(again->surfaces.front().key(), program->surfaces.front().key());
}

TEST_F(VolumeTexts, AVolumeStandsInAnyFormula) {
    for (const char* const text :
         {"s := volume(\"sample.nrrd\")\nmax(s(x,y,z) - 0.4, x) = 0",
          "scan = volume(“sample.nrrd”); scan(x + 0.1 sin(5y), y, z) = a",
          "2volume(\"sample.nrrd\")(x, y, z)^2 = 1",
          "f(u) = volume(\"sample.nrrd\", edge)(u, u, z); f(x) + f(y) = 0",
          "scan = volume(\"sample.nrrd\", 0.5, trilinear); sqrt(abs(scan(x, y, z))) = 0.3"}) {
        EXPECT_EQ(error_of(text), "no error") << text;
    }
}

TEST_F(VolumeTexts, ArgumentsSayWhatIsBeyondTheGrid) {
    const auto options_of = [this](const std::string& arguments) {
        const auto program = read("s = volume(\"sample.nrrd\"" + arguments + "); s(x, y, z) = 0");
        EXPECT_TRUE(program.has_value()) << arguments;
        return volume_in(*program).options();
    };
    EXPECT_EQ(options_of("").outside, Outside::Undefined);
    EXPECT_EQ(options_of(", edge").outside, Outside::Edge);
    EXPECT_EQ(options_of(", trilinear, undefined").outside, Outside::Undefined);
    EXPECT_EQ(options_of(", -2.5"), (VolumeOptions{Outside::Constant, -2.5}));
    EXPECT_EQ(options_of(", cubic, edge").outside, Outside::Edge);
}

TEST_F(VolumeTexts, ArgumentsSayWhatIsBetweenTheSamples) {
    const auto value_of = [this](const std::string& arguments) {
        const auto program = read("s = volume(\"sample.nrrd\"" + arguments + "); s(x, y, z) = 0");
        EXPECT_TRUE(program.has_value()) << arguments;
        const auto& data = volume_in(*program).data();
        const auto at = world_point(data.geometry(), {1, 2, 1});
        std::array<double, 4> value{};
        volume_in(*program).values(0, at.data(), value.data(), 1);
        EXPECT_EQ(volume_in(*program).spline() == nullptr, arguments.empty());
        return value[0];
    };
    const double sample = sample_at(sample_field()->data(), 1, 2, 1);
    EXPECT_NEAR(value_of(""), sample, 1e-9);
    EXPECT_NEAR(value_of(", cubic"), sample, 1e-9);
    EXPECT_GT(std::abs(value_of(", smooth") - sample), 0.01);
    EXPECT_NEAR(value_of(", cubic, 0.5"), sample, 1e-9);
    std::vector<float> numbers(27, 1);
    numbers[4] = std::nanf("");
    const auto kept = std::make_shared<const std::vector<float>>(numbers);
    bytes_ = nrrd_bytes({.type = SampleType::Float,
                         .size = {3, 3, 3},
                         .data = std::shared_ptr<const void>(kept, kept->data())},
                        {}, "test");
    write("holes.nrrd");
    EXPECT_EQ(error_of("volume(\"holes.nrrd\", cubic)(x, y, z) = 1"),
              "8: 'holes.nrrd': some of its samples are no finite numbers, through which no spline "
              "goes; type smooth for one beside the samples, or trilinear");
    EXPECT_EQ(error_of("volume(\"holes.nrrd\", smooth)(x, y, z) = 1"), "no error");
}

TEST_F(VolumeTexts, RawSamplesHaveTheirLayoutBehindThem) {
    std::ofstream(folder_ / "a.raw") << std::string(2 * 4 * 3 * 2, 'a');
    const auto program = read(
        "s = volume(\"a.raw\", size 4 3 2, int16, big, spacing 1 2 3, origin -1 0 0);"
        "s(x,y,z) = 1");
    ASSERT_TRUE(program.has_value()) << program.error().reason;
    EXPECT_EQ(volume_in(*program).data().samples().size, (GridSize{4, 3, 2}));
    EXPECT_EQ(volume_in(*program).data().bounds(), (std::array{-1.0, 0.0, 0.0, 2.0, 4.0, 3.0}));
}

TEST_F(VolumeTexts, MistakesAreShownAtTheirPlace) {
    EXPECT_EQ(error_of("volume(\"none.nrrd\")(x, y, z) = 1"),
              "8: 'none.nrrd': there is no such file");
    EXPECT_EQ(
        error_of("volume(\"sample.nrrd\", sharp)(x, y, z) = 1"),
        "22: 'sharp' says nothing of a volume; known are trilinear, cubic, smooth, edge, "
        "undefined, 0.5, size 256 256 109, uint8, big, skip 512, spacing 1 1 2, origin 0 0 0");
    EXPECT_EQ(error_of("volume(\"sample.nrrd\", uint8)(x, y, z) = 1"),
              "0: raw samples need their sizes; type size 256 256 109");
    EXPECT_EQ(error_of("volume(\"sample.nrrd\")(x, y) = 1"),
              "0: a volume takes 3 arguments, not 2; type (x, y, z)");
    EXPECT_EQ(error_of("s = volume(\"sample.nrrd\"); 2 s(x, y) = 1"),
              "29: s takes 3 arguments, not 2");
    EXPECT_EQ(error_of("volume(\"sample.nrrd\") = 1"),
              "0: a volume is a function of a point; give it a name in a row of its own, scan = "
              "volume(\"sample.nrrd\"), and type scan(x, y, z)");
    EXPECT_EQ(error_of("volume(\"sample.nrrd"),
              "7: the file's name is not closed; add a \" where it ends");
    EXPECT_EQ(error_of("volume(\"sample.nrrd\"; x = 1"),
              "27: a ')' is missing behind the file's name; add a ')'");
    EXPECT_EQ(error_of("volume(x) + 1"),
              "0: a volume is named by its file, in quotes; type volume(\"ct.nrrd\")");
    std::ofstream(folder_ / "a.spec") << "II";
    EXPECT_EQ(error_of("volume(\"a.spec\")(x, y, z) = 1").substr(0, 70),
              "8: 'a.spec': it is read as raw samples only, of sizes that are typed b");
}

TEST_F(VolumeTexts, ADocumentFromElsewhereReadsOnlyBesideItself) {
    write("scans/inner.nrrd");
    const auto folder = folder_ / "scans";
    use({.folder = folder, .closed = true});
    EXPECT_EQ(error_of("volume(\"inner.nrrd\")(x, y, z) = 1"), "no error");
    EXPECT_EQ(error_of("volume(\"../scans/inner.nrrd\")(x, y, z) = 1"), "no error");
    const std::string refused =
        "' lies outside the document's folder; open that file itself to "
        "allow it, or put it beside the document";
    EXPECT_EQ(error_of("volume(\"../sample.nrrd\")(x, y, z) = 1"), "8: '../sample.nrrd" + refused);
    EXPECT_EQ(error_of("volume(\"/etc/passwd\", size 2 2 2)(x, y, z) = 1"),
              "8: '/etc/passwd" + refused);
    std::filesystem::create_symlink(folder_ / "sample.nrrd", folder / "link.nrrd");
    EXPECT_EQ(error_of("volume(\"link.nrrd\")(x, y, z) = 1"), "8: 'link.nrrd" + refused);
    access_->allow(folder_ / "sample.nrrd");
    EXPECT_EQ(error_of("volume(\"../sample.nrrd\")(x, y, z) = 1"), "no error");
}

TEST_F(VolumeTexts, EqualTextsHaveTheSameFunction) {
    const std::string text = "volume(\"sample.nrrd\")(x, y, z) = 1";
    const auto first = read(text);
    const auto second = read(text);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(&volume_in(*first), &volume_in(*second));
    const auto edge = read("volume(\"sample.nrrd\", edge)(x, y, z) = 1");
    ASSERT_TRUE(edge);
    EXPECT_NE(&volume_in(*first), &volume_in(*edge));
    EXPECT_EQ(&volume_in(*first).data(), &volume_in(*edge).data());
}

TEST_F(VolumeTexts, TheProgramMakesSomeItself) {
    for (const MadeVolume& made : made_volumes()) {
        const auto program =
            read("volume(\"@" + std::string(made.name) + "\", size 12)(x, y, z) = 0.5");
        ASSERT_TRUE(program.has_value()) << program.error().reason;
        EXPECT_EQ(volume_in(*program).data().samples().size, (GridSize{12, 12, 12}));
        EXPECT_LT(volume_in(*program).data().range().lo, volume_in(*program).data().range().hi);
    }
    EXPECT_EQ(error_of("volume(\"@skull\")(x, y, z) = 1"),
              "8: '@skull': there is no such volume; the program makes @marschner_lobb, @bone, "
              "@orbital, @atoms");
    EXPECT_EQ(error_of("volume(\"@bone\", size 5000)(x, y, z) = 1"),
              "8: '@bone': its size is from 2 to 1024 samples along each edge");
}

/// The signal of Marschner and Lobb at 41^3: the error of trilinear interpolation as published.
TEST(MadeVolume, TrilinearErrorOfMarschnerAndLobbsTestIsThePublishedOne) {
    const auto data = made_volume("marschner_lobb", 41);
    ASSERT_TRUE(data.has_value());
    const auto volume = Volume::make(*data, {}, "");
    const auto fine = made_volume("marschner_lobb", 161);
    double largest = 0;
    for (std::uint64_t k = 0; k < 161; ++k) {
        for (std::uint64_t j = 0; j < 161; ++j) {
            for (std::uint64_t i = 0; i < 161; ++i) {
                const auto at = world_point(
                    (*fine)->geometry(),
                    {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
                std::array<double, 4> value{};
                volume->values(0, at.data(), value.data(), 1);
                if (std::isnan(value[0])) continue;  // a rounding beyond the last sample
                largest = std::max(largest, std::abs(value[0] - sample_at(**fine, i, j, k)));
            }
        }
    }
    EXPECT_NEAR(largest, 0.088, 0.01);
}

TEST_F(VolumeTexts, AFileBecomesADocument) {
    const auto document = document_of_volume(folder_ / "sample.nrrd");
    ASSERT_TRUE(document.has_value()) << document.error().reason;
    ASSERT_EQ(document->statements.size(), 2);
    EXPECT_EQ(document->statements[1].text, "scan(x, y, z) = a");
    EXPECT_EQ(document->statements[1].solid, SolidSide::Above);
    const SampleRange range = sample_field()->data().range();
    const Slider level = slider_of(*document, "a");
    EXPECT_EQ(level.lo, range.lo);
    EXPECT_EQ(level.hi, range.hi);
    EXPECT_NEAR(document->clip.lo.x, sample_field()->data().bounds()[0], 1e-12);
    EXPECT_FALSE(document_of_volume(folder_ / "none.nrrd").has_value());
}

TEST_F(VolumeTexts, AChangeOfAFileIsToldOnceNoOneWritesAnyMore) {
    const std::string text = "s = volume(\"sample.nrrd\"); s(x, y, z) = 0";
    auto program = read(text);
    ASSERT_TRUE(program.has_value()) << program.error().reason;
    access_->look_for_changes();
    EXPECT_FALSE(access_->look_for_changes());
    const std::uint64_t before = access_->version();
    std::filesystem::resize_file(folder_ / "sample.nrrd", bytes_.size() / 2);
    EXPECT_FALSE(access_->look_for_changes()) << "it may still be written";
    EXPECT_EQ(access_->version(), before);
    EXPECT_TRUE(access_->look_for_changes());
    EXPECT_EQ(access_->version(), before + 1);
    EXPECT_FALSE(access_->look_for_changes());
    EXPECT_TRUE(error_of(text).contains("it is too short")) << error_of(text);

    write("sample.nrrd");
    EXPECT_FALSE(access_->look_for_changes());
    EXPECT_TRUE(access_->look_for_changes());
    program = std::unexpected(ParseError{});
    use({.folder = folder_.path()});  // what keeps the latest volumes is new
    std::filesystem::remove(folder_ / "sample.nrrd");
    access_->look_for_changes();
    EXPECT_FALSE(access_->look_for_changes()) << "no one looks at it any more";
}

TEST_F(VolumeTexts, AChangeOfSeveralFilesIsToldOnceAllOfThemRest) {
    write("slices/s0.raw");
    write("slices/s1.raw");
    const std::string size = std::to_string(bytes_.size() / 2);
    std::ofstream(folder_ / "slices" / "all.mhd")
        << "ObjectType = Image\nNDims = 3\nDimSize = " << size << " 2 2\n"
        << "ElementType = MET_UCHAR\nElementDataFile = s%d.raw 0 1 1\n";
    const auto program = read("s = volume(\"slices/all.mhd\"); s(x, y, z) = 9");
    ASSERT_TRUE(program.has_value()) << program.error().reason;
    access_->look_for_changes();
    EXPECT_FALSE(access_->look_for_changes());
    std::filesystem::resize_file(folder_ / "slices" / "s0.raw", 7);
    EXPECT_FALSE(access_->look_for_changes());
    std::filesystem::resize_file(folder_ / "slices" / "s1.raw", 7);
    EXPECT_FALSE(access_->look_for_changes()) << "one rests, the other was written just now";
    EXPECT_TRUE(access_->look_for_changes());
    EXPECT_FALSE(access_->look_for_changes());
}

TEST_F(VolumeTexts, AChangeOfAFileOfBallsIsToldToo) {
    std::ofstream(folder_ / "balls.xyz") << "0 0 0 1\n";
    const auto program = read("blobs(\"balls.xyz\") = 1");
    ASSERT_TRUE(program.has_value()) << program.error().reason;
    access_->look_for_changes();
    std::ofstream(folder_ / "balls.xyz") << "0 0 0 1\n1 0 0 1\n";
    access_->look_for_changes();
    EXPECT_TRUE(access_->look_for_changes());
}

TEST_F(VolumeTexts, ASampledFormulaIsTheFormulaAtTheSamples) {
    const auto program = read("x y + z^2 - a");
    ASSERT_TRUE(program);
    Uniforms uniforms;
    uniforms.set(0, 0);
    uniforms.set(1, 0.25);
    const GridPlan plan{.box = {.lo = {-1, 0, 1}, .hi = {1, 2, 5}}, .size = {5, 4, 9}};
    const Samples samples = sampled(program->surfaces.front(), uniforms, plan);
    const auto data = VolumeData::make(samples, geometry_of(plan));
    ASSERT_TRUE(data.has_value()) << data.error();
    for (std::uint64_t i = 0; i < 5; ++i) {
        const auto at = world_point((*data)->geometry(), {static_cast<double>(i), 3, 8});
        const double expected = at[0] * at[1] + at[2] * at[2] - 0.25;
        EXPECT_NEAR(sample_at(**data, i, 3, 8), expected, 1e-5);
    }
    EXPECT_EQ((*data)->bounds(), (std::array{-1.0, 0.0, 1.0, 1.0, 2.0, 5.0}));
}

}  // namespace
}  // namespace zeroset::test::volume_source_test
