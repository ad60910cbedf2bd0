#pragma once

#include "engine/trace/time_limit.hpp"

namespace zeroset {

/// How work on a mesh is done. Where it is cancelled, what is returned is of no use but can be gone
/// on with. When the time is over, work that can be left out is.
struct MeshWork {
    int threads = 0;  ///< 0: all cores
    TimeLimit limit = {};
};

}  // namespace zeroset
