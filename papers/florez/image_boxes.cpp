#include "papers/florez/image_boxes.hpp"

#include "engine/real/scalar.hpp"
#include "engine/trace/tile_costs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

/// The smallest boxes: the thesis's have some 9 pixels a side, 1/32 of the screen.
constexpr int smallest_side = 8;
/// epsilon_T = 1e-3, "the results obtained are good" [Florez08, sec. 5.4.2].
constexpr int finest_halving = 10;

}  // namespace

template <class Real>
const std::vector<ImageBox>& ImageBoxes<Real>::find(const TraceFrame& frame, const Tile& tile,
                                                    const TileRays& rays, BoxTests tests,
                                                    Counters& counters) {
    frame_ = &frame;
    rays_ = &rays;
    tests_ = tests;
    margin_ = rays.depth_error();
    finest_ = std::ldexp(rays.extent(), -finest_halving);
    boxes_.clear();
    beams_.clear();
    add({.col = 0, .row = 0, .cols = tile.cols, .rows = tile.rows});
    while (!beams_.empty()) {
        if (frame.stopped()) {
            for (const Beam& beam : beams_)
                boxes_.push_back(beam.box);
            break;
        }
        const std::size_t count = std::min(beams_.size(), most_boxes);
        taken_.assign(beams_.end() - static_cast<std::ptrdiff_t>(count), beams_.end());
        beams_.resize(beams_.size() - count);
        ranges_size_ = 0;
        for (Beam& beam : taken_) {
            const std::size_t before = ranges_size_;
            ask(beam);
            const ImageBox& box = beam.box;
            if (counters.costs != nullptr)
                counters.costs->add(box.col, box.row, box.cols, box.rows,
                                    static_cast<double>(ranges_size_ - before));
        }
        counters.range += ranges_size_;
        ranges_.pad(ranges_size_);
        frame.kernel.template range<Real>(
            ranges_.batch(padded(ranges_size_), frame.scene.uniforms.template boxes<Real>()));
        for (Beam& beam : taken_)
            take(beam);
    }
    return boxes_;
}

template <class Real>
void ImageBoxes<Real>::add(const ImageBox& box) {
    Beam beam;
    beam.box = box;
    beam.u = rays_->u(box.col + TileRays::middle_of(box.cols));
    beam.v = rays_->v(box.row + TileRays::middle_of(box.rows));
    beam.u_radius = TileRays::middle_of(box.cols) * rays_->pixel();
    beam.v_radius = TileRays::middle_of(box.rows) * rays_->pixel();
    const DepthRange inside = rays_->depths(beam.u, beam.v, beam.u_radius, beam.v_radius);
    beam.from = inside.enter_lo - margin_;
    const double to = inside.exit_hi + margin_;
    if (!(beam.from <= to)) return finish(beam, ImageBox::Kind::Rejected);
    beam.seen_from = inside.enter_hi + margin_;
    beam.seen_to = inside.exit_lo - margin_;
    beam.from_sign = EndSign::NotAsked;
    beam.count = 1;
    beam.ends[0] = {.at = to};
    beams_.push_back(beam);
}

/// Adds the box about the part of a beam between two depths, as far as it is in the clip box; its
/// number. At a depth the beam is the hull of its four corners.
template <class Real>
std::size_t ImageBoxes<Real>::push(const Beam& beam, double from, double to) {
    const std::size_t i = ranges_size_++;
    const ViewFrame& axes = rays_->axes();
    for (int axis = 0; axis < 3; ++axis) {
        const double across = beam.u * axes.right[axis] + beam.v * axes.up[axis];
        const double aside =
            beam.u_radius * std::abs(axes.right[axis]) + beam.v_radius * std::abs(axes.up[axis]);
        double lo = std::numeric_limits<double>::infinity();
        double hi = -lo;
        for (const double s : {from, to}) {
            const double middle = rays_->base()[axis] + rays_->distance() * across +
                                  s * (axes.forward[axis] + across);
            const double radius = std::abs(rays_->distance() + s) * aside;
            lo = std::min(lo, middle - radius);
            hi = std::max(hi, middle + radius);
        }
        const auto shown = [&](double place) {
            return std::clamp(place, rays_->clip().lo[axis] - margin_,
                              rays_->clip().hi[axis] + margin_);
        };
        ranges_.ends[axis][i] = upper_end(Real{}, -shown(lo - margin_));
        ranges_.ends[axis + 3][i] = upper_end(Real{}, shown(hi + margin_));
    }
    return i;
}

