#include "engine/trace/blobs/ball_bins.hpp"

#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

namespace zeroset {
namespace {

void for_each_column(BinColumns<float>& a, BinColumns<double>& b, const auto& visit) {
    visit(a.x, b.x);
    visit(a.y, b.y);
    visit(a.z, b.z);
    visit(a.per_square, b.per_square);
    visit(a.strength, b.strength);
}

struct Indices {
    std::size_t first, last;
};
/// The bins along an axis of the image that places between two pixels may be in.
Indices bins_between(double from, double to) {
    constexpr double reach = 0.5 + 2 * BallBins::margin;
    const auto index = [](double pixel) {
        const double at = std::floor((pixel + 0.5) / BallBins::side);
        return static_cast<std::size_t>(
            std::clamp(at, 0.0, static_cast<double>(BallBins::across - 1)));
    };
    if (!(to >= -reach && from <= tile_size - 1 + reach)) return {.first = 1, .last = 0};
    return {.first = index(from - 2 * BallBins::margin), .last = index(to + 2 * BallBins::margin)};
}

}  // namespace

void BallBins::begin(const TraceFrame& frame, const Tile& tile, const BlobSurface& surface) {
    rays_.emplace(frame, tile);
    first_u_ = rays_->u(0);
    first_v_ = rays_->v(0);
    per_pixel_ = 1 / rays_->pixel();
    for (Listed& listed : bins_) {
        listed.balls.clear();
        listed.packed = 0;
    }
    balls_.clear();
    // Bound the rays somewhat beyond all pixels.
    const double half = 0.5 + 2 * margin;
    const NearBalls::Rays whole{.u = rays_->u(0.5 * (tile.cols - 1)),
                                .v = rays_->v(0.5 * (tile.rows - 1)),
                                .u_radius = (0.5 * (tile.cols - 1) + half) * rays_->pixel(),
                                .v_radius = (0.5 * (tile.rows - 1) + half) * rays_->pixel(),
                                .from = 0,
                                .to = 0};
    const double u_most = std::abs(whole.u) + whole.u_radius;
    const double v_most = std::abs(whole.v) + whole.v_radius;
    longest_ = std::sqrt(1 + u_most * u_most + v_most * v_most);
    const DepthRange inside = rays_->depths(whole.u, whole.v, whole.u_radius, whole.v_radius);
    found_to_ = from_ = to_ = inside.enter_lo;
    if (inside.empty()) {
        found_to_ = unbounded;
        return;
    }
    // Widen the depths: cells are a little longer than the stretches they stand for.
    const double spare = rays_->pixel() * (rays_->distance() + std::max(std::abs(inside.enter_lo),
                                                                        std::abs(inside.exit_hi)));
    from_ = inside.enter_lo - spare;
    to_ = inside.exit_hi + spare;
    found_to_ = from_;
    NearBalls::Rays of = whole;
    of.from = from_;
    of.to = to_;
    const Blobs& blobs = *surface.blobs;
    near_.begin(blobs.set(), blob_facts(blobs.kind()).reach, *rays_, of);
}

/// Lists the balls of the next slab; false: there are none.
bool BallBins::find_more() {
    if (found_to_ == unbounded) return false;
    const bool more = near_.next();
    found_to_ = more ? near_.to() : unbounded;
    if (!more) return false;
    for (const ViewBall& ball : near_.fresh()) {
        balls_.push_back(ball);
        put(static_cast<std::uint32_t>(balls_.size() - 1));
    }
    return true;
}

/// Lists a ball in the bins whose rays it may reach.
void BallBins::put(std::uint32_t number) {
    const ViewBall& ball = balls_[number];
    const double w = rays_->distance() + ball.z;
    const double reach = (1 + 0x1p-40) * ball.support * longest_;
    Indices cols{.first = 0, .last = across - 1};
    Indices rows = cols;
    // Rays that the ball reaches have |x - u w| <= reach.
    if (w > reach) {
        cols = bins_between(col((ball.x - reach) / w), col((ball.x + reach) / w));
        rows = bins_between(row((ball.y + reach) / w), row((ball.y - reach) / w));
    }
    for (std::size_t i = rows.first; i <= rows.last; ++i) {
        for (std::size_t j = cols.first; j <= cols.last; ++j)
            bins_[i * across + j].balls.push_back(number);
    }
}

const BallBin& BallBins::bin(std::size_t index, double until) {
    while (found_to_ < until && find_more()) {
    }
    Listed& listed = bins_[index];
    if (listed.packed < listed.balls.size() || listed.balls.empty())
        pack(listed, index % across, index / across);
    return listed.bin;
}

/// Writes a bin's columns.
void BallBins::pack(Listed& listed, std::size_t col, std::size_t row) {
    BallBin& bin = listed.bin;
    bin.u = rays_->u(middle_of(col));
    bin.v = rays_->v(middle_of(row));
    std::ranges::sort(listed.balls, {},
                      [&](std::uint32_t number) { return balls_[number].from(); });
    const std::size_t count = listed.balls.size();
    listed.packed = count;
    bin.count = count;
    for_each_column(bin.floats, bin.doubles, [&](auto& floats, auto& doubles) {
        floats.resize(count);
        doubles.resize(count);
    });
    bin.from.resize(count);
    bin.to.resize(count);
    bin.depth = count == 0 ? 0 : balls_[listed.balls.front()].z;
    bin.most_support = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const ViewBall& ball = balls_[listed.balls[i]];
        bin.most_support = std::max(bin.most_support, ball.support);
        const double w = rays_->distance() + ball.z;
        const double z = ball.z - bin.depth;
        // Widen the reach by more than these floats are rounded.
        const double support = ball.support + 0x1p-20 * (std::abs(z) + ball.support);
        bin.from[i] = static_cast<float>(z - support);
        bin.to[i] = static_cast<float>(z + support);
        bin.doubles.x[i] = ball.x - bin.u * w;
        bin.doubles.y[i] = ball.y - bin.v * w;
        bin.doubles.z[i] = z;
        bin.doubles.per_square[i] = ball.per_square;
        bin.doubles.strength[i] = ball.strength;
    }
    for_each_column(bin.floats, bin.doubles, [&](auto& floats, auto& doubles) {
        std::ranges::transform(doubles, floats.begin(),
                               [](double x) { return static_cast<float>(x); });
    });
}

/// Whether a ball may reach a ray of a pixel.
bool BallBins::may_reach(const ViewBall& ball, int col, int row) const {
    const double w = rays_->distance() + ball.z;
    const double reach = (1 + 0x1p-40) * ball.support * longest_;
    const double half = (0.5 + margin) * rays_->pixel() * std::abs(w);
    return std::abs(ball.x - rays_->u(col) * w) <= reach + half &&
           std::abs(ball.y - rays_->v(row) * w) <= reach + half;
}

double BallBins::first_depth(int col, int row) {
    double first = unbounded;
    const auto& listed = bins_[place_of(row) * across + place_of(col)];
    std::size_t seen = 0;
    do {
        for (; seen < listed.balls.size(); ++seen) {
            const ViewBall& ball = balls_[listed.balls[seen]];
            if (ball.from() < first && may_reach(ball, col, row)) first = ball.from();
        }
    } while (found_to_ < first && find_more());
    return first;
}

BallBins& thread_ball_bins() {
    thread_local const auto kept = std::make_unique<BallBins>();
    BallBins& bins = *kept;
    return bins;
}

}  // namespace zeroset
