#include "engine/volume/files/dicom_rle.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace zeroset::test::dicom_rle_test {
namespace {

std::string item(const std::string& bytes) {
    std::string text("\xfe\xff\x00\xe0", 4);
    for (unsigned shift = 0; shift < 32; shift += 8)
        text += static_cast<char>(bytes.size() >> shift & 0xFFU);
    return text + bytes;
}

/// Slices without a byte ask for no memory, however large the table of offsets is.
TEST(DicomRunLengths, AnnounceNoMoreThanTheyCanHold) {
    constexpr std::uint64_t slices = 4096;
    std::string items = item(std::string(std::size_t{1} << 21U, '\0'));
    for (std::uint64_t k = 0; k < slices; ++k)
        items += item({});
    items += std::string("\xfe\xff\xdd\xe0\0\0\0\0", 8);
    const auto samples = unpacked_rle(items, {5800, 5800, slices}, 2);
    ASSERT_FALSE(samples);
    EXPECT_EQ(samples.error(), "its packed samples are damaged or cut off");
}

}  // namespace
}  // namespace zeroset::test::dicom_rle_test
