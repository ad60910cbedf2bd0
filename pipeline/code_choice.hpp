#pragma once

#include "engine/render/render_job.hpp"
#include "pipeline/formula.hpp"

#include <atomic>
#include <optional>

namespace zeroset {

/// The code that is made and has drawn one picture soonest; nothing: the interpreters, of which
/// `picture` is. A small picture is drawn with them, and its evaluations are counted: what comes
/// out depends neither on the number of threads nor on the machine's load, unless the small picture
/// takes 100 ms.
std::optional<CodeUse> code_for_one(const RenderRequest& picture, const Formula& formula,
                                    const std::atomic<bool>* cancel);

}  // namespace zeroset
