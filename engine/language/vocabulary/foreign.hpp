#pragma once

#include "engine/language/vocabulary/reading.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

// Errors and hints for names and signs of other languages that have no meaning here.

namespace zeroset {

/// The error for a name of something that the language lacks (vectors, noise, commands); nullopt
/// for other names.
std::optional<ParseError> error_for_foreign(std::string_view name, std::size_t offset);

/// A hint for an unknown name: the nearest known name, or the product that was meant.
std::string hint_for_unknown(std::string_view name);

/// A hint for a character without a meaning.
std::string hint_for_sign(char32_t code);

/// The error for a component after a point, such as x in v.x.
ParseError error_for_part(std::string_view part, std::size_t offset);

}  // namespace zeroset
