// NIfTI-1 and NIfTI-2 files, in one piece or with a header of their own (nifti.nimh.nih.gov), and
// pairs of Analyze 7.5, which are older.

#include "engine/base/text.hpp"
#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/files/sample_pieces.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace zeroset {
namespace {

constexpr std::size_t longest_header = 540;
constexpr int rgb = 128;  // types of samples
constexpr int rgba = 2304;

/// Where the header's numbers stand in the two versions of the format.
struct Layout {
    std::size_t dim, datatype, pixdim, vox_offset, slope, inter, units, qform, sform, quaternion,
        shift, rows;
};
constexpr Layout version_1{.dim = 40,
                           .datatype = 70,
                           .pixdim = 76,
                           .vox_offset = 108,
                           .slope = 112,
                           .inter = 116,
                           .units = 123,
                           .qform = 252,
                           .sform = 254,
                           .quaternion = 256,
                           .shift = 268,
                           .rows = 280};
constexpr Layout version_2{.dim = 16,
                           .datatype = 12,
                           .pixdim = 104,
                           .vox_offset = 168,
                           .slope = 176,
                           .inter = 184,
                           .units = 500,
                           .qform = 344,
                           .sform = 348,
                           .quaternion = 352,
                           .shift = 376,
                           .rows = 400};

class NiftiHeader {
public:
    static Expected<NiftiHeader> read(std::string bytes) {
        for (const bool big_endian : {false, true}) {
            const auto size = number_at<std::int32_t>(bytes, 0, big_endian);
            if (size == 348 && bytes.size() >= 348)
                return NiftiHeader(std::move(bytes), big_endian, 1);
            if (size == 540 && bytes.size() >= 540)
                return NiftiHeader(std::move(bytes), big_endian, 2);
        }
        return std::unexpected("it does not begin with a header of NIfTI");
    }

    [[nodiscard]] bool big_endian() const { return big_endian_; }
    [[nodiscard]] const Layout& at() const { return version_ == 1 ? version_1 : version_2; }
    [[nodiscard]] std::int64_t dim(std::size_t i) const {
        return version_ == 1 ? number_at<std::int16_t>(bytes_, at().dim + 2 * i, big_endian_)
                             : number_at<std::int64_t>(bytes_, at().dim + 8 * i, big_endian_);
    }
    [[nodiscard]] double real(std::size_t offset, std::size_t i = 0) const {
        if (version_ == 2) return number_at<double>(bytes_, offset + 8 * i, big_endian_);
        return static_cast<double>(number_at<float>(bytes_, offset + 4 * i, big_endian_));
    }
    [[nodiscard]] int whole(std::size_t offset) const {
        return version_ == 1 || offset == version_2.datatype
                   ? number_at<std::int16_t>(bytes_, offset, big_endian_)
                   : number_at<std::int32_t>(bytes_, offset, big_endian_);
    }
    [[nodiscard]] double vox_offset() const {
        if (version_ == 1) return real(at().vox_offset);
        return static_cast<double>(number_at<std::int64_t>(bytes_, at().vox_offset, big_endian_));
    }
    [[nodiscard]] int units() const {
        return version_ == 1 ? static_cast<unsigned char>(bytes_[at().units]) : whole(at().units);
    }
    /// Whether it is of Analyze 7.5, whose header NIfTI's is made from.
    [[nodiscard]] bool is_analyze() const { return version_ == 1 && !magic().starts_with('n'); }
    /// Whether the samples lie in a file of their own.
    [[nodiscard]] bool is_apart() const {
        return is_analyze() || magic() == "ni1" || magic() == "ni2";
    }
    /// Where samples begin at least that lie behind the header.
    [[nodiscard]] double least_offset() const { return version_ == 1 ? 352 : 544; }

private:
    NiftiHeader(std::string bytes, bool big_endian, int version)
        : bytes_(std::move(bytes)), big_endian_(big_endian), version_(version) {}
    [[nodiscard]] std::string_view magic() const {
        return std::string_view(bytes_).substr(version_ == 1 ? 344 : 4, 3);
    }

