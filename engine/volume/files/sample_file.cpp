#include "engine/volume/files/sample_file.hpp"

#include "engine/base/parallel.hpp"
#include "engine/base/text.hpp"
#include "engine/real/rounding.hpp"
#include "engine/volume/files/header_text.hpp"
#include "engine/volume/files/mapped_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace zeroset {

std::shared_ptr<std::byte> room_for_samples(std::uint64_t bytes) {
    return {static_cast<std::byte*>(::operator new(bytes, std::align_val_t{64}, std::nothrow)),
            [](std::byte* room) { ::operator delete(room, std::align_val_t{64}); }};
}

std::unexpected<std::string> no_memory_for_samples(std::uint64_t bytes) {
    return std::unexpected("there is no memory for its " + std::to_string(bytes) +
                           " bytes of samples");
}

namespace {

using ReadSamples = std::expected<Samples, std::string>;

std::string of_bytes(std::uint64_t bytes) { return std::to_string(bytes) + " bytes"; }

/// Turns the bytes of each sample around.
void swap_bytes(std::byte* data, std::uint64_t bytes, std::size_t width) {
    if (width == 1) return;
    constexpr std::size_t part = std::size_t{1} << 20U;
    parallel_for((bytes + part - 1) / part, 0, [&](std::size_t i) {
        std::byte* const end = data + std::min<std::uint64_t>(bytes, (i + 1) * part);
        for (std::byte* at = data + i * part; at + width <= end; at += width)
            std::reverse(at, at + width);
    });
}

Samples samples_of(const SampleBlock& block, std::shared_ptr<const void> data) {
    return {.type = block.type, .size = block.size, .data = std::move(data)};
}

bool is_native(const SampleBlock& block) {
    return size_of(block.type) == 1 ||
           block.big_endian == (std::endian::native == std::endian::big);
}

ReadSamples raw(const SampleBlock& block, const std::shared_ptr<const MappedFile>& file,
                std::uint64_t needed) {
    const auto bytes = file->bytes();
    const std::uint64_t offset =
        block.at_end && bytes.size() >= needed ? bytes.size() - needed : block.offset;
    if (offset > bytes.size() || bytes.size() - offset < needed) {
        const std::uint64_t there = bytes.size() - std::min<std::uint64_t>(offset, bytes.size());
        return std::unexpected("it is too short: " + of_bytes(needed) +
                               " of samples are announced, " + of_bytes(there) + " are there");
    }
    const std::byte* const first = bytes.data() + offset;
    const bool aligned = std::bit_cast<std::uintptr_t>(first) % size_of(block.type) == 0;
    if (is_native(block) && aligned) return samples_of(block, {file, first});
    const auto room = room_for_samples(needed);
    if (!room) return no_memory_for_samples(needed);
    // Read, not mapped: mapped pages would count beside the copy.
    std::ifstream stream(block.file, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(offset));
    stream.read(reinterpret_cast<char*>(room.get()), static_cast<std::streamsize>(needed));
    if (!stream) return std::unexpected("it cannot be read to its end");
    if (!is_native(block)) swap_bytes(room.get(), needed, size_of(block.type));
    return samples_of(block, room);
}

/// Unpacks gzip or zlib data step by step.
class Unpacker {
public:
    explicit Unpacker(std::span<const std::byte> packed, PackedAs packing = PackedAs::Zlib)
        : packed_(packed) {
        constexpr int window = 15;  // bits
        const int any_header = window + 32;
        ready_ = inflateInit2(&stream_, packing == PackedAs::Zlib ? any_header : -window) == Z_OK;
    }
    Unpacker(const Unpacker&) = delete;
    Unpacker& operator=(const Unpacker&) = delete;
    ~Unpacker() { inflateEnd(&stream_); }

    /// Fills the room; returns how many bytes there were.
    std::uint64_t fill(std::byte* room, std::uint64_t size) {
        std::uint64_t filled = 0;
        while (ready_ && filled < size) {
            constexpr std::uint64_t most = 1U << 30U;
            if (stream_.avail_in == 0) {
                const auto part = static_cast<uInt>(std::min<std::uint64_t>(most, packed_.size()));
                // NOLINTNEXTLINE(cppcoreguidelines-pro-type-*): zlib takes no const
                stream_.next_in =
                    const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed_.data()));
                stream_.avail_in = part;
                packed_ = packed_.subspan(part);
            }
            const auto wanted = static_cast<uInt>(std::min(most, size - filled));
            stream_.next_out = reinterpret_cast<Bytef*>(room + filled);
            stream_.avail_out = wanted;
            const int state = inflate(&stream_, Z_NO_FLUSH);
            filled += wanted - stream_.avail_out;
            const bool member_ends = state == Z_STREAM_END;
            const bool goes_on = stream_.avail_in > 0 || !packed_.empty();
            if (member_ends && goes_on) {
                ready_ = inflateReset(&stream_) == Z_OK;
            } else if (state != Z_OK || (!goes_on && stream_.avail_out > 0)) {
                ready_ = false;
            }
        }
        return filled;
    }

