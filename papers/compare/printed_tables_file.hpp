#pragma once

#include <span>
#include <string_view>

namespace zeroset {

/// The text of papers/compare/printed_tables.json, alone in the list.
std::span<const std::string_view> printed_tables_file();

}  // namespace zeroset
