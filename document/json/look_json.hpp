#pragma once

#include "document/json/json_fields.hpp"
#include "document/look.hpp"

#include <string>
#include <vector>

// Conversions of the fields "color", "section_values" and "markers" of a document. Reading throws
// Damage.

namespace zeroset {

Json json_of(const ColorChoice& coloring);
ColorChoice coloring_of(const Json& json, std::vector<std::string>& unknown);

Json json_of(const SectionChoice& values);
SectionChoice section_choice_of(const Json& json, std::vector<std::string>& unknown);

Json json_of(const std::vector<Marker>& markers);
std::vector<Marker> markers_of(const Json& json, std::vector<std::string>& unknown);

}  // namespace zeroset
