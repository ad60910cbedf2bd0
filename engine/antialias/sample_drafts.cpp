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

RayRoot& SampleDrafts::begin(const CoverSquare& square, double share, Certificate certificate) {
    CoverSample& sample = samples_.emplace_back();
    sample.pixel = square.pixel;
    sample.surface = surface_;
    sample.certificate = certificate;
    sample.area = static_cast<float>(share * square.area);
    return roots_.emplace_back();
}

void SampleDrafts::add(const CoverSquare& square, double share, const RayRoot& root) {
    begin(square, share, Certificate::Certified) = root;
}

void SampleDrafts::add(const CoverSquare& square, const SquareRay& place, double share, double from,
                       double to, Certificate certificate) {
    unknown_.push_back(static_cast<std::uint32_t>(roots_.size()));
    RayRoot& root = begin(square, share, certificate);
    root.col = SquareField::col_of(square, place);
    root.row = SquareField::row_of(square, place);
    root.from = from;
    root.to = to;
    root.several = true;
}

void SampleDrafts::add(const CoverSquare& square, const Front& front) {
    add(square, square.middle(), square.share(), front.at, front.to, Certificate::Certified);
    roots_.back().several = !front.monotone;
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

void SampleDrafts::add_parts(const CoverSquare& square, const Front& sheet) {
    const int across = 1 << (square.least_level - square.level);
    const double side = 2.0 / across;
    const auto middle_of = [&](int part) { return (part + 0.5) * side - 1.0; };
    for (int row = 0; row < across; ++row) {
        for (int col = 0; col < across; ++col)
            add(square.ray({.x = middle_of(col), .y = middle_of(row)}, 0.25 * side * side), sheet);
    }
}

void SampleDrafts::write(const TraceFrame& frame, const TileRays& rays,
                         std::vector<CoverSample>& out, Counters& counters) {
    find_roots(frame, rays, roots_, unknown_, counters);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const RayRoot& root = roots_[i];
        CoverSample& sample = samples_[i];
        sample.col = static_cast<float>(root.col);
        sample.row = static_cast<float>(root.row);
        sample.distance =
            static_cast<float>(rays.distance_at(root.s, rays.u(root.col), rays.v(root.row)));
        sample.gradient = float_gradient({root.gradient.x, root.gradient.y, root.gradient.z});
    }
    out.insert(out.end(), samples_.begin(), samples_.end());
}

}  // namespace zeroset
