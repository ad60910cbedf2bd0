#pragma once

#include "document/json/json_fields.hpp"

namespace zeroset {

/// The region as the document's field `region`.
Json json_of(const Region& region);
/// The region from that field. Throws Damage; names of unknown fields are added to `unknown`.
Region region_of(const Json& json, std::vector<std::string>& unknown);

}  // namespace zeroset
