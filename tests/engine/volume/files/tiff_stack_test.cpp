#include "tests/support/volume_files.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

// Stacks as the words of TIFF 6.0 have them; those of other programs are compared by hand.

namespace zeroset::test::tiff_stack_test {
namespace {

std::string deflated(const std::string& bytes) {
    std::string packed(compressBound(bytes.size()), '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    return packed.substr(0, size);
}

/// A file of pages of 4 x 3 samples, written bit by bit.
struct Tiff {
    bool big_endian = false;
    unsigned bits = 16, format = 1, packing = 1, numbers = 1;
    std::string description = {};
    std::vector<std::string> pages = {};  ///< their samples
    bool in_rows = false;                 ///< a strip for each row, in turn with other bytes

    [[nodiscard]] std::string word(std::uint64_t value, std::size_t width) const {
        std::string bytes;
        for (std::size_t i = 0; i < width; ++i)
            bytes += static_cast<char>(value >> 8 * i & 0xFFU);
        if (big_endian) std::reverse(bytes.begin(), bytes.end());
        return bytes;
    }
    [[nodiscard]] std::string entry(unsigned tag, unsigned type, std::uint64_t count,
                                    std::uint64_t value) const {
        const bool is_short = type == 3 && count == 1;
        return word(tag, 2) + word(type, 2) + word(count, 4) +
               (is_short ? word(value, 2) + std::string(2, '\0') : word(value, 4));
    }
    [[nodiscard]] std::string bytes() const {
        std::string file = (big_endian ? "MM" : "II") + word(42, 2) + word(0, 4);
        std::size_t link = 4;
        for (const std::string& page : pages) {
            const std::size_t rows = in_rows ? 3 : 1;
            std::vector<std::size_t> offsets, counts;
            for (std::size_t row = 0; row < rows; ++row) {
                const std::string part = page.substr(row * page.size() / rows, page.size() / rows);
                const std::string strip = packing == 1 ? part : deflated(part);
                if (in_rows) file += "gap";
                offsets.push_back(file.size());
                counts.push_back(strip.size());
                file += strip;
            }
            std::string lists;
            for (const auto* const list : {&offsets, &counts}) {
                for (const std::size_t number : *list)
                    lists += word(number, 4);
            }
            const std::size_t at = file.size();
            file += lists + description + '\0';
            const std::size_t described = at + lists.size();
            const std::size_t resolution = file.size();
            file += word(4, 4) + word(2, 4);  // two samples a unit
            file.replace(link, 4, word(file.size(), 4));
            std::string tags =
                entry(256, 3, 1, 4) + entry(257, 3, 1, 3) + entry(258, 3, 1, bits) +
                entry(259, 3, 1, packing) + entry(270, 2, description.size() + 1, described) +
                entry(273, 4, rows, rows == 1 ? offsets[0] : at) + entry(277, 3, 1, numbers) +
                entry(279, 4, rows, rows == 1 ? counts[0] : at + 4 * rows) +
                entry(282, 5, 1, resolution) + entry(339, 3, 1, format);
            file += word(tags.size() / 12, 2) + tags;
            link = file.size();
            file += word(0, 4);
        }
        return file;
    }
};

template <class Sample>
std::vector<std::string> slices(bool big_endian = false) {
    const std::string all = grid_bytes<Sample>(big_endian);
    return {all.substr(0, all.size() / 2), all.substr(all.size() / 2)};
}

TEST_F(VolumeFiles, TiffStacksAreRead) {
    expect_grid(write("a.tif", Tiff{.pages = slices<std::uint16_t>()}.bytes()));
    expect_grid(
        write("b.tiff",
              Tiff{.big_endian = true, .format = 2, .pages = slices<std::int16_t>(true)}.bytes()));
    expect_grid(write(
        "c.TIF",
        Tiff{.bits = 8, .packing = 8, .pages = slices<std::uint8_t>(), .in_rows = true}.bytes()));
    expect_grid(write("d.tif", Tiff{.big_endian = true,
                                    .bits = 32,
                                    .format = 3,
                                    .packing = 32946,
                                    .pages = slices<float>(true)}
                                   .bytes()));
    expect_grid(
        write("e.tif",
              Tiff{.bits = 64, .format = 3, .pages = slices<double>(), .in_rows = true}.bytes()));
    EXPECT_EQ(place_of(folder_ / "a.tif"), Geometry{});
}

TEST_F(VolumeFiles, TiffStacksTellTheirSpacings) {
    const auto place = [&](const std::string& name, const std::string& description) {
        const auto file = write(
            name,
            Tiff{.bits = 8, .description = description, .pages = slices<std::uint8_t>()}.bytes());
        expect_grid(file);
        return place_of(file).world_from_index;
    };
    EXPECT_EQ(place("a.tif", "ImageJ=1.53t\nimages=2\nslices=2\nunit=micron\nspacing=2.5\n"),
              (Matrix3{{{0.5, 0, 0}, {0, 1, 0}, {0, 0, 2.5}}}));
    EXPECT_EQ(place("b.tif",
                    "<?xml version=\"1.0\"?><OME><Image><Pixels SizeC=\"1\" SizeT=\"1\" "
                    "PhysicalSizeX=\"0.25\" PhysicalSizeY=\"0.5\" "
                    "PhysicalSizeZ=\"3\"/></Image></OME>"),
              (Matrix3{{{0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 3}}}));
    // One page whose description tells of further slices behind its own
    const std::string all = grid_bytes<std::uint8_t>();
    Tiff run{.bits = 8, .description = "ImageJ=1.53t\nimages=2\n", .pages = {all}};
    expect_grid(write("c.tif", run.bytes()));
}

TEST_F(VolumeFiles, TiffThatIsNoVolumeGetsItsLine) {
    const auto error = [&](const Tiff& tiff) { return error_of(write("a.tif", tiff.bytes())); };
    const auto pages = slices<std::uint16_t>();
    EXPECT_EQ(error_of(write("a.tif", "no picture")), "it does not begin as TIFF does");
    EXPECT_EQ(error_of(write("a.tif", std::string("II\x2b\0", 4))),
              "it is a BigTIFF; only TIFF of up to 4 GB is read");
    EXPECT_EQ(error({.pages = {pages[0]}}), "it is a picture of 4 x 3 samples, no volume");
    EXPECT_EQ(error({.numbers = 3, .pages = pages}),
              "it has 3 numbers at each point: colors; a volume has one");
    EXPECT_EQ(error({.bits = 12, .pages = pages}),
              "its samples have 12 bits; 8, 16, 32 and floats are read");
    EXPECT_TRUE(error({.packing = 5, .pages = pages}).starts_with("it is packed in way 5"));
    EXPECT_EQ(error({.description = "ImageJ=1\nchannels=2\n", .pages = pages}),
              "it has several channels; a volume has one number at each point");
    EXPECT_EQ(error({.pages = {pages[0], pages[1].substr(0, 20)}, .in_rows = true}),
              "its page 2 is damaged or cut off");
}

/// Any bytes end in a volume or a line, in bounded time: pages may lead back to others.
TEST_F(VolumeFiles, TiffMayBeDamaged) {
    const std::string whole =
        Tiff{.packing = 8, .description = "ImageJ=1\n", .pages = slices<std::uint16_t>()}.bytes();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (const int value : {0, 8, 0xff}) {
            std::string bytes = whole;
            bytes[at] = static_cast<char>(value);
            const auto read = read_volume_file(write("a.tif", bytes), {});
            EXPECT_TRUE(read || read.error().find('\n') == std::string::npos) << at;
        }
        const auto cut = read_volume_file(write("a.tif", whole.substr(0, at)), {});
        EXPECT_FALSE(cut) << at;
    }
    std::string loop = whole;
    loop.replace(loop.size() - 4, 4, loop.substr(4, 4));
    EXPECT_EQ(error_of(write("a.tif", loop)), "its pages are damaged or cut off");
    // A page of many entries that nothing is taken of, before itself.
    const Tiff plain;
    std::string entries = "II" + plain.word(42, 2) + plain.word(8, 4) + plain.word(60'000, 2);
    for (int i = 0; i < 60'000; ++i)
        entries += plain.entry(256, 7, 1, 4);
    EXPECT_EQ(error_of(write("a.tif", entries + plain.word(8, 4))),
              "its pages are damaged or cut off");
}

/// Pages that name the same samples get no more memory than the file's size tells.
TEST_F(VolumeFiles, TiffPagesMayNotShareSamples) {
    std::string bytes = Tiff{.pages = {std::string(24, 'a')}}.bytes();
    const std::size_t first = bytes.find(Tiff{}.entry(256, 3, 1, 4)) - 2;
    const std::string page = bytes.substr(first, bytes.size() - 4 - first);
    for (int i = 0; i < 400; ++i) {
        bytes.replace(bytes.size() - 4, 4, Tiff{}.word(bytes.size(), 4));
        bytes += page + Tiff{}.word(0, 4);
    }
    const auto read = read_volume_file(write("a.tif", bytes), {});
    EXPECT_TRUE(read) << read.error();  // directories are larger than such small pages
    std::string large = Tiff{.pages = {std::string(24, 'a')}}.bytes();
    large.replace(large.find(Tiff{}.entry(257, 3, 1, 3)), 12, Tiff{}.entry(257, 4, 1, 1'000'000));
    std::string again = large.substr(first, large.size() - 4 - first);
    large.replace(large.size() - 4, 4, Tiff{}.word(large.size(), 4));
    large += again + Tiff{}.word(0, 4);
    EXPECT_EQ(error_of(write("a.tif", large)), "it is too short for its 2 pages");
}

}  // namespace
}  // namespace zeroset::test::tiff_stack_test
