#pragma once

#include "engine/scene/precision.hpp"
#include "engine/trace/trace_frame.hpp"

namespace zeroset {

/// Calls `work` with a number of the type in which the frame is traced, 0.0F or 0.0: decltype of
/// its parameter is that type.
decltype(auto) in_precision(const TraceFrame& frame, auto&& work) {
    return frame.precision == Precision::Double ? work(0.0) : work(0.0F);
}

}  // namespace zeroset
