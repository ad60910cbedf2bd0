// The structure of boxes in image space [Florez08, sec. 5.4]: coherence of rays by beams.
//   Xs, Ys    a box of the image, and with the eye a beam of rays
//   T         a stretch of all rays of the beam
//   fR(Xs, Ys, T)   the interval extension of f over the beam in T
//   Meet      the meet of fR(Xs, Ys, t) at the ends t of all T so far
//   TFinal    where the first roots of a box's rays are
// A box is rejected where 0 is outside fR in each T, and included where Meet shows that f changes
// its sign on every ray (figure 5.10); T is bisected, front to back, down to epsilon_T = 1e-3. Else
// the box is bisected. Rays of rejected boxes are not traced, those of included ones in TFinal,
// those of undefined ones in their whole T: by MRFro
// (papers/along_rays/mrfro.cpp).
//
// Differs from the thesis:
// - Boxes begin with tiles of 64 x 64 pixels and end with 8 x 8 (the thesis: with 1/32 of the
//   screen, as follows from its tables), and many are looked at together, for the kernels.
// - fR is taken over the box about the beam's part, rounded outward.
// - Ends t that are known are not evaluated again. Those count where all rays of the beam are in
//   what is shown, and only together with a proof that f is continuous between them; a pole passes
//   for a change of sign in the thesis.
// - TFinal is from the first T that is not rejected to the first end behind the change of sign: the
//   thesis takes bounds of fR at the ends for depths.
// - A box says where rays are traced, not how many: the thesis takes one ray a pixel in included
//   boxes, nine in undefined ones.
// - The root finder is not named there; the times without boxes are those of MRFro in table 4.1
//   (Gumdrop torus 545 and 541 s, sphere 53 and 48 s).
// - Shadow beams (section 5.4.4) are left out: shadows are the program's own.

#include "engine/base/clock.hpp"
#include "papers/along_rays/mrfro.hpp"
#include "papers/along_rays/ray_search.hpp"
#include "papers/florez/box_tally.hpp"
#include "papers/florez/florez_tracers.hpp"
#include "papers/florez/image_boxes.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace zeroset {
namespace {

ImageBoxCounters::Kind& kind_of(ImageBox::Kind kind, ImageBoxCounters& counters) {
    switch (kind) {
        case ImageBox::Kind::Rejected: return counters.rejected;
        case ImageBox::Kind::Included: return counters.included;
        case ImageBox::Kind::Undefined: break;
    }
    return counters.undefined;
}

void count(const std::vector<ImageBox>& boxes, ImageBoxCounters& counters) {
    for (const ImageBox& box : boxes)
        kind_of(box.kind, counters) +=
            {.boxes = 1,
             .pixels = static_cast<std::uint64_t>(box.cols) * static_cast<std::uint64_t>(box.rows)};
}

/// Leaves the rays of one kind of boxes, in their T.
void keep_rays_of(ImageBox::Kind kind, const std::vector<ImageBox>& boxes, RayLines& lines) {
    std::vector<const ImageBox*> box_of(std::size_t{tile_size} * tile_size);
    for (const ImageBox& box : boxes) {
        for (int row = box.row; row < box.row + box.rows; ++row) {
            for (int col = box.col; col < box.col + box.cols; ++col)
                box_of[static_cast<std::size_t>(row * tile_size + col)] = &box;
        }
    }
    lines.keep_if([&](std::uint32_t pixel, RayLine& line) {
        const ImageBox& box = *box_of[pixel];
        if (box.kind != kind) return false;
        if (kind == ImageBox::Kind::Undefined) return true;
        line.from = std::max(line.from, box.from);
        line.to = std::min(line.to, box.to);
        return line.from <= line.to;
    });
}

template <class Real>
struct BoxMemory {
    RayMemory<Real> rays;
    ImageBoxes<Real> boxes;
};

/// Traces the rays of one kind of boxes.
template <class Real>
void trace_rays_of(ImageBox::Kind kind, const std::vector<ImageBox>& boxes, const TraceFrame& frame,
                   const Tile& tile, const TileRays& rays, TileHits& hits, Counters& counters,
                   ImageBoxCounters& tally, RayMemory<Real>& memory) {
    if (std::ranges::find(boxes, kind, &ImageBox::kind) == boxes.end()) return;
    const auto start = std::chrono::steady_clock::now();
    memory.field.begin(frame, tile, rays, counters);
    keep_rays_of(kind, boxes, memory.field.lines);
    MrfRo<Real> method(memory.field);
    RaySearch<Real, MrfRo<Real>>(rays, hits, memory, method).run();
    kind_of(kind, tally).ms += ms_since(start);
}

void trace_tile(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters,
                BoxTests tests) {
    in_precision(frame, [&](auto real) {
        using Real = decltype(real);
        thread_local const auto kept = std::make_unique<BoxMemory<Real>>();
        BoxMemory<Real>& memory = *kept;
        const TileRays rays(frame, tile);
        const auto start = std::chrono::steady_clock::now();
        const std::vector<ImageBox>& boxes = memory.boxes.find(frame, tile, rays, tests, counters);
        ImageBoxCounters tally;
        tally.ms = ms_since(start);
        count(boxes, tally);
        for (const auto kind : {ImageBox::Kind::Included, ImageBox::Kind::Undefined})
            trace_rays_of(kind, boxes, frame, tile, rays, hits, counters, tally, memory.rays);
        frame.kernel.memory->of<BoxTally>()->add(tally);
    });
}

}  // namespace

void trace_tile_florez_boxes(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                             Counters& counters) {
    trace_tile(frame, tile, hits, counters, BoxTests::RejectionAndInclusion);
}

void trace_tile_florez_trimming(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                                Counters& counters) {
    trace_tile(frame, tile, hits, counters, BoxTests::Rejection);
}

}  // namespace zeroset
