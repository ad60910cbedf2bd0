#pragma once

#include "app/formula.hpp"
#include "engine/trace/render_job.hpp"

#include <atomic>

namespace zeroset {

/// Whether machine code for the formula takes less time than it saves in one picture. `picture` is
/// of its interpreters; a small picture is drawn with them, and its evaluations are counted: what
/// comes out depends neither on the number of threads nor on the machine's load, unless the small
/// picture takes 100 ms.
bool machine_code_pays(const RenderRequest& picture, const Formula& formula,
                       const std::atomic<bool>* cancel);

/// The code that is made and has drawn one picture of this size soonest.
CodeUse use_in_one_picture(int width, int height);

}  // namespace zeroset
