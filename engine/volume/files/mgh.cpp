// MGH and MGZ, the volumes of FreeSurfer
// (surfer.nmr.mgh.harvard.edu/fswiki/FsTutorial/MghFormat).

#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace zeroset {
namespace {

constexpr std::size_t mgh_header = 284;  // bytes

std::optional<SampleType> mgh_type(std::int32_t code) {
    switch (code) {
        case 0: return SampleType::UInt8;
        case 1: return SampleType::Int32;
        case 3: return SampleType::Float;
        case 4: return SampleType::Int16;
        case 10: return SampleType::UInt16;
        default: return std::nullopt;
    }
}

/// Where samples lie in RAS: by spacings, directions of the axes and the place of the grid's
/// middle; without these in the order of a coronal scan.
Geometry mgh_geometry(std::string_view header, const GridSize& size) {
    const auto real = [&](std::size_t offset) {
        return static_cast<double>(number_at<float>(header, offset, true));
    };
    const bool is_told = number_at<std::int16_t>(header, 28, true) > 0;
    constexpr std::array<double, 9> coronal{-1, 0, 0, 0, 0, -1, 0, 1, 0};
    Geometry geometry;
    for (std::size_t r = 0; r < 3; ++r) {
        geometry.origin[r] = is_told ? real(78 + 4 * r) : 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double spacing = is_told ? real(30 + 4 * c) : 1;
            const double direction = is_told ? real(42 + 4 * (3 * c + r)) : coronal[3 * c + r];
            geometry.world_from_index[r][c] = direction * spacing;
            geometry.origin[r] -= direction * spacing * static_cast<double>(size[c]) / 2;
        }
    }
    return geometry;
}

}  // namespace

Expected<VolumeFile> read_mgh(const std::filesystem::path& file) {
    const auto header = unpacked_start(file, mgh_header);
    if (!header) return std::unexpected(header.error());
    const auto whole = [&](std::size_t offset) {
        return number_at<std::int32_t>(*header, offset, true);
    };
    if (header->size() < mgh_header || whole(0) != 1)
        return std::unexpected("it does not begin with a header of MGH");
    if (whole(16) != 1) {
        return std::unexpected("it has " + std::to_string(whole(16)) +
                               " volumes; a volume has one number at each point");
    }
    const auto type = mgh_type(whole(20));
    if (!type) {
        return std::unexpected("its samples are of type " + std::to_string(whole(20)) +
                               " of the format; only single numbers are read");
    }
    SampleBlock block{.file = file, .type = *type, .big_endian = true};
    for (std::size_t i = 0; i < 3; ++i)
        block.size[i] = static_cast<std::uint64_t>(std::max(whole(4 + 4 * i), 0));
    start_at(block, mgh_header);
    const auto samples = read_samples(block);
    if (!samples) return std::unexpected(samples.error());
    return VolumeFile{.samples = *samples, .geometry = mgh_geometry(*header, block.size)};
}

}  // namespace zeroset
