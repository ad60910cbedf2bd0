#pragma once

#include "document/json/json_fields.hpp"
#include "document/look.hpp"
#include "document/views.hpp"
#include "engine/view/camera.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace zeroset {

// Conversions of the fields "camera", "home" and "views" of a document. Reading throws Damage.

Json json_of(const Camera& camera);
/// A stretch of a camera (engine/view/camera.hpp).
glm::dvec3 stretch_of(const Json& json, const std::string& place);
Camera camera_of(const Json& json, const std::string& place, std::vector<std::string>& unknown);

Json json_of(const std::vector<SavedView>& views);
std::vector<SavedView> views_of(const Json& json, std::vector<std::string>& unknown);

// Conversions of the field "light" of a document, and of colours. Reading throws Damage.

std::uint32_t color_of(const Json& json, const std::string& place);
/// One colour, or those of the top and the bottom.
Background background_of(const Json& json, const std::string& place);
Json json_of(const Background& background);

Look look_in(const Json& json, const std::string& place);

Json json_of(const LightChoice& light);
LightChoice light_choice_of(const Json& json, std::vector<std::string>& unknown);

// Conversions of the fields "color", "section_values" and "markers" of a document. Reading throws
// Damage.

Json json_of(const ColorChoice& coloring);
ColorChoice coloring_of(const Json& json, std::vector<std::string>& unknown);

Json json_of(const SectionChoice& values);
SectionChoice section_choice_of(const Json& json, std::vector<std::string>& unknown);

Json json_of(const std::vector<Marker>& markers);
std::vector<Marker> markers_of(const Json& json, std::vector<std::string>& unknown);

/// The region as the document's field `region`.
Json json_of(const Region& region);
/// The region from that field. Throws Damage; names of unknown fields are added to `unknown`.
Region region_of(const Json& json, std::vector<std::string>& unknown);

}  // namespace zeroset
