#pragma once

#include "engine/volume/files/header_text.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

enum class TiffTag : std::uint16_t {
    NewSubfileType = 254,
    ImageWidth = 256,
    ImageLength = 257,
    BitsPerSample = 258,
    Compression = 259,
    ImageDescription = 270,
    StripOffsets = 273,
    SamplesPerPixel = 277,
    StripByteCounts = 279,
    XResolution = 282,
    YResolution = 283,
    Predictor = 317,
    TileWidth = 322,
    SampleFormat = 339
};

/// A picture of a file by its tags: whole numbers, fractions and its description.
struct TiffPage {
    std::map<TiffTag, std::vector<std::uint64_t>> numbers;
    std::map<TiffTag, double> fractions;
    std::string description;

    [[nodiscard]] std::uint64_t number(TiffTag tag, std::uint64_t otherwise) const {
        const auto found = numbers.find(tag);
        return found == numbers.end() || found->second.empty() ? otherwise : found->second[0];
    }
    [[nodiscard]] std::vector<std::uint64_t> all(TiffTag tag) const {
        const auto found = numbers.find(tag);
        return found == numbers.end() ? std::vector<std::uint64_t>() : found->second;
    }
};

/// The pages of a file in their order, without smaller copies of others; at least one.
struct TiffPages {
    std::vector<TiffPage> pages;
    bool big_endian = false;
};
/// Reads the tags of a file of these bytes.
Expected<TiffPages> read_tiff_pages(std::string_view bytes);

}  // namespace zeroset
