#pragma once

#include "engine/expr/expr.hpp"
#include "engine/trace/render_job.hpp"

#include <atomic>
#include <span>

namespace zeroset {

/// Whether machine code for the surfaces, which are drawn as `drawn`, takes less time than it saves
/// in one picture. `picture` has their interpreters; a small picture is drawn with them, and its
/// evaluations are counted: what comes out does not depend on the time of day, nor on the number of
/// threads.
bool machine_code_pays(const RenderRequest& picture, std::span<const Expr> drawn,
                       const std::atomic<bool>* cancel);

}  // namespace zeroset
