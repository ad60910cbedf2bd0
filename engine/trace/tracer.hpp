#pragma once

#include "engine/trace/tile.hpp"
#include "engine/trace/tile_hits.hpp"
#include "engine/trace/trace_frame.hpp"

#include <memory>
#include <string_view>

namespace zeroset {

class Expr;

/// The things that an algorithm asks for beside the functions of a kernel. Some of papers do, none
/// of the product's own.
struct TracerNeeds {
    /// Finds in a surface's formula what is needed, and keeps it in Kernel::memory. Called before
    /// each frame; machine code is wanted where there is such of the kernel. Any thread.
    void (*read_formula)(const Kernel& kernel, const Expr& surface, bool by_machine_code) = nullptr;
    /// Makes what belongs to a surface rather than to a view of it, on so many threads (0: all
    /// cores), or finds it where a frame before has left it (Kernel::memory); nullptr where `limit`
    /// is over. Called once for a frame; the kernel is the whole one.
    std::shared_ptr<const PreparedSurface> (*prepare)(const TraceFrame& surface,
                                                      int threads) = nullptr;
    /// Why it cannot draw a surface: one line, to be translated; nullptr: it can. What it refuses
    /// it leaves undecided. No function: it draws all formulas.
    const char* (*refuses)(const Kernel& surface) = nullptr;
    /// The finest d_stop, where that is beyond max_d_stop and called levels; 0: it is not.
    int levels = 0;
};

/// A way to find the first root on each ray. A new tracer is a new row of `tracers()`
/// (engine/render/tracers.hpp): camera, kernels, shading and framebuffer are shared.
struct Tracer {
    std::string_view name;
    std::string_view about;  ///< one line
    /// One surface, one tile. Called in upward rounding, from many threads at once. `hits` is
    /// clear. When stopped it ends soon; rays that were not searched to their end are unsettled.
    void (*trace_tile)(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                       Counters& counters);
    /// Whether it is quicker with specialized kernels than with machine code of many choices.
    bool specializes = false;
    bool takes_open_space = false;  ///< knows of TraceFrame::open
    bool takes_unions = false;      ///< knows of TraceFrame::union_members
    /// Asks the way of a surface's kind first (engine/trace/ways), so that it draws those, too,
    /// that are no level sets.
    bool takes_ways = false;
    bool finds_jumps = false;  ///< knows of Scene::jumps
    /// Whether it certifies roots and rays without any; else all it says is undecided, and where it
    /// shows nothing there may be a root.
    bool proves = true;
    TracerNeeds needs = {};
};

}  // namespace zeroset
