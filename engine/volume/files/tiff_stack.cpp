// Stacks of pictures in a TIFF file (Adobe, TIFF 6.0, 1992), as microscopes and ImageJ write them:
// a page for each slice, or one page and the others' samples behind it.

#include "engine/base/text.hpp"
#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/mapped_file.hpp"
#include "engine/volume/files/sample_file.hpp"
#include "engine/volume/files/tiff_pages.hpp"
#include "engine/volume/files/volume_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::uint64_t plain = 1, adobe_deflate = 8, old_deflate = 32946;

std::optional<SampleType> tiff_type(std::uint64_t bits, std::uint64_t format) {
    constexpr std::uint64_t no_sign = 1, with_sign = 2, real = 3;
    if (format == no_sign) {
        if (bits == 8) return SampleType::UInt8;
        if (bits == 16) return SampleType::UInt16;
        if (bits == 32) return SampleType::UInt32;
    }
    if (format == with_sign) {
        if (bits == 8) return SampleType::Int8;
        if (bits == 16) return SampleType::Int16;
        if (bits == 32) return SampleType::Int32;
    }
    if (format == real && bits == 32) return SampleType::Float;
    if (format == real && bits == 64) return SampleType::Double;
    return std::nullopt;
}

/// The number behind "KEY=" in a line of ImageJ's description, or of an attribute of OME's.
std::optional<double> told(const std::string& description, const std::string& key) {
    if (description.contains("<OME")) {
        const std::string start = " " + key + "=\"";
        const std::size_t at = description.find(start);
        if (at == std::string::npos) return std::nullopt;
        const std::size_t from = at + start.size();
        return number_from<double>(
            std::string_view(description).substr(from, description.find('"', from) - from));
    }
    if (!description.starts_with("ImageJ=")) return std::nullopt;
    for (const std::string_view line : split(description, '\n')) {
        if (line.starts_with(key) && line.substr(key.size()).starts_with("="))
            return number_from<double>(line.substr(key.size() + 1));
    }
    return std::nullopt;
}

/// Why a page is not read, or nothing.
std::string wrong_page(const TiffPage& page) {
    if (page.number(TiffTag::SamplesPerPixel, 1) != 1)
        return "it has " + std::to_string(page.number(TiffTag::SamplesPerPixel, 1)) +
               " numbers at each point: colors; a volume has one";
    const std::uint64_t packing = page.number(TiffTag::Compression, plain);
    if (packing != plain && packing != adobe_deflate && packing != old_deflate) {
        return "it is packed in way " + std::to_string(packing) +
               " of the format; plain and deflated pages are read: save it so in the program that "
               "wrote it";
    }
    if (page.number(TiffTag::Predictor, 1) != 1) return "its samples are written as differences";
    if (!page.all(TiffTag::TileWidth).empty())
        return "its pages are cut into tiles; strips are read";
    return {};
}

class TiffStack {
public:
    TiffStack(std::string_view bytes, std::filesystem::path file)
        : bytes_(bytes), block_{.file = std::move(file)} {}

