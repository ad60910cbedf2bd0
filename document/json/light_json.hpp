#pragma once

#include "document/json/json_fields.hpp"
#include "document/look.hpp"

#include <cstdint>
#include <string>
#include <vector>

// Conversions of the field "light" of a document, and of colours. Reading throws Damage.

namespace zeroset {

std::uint32_t color_of(const Json& json, const std::string& place);
/// One colour, or those of the top and the bottom.
Background background_of(const Json& json, const std::string& place);
Json json_of(const Background& background);

Look look_in(const Json& json, const std::string& place);

Json json_of(const LightChoice& light);
LightChoice light_choice_of(const Json& json, std::vector<std::string>& unknown);

}  // namespace zeroset
