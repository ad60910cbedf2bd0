#pragma once

#include "engine/render/render_request.hpp"
#include "pipeline/formula.hpp"

#include <atomic>
#include <optional>

namespace zeroset {

/// Returns the machine code that, compilation included, finishes this one picture soonest, or
/// nothing if the interpreters do; `picture` must use their code. Draws a small picture with them
/// and counts its evaluations. The answer depends neither on the number of threads nor on the
/// machine's load, unless the small picture takes 100 ms.
std::optional<CodeUse> code_for_one(const RenderRequest& picture, const Formula& formula,
                                    const std::atomic<bool>* cancel);

}  // namespace zeroset