    std::string bytes_;
    bool big_endian_;
    int version_;
};

std::optional<SampleType> type_of(int code) {
    switch (code) {
        case 2: return SampleType::UInt8;
        case 4: return SampleType::Int16;
        case 8: return SampleType::Int32;
        case 16: return SampleType::Float;
        case 64: return SampleType::Double;
        case 256: return SampleType::Int8;
        case 512: return SampleType::UInt16;
        case 768: return SampleType::UInt32;
        case 1024: return SampleType::Int64;
        case 1280: return SampleType::UInt64;
        default: return std::nullopt;
    }
}

/// Rows of the turn that a quaternion is, b, c and d given.
Matrix3 turn_of(double b, double c, double d) {
    const double rest = 1.0 - (b * b + c * c + d * d);
    const double a = rest > 0 ? std::sqrt(rest) : 0;
    return {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
             {2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b)},
             {2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c}}};
}

double spacing_of(const NiftiHeader& header, std::size_t axis) {
    const double size = std::abs(header.real(header.at().pixdim, axis + 1));
    return size > 0 && std::isfinite(size) ? size : 1.0;
}

/// Method 3 of the format: rows of a map.
Geometry by_rows(const NiftiHeader& header) {
    Geometry geometry;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c)
            geometry.world_from_index[r][c] = header.real(header.at().rows, 4 * r + c);
        geometry.origin[r] = header.real(header.at().rows, 4 * r + 3);
    }
    return geometry;
}

/// Method 2: a quaternion and a shift.
Geometry by_quaternion(const NiftiHeader& header) {
    const Layout& at = header.at();
    const Matrix3 turn = turn_of(header.real(at.quaternion, 0), header.real(at.quaternion, 1),
                                 header.real(at.quaternion, 2));
    const double handed = header.real(at.pixdim, 0) < 0 ? -1.0 : 1.0;
    Geometry geometry;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c)
            geometry.world_from_index[r][c] =
                turn[r][c] * spacing_of(header, c) * (c == 2 ? handed : 1.0);
        geometry.origin[r] = header.real(at.shift, r);
    }
    return geometry;
}

/// Method 1: spacings alone.
Geometry by_spacing(const NiftiHeader& header) {
    Geometry geometry;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c)
            geometry.world_from_index[r][c] = r == c ? spacing_of(header, c) : 0.0;
    }
    return geometry;
}

/// Where SPM and what followed it place volumes of Analyze: x runs to the left; 0 is at the sample
/// that is told, counted from 1, else in the middle.
Geometry of_analyze(const NiftiHeader& header) {
    constexpr std::size_t originator = 253;
    Geometry geometry = by_spacing(header);
    const bool told = header.whole(originator) != 0 || header.whole(originator + 2) != 0 ||
                      header.whole(originator + 4) != 0;
    geometry.world_from_index[0][0] *= -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const double at = told ? header.whole(originator + 2 * i) - 1
                               : (static_cast<double>(header.dim(i + 1)) - 1) / 2;
        geometry.origin[i] = -at * geometry.world_from_index[i][i];
    }
    return geometry;
}

/// Method 3 (sform), else method 2 (qform), else method 1 of the format; in millimetres.
Geometry geometry_of(const NiftiHeader& header) {
    if (header.is_analyze()) return of_analyze(header);
    const Layout& at = header.at();
    Geometry geometry = header.whole(at.sform) > 0   ? by_rows(header)
                        : header.whole(at.qform) > 0 ? by_quaternion(header)
                                                     : by_spacing(header);
    const int unit = header.units() & 7;
    const double millimetres = unit == 1 ? 1e3 : unit == 3 ? 1e-3 : 1.0;
    for (std::size_t r = 0; r < 3; ++r) {
        geometry.origin[r] *= millimetres;
        for (double& m : geometry.world_from_index[r])
            m *= millimetres;
    }
    return geometry;
}

/// The other file of a pair, packed or not: the one of the same name that ends in `ending`, in
/// capitals where the file's own ending is.
Expected<std::filesystem::path> beside(const std::filesystem::path& file,
                                       const std::string& ending) {
    const bool packed = lower_case(file.extension().string()) == ".gz";
    const std::filesystem::path plain =
        packed ? std::filesystem::path(file).replace_extension() : file;
    const std::string own = plain.extension().string();
    if (lower_case(own) != ".hdr" && lower_case(own) != ".img")
        return std::unexpected(
            "its header says that its samples lie in a file of their own: then its name ends in "
            ".hdr");
    std::string other = ending;
    if (own != lower_case(own))
        std::ranges::transform(other, other.begin(), [](char c) {
            return c == '.' ? c : static_cast<char>(c - 'a' + 'A');
        });
    std::filesystem::path wanted = plain;
    wanted.replace_extension(other);
    std::error_code error;
    for (const char* const behind : {"", ".gz", ".GZ"}) {
        std::filesystem::path found = wanted.string() + behind;
        if (std::filesystem::exists(found, error)) return found;
    }
    return std::unexpected("its other file '" + printable(wanted.filename().string()) +
                           "' is not there, nor packed as .gz");
}