    Expected<VolumeFile> read() {
        auto read = read_tiff_pages(bytes_);
        if (!read) return std::unexpected(read.error());
        pages_ = std::move(read->pages);
        block_.big_endian = read->big_endian;
        if (auto problem = check(); !problem.empty()) return std::unexpected(problem);
        const auto page_bytes = bytes_of({block_.size[0], block_.size[1], 1}, block_.type);
        if (!page_bytes || *page_bytes == 0) return std::unexpected("its pages have no samples");
        if (is_one_run(*page_bytes)) return one_run();
        // Pages may name the same bytes; none are gathered that the file cannot hold.
        const bool is_packed = std::ranges::any_of(pages_, [](const TiffPage& page) {
            return page.number(TiffTag::Compression, plain) != plain;
        });
        const std::uint64_t most = bytes_.size() * (is_packed ? best_deflate_ratio : 1);
        if (*page_bytes > most / pages_.size()) {
            return std::unexpected("it is too short for its " + std::to_string(pages_.size()) +
                                   " pages");
        }
        std::string all;
        for (std::size_t n = 0; n < pages_.size(); ++n) {
            const std::size_t before = all.size();
            if (!add(pages_[n], before + *page_bytes, all) || all.size() < before + *page_bytes) {
                return std::unexpected("its page " + std::to_string(n + 1) +
                                       " is damaged or cut off");
            }
            all.resize(before + *page_bytes);
        }
        const auto samples = samples_of_bytes(all, block_);
        if (!samples) return std::unexpected(samples.error());
        return VolumeFile{.samples = *samples, .geometry = geometry()};
    }

private:
    /// Takes what the pages must agree in; what is wrong, or nothing.
    std::string check() {
        const TiffPage& first = pages_.front();
        const auto kind = [](const TiffPage& page) {
            return std::array{
                page.number(TiffTag::ImageWidth, 0), page.number(TiffTag::ImageLength, 0),
                page.number(TiffTag::BitsPerSample, 1), page.number(TiffTag::SampleFormat, 1)};
        };
        for (const TiffPage& page : pages_) {
            if (auto problem = wrong_page(page); !problem.empty()) return problem;
            if (kind(page) != kind(first)) return "its pages have several sizes or types";
        }
        for (const char* const name : {"channels", "frames", "SizeC", "SizeT"}) {
            if (told(first.description, name).value_or(1) > 1)
                return std::string("it has several ") + name +
                       "; a volume has one number at each point";
        }
        const auto [width, height, bits, format] = kind(first);
        const auto type = tiff_type(bits, format);
        if (!type) {
            return "its samples have " + std::to_string(bits) +
                   " bits; 8, 16, 32 and floats are read";
        }
        const double images = told(first.description, "images").value_or(1);
        constexpr double most = 1U << 20U;
        const bool is_run = pages_.size() == 1 && images > 1 && images <= most &&
                            first.number(TiffTag::Compression, plain) == plain;
        if (pages_.size() == 1 && !is_run) return no_volume({width, height});
        block_.size = {width, height, is_run ? static_cast<std::uint64_t>(images) : pages_.size()};
        block_.type = *type;
        return {};
    }
    /// Whether all samples follow each other as they are: then they may stay in the file.
    [[nodiscard]] bool is_one_run(std::uint64_t page_bytes) const {
        if (pages_.size() == 1) return true;
        std::uint64_t next = pages_.front().number(TiffTag::StripOffsets, 0);
        for (const TiffPage& page : pages_) {
            if (page.number(TiffTag::Compression, plain) != plain) return false;
            const auto offsets = page.all(TiffTag::StripOffsets);
            const auto counts = page.all(TiffTag::StripByteCounts);
            const std::uint64_t end = next + page_bytes;
            for (std::size_t i = 0; i < std::min(offsets.size(), counts.size()); ++i) {
                if (offsets[i] != next) return false;
                next += counts[i];
            }
            if (next != end) return false;
        }
        return true;
    }
    /// Samples that follow each other; as ImageJ has stacks beyond 4 GB, with one page alone.
    Expected<VolumeFile> one_run() {
        block_.offset = pages_.front().number(TiffTag::StripOffsets, 0);
        if (block_.offset == 0) return std::unexpected("its page 1 is damaged or cut off");
        const auto samples = read_samples(block_);
        if (!samples) return std::unexpected(samples.error());
        return VolumeFile{.samples = *samples, .geometry = geometry()};
    }
    /// Adds a page's bytes, up to `most` in all; false where they are not there.
    bool add(const TiffPage& page, std::size_t most, std::string& all) const {
        const auto offsets = page.all(TiffTag::StripOffsets);
        const auto counts = page.all(TiffTag::StripByteCounts);
        if (offsets.empty() || offsets.size() != counts.size()) return false;
        for (std::size_t i = 0; i < offsets.size() && all.size() < most; ++i) {
            if (offsets[i] > bytes_.size() || counts[i] > bytes_.size() - offsets[i]) return false;
            const std::string_view strip = bytes_.substr(offsets[i], counts[i]);
            if (page.number(TiffTag::Compression, plain) == plain) {
                all += strip.substr(0, most - all.size());
                continue;
            }
            const auto unpacked = unpacked_bytes(strip, most - all.size());
            if (!unpacked) return false;
            all += *unpacked;
        }
        return true;
    }
    /// In the unit of ImageJ or OME, where they tell one; else samples are 1 apart.
    [[nodiscard]] Geometry geometry() const {
        const TiffPage& first = pages_.front();
        Geometry geometry;
        const auto set = [&](std::size_t axis, double spacing) {
            if (spacing > 0 && std::isfinite(spacing))
                geometry.world_from_index[axis][axis] = spacing;
        };
        const auto step = [&](TiffTag tag, const char* name) {
            const auto found = first.fractions.find(tag);
            const bool is_imagej = first.description.starts_with("ImageJ=");
            return is_imagej && found != first.fractions.end()
                       ? 1 / found->second
                       : told(first.description, name).value_or(1);
        };
        set(0, step(TiffTag::XResolution, "PhysicalSizeX"));
        set(1, step(TiffTag::YResolution, "PhysicalSizeY"));
        set(2, told(first.description, "spacing")
                   .value_or(told(first.description, "PhysicalSizeZ").value_or(1)));
        return geometry;
    }

    std::string_view bytes_;
    std::vector<TiffPage> pages_;
    SampleBlock block_;
};

}  // namespace

Expected<VolumeFile> read_tiff_stack(const std::filesystem::path& file) {
    const auto mapped = MappedFile::open(file);
    if (!mapped) return std::unexpected(mapped.error());
    const auto bytes = (*mapped)->bytes();
    return TiffStack({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file).read();
}

}  // namespace zeroset
