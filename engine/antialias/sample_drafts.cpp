#include "engine/antialias/sample_drafts.hpp"

#include "engine/antialias/square_field.hpp"
#include "engine/trace/tile_hits.hpp"

#include <array>

namespace zeroset {
namespace {

/// Places in a pixel, in halves of its side: each in a row and a column of its own, so that edges
/// along rows and columns, too, leave eight shares to tell apart.
constexpr std::array<SquareRay, 8> sheet_places{{{.x = 0.125, .y = -0.375},
                                                 {.x = -0.125, .y = 0.375},
                                                 {.x = 0.625, .y = 0.125},
                                                 {.x = -0.375, .y = -0.625},
                                                 {.x = -0.625, .y = 0.625},
                                                 {.x = -0.875, .y = -0.125},
                                                 {.x = 0.375, .y = 0.875},
                                                 {.x = 0.875, .y = -0.875}}};

}  // namespace

void SampleDrafts::add(const CoverSquare& square, double share, const RayRoot& root) {
    drafts_.push_back({.sample = {.pixel = square.pixel,
                                  .surface = surface_,
                                  .certificate = Certificate::Certified,
                                  .area = static_cast<float>(share * square.area),
                                  .col = static_cast<float>(root.col),
                                  .row = static_cast<float>(root.row),
                                  .distance = 0.0F,
                                  .gradient = {}},
                       .root = root,
                       .is_known = true});
}

void SampleDrafts::add(const CoverSquare& square, const SquareRay& place, double share, double from,
                       double to, Certificate certificate) {
    add(square, share,
        {.col = SquareField::col_of(square, place),
         .row = SquareField::row_of(square, place),
         .from = from,
         .to = to,
         .several = true});
    drafts_.back().sample.certificate = certificate;
    drafts_.back().is_known = false;
}

void SampleDrafts::add(const CoverSquare& square, const Front& front) {
    add(square, square.middle(), square.share(), front.at, front.to, Certificate::Certified);
    drafts_.back().root.several = !front.monotone;
}

void SampleDrafts::add(const MixedPixel& pixel) {
    Front sheet;
    sheet.at = static_cast<double>(pixel.from);
    sheet.to = static_cast<double>(pixel.sheet_to);
    sheet.monotone = true;
    for (const SquareRay& place : sheet_places) {
        const CoverSquare part{.pixel = pixel.pixel,
                               .level = pixel.least_level,
                               .col = 0.5 * place.x,
                               .row = 0.5 * place.y,
                               .side = 0.0,
                               .area = 1.0 / sheet_places.size()};
        add(part, sheet);
    }
}

void SampleDrafts::write(const TraceFrame& frame, const TileRays& rays,
                         std::vector<CoverSample>& out, Counters& counters) const {
    std::vector<RayRoot> roots;
    roots.reserve(drafts_.size());
    out.reserve(out.size() + drafts_.size());
    for (const Draft& draft : drafts_) {
        if (!draft.is_known) roots.push_back(draft.root);
    }
    find_roots(frame, rays, roots, counters);
    auto next = roots.begin();
    for (const Draft& draft : drafts_) {
        const RayRoot& root = draft.is_known ? draft.root : *next++;
        CoverSample sample = draft.sample;
        sample.distance =
            static_cast<float>(rays.distance_at(root.s, rays.u(root.col), rays.v(root.row)));
        sample.gradient = float_gradient({root.gradient.x, root.gradient.y, root.gradient.z});
        out.push_back(sample);
    }
}

}  // namespace zeroset
