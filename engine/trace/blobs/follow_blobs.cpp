// Stretches of parallel rays through soft balls: blocks of them go through slabs of depth as those
// of pixels do (blob_tile.cpp), but begin and end where they like, and are anywhere in the view.

#include "engine/real/unbounded.hpp"
#include "engine/trace/blobs/blob_surface.hpp"
#include "engine/trace/blobs/blob_way.hpp"
#include "engine/trace/blobs/slab_balls.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace zeroset {
namespace {

/// A rectangle of rays, and the depths that they look at.
struct BallReach {
    double u_lo = unbounded, u_hi = -unbounded, v_lo = unbounded, v_hi = -unbounded;
    double from = unbounded, to = -unbounded;

    void add(const FollowedRay& ray) {
        u_lo = std::min(u_lo, ray.u);
        u_hi = std::max(u_hi, ray.u);
        v_lo = std::min(v_lo, ray.v);
        v_hi = std::max(v_hi, ray.v);
        from = std::min(from, ray.from);
        to = std::max(to, ray.to);
    }
    void add(const BallReach& other) {
        if (other.empty()) return;
        add({.u = other.u_lo, .v = other.v_lo, .from = other.from, .to = other.to});
        add({.u = other.u_hi, .v = other.v_hi, .from = other.from, .to = other.to});
    }
    [[nodiscard]] bool empty() const { return !(from < to); }
    [[nodiscard]] double u() const { return 0.5 * (u_lo + u_hi); }
    [[nodiscard]] double v() const { return 0.5 * (v_lo + v_hi); }
    /// A little more than half of the sides, for what rounding makes of the middle.
    [[nodiscard]] double u_radius() const { return radius(u_lo, u_hi); }
    [[nodiscard]] double v_radius() const { return radius(v_lo, v_hi); }

private:
    static double radius(double lo, double hi) {
        return 0.5 * (hi - lo) + 0x1p-50 * (std::abs(lo) + std::abs(hi));
    }
};

/// A block on its way.
struct Block {
    FollowedRays* rays;
    BallReach reach;
    std::array<bool, ray_block_rays> open{};  ///< rays that have not ended
    BallBlock::Numbers at{};                  ///< no root is before
    std::array<std::int8_t, ray_block_rays> side{};
    bool any_open = false;
};

/// Memory that a thread keeps.
struct FollowScratch {
    SlabBalls slab;
    BallBlock block;
    std::vector<Block> blocks;
};

class Follower {
public:
    Follower(const TraceFrame& frame, const TileRays& rays, const BlobSurface& surface,
             double bracket, FollowScratch& scratch, Counters& counters)
        : frame_(frame),
          rays_(rays),
          surface_(surface),
          bracket_(bracket),
          scratch_(scratch),
          counters_(counters),
          per_distance_(1 / rays.distance()) {}

    void run(std::span<FollowedRays> blocks);

private:
    /// Sets up the blocks; returns how far they reach.
    BallReach begin(std::span<FollowedRays> blocks);
    void go(Block& block);
    void fill(const Block& block, double first);
    void end(Block& block, double first) const;

