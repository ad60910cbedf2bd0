#pragma once

#include "engine/language/vocabulary/reading.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

// What to answer to names and signs of other languages that have no meaning here.

namespace zeroset {

/// What is wrong with a name that belongs to what is not read: vectors, noise, commands.
std::optional<ParseError> error_for_foreign(std::string_view name, std::size_t offset);

/// The hint for a name that is not known: the nearest known one, or the product that was meant.
std::string hint_for_unknown(std::string_view name);

/// The hint for a character without a meaning.
std::string hint_for_sign(char32_t code);

/// What is wrong with the part of a value that stands behind a point, such as hf or x.
ParseError error_for_part(std::string_view part, std::size_t offset);

}  // namespace zeroset
