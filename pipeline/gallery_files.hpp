#pragma once

#include <span>
#include <string_view>

namespace zeroset {

/// The text of each file of resources/gallery, in the order of their names.
std::span<const std::string_view> gallery_files();

}  // namespace zeroset
