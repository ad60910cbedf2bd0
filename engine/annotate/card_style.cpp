#include "engine/annotate/card_style.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zeroset {

CardStyle card_style_for(int width_px, int height_px, TextWidth width) {
    constexpr double usual_side = 800.0;
    constexpr double small_side = 300.0;
    const double side = std::min(width_px, height_px);
    const double least = side < small_side ? 0.75 : 1.0;
    const double scale = std::clamp(std::round(4.0 * side / usual_side) / 4.0, least, 8.0);
    // Letters such as x are whole pixels high, so that they are sharp above and below.
    constexpr double em_at_1 = 12.0 / line_height_em;
    constexpr double x_height_em = 0.547;
    return {.colors = cards_on_dark,
            .unit = std::round(14.0 * scale),
            .em = std::round(x_height_em * em_at_1 * scale) / x_height_em,
            .width = std::move(width)};
}

}  // namespace zeroset
