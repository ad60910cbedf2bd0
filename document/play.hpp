#pragma once

#include "document/document.hpp"

namespace zeroset {

/// A slider that plays: its place between the steps, and which way it goes.
struct Playing {
    double place = 0.0;  ///< from lo (0) to hi (1), before it is rounded to a step
    bool forward = true;
};

/// The play of a slider from its value on.
Playing started(const Slider& slider);
/// Moves `playing` on by `elapsed_s` and sets the slider's value.
void advance(Slider& slider, Playing& playing, double elapsed_s);

/// The value on the slider's steps that is nearest, within its ends; the value itself where the
/// slider has no steps.
double on_step(const Slider& slider, double value);

}  // namespace zeroset