template <class Real>
void ImageBoxes<Real>::ask(Beam& beam) {
    const End& end = beam.ends[beam.count - 1];
    beam.range = push(beam, beam.from, end.at);
    beam.from_range = no_range;
    beam.to_range = no_range;
    if (tests_ == BoxTests::Rejection) return;
    const auto is_seen = [&](double s) { return beam.seen_from <= s && s <= beam.seen_to; };
    if (beam.from_sign == EndSign::NotAsked && is_seen(beam.from))
        beam.from_range = push(beam, beam.from, beam.from);
    if (end.sign == EndSign::NotAsked && is_seen(end.at))
        beam.to_range = push(beam, end.at, end.at);
}

template <class Real>
EndSign ImageBoxes<Real>::sign(std::size_t range) const {
    if (range == no_range) return EndSign::Unknown;
    return static_cast<EndSign>(static_cast<int>(ranges_.f_neg_lo[range] < 0) -
                                static_cast<int>(ranges_.f_hi[range] < 0));
}

/// Whether the meet of f at the ends of all stretches so far, as far as they are not passed, shows
/// a change of sign on every ray; then `box.to` becomes the first end behind it.
template <class Real>
bool ImageBoxes<Real>::is_included(Beam& beam) const {
    bool is_above = beam.from_sign == EndSign::Above;
    bool is_below = beam.from_sign == EndSign::Below;
    for (std::size_t i = beam.count; i > 0; --i) {
        const End& end = beam.ends[i - 1];
        if (!end.is_continuous) return false;
        is_above |= end.sign == EndSign::Above;
        is_below |= end.sign == EndSign::Below;
        if (!is_above || !is_below) continue;
        beam.box.to = end.at;
        return true;
    }
    return false;
}

template <class Real>
void ImageBoxes<Real>::take(Beam& beam) {
    End& end = beam.ends[beam.count - 1];
    if (beam.from_sign == EndSign::NotAsked) beam.from_sign = sign(beam.from_range);
    if (end.sign == EndSign::NotAsked) end.sign = sign(beam.to_range);
    if (ranges_.excludes_zero(beam.range)) {
        beam.from = end.at;
        beam.from_sign = end.sign;
        --beam.count;
        if (beam.count == 0) return finish(beam, ImageBox::Kind::Rejected);
        beams_.push_back(beam);
        return;
    }
    end.is_continuous |= ranges_.continuous[beam.range] != 0;
    if (tests_ == BoxTests::RejectionAndInclusion && is_included(beam))
        return finish(beam, ImageBox::Kind::Included);
    const double middle = 0.5 * beam.from + 0.5 * end.at;
    const bool is_narrow = end.at - beam.from < finest_ || !(beam.from < middle && middle < end.at);
    if (is_narrow || beam.count == most_stretches) return finish(beam, ImageBox::Kind::Undefined);
    beam.ends[beam.count++] = {.at = middle};
    beams_.push_back(beam);
}

/// Keeps a box, or divides it where nothing is proved.
template <class Real>
void ImageBoxes<Real>::finish(Beam& beam, ImageBox::Kind kind) {
    ImageBox& box = beam.box;
    box.kind = kind;
    box.from = beam.from;
    const int longest = std::max(box.cols, box.rows);
    if (kind != ImageBox::Kind::Undefined || longest <= smallest_side) {
        boxes_.push_back(box);
        return;
    }
    ImageBox first{.col = box.col, .row = box.row, .cols = box.cols, .rows = box.rows};
    ImageBox second = first;
    if (box.cols == longest) {
        first.cols = box.cols / 2;
        second.cols -= first.cols;
        second.col += first.cols;
    } else {
        first.rows = box.rows / 2;
        second.rows -= first.rows;
        second.row += first.rows;
    }
    add(first);
    add(second);
}

template class ImageBoxes<float>;
template class ImageBoxes<double>;

}  // namespace zeroset
