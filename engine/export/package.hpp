#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The bytes of a package of 3MF that holds this model, an XML text; the error is one line.
std::expected<std::vector<std::byte>, std::string> package_of_3mf(const std::string& model);

/// A colour of red, green and blue as "#RRGGBB".
std::string hex_of(const std::array<std::uint8_t, 3>& color);

/// The text as XML has it between tags or quotes.
std::string xml_escaped(std::string_view text);

}  // namespace zeroset
