#pragma once

#include <expected>
#include <string>
#include <string_view>

namespace zeroset {

/// The XML of a package's root model: that which its relationships tell, else the first one in it.
/// The error is one line.
std::expected<std::string, std::string> model_of_package(std::string_view bytes);

}  // namespace zeroset