/// The file with the header: the file itself, or the one beside it that has the samples.
Expected<std::filesystem::path> header_file_of(const std::filesystem::path& file) {
    const std::string name = lower_case(file.filename().string());
    const bool has_samples = name.ends_with(".img") || name.ends_with(".img.gz");
    return has_samples ? beside(file, ".hdr") : file;
}

Expected<SampleBlock> block_of(const NiftiHeader& header, const std::filesystem::path& file) {
    SampleBlock block{.file = file};
    const std::int64_t dimensions = header.dim(0);
    if (dimensions == 2) {
        const auto size = [&](std::size_t axis) {
            return static_cast<std::uint64_t>(std::max<std::int64_t>(header.dim(axis), 0));
        };
        return std::unexpected(no_volume({size(1), size(2)}));
    }
    if (dimensions < 3 || dimensions > 7)
        return std::unexpected("it has " + std::to_string(dimensions) +
                               " axes; a volume has three");
    for (std::size_t i = 0; i < 3; ++i)
        block.size[i] = static_cast<std::uint64_t>(std::max<std::int64_t>(header.dim(i + 1), 0));
    for (std::int64_t axis = 4; axis <= dimensions; ++axis) {
        if (header.dim(static_cast<std::size_t>(axis)) > 1)
            return std::unexpected(
                "it has several volumes or numbers at each point; a volume has one");
    }
    const int type_code = header.whole(header.at().datatype);
    if (type_code == rgb || type_code == rgba)
        return std::unexpected("its samples are colors; a volume has one number at each point");
    const auto type = type_of(type_code);
    if (!type) {
        return std::unexpected("its samples are of type " + std::to_string(type_code) +
                               " of the format; only single numbers of up to 64 bits are read");
    }
    block.type = *type;
    block.big_endian = header.big_endian();
    double offset = header.vox_offset();
    if (!(offset >= 0) || offset > 1e15)
        return std::unexpected("its 'vox_offset' is no place in it");
    if (header.is_apart()) {
        const auto samples = beside(file, ".img");
        if (!samples) return std::unexpected(samples.error());
        block.file = *samples;
    } else if (offset == 0) {
        offset = header.least_offset();  // where the standard has them begin that it is left out of
    } else if (offset < header.least_offset()) {
        return std::unexpected("its 'vox_offset' is " + short_number(offset) +
                               "; behind its header samples begin at " +
                               short_number(header.least_offset()));
    }
    start_at(block, static_cast<std::uint64_t>(offset));
    return block;
}

}  // namespace

Expected<VolumeFile> read_nifti(const std::filesystem::path& file) {
    const auto header_file = header_file_of(file);
    if (!header_file) return std::unexpected(header_file.error());
    auto bytes = unpacked_start(*header_file, longest_header);
    if (!bytes) return std::unexpected(bytes.error());
    const auto header = NiftiHeader::read(std::move(*bytes));
    if (!header) return std::unexpected(header.error());
    const auto block = block_of(*header, *header_file);
    if (!block) return std::unexpected(block.error());
    auto found = read_samples_of(*header_file, *block);
    if (!found) return std::unexpected(found.error());
    if (*header_file != file) found->files.push_back(FileStamp::now(*header_file));
    VolumeFile volume{.samples = std::move(found->samples),
                      .geometry = geometry_of(*header),
                      .sample_files = std::move(found->files)};
    const double slope = header->real(header->at().slope);
    const double shift = header->is_analyze() ? 0 : header->real(header->at().inter);
    const bool scales = slope != 0 && std::isfinite(slope) && std::isfinite(shift);
    if (!scales || (slope == 1 && shift == 0)) return volume;
    const auto scaled = rescaled(volume.samples, slope, shift);
    if (!scaled) return std::unexpected(scaled.error());
    volume.samples = *scaled;
    return volume;
}

}  // namespace zeroset
