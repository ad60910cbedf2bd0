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

/// The known name that an unknown one is near to; nullopt: it is near to none.
std::optional<std::string> nearest_known_name(std::string_view name);

/// A likely word in place of an unknown name: the known one that it is near, or a product.
std::optional<Mend> mend_for_unknown(const std::string& name);

/// A hint for an unknown name: the nearest known name, or the product that was meant.
std::string hint_for_unknown(std::string_view name);

/// A hint for an unknown name that is called as a function.
std::string hint_for_unknown_function(std::string_view name);

/// A hint for a function that the text is to define.
std::string hint_to_define(std::string_view function);

/// A hint for a character without a meaning.
std::string hint_for_sign(char32_t code);

/// The error for a component after a point, such as x in v.x.
ParseError error_for_part(std::string_view part, std::size_t offset);

}  // namespace zeroset
