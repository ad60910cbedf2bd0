#include "app/gallery/thumbnail_cache.hpp"

#include "engine/export/file.hpp"
#include "engine/export/png.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

namespace fs = std::filesystem;
using Checksum = std::array<std::byte, sizeof(std::uint64_t)>;

/// FNV-1a; `hash` is the value to continue from.
std::uint64_t hash_of(std::span<const std::byte> bytes, std::uint64_t hash = 0xCBF29CE484222325U) {
    for (const std::byte byte : bytes)
        hash = (hash ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001B3U;
    return hash;
}

std::uint64_t hash_of(const std::string& text) { return hash_of(std::as_bytes(std::span(text))); }

/// Checksum over key and picture, so that a file under a wrong name is found out, too.
Checksum checksum(const std::string& key, std::span<const std::byte> png) {
    return std::bit_cast<Checksum>(hash_of(png, hash_of(key)));
}

std::vector<std::byte> bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

}  // namespace

ThumbnailCache::ThumbnailCache(std::optional<fs::path> folder) : folder_(std::move(folder)) {}

fs::path ThumbnailCache::file_of(const std::string& key) const {
    std::array<char, 24> name{};
    std::snprintf(name.data(), name.size(), "%016llx.png",
                  static_cast<unsigned long long>(hash_of(key)));
    return folder_.value_or(fs::path()) / name.data();
}

std::optional<RgbaImage> ThumbnailCache::find(const std::string& key) const {
    if (!folder_) return std::nullopt;
    const std::vector<std::byte> bytes = bytes_of(file_of(key));
    if (bytes.size() < sizeof(Checksum)) return std::nullopt;
    const auto png = std::span(bytes).first(bytes.size() - sizeof(Checksum));
    const Checksum expected = checksum(key, png);
    if (!std::equal(expected.begin(), expected.end(), bytes.end() - sizeof(Checksum))) {
        return std::nullopt;
    }
    return image_from_png(png);
}

void ThumbnailCache::keep(const std::string& key, const RgbaImage& image) const {
    if (!folder_) return;
    std::vector<std::byte> bytes = png_of(image);
    const Checksum sum = checksum(key, bytes);
    bytes.insert(bytes.end(), sum.begin(), sum.end());
    std::error_code ignored;
    fs::create_directories(*folder_, ignored);
    (void)write_file(file_of(key), bytes);
}

}  // namespace zeroset
