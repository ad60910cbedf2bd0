#pragma once

namespace zeroset {

/// Adds the algorithms of papers to the table of tracers (engine/render/tracers.hpp), behind those
/// that are there. Called once, before anyone asks for a tracer.
void add_paper_tracers();

}  // namespace zeroset
