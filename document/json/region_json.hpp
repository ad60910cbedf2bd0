#pragma once

#include "document/json/json_fields.hpp"

namespace zeroset {

/// The document's field `region`.
Json json_of(const Region& region);
/// Throws Damage; what it does not know is added to `unknown`.
Region region_of(const Json& json, std::vector<std::string>& unknown);

}  // namespace zeroset
