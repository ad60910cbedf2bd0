#pragma once

#include "engine/base/enum_names.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace zeroset::ui {

/// Colours of the window's controls and of what lies behind the picture.
enum class Theme : std::uint8_t { Dark, Light };

/// The names of themes in files and options.
inline constexpr auto theme_names = enum_names<Theme>("dark", "light");
constexpr std::string_view name_of(Theme theme) { return theme_names.of(theme); }
constexpr std::optional<Theme> theme_named(std::string_view name) {
    return theme_names.named(name);
}

}  // namespace zeroset::ui
