#pragma once

#include "document/json/json_fields.hpp"
#include "document/views.hpp"
#include "engine/view/camera.hpp"

#include <string>
#include <vector>

// Conversions of the fields "camera", "home" and "views" of a document. Reading throws Damage.

namespace zeroset {

Json json_of(const Camera& camera);
Camera camera_of(const Json& json, const std::string& place, std::vector<std::string>& unknown);

Json json_of(const std::vector<SavedView>& views);
std::vector<SavedView> views_of(const Json& json, std::vector<std::string>& unknown);

}  // namespace zeroset