private:
    std::span<const std::byte> packed_;
    z_stream stream_{};
    bool ready_ = false;
};

ReadSamples unpacked(const SampleBlock& block, const std::shared_ptr<const MappedFile>& file,
                     std::uint64_t needed) {
    const auto packed =
        file->bytes().subspan(std::min<std::uint64_t>(block.offset, file->bytes().size()));
    const std::uint64_t most = packed.size() * best_deflate_ratio;
    if (most < needed || most - needed < std::min(block.skip_unpacked, most)) {
        if (most < needed) {
            return std::unexpected("it is too short: " + of_bytes(needed) +
                                   " of samples are announced, its " + of_bytes(packed.size()) +
                                   " of packed data cannot hold them");
        }
    }
    Unpacker unpacker(packed);
    std::vector<std::byte> skipped(1U << 16U);
    for (std::uint64_t left = block.skip_unpacked; left > 0;) {
        const std::uint64_t part = std::min<std::uint64_t>(left, skipped.size());
        if (unpacker.fill(skipped.data(), part) < part)
            return std::unexpected("its packed data are damaged or cut off");
        left -= part;
    }
    const auto room = room_for_samples(needed);
    if (!room) return no_memory_for_samples(needed);
    const std::uint64_t filled = unpacker.fill(room.get(), needed);
    if (filled < needed) {
        return std::unexpected("its packed data are damaged or cut off: " + of_bytes(needed) +
                               " of samples are announced, " + of_bytes(filled) + " are there");
    }
    if (!is_native(block)) swap_bytes(room.get(), needed, size_of(block.type));
    return samples_of(block, room);
}

template <class Sample>
bool read_number(std::string_view word, Sample& number) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size();
}

ReadSamples written_out(const SampleBlock& block, std::string_view text, std::uint64_t needed) {
    const std::uint64_t count = needed / size_of(block.type);
    // Each number takes a digit and what parts it from the next.
    if (text.size() + 1 < 2 * count) {
        return std::unexpected("it is too short: " + std::to_string(count) +
                               " numbers are announced, its " + of_bytes(text.size()) +
                               " cannot hold them");
    }
    const auto room = room_for_samples(needed);
    if (!room) return no_memory_for_samples(needed);
    Samples samples = samples_of(block, room);
    std::string problem;
    visit_samples(samples, [&](const auto* first) {
        using Sample = std::remove_cvref_t<decltype(*first)>;
        auto* const out = reinterpret_cast<Sample*>(room.get());
        for (std::uint64_t i = 0; i < count && problem.empty(); ++i) {
            constexpr std::string_view spaces = " \t\r\n,";
            text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
            const std::string_view word = text.substr(0, text.find_first_of(spaces));
            text.remove_prefix(word.size());
            if (word.empty()) {
                problem = "it is too short: " + std::to_string(count) + " numbers are announced, " +
                          std::to_string(i) + " are there";
            } else if (!read_number(word, out[i])) {
                problem = "'" + printable(word.substr(0, 20)) + "' is no " +
                          std::string(name_of(block.type));
            }
        }
    });
    if (!problem.empty()) return std::unexpected(problem);
    return samples;
}

std::expected<std::uint64_t, std::string> needed_bytes(const SampleBlock& block) {
    const auto needed = bytes_of(block.size, block.type);
    if (needed && *needed > 0) return *needed;
    return std::unexpected("its sizes " + std::to_string(block.size[0]) + " x " +
                           std::to_string(block.size[1]) + " x " + std::to_string(block.size[2]) +
                           " are no grid");
}

}  // namespace

ReadSamples samples_of_bytes(std::string_view bytes, const SampleBlock& block) {
    const auto needed = needed_bytes(block);
    if (!needed) return std::unexpected(needed.error());
    if (block.encoding == SampleEncoding::Ascii) return written_out(block, bytes, *needed);
    if (bytes.size() < *needed) {
        return std::unexpected("it is too short: " + of_bytes(*needed) +
                               " of samples are announced, " + of_bytes(bytes.size()) +
                               " are there");
    }
    const auto room = room_for_samples(*needed);
    if (!room) return no_memory_for_samples(*needed);
    std::memcpy(room.get(), bytes.data(), *needed);
    if (!is_native(block)) swap_bytes(room.get(), *needed, size_of(block.type));
    return samples_of(block, room);
}

