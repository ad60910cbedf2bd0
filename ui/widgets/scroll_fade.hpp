#pragma once

#include <cstdint>

namespace zeroset::ui {

/// Lets what the current window cuts at its upper and lower edge fade into `back`, the color behind
/// it, so that no line of letters ends in its middle. To be called last in a window that scrolls.
void draw_scroll_fade(std::uint32_t back);

}  // namespace zeroset::ui
