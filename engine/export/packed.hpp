#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

enum class Packing : std::uint8_t { Small, Quick };

/// The text deflated with a zlib header [RFC 1950]. Equal texts make equal bytes.
std::vector<std::uint8_t> packed(std::string_view text, Packing packing = Packing::Small);

/// The text that packed() made these bytes of; nullopt where they are damaged, or where the text is
/// longer than 64 MiB.
std::optional<std::string> unpacked(std::span<const std::uint8_t> bytes);

}  // namespace zeroset
