#pragma once

#include "document/document.hpp"

namespace zeroset {

/// The state of a playing slider: its place between the ends, and its direction.
struct PlayState {
    double place = 0.0;  ///< from lo (0) to hi (1), before it is rounded to a step
    bool forward = true;
};

/// The state of a slider that begins to play at its value.
PlayState started(const Slider& slider);
/// Moves `playing` on by `elapsed_s` and sets the slider's value.
void advance(Slider& slider, PlayState& playing, double elapsed_s);

/// The nearest value on the slider's steps within its ends; `value` itself where it has no steps.
double on_step(const Slider& slider, double value);

}  // namespace zeroset
