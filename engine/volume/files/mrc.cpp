// MRC and CCP4 maps of electron microscopes and crystals (ccpem.ac.uk/mrc_format/mrc2014.php).

#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace zeroset {
namespace {

constexpr std::size_t mrc_header = 1024;  // bytes

/// The numbers of a header, in words of four bytes.
class MrcHeader {
public:
    explicit MrcHeader(std::string bytes) : bytes_(std::move(bytes)) {
        constexpr std::size_t stamp = 212;
        big_endian_ = bytes_[stamp] == '\x11';
    }
    [[nodiscard]] bool big_endian() const { return big_endian_; }
    [[nodiscard]] std::int32_t whole(std::size_t word) const {
        return number_at<std::int32_t>(bytes_, 4 * word, big_endian_);
    }
    [[nodiscard]] double real(std::size_t word) const {
        return static_cast<double>(number_at<float>(bytes_, 4 * word, big_endian_));
    }
    /// Whether the columns, rows and sections lead along x, y and z in some order.
    [[nodiscard]] bool has_axes() const {
        std::array<std::int32_t, 3> axes{whole(16), whole(17), whole(18)};
        std::ranges::sort(axes);
        return axes == std::array<std::int32_t, 3>{1, 2, 3};
    }
    /// The axis, 0 to 2, along which columns, rows or sections follow each other.
    [[nodiscard]] std::size_t axis(std::size_t i) const {
        return static_cast<std::size_t>(whole(16 + i)) - 1;
    }
    [[nodiscard]] std::optional<SampleType> type() const {
        constexpr std::int32_t imod = 1146047817;  // whose bytes have no sign unless it says so
        const bool no_sign = whole(38) == imod && (whole(39) & 1) == 0;
        switch (whole(3)) {
            case 0: return no_sign ? SampleType::UInt8 : SampleType::Int8;
            case 1: return SampleType::Int16;
            case 2: return SampleType::Float;
            case 6: return SampleType::UInt16;
            default: return std::nullopt;
        }
    }

private:
    std::string bytes_;
    bool big_endian_ = false;
};

/// The vectors of a crystal's cell as columns, from their lengths and the angles between them:
/// the first along x, the second in the plane of x and y. Without a cell: steps of 1.
Matrix3 cell_of(const MrcHeader& header) {
    std::array<double, 3> length{};
    std::array<double, 3> cosine{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double edge = header.real(10 + i);
        length[i] = edge > 0 && std::isfinite(edge) ? edge : std::max(header.whole(7 + i), 1);
        const double angle = header.real(13 + i);  // between the two other vectors
        const bool is_right = angle == 0 || angle == 90;
        cosine[i] = is_right ? 0 : std::cos(angle * std::numbers::pi / 180);
    }
    const double sine = std::sqrt(1 - cosine[2] * cosine[2]);
    const double across = (cosine[0] - cosine[1] * cosine[2]) / sine;
    const double up = std::sqrt(1 - cosine[1] * cosine[1] - across * across);
    return {{{length[0], length[1] * cosine[2], length[2] * cosine[1]},
             {0, length[1] * sine, length[2] * across},
             {0, 0, length[2] * up}}};
}

/// In the file's unit, mostly an angstrom. The origin is that of the words for it, or where these
/// are 0 that of the first column, row and section.
Geometry mrc_geometry(const MrcHeader& header) {
    Geometry geometry;
    const Matrix3 cell = cell_of(header);
    const bool has_origin = header.real(49) != 0 || header.real(50) != 0 || header.real(51) != 0;
    for (std::size_t r = 0; r < 3; ++r) {
        geometry.origin[r] = has_origin ? header.real(49 + r) : 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t axis = header.axis(i);
            const int cells = std::max(header.whole(7 + axis), 1);
            geometry.world_from_index[r][i] = cell[r][axis] / cells;
            if (!has_origin)
                geometry.origin[r] += geometry.world_from_index[r][i] * header.whole(4 + i);
        }
    }
    return geometry;
}

}  // namespace

Expected<VolumeFile> read_mrc(const std::filesystem::path& file) {
    auto bytes = unpacked_start(file, mrc_header);
    if (!bytes) return std::unexpected(bytes.error());
    if (bytes->size() < mrc_header || bytes->substr(208, 3) != "MAP")
        return std::unexpected("it does not begin with a header of MRC, which has MAP at byte 208");
    const MrcHeader header(std::move(*bytes));
    const auto type = header.type();
    if (!type) {
        return std::unexpected("its samples are of mode " + std::to_string(header.whole(3)) +
                               " of the format; read are 0, 1, 2 and 6: bytes, whole numbers of 16 "
                               "bits and floats");
    }
    if (!header.has_axes())
        return std::unexpected("its columns, rows and sections are not those of x, y and z");
    SampleBlock block{.file = file, .type = *type, .big_endian = header.big_endian()};
    for (std::size_t i = 0; i < 3; ++i)
        block.size[i] = static_cast<std::uint64_t>(std::max(header.whole(i), 0));
    const std::uint64_t skip =
        mrc_header + static_cast<std::uint64_t>(std::max(header.whole(23), 0));
    start_at(block, skip);
    const auto samples = read_samples(block);
    if (!samples) return std::unexpected(samples.error());
    return VolumeFile{.samples = *samples, .geometry = mrc_geometry(header)};
}

}  // namespace zeroset
