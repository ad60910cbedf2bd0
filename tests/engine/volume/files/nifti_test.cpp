#include "tests/support/volume_files.hpp"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace zeroset::test::nifti_test {
namespace {

/// A header of NIfTI-1 with the numbers that matter.
class NiftiHeader {
public:
    explicit NiftiHeader(std::int16_t datatype, bool big_endian = false)
        : bytes_(352, '\0'), big_endian_(big_endian) {
        put<std::int32_t>(0, 348);
        const std::vector<std::int16_t> dim{3, 4, 3, 2, 1, 1, 1, 1};
        for (std::size_t i = 0; i < dim.size(); ++i)
            put(40 + 2 * i, dim[i]);
        put(70, datatype);
        put(108, 352.0F);
        bytes_.replace(344, 3, "n+1");
    }
    template <class Number>
    NiftiHeader& put(std::size_t offset, Number number) {
        std::string raw(sizeof number, '\0');
        std::memcpy(raw.data(), &number, sizeof number);
        if (big_endian_) std::reverse(raw.begin(), raw.end());
        bytes_.replace(offset, raw.size(), raw);
        return *this;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    bool big_endian_;
};

TEST_F(VolumeFiles, NiftiIsRead) {
    expect_grid(write("a.nii", NiftiHeader(4).bytes() + grid_bytes<std::int16_t>()));
    expect_grid(write("b.nii", NiftiHeader(16, true).bytes() + grid_bytes<float>(true)));
    const std::string whole = NiftiHeader(512).bytes() + grid_bytes<std::uint16_t>();
    expect_grid(write("c.nii.gz", gzipped(whole)));
    std::string header = NiftiHeader(2).put(108, 0.0F).bytes();
    header.replace(344, 3, "ni1");
    write("d.img", grid_bytes<std::uint8_t>());
    expect_grid(write("d.hdr", header));
}

TEST_F(VolumeFiles, NiftiIsReadByItsBytesWhateverItsName) {
    const std::string whole = NiftiHeader(512).bytes() + grid_bytes<std::uint16_t>();
    expect_grid(write("a.NII.GZ", gzipped(whole)));
    expect_grid(write("b.nii", gzipped(whole)));
    expect_grid(write("c.nii.gz", whole));
    expect_grid(
        write("d.nii", NiftiHeader(512).put(108, 0.0F).bytes() + grid_bytes<std::uint16_t>()));
}

/// Pairs of headers and samples, each packed or not, named by either file.
TEST_F(VolumeFiles, NiftiPairsAreReadByEitherFile) {
    std::string header = NiftiHeader(2).put(108, 5.0F).bytes();
    header.replace(344, 3, "ni1");
    const std::string samples = "12345" + grid_bytes<std::uint8_t>();
    for (const bool capitals : {false, true}) {
        const std::string hdr = capitals ? ".HDR" : ".hdr";
        const std::string img = capitals ? ".IMG" : ".img";
        const std::string gz = capitals ? ".GZ" : ".gz";
        write("a" + hdr, header);
        write("a" + img, samples);
        write("b" + hdr + gz, gzipped(header));
        write("b" + img + gz, gzipped(samples));
        write("c" + hdr, header);
        write("c" + img + gz, gzipped(samples));
        write("d" + hdr + gz, gzipped(header));
        write("d" + img, samples);
        for (const std::string& name : {"a" + hdr, "a" + img, "b" + hdr + gz, "b" + img + gz,
                                        "c" + hdr, "c" + img + gz, "d" + hdr + gz, "d" + img}) {
            EXPECT_TRUE(is_volume_file(folder_ / name));
            expect_grid(folder_ / name);
        }
    }
}

/// Headers of Analyze 7.5 lack the mark of NIfTI. SPM's origin is counted from 1, and x runs to the
/// left (as nibabel places them).
TEST_F(VolumeFiles, AnalyzePairsAreReadAsSpmPlacesThem) {
    NiftiHeader header(4, true);
    header.put<std::int32_t>(344, 0).put(108, 0.0F);
    for (std::size_t i = 1; i < 4; ++i)
        header.put(76 + 4 * i, static_cast<float>(i));
    write("a.img", grid_bytes<std::int16_t>(true));
    const auto file = write("a.hdr", header.bytes().substr(0, 348));
    expect_grid(file);
    EXPECT_EQ(place_of(file), (Geometry{.world_from_index = {{{-1, 0, 0}, {0, 2, 0}, {0, 0, 3}}},
                                        .origin = {1.5, -2, -1.5}}));
    header.put<std::int16_t>(253, 3).put<std::int16_t>(255, 1).put<std::int16_t>(257, 2);
    write("b.img", grid_bytes<std::int16_t>(true));
    EXPECT_EQ(
        place_of(write("b.hdr", header.put(112, 2.0F).bytes().substr(0, 348))),
        (Geometry{.world_from_index = {{{-1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}, .origin = {2, 0, -3}}));
    EXPECT_EQ(sample_at(**open_volume(folder_ / "b.hdr", {}), 3, 2, 1), 246);
}

TEST_F(VolumeFiles, NiftiTellsItsPlaceAndScale) {
    NiftiHeader header(4);
    for (std::size_t i = 0; i < 4; ++i)
        header.put(76 + 4 * i, i == 0 ? 1.0F : static_cast<float>(i));
    const auto file = [&](const std::string& name) {
        return write(name, header.bytes() + grid_bytes<std::int16_t>());
    };
    EXPECT_EQ(place_of(file("a.nii")),
              (Geometry{.world_from_index = {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}, .origin = {}}));
    // A half turn about z, and the third axis flipped
    header.put<std::int16_t>(252, 1).put(76, -1.0F).put(264, 1.0F).put(268, 5.0F).put(272, 6.0F);
    EXPECT_EQ(place_of(file("b.nii")),
              (Geometry{.world_from_index = {{{-1, 0, 0}, {0, -2, 0}, {0, 0, -3}}},
                        .origin = {5, 6, 0}}));
    const std::vector<float> rows{0, 2, 0, 10, 3, 0, 0, 20, 0, 0, 4, 30};
    header.put<std::int16_t>(254, 1);
    for (std::size_t i = 0; i < rows.size(); ++i)
        header.put(280 + 4 * i, rows[i]);
    EXPECT_EQ(place_of(file("c.nii")),
              (Geometry{.world_from_index = {{{0, 2, 0}, {3, 0, 0}, {0, 0, 4}}},
                        .origin = {10, 20, 30}}));
    header.put(112, 2.0F).put(116, -7.0F);
    const auto data = open_volume(file("d.nii"), {});
    ASSERT_TRUE(data.has_value()) << data.error();
    EXPECT_EQ(sample_at(**data, 3, 2, 1), 2 * 123 - 7);
}

/// Nothing is rounded on the way: to double where floats do not hold what was scaled.
TEST_F(VolumeFiles, ScaledNiftiIsExact) {
    const auto scaled = [&](const std::string& name, float slope, float shift) {
        NiftiHeader header(4);
        header.put(112, slope).put(116, shift);
        return open_volume(write(name, header.bytes() + grid_bytes<std::int16_t>()), {}).value();
    };
    const auto halves = scaled("halves.nii", 0.5F, -1024.0F);
    EXPECT_EQ(halves->samples().type, SampleType::Float);
    EXPECT_EQ(sample_at(*halves, 3, 2, 1), 123 / 2.0 - 1024);
    const auto thirds = scaled("thirds.nii", 1.0F / 3.0F, 0.1F);
    EXPECT_EQ(thirds->samples().type, SampleType::Double);
    EXPECT_EQ(sample_at(*thirds, 3, 2, 1),
              123 * static_cast<double>(1.0F / 3.0F) + static_cast<double>(0.1F));
}

TEST_F(VolumeFiles, DamagedNiftiGetsItsLine) {
    const auto error = [&](const std::string& bytes) { return error_of(write("a.nii", bytes)); };
    EXPECT_EQ(error("no header"), "it does not begin with a header of NIfTI");
    EXPECT_EQ(error(NiftiHeader(128).bytes()),
              "its samples are colors; a volume has one number at each point");
    EXPECT_EQ(error(NiftiHeader(32).bytes()),
              "its samples are of type 32 of the format; only single numbers of up to 64 bits are "
              "read");
    EXPECT_EQ(error(NiftiHeader(4).put<std::int16_t>(40, 2).bytes()),
              "it is a picture of 4 x 3 samples, no volume");
    EXPECT_EQ(error(NiftiHeader(4).put(108, 348.0F).bytes()),
              "its 'vox_offset' is 348; behind its header samples begin at 352");
    EXPECT_EQ(error(NiftiHeader(4).put(344, '\0').bytes()),
              "its header says that its samples lie in a file of their own: then its name ends in "
              ".hdr");
    EXPECT_EQ(error_of(write("alone.hdr", NiftiHeader(4).put<std::int32_t>(344, 0).bytes())),
              "its other file 'alone.img' is not there, nor packed as .gz");
    EXPECT_EQ(error(NiftiHeader(4).put<std::int16_t>(40, 1).bytes()),
              "it has 1 axes; a volume has three");
    EXPECT_EQ(error(NiftiHeader(4).put<std::int16_t>(40, 4).put<std::int16_t>(48, 2).bytes()),
              "it has several volumes or numbers at each point; a volume has one");
    EXPECT_EQ(error(NiftiHeader(4).put<std::int16_t>(42, -5).bytes()),
              "its sizes 0 x 3 x 2 are no grid");
    EXPECT_EQ(error(NiftiHeader(4).put(108, -1.0F).bytes()), "its 'vox_offset' is no place in it");
    EXPECT_EQ(error(NiftiHeader(4).bytes() + "12"),
              "it is too short: 48 bytes of samples are announced, 2 bytes are there");
}

}  // namespace
}  // namespace zeroset::test::nifti_test
