#pragma once

#include "engine/volume/samples.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset {

enum class SampleEncoding : std::uint8_t { Raw, Gzip, Ascii };

/// Where the samples of a grid lie in a file.
struct SampleBlock {
    std::filesystem::path file;
    std::uint64_t offset = 0;         ///< in bytes; in unpacked bytes for Gzip with `skip_unpacked`
    std::uint64_t skip_unpacked = 0;  ///< Gzip: bytes to leave out at the start of what is unpacked
    bool at_end = false;              ///< Raw: they are the file's last bytes; `offset` is ignored
    SampleEncoding encoding = SampleEncoding::Raw;
    SampleType type = SampleType::Float;
    bool big_endian = false;
    GridSize size{};
};

/// Lets a block's samples begin at this byte: of what is unpacked, where its file is packed by
/// gzip.
void start_at(SampleBlock& block, std::uint64_t start);

/// Reads a block: raw samples in this machine's byte order are mapped, others copied. Nothing is
/// allocated before the file is known to be long enough. An error is one line that begins with what
/// the file lacks, without its name.
std::expected<Samples, std::string> read_samples(const SampleBlock& block);

/// Room for samples, aligned for every type; nullptr where there is no memory for them.
std::shared_ptr<std::byte> room_for_samples(std::uint64_t bytes);
/// The error of a grid that there is no room for.
std::unexpected<std::string> no_memory_for_samples(std::uint64_t bytes);

/// A packed byte is at most so many bytes.
inline constexpr std::uint64_t best_deflate_ratio = 1032;

/// The samples that are these bytes, or with SampleEncoding::Ascii these words; the block's file
/// and offsets are ignored.
std::expected<Samples, std::string> samples_of_bytes(std::string_view bytes,
                                                     const SampleBlock& block);

enum class PackedAs : std::uint8_t {
    Zlib,    ///< with the header of gzip or zlib
    Deflate  ///< without one
};
/// The bytes that zlib packed, at most `most` of them; nothing where they are damaged or more.
std::optional<std::string> unpacked_bytes(std::string_view packed, std::uint64_t most,
                                          PackedAs packing = PackedAs::Zlib);

/// The samples times `slope` plus `shift`, as computed in double: as float32 where all of them are
/// such numbers, else as float64. The error is that there is no memory for them.
std::expected<Samples, std::string> rescaled(const Samples& samples, double slope, double shift);

}  // namespace zeroset
