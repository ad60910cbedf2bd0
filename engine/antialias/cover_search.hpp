#pragma once

#include "engine/antialias/cover_sample.hpp"
#include "engine/trace/tile.hpp"
#include "engine/trace/trace_frame.hpp"

#include <span>
#include <vector>

namespace zeroset {

/// Finds what pixels show, part by part [Florez08, sec. 5.5.2], and adds samples to `out`. A part
/// of a pixel that no sample stands for shows the background. Takes those from `pixels` that one
/// smooth sheet covers after all: their own hits stand for them. Ends early when the frames' limit
/// is over: then nothing is said of some pixels. In upward rounding.
void find_cover(std::span<const TraceFrame> surfaces, const Tile& tile,
                std::vector<MixedPixel>& pixels, std::vector<CoverSample>& out, Counters& counters);

}  // namespace zeroset
