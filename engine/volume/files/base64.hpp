#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace zeroset {

/// The bytes of base64, in lines or not, of parts that end in padding; nothing where another
/// character is in it.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace zeroset
