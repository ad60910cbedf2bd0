#pragma once

#include "engine/volume/files/volume_file.hpp"
#include "tests/support/sample_field.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace zeroset::test {

/// The sample at (i, j, k) of the grids here, 4 x 3 x 2.
inline int number_at(std::uint64_t i, std::uint64_t j, std::uint64_t k) {
    return static_cast<int>(i + 10 * j + 100 * k);
}

/// Their samples one after another.
template <class Sample>
std::string grid_bytes(bool big_endian = false) {
    std::string bytes;
    for (std::uint64_t k = 0; k < 2; ++k) {
        for (std::uint64_t j = 0; j < 3; ++j) {
            for (std::uint64_t i = 0; i < 4; ++i) {
                const auto sample = static_cast<Sample>(number_at(i, j, k));
                std::string raw(sizeof sample, '\0');
                std::memcpy(raw.data(), &sample, sizeof sample);
                if (big_endian) std::reverse(raw.begin(), raw.end());
                bytes += raw;
            }
        }
    }
    return bytes;
}

inline std::string gzipped(const std::string& bytes) {
    const TestFolder folder;
    const std::string path = (folder / "a.gz").string();
    const gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(file);
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Files of grids in a folder of their own.
class VolumeFiles : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& bytes) {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    static void expect_grid(const std::filesystem::path& file, const RawLayout& layout = {}) {
        const auto data = open_volume(file, layout);
        ASSERT_TRUE(data.has_value()) << file.filename() << ": " << data.error();
        ASSERT_EQ((*data)->samples().size, (GridSize{4, 3, 2})) << file.filename();
        for (std::uint64_t k = 0; k < 2; ++k) {
            for (std::uint64_t j = 0; j < 3; ++j) {
                for (std::uint64_t i = 0; i < 4; ++i)
                    ASSERT_EQ(sample_at(**data, i, j, k), number_at(i, j, k)) << file.filename();
            }
        }
    }
    static Geometry place_of(const std::filesystem::path& file) {
        const auto data = open_volume(file, {});
        EXPECT_TRUE(data.has_value()) << data.error();
        return data ? (*data)->geometry() : Geometry{};
    }
    static std::string error_of(const std::filesystem::path& file, const RawLayout& layout = {}) {
        const auto data = open_volume(file, layout);
        return data ? "no error" : data.error();
    }

    TestFolder folder_;
};

}  // namespace zeroset::test
