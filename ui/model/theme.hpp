#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace zeroset::ui {

/// Colours of the window's controls and of what lies behind the picture.
enum class Theme : std::uint8_t { Dark, Light };

/// The theme's name in files and options: "dark" or "light".
std::string_view name_of(Theme theme);
std::optional<Theme> theme_named(std::string_view name);

}  // namespace zeroset::ui
