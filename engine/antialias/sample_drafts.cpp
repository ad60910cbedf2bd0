#include "engine/antialias/sample_drafts.hpp"

#include "engine/antialias/square_field.hpp"
#include "engine/trace/tile_hits.hpp"

namespace zeroset {

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
    const int parts = 1 << pixel.least_level;
    const double side = 1.0 / parts;
    Front sheet;
    sheet.at = static_cast<double>(pixel.from);
    sheet.to = static_cast<double>(pixel.sheet_to);
    sheet.monotone = true;
    for (int row = 0; row < parts; ++row) {
        for (int col = 0; col < parts; ++col) {
            const CoverSquare part{.pixel = pixel.pixel,
                                   .level = pixel.least_level,
                                   .col = (col + 0.5) * side - 0.5,
                                   .row = (row + 0.5) * side - 0.5,
                                   .side = side,
                                   .area = side * side};
            add(part, sheet);
        }
    }
}

void SampleDrafts::write(const TraceFrame& frame, const TileRays& rays,
                         std::vector<CoverSample>& out, Counters& counters) const {
    std::vector<RayRoot> roots;
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
