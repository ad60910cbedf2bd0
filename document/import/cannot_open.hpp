#pragma once

#include <expected>
#include <filesystem>
#include <string>

namespace zeroset {

/// The error of a file or folder that is not opened, for this reason: one line.
std::unexpected<std::string> cannot_open(const std::filesystem::path& path,
                                         const std::string& reason);

}  // namespace zeroset