std::optional<std::string> unpacked_bytes(std::string_view packed, std::uint64_t most,
                                          PackedAs packing) {
    constexpr std::uint64_t least_step = std::uint64_t{1} << 16U;
    const auto* const first = reinterpret_cast<const std::byte*>(packed.data());
    Unpacker unpacker({first, packed.size()}, packing);
    std::string bytes;
    try {
        while (bytes.size() < most) {
            const std::uint64_t had = bytes.size();
            const std::uint64_t step = std::min(most - had, std::max(least_step, had));
            bytes.resize(had + step);
            const std::uint64_t filled =
                unpacker.fill(reinterpret_cast<std::byte*>(bytes.data()) + had, step);
            bytes.resize(had + filled);
            if (filled < step) break;
        }
    } catch (const std::bad_alloc&) {
        return std::nullopt;
    }
    return bytes.empty() ? std::nullopt : std::optional(std::move(bytes));
}

void start_at(SampleBlock& block, std::uint64_t start) {
    const bool packed = is_packed(block.file);
    if (packed) block.encoding = SampleEncoding::Gzip;
    (packed ? block.skip_unpacked : block.offset) = start;
}

ReadSamples read_samples(const SampleBlock& block) {
    const auto needed = needed_bytes(block);
    if (!needed) return std::unexpected(needed.error());
    const auto file = MappedFile::open(block.file);
    if (!file) return std::unexpected(file.error());
    switch (block.encoding) {
        case SampleEncoding::Raw: break;
        case SampleEncoding::Gzip: return unpacked(block, *file, *needed);
        case SampleEncoding::Ascii: {
            const auto bytes = (*file)->bytes();
            const auto offset = std::min<std::uint64_t>(block.offset, bytes.size());
            const auto* const text = reinterpret_cast<const char*>(bytes.data());
            return written_out(block, std::string_view(text, bytes.size()).substr(offset), *needed);
        }
    }
    return raw(block, *file, *needed);
}

namespace {

constexpr std::uint64_t samples_at_once = std::uint64_t{1} << 18U;

/// Calls body(first, last) for all stretches of 0 to `count`, on all cores, rounding to nearest.
void each_stretch(std::uint64_t count, auto body) {
    parallel_for((count + samples_at_once - 1) / samples_at_once, 0, [&](std::size_t n) {
        const NearestRounding nearest;
        body(n * samples_at_once, std::min<std::uint64_t>(count, (n + 1) * samples_at_once));
    });
}

/// Whether all samples times `slope` plus `shift` are floats, as computed in double.
bool fit_floats(const Samples& samples, double slope, double shift) {
    std::atomic<bool> fit = true;
    visit_samples(samples, [&](const auto* in) {
        each_stretch(samples.count(), [&](std::uint64_t first, std::uint64_t last) {
            for (std::uint64_t i = first; i < last && fit; ++i) {
                const double value = static_cast<double>(in[i]) * slope + shift;
                if (std::isfinite(value) && static_cast<double>(static_cast<float>(value)) != value)
                    fit = false;
            }
        });
    });
    return fit;
}

template <class Number>
Samples rescaled_to(const Samples& samples, double slope, double shift, SampleType type) {
    const auto room = room_for_samples(samples.count() * sizeof(Number));
    if (!room) return {};
    auto* const out = reinterpret_cast<Number*>(room.get());
    visit_samples(samples, [&](const auto* in) {
        each_stretch(samples.count(), [&](std::uint64_t first, std::uint64_t last) {
            for (std::uint64_t i = first; i < last; ++i)
                out[i] = static_cast<Number>(static_cast<double>(in[i]) * slope + shift);
        });
    });
    return {.type = type, .size = samples.size, .data = room};
}

}  // namespace

ReadSamples rescaled(const Samples& samples, double slope, double shift) {
    const bool floats = fit_floats(samples, slope, shift);
    Samples result = floats ? rescaled_to<float>(samples, slope, shift, SampleType::Float)
                            : rescaled_to<double>(samples, slope, shift, SampleType::Double);
    if (!result.data) {
        return no_memory_for_samples(samples.count() *
                                     size_of(floats ? SampleType::Float : SampleType::Double));
    }
    return result;
}

}  // namespace zeroset
