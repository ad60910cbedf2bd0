#include "ui/model/theme.hpp"

#include "engine/base/enum_names.hpp"

namespace zeroset::ui {
namespace {

constexpr auto names = enum_names<Theme>("dark", "light");

}  // namespace

std::string_view name_of(Theme theme) { return names.of(theme); }
std::optional<Theme> theme_named(std::string_view name) { return names.named(name); }

}  // namespace zeroset::ui
