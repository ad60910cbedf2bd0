#pragma once

#include "app/formula.hpp"
#include "engine/trace/render_job.hpp"

#include <atomic>
#include <span>

namespace zeroset {

/// Whether machine code for the surfaces, which are drawn as `drawn`, takes less time than it saves
/// in one picture. `picture` has their interpreters; a small picture is drawn with them, and its
/// evaluations are counted: what comes out depends neither on the machine's load nor on the number
/// of threads.
bool machine_code_pays(const RenderRequest& picture, std::span<const Expr> drawn,
                       const std::atomic<bool>* cancel);

/// The code that is made and has drawn one picture of this size soonest.
CodeUse use_in_one_picture(int width, int height);

}  // namespace zeroset
