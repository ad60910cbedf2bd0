#include "engine/volume/files/dicom_rle.hpp"

#include "engine/volume/files/sample_file.hpp"

#include <algorithm>
#include <cstdint>
#include <new>
#include <optional>
#include <vector>

// Each slice is a fragment: 64 bytes of a header, then a segment for each byte of a sample, the
// highest first, packed as PackBits does.

namespace zeroset {
namespace {

constexpr std::size_t header_bytes = 64;

std::unexpected<std::string> damaged_samples() {
    return std::unexpected(std::string("its packed samples are damaged or cut off"));
}

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    return number_at<std::uint32_t>(bytes, at, false);
}

/// The fragments, the first of which tells offsets; nothing where they do not end.
std::optional<std::vector<std::string_view>> fragments_of(std::string_view items) {
    constexpr std::string_view item("\xfe\xff\x00\xe0", 4);
    constexpr std::string_view end("\xfe\xff\xdd\xe0", 4);
    constexpr std::size_t head = 8;
    std::vector<std::string_view> fragments;
    while (items.size() >= head) {
        if (items.starts_with(end)) return fragments;
        const std::size_t length = word_at(items, 4);
        if (!items.starts_with(item) || length > items.size() - head) return std::nullopt;
        fragments.push_back(items.substr(head, length));
        items.remove_prefix(head + length);
    }
    return std::nullopt;
}

/// Unpacks a segment to every `step`-th byte from `to` on; whether it has `count` of them.
bool unpack_segment(std::string_view packed, std::size_t count, char* to, std::size_t step) {
    std::size_t done = 0;
    for (std::size_t at = 0; at < packed.size() && done < count;) {
        const auto control = static_cast<unsigned char>(packed[at++]);
        constexpr unsigned nothing = 128;
        if (control == nothing) continue;
        const bool repeats = control > nothing;
        const std::size_t run = repeats ? 257U - control : control + 1U;
        if (run > count - done || (repeats ? 1 : run) > packed.size() - at) return false;
        for (std::size_t n = 0; n < run; ++n)
            to[(done + n) * step] = packed[repeats ? at : at + n];
        at += repeats ? 1 : run;
        done += run;
    }
    return done == count;
}

bool unpack_slice(std::string_view fragment, std::size_t count, std::size_t bytes, char* to) {
    if (fragment.size() < header_bytes || word_at(fragment, 0) != bytes) return false;
    for (std::size_t segment = 0; segment < bytes; ++segment) {
        const std::size_t from = word_at(fragment, 4 * (segment + 1));
        const std::size_t end =
            segment + 1 < bytes ? word_at(fragment, 4 * (segment + 2)) : fragment.size();
        if (from < header_bytes || from > end || end > fragment.size()) return false;
        const std::string_view packed = fragment.substr(from, end - from);
        if (!unpack_segment(packed, count, to + (bytes - 1 - segment), bytes)) return false;
    }
    return true;
}

}  // namespace

Expected<std::string> unpacked_rle(std::string_view items, const GridSize& size,
                                   std::size_t bytes) {
    const auto fragments = fragments_of(items);
    if (!fragments || fragments->empty()) return damaged_samples();
    if (fragments->size() - 1 != size[2]) {
        return std::unexpected("it announces " + std::to_string(size[2]) + " slices, but has " +
                               std::to_string(fragments->size() - 1) + " packed ones");
    }
    constexpr std::uint64_t best_ratio = 64;  // two bytes become 128
    const std::uint64_t count = size[0] * size[1];
    const std::uint64_t slice = count * bytes;
    for (std::size_t k = 1; k < fragments->size(); ++k) {
        if (slice > best_ratio * (*fragments)[k].size()) return damaged_samples();
    }
    try {
        std::string samples(slice * size[2], '\0');
        for (std::size_t k = 0; k < size[2]; ++k) {
            if (!unpack_slice((*fragments)[k + 1], count, bytes, samples.data() + k * slice))
                return damaged_samples();
        }
        return samples;
    } catch (const std::bad_alloc&) {
        return no_memory_for_samples(slice * size[2]);
    }
}

}  // namespace zeroset
