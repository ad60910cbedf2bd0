#include "document/play.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {

double on_step(const Slider& slider, double value) {
    if (!(slider.step > 0.0)) return value;
    const double steps = std::round((value - slider.lo) / slider.step);
    const double last = std::floor((slider.hi - slider.lo) / slider.step * (1.0 + 1e-12));
    return slider.lo + std::clamp(steps, 0.0, last) * slider.step;
}

PlayState started(const Slider& slider) {
    const double place = (slider.value - slider.lo) / (slider.hi - slider.lo);
    return {.place = std::clamp(place, 0.0, 1.0), .forward = true};
}

void advance(Slider& slider, PlayState& playing, double elapsed_s) {
    double way = elapsed_s * slider.speed / seconds_per_range;
    if (slider.repeat == Repeat::Loop) {
        playing.place += way;
        playing.place -= std::floor(playing.place);
    } else {
        // Forth and back make a round of length 2.
        way += playing.forward ? playing.place : 2.0 - playing.place;
        way -= 2.0 * std::floor(0.5 * way);
        playing = {.place = way <= 1.0 ? way : 2.0 - way, .forward = way <= 1.0};
    }
    slider.value = on_step(slider, std::lerp(slider.lo, slider.hi, playing.place));
}

}  // namespace zeroset