    const TraceFrame& frame_;
    const TileRays& rays_;
    const BlobSurface& surface_;
    double bracket_;
    FollowScratch& scratch_;
    Counters& counters_;
    double per_distance_;
};

BallReach Follower::begin(std::span<FollowedRays> blocks) {
    BallReach all;
    scratch_.blocks.clear();
    for (FollowedRays& rays : blocks) {
        Block block{.rays = &rays, .reach = {}};
        for (std::size_t i = 0; i < rays.size(); ++i) {
            rays[i].found = RayFinding::Free;
            rays[i].side = surface_.level > 0 ? -1 : 1;  // where no ball is
            block.at[i] = -unbounded;
            block.open[i] = rays[i].from < rays[i].to;
            if (block.open[i]) block.reach.add(rays[i]);
        }
        block.any_open = !block.reach.empty();
        all.add(block.reach);
        if (block.any_open) scratch_.blocks.push_back(block);
    }
    return all;
}

void Follower::run(std::span<FollowedRays> blocks) {
    const BallReach all = begin(blocks);
    if (all.empty()) return;
    NearBalls& near = scratch_.slab.near;
    near.begin(surface_.blobs->set(), blob_facts(surface_.blobs->kind()).reach, rays_,
               {.u = all.u() * per_distance_,
                .v = all.v() * per_distance_,
                .u_radius = all.u_radius() * per_distance_,
                .v_radius = all.v_radius() * per_distance_,
                .from = all.from,
                .to = all.to});
    for (bool any = near.next(); any; any = any && near.next()) {
        scratch_.slab.columns.fill(near.balls());
        any = false;
        for (Block& block : scratch_.blocks) {
            if (!block.any_open) continue;
            go(block);
            any = any || block.any_open;
        }
    }
}

/// Takes a block's rays through the slab.
void Follower::go(Block& block) {
    const NearBalls& near = scratch_.slab.near;
    if (frame_.stopped()) {
        for (std::size_t i = 0; i < ray_block_rays; ++i) {
            if (block.open[i]) (*block.rays)[i].found = RayFinding::Unknown;
        }
        block.any_open = false;
        return;
    }
    // List the slab's balls that the block's rays may meet.
    const BallReach& reach = block.reach;
    if (near.from() > reach.to) block.any_open = false;
    const double from = std::max(reach.from, near.from());
    const double to = std::min(reach.to, near.to());
    const bool some =
        from <= to && scratch_.slab.list(surface_, surface_.tail(), rays_,
                                         {.u = reach.u() * per_distance_,
                                          .v = reach.v() * per_distance_,
                                          .u_radius = reach.u_radius() * per_distance_,
                                          .v_radius = reach.v_radius() * per_distance_,
                                          .distance = 0,
                                          .from = from,
                                          .to = to,
                                          .spare = 0});
    if (!some) return;
    // March the rays through these, and take over what is found.
    const double first = std::max(from, scratch_.slab.balls.front().from());
    fill(block, first);
    const double extent = std::max(to - first, 0.0);
    counters_.value += march({.kind = surface_.blobs->kind(),
                              .level = surface_.level,
                              .balls = scratch_.slab.balls,
                              .extent = extent,
                              .width = reach.u_radius() + reach.v_radius(),
                              .square = 1,
                              .place_error = 16 * rays_.depth_error(),
                              .tail = surface_.tail(),
                              .bracket = bracket_},
                             scratch_.block);
    end(block, first);
}

/// Puts rays and balls into the block's coordinates.
void Follower::fill(const Block& block, double first) {
    BallBlock& to = scratch_.block;
    to.state.fill(BallRayState::Outside);
    const double u = block.reach.u();
    const double v = block.reach.v();
    for (std::size_t i = 0; i < ray_block_rays; ++i) {
        if (!block.open[i]) continue;
        const FollowedRay& ray = (*block.rays)[i];
        to.u[i] = to.v[i] = to.tilt_x[i] = to.tilt_y[i] = 0;
        to.start_x[i] = ray.u - u;
        to.start_y[i] = ray.v - v;
        to.at[i] = std::max({block.at[i], ray.from, first}) - first;
        to.stop[i] = std::min(ray.to, scratch_.slab.near.to()) - first;
        to.side[i] = block.side[i];
        to.state[i] = to.at[i] < to.stop[i] ? BallRayState::Open : BallRayState::Passed;
    }
    for (ViewBall& ball : scratch_.slab.balls) {
        ball.x -= u;
        ball.y -= v;
        ball.z -= first;
    }
}

/// Takes over what was found of a block's rays.
void Follower::end(Block& block, double first) const {
    const BallBlock& found = scratch_.block;
    block.any_open = false;
    for (std::size_t i = 0; i < ray_block_rays; ++i) {
        if (!block.open[i]) continue;
        FollowedRay& ray = (*block.rays)[i];
        block.side[i] = found.side[i];
        if (found.side[i] != 0) ray.side = found.side[i];
        block.open[i] = false;
        if (found.state[i] == BallRayState::Passed) {
            block.at[i] = first + found.stop[i];
            block.open[i] = ray.to > scratch_.slab.near.to();
            block.any_open = block.any_open || block.open[i];
            continue;
        }
        ray.found = found.state[i] == BallRayState::Root ? RayFinding::Root : RayFinding::Unknown;
        ray.root = first + found.depth[i];
    }
}

}  // namespace

bool follow_blobs(const TraceFrame& frame, const TileRays& rays, double bracket,
                  std::span<FollowedRays> blocks, Counters& counters) {
    if (!rays.axes().parallel() || !frame.union_members.empty()) return false;
    const auto surface = blob_surface(frame);
    if (!surface || !(bracket > 64 * rays.depth_error())) return false;
    thread_local const auto kept = std::make_unique<FollowScratch>();
    FollowScratch& scratch = *kept;
    Follower(frame, rays, *surface, bracket, scratch, counters).run(blocks);
    return true;
}

}  // namespace zeroset
