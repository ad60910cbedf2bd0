#include "ui/model/edited.hpp"

#include "engine/base/enum_names.hpp"

namespace zeroset::ui {
namespace {

constexpr auto uses = enum_names<WheelUse>("zoom", "orbit", "pan");

}  // namespace

std::string_view name_of(WheelUse use) { return uses.of(use); }
std::optional<WheelUse> wheel_use_named(std::string_view name) { return uses.named(name); }

}  // namespace zeroset::ui
