// The first roots of a plain surface of soft balls, by those that are near.
//   near     the balls that reach a tile's rays, front to back, some at a time: a slab of depth
//   block    8 x 8 rays, which look only at those of a slab's balls that may reach one of them
//   first    the depth that is 0 in a block's own coordinates, where floats are finest
// A block's rays go through a slab to its end, or to their root (ray_block.hpp); where no ball is
// f is 0, on one side of the level, so nothing is looked at there.

#include "engine/trace/blobs/blob_tile.hpp"

#include "engine/real/unbounded.hpp"
#include "engine/trace/tile_costs.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

struct BlockPixel {
    int col, row;
};
constexpr auto places = [] {
    std::array<BlockPixel, ray_block_rays> all{};
    for (int row = 0; row < ray_block_side; ++row) {
        for (int col = 0; col < ray_block_side; ++col)
            all[place_in_block(col, row)] = {.col = col, .row = row};
    }
    return all;
}();

void for_each_bit(std::uint64_t bits, const auto& take) {
    for (; bits != 0; bits &= bits - 1)
        take(static_cast<std::size_t>(std::countr_zero(bits)));
}

constexpr std::uint64_t bit(std::size_t place) { return std::uint64_t{1} << place; }

}  // namespace

BlobTile::BlobTile(const TraceFrame& frame, const Tile& tile, const BlobSurface& surface,
                   BlobScratch& scratch, TileHits& hits, Counters& counters)
    : frame_(frame),
      tile_(tile),
      surface_(surface),
      scratch_(scratch),
      rays_(frame, tile),
      hits_(frame, rays_, hits, counters),
      counters_(counters) {
    tail_ = surface.tail();
    const bool in_double = frame.precision == Precision::Double;
    scratch_.lines.begin_singly(frame, in_double ? std::numeric_limits<double>::digits
                                                 : std::numeric_limits<float>::digits);
}

std::uint32_t BlobTile::pixel_of(const Block& block, std::size_t place) {
    return static_cast<std::uint32_t>((block.row + places[place].row) * tile_size + block.col +
                                      places[place].col);
}

BlobTile::Block BlobTile::block_at(int col, int row, int side) const {
    Block block{.col = col,
                .row = row,
                .cols = std::min(side, tile_.cols - col),
                .rows = std::min(side, tile_.rows - row)};
    block.u = rays_.u(col + 0.5 * (block.cols - 1));
    block.v = rays_.v(row + 0.5 * (block.rows - 1));
    block.u_radius = 0.5 * block.cols * rays_.pixel();
    block.v_radius = 0.5 * block.rows * rays_.pixel();
    block.inside = rays_.depths(block.u, block.v, block.u_radius, block.v_radius);
    set_bracket(block);
    if (block.inside.empty()) return block;
    for (std::size_t place = 0; place < ray_block_rays; ++place) {
        if (places[place].col < block.cols && places[place].row < block.rows)
            block.open |= bit(place);
    }
    return block;
}

/// Sets the widest bracket that certifies a root on any of the rays: the narrowest of theirs.
void BlobTile::set_bracket(Block& block) const {
    block.bracket = unbounded;
    block.certifies = true;
    double largest = 0;
    RayLine line{};
    for (const double u : {block.u - block.u_radius, block.u + block.u_radius}) {
        for (const double v : {block.v - block.v_radius, block.v + block.v_radius}) {
            const ViewFrame& view = rays_.axes();
            const glm::dvec3 along = view.forward + u * view.right + v * view.up;
            const glm::dvec3 size = glm::abs(along);
            largest = std::max({largest, size.x, size.y, size.z});
            if (glm::dot(along, along) >
                std::pow(std::hypot(line.direction[0], line.direction[1], line.direction[2]), 2))
                line.direction = {along.x, along.y, along.z};
        }
    }
    line.per_size = 1 / largest;
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
        line.axis = axis;
        block.bracket = std::min(block.bracket, scratch_.lines.finest(line, block.inside.enter_lo));
        block.certifies = block.certifies && scratch_.lines.certifies(line);
    }
}

bool BlobTile::run() {
    const Block whole = block_at(0, 0, tile_size);
    if (whole.inside.empty()) return true;
    if (!(whole.bracket > 64 * rays_.depth_error())) return false;
    const Blobs& blobs = *surface_.blobs;
    // Begin with the balls that may reach the tile's rays.
    scratch_.slab.near.begin(blobs.set(), blob_facts(blobs.kind()).reach, rays_,
                             {.u = whole.u,
                              .v = whole.v,
                              .u_radius = whole.u_radius,
                              .v_radius = whole.v_radius,
                              .from = whole.inside.enter_lo,
                              .to = whole.inside.exit_hi});
    bool any = scratch_.slab.near.next();
    if (any) begin_blocks();
    // Take all blocks through one slab after the other.
    for (; any; any = any && scratch_.slab.near.next()) {
        scratch_.slab.columns.fill(scratch_.slab.near.balls());
        any = false;
        for (std::size_t i = 0; i < count_; ++i) {
            if (blocks_[i].open == 0) continue;
            if (frame_.stopped()) {
                leave(blocks_[i]);
            } else {
                trace(blocks_[i], rays_of_[i]);
                any = any || blocks_[i].open != 0;
            }
        }
    }
    return true;
}

void BlobTile::begin_blocks() {
    count_ = 0;
    for (int row = 0; row < tile_.rows; row += ray_block_side) {
        for (int col = 0; col < tile_.cols; col += ray_block_side) {
            rays_of_[count_].at.fill(-unbounded);
            rays_of_[count_].side.fill(0);
            blocks_[count_++] = block_at(col, row, ray_block_side);
        }
    }
}

/// Takes a block's rays through the slab.
void BlobTile::trace(Block& block, RaysKnown& known) {
    const NearBalls& near = scratch_.slab.near;
    // List the slab's balls that the block's rays may meet.
    const double from = std::max(block.inside.enter_lo, near.from());
    const double to = std::min(block.inside.exit_hi, near.to());
    if (from > block.inside.exit_hi) block.open = 0;
    if (!(from <= to) || !list_balls(block, from, to)) return;
    if (!block.singly && near_ends(block)) take_singly(block);
    // Put rays and balls into the block's own coordinates.
    const double first = std::max(from, scratch_.slab.balls.front().from());
    fill(block, known, first);
    const Blobs& blobs = *surface_.blobs;
    const double extent = std::max(to - first, 0.0);
    const double u_most = std::abs(block.u) + block.u_radius;
    const double v_most = std::abs(block.v) + block.v_radius;
    const BallQuestion question{
        .kind = blobs.kind(),
        .level = surface_.level,
        .balls = scratch_.slab.balls,
        .extent = extent,
        .width = (block.u_radius + block.v_radius) * (rays_.distance() + std::abs(first) + extent),
        .square = 1 + u_most * u_most + v_most * v_most,
        .place_error = 16 * rays_.depth_error(),
        .tail = tail_,
        .bracket = block.bracket};
    // March the rays, and take over what is found.
    const BallEvaluations evaluations = march(question, scratch_.block);
    counters_.value += evaluations;
    if (counters_.costs != nullptr) {
        counters_.costs->add(block.col, block.row, block.cols, block.rows,
                             static_cast<double>(evaluations));
    }
    end(block, known, first);
}

/// Lists the slab's balls that may reach the block's rays between two depths; whether these may
/// bring f to the level.
bool BlobTile::list_balls(const Block& block, double from, double to) {
    ++counters_.range;
    return scratch_.slab.list(surface_, tail_, rays_,
                              {.u = block.u,
                               .v = block.v,
                               .u_radius = block.u_radius,
                               .v_radius = block.v_radius,
                               .distance = 0,
                               .from = from,
                               .to = to,
                               .spare = 0});
}

/// Whether balls are where some rays are inside and others are not.
bool BlobTile::near_ends(const Block& block) const {
    if (tile_.limits != nullptr) return true;
    const DepthRange& inside = block.inside;
    return std::ranges::any_of(scratch_.slab.balls, [&](const ViewBall& ball) {
        const bool at_begin = ball.to() >= inside.enter_lo && ball.from() <= inside.enter_hi;
        const bool at_end = ball.to() >= inside.exit_lo && ball.from() <= inside.exit_hi;
        return at_begin || at_end;
    });
}

void BlobTile::take_singly(Block& block) {
    block.singly = true;
    for_each_bit(block.open, [&](std::size_t place) {
        const bool seen = scratch_.lines.take(tile_, rays_, block.col + places[place].col,
                                              block.row + places[place].row);
        if (!seen) block.open &= ~bit(place);
    });
}

double BlobTile::end_of(const Block& block, std::size_t place) const {
    return block.singly ? scratch_.lines.of(pixel_of(block, place)).to : block.inside.exit_lo;
}

/// Puts rays and balls into the block's coordinates.
void BlobTile::fill(const Block& block, const RaysKnown& known, double first) {
    const bool parallel = rays_.axes().parallel();
    const double distance = rays_.distance();
    BallBlock& to = scratch_.block;
    to.state.fill(BallRayState::Outside);
    for_each_bit(block.open, [&](std::size_t place) {
        const double u = rays_.u(block.col + places[place].col);
        const double v = rays_.v(block.row + places[place].row);
        to.u[place] = parallel ? 0 : u;
        to.v[place] = parallel ? 0 : v;
        to.tilt_x[place] = parallel ? 0 : u - block.u;
        to.tilt_y[place] = parallel ? 0 : v - block.v;
        to.start_x[place] = (u - block.u) * (distance + first);
        to.start_y[place] = (v - block.v) * (distance + first);
        const double begin =
            block.singly ? scratch_.lines.of(pixel_of(block, place)).from : block.inside.enter_hi;
        to.at[place] = std::max({known.at[place], begin, first}) - first;
        to.stop[place] = std::min(end_of(block, place), scratch_.slab.near.to()) - first;
        to.side[place] = known.side[place];
        to.state[place] = to.at[place] < to.stop[place] ? BallRayState::Open : BallRayState::Passed;
    });
    for (ViewBall& ball : scratch_.slab.balls) {
        ball.x -= block.u * (distance + ball.z);
        ball.y -= block.v * (distance + ball.z);
        ball.z -= first;
    }
}

/// Takes over what was found of a block's rays.
void BlobTile::end(Block& block, RaysKnown& known, double first) {
    const BallBlock& found = scratch_.block;
    for_each_bit(block.open, [&](std::size_t place) {
        known.side[place] = found.side[place];
        if (found.state[place] == BallRayState::Passed) {
            known.at[place] = first + found.stop[place];
            // Balls of the next slab may be where some rays have ended and others have not.
            const double last = block.singly ? end_of(block, place) : block.inside.exit_hi;
            if (last <= scratch_.slab.near.to()) block.open &= ~bit(place);
            return;
        }
        block.open &= ~bit(place);
        if (found.state[place] == BallRayState::Open) return hits_.leave(pixel_of(block, place));
        tell(block, place, first);
    });
}

void BlobTile::tell(const Block& block, std::size_t place, double first) {
    const BallBlock& found = scratch_.block;
    const std::uint32_t pixel = pixel_of(block, place);
    const DepthRange& inside = block.singly ? scratch_.lines.of(pixel).inside : block.inside;
    const bool proved = found.state[place] == BallRayState::Root && block.certifies &&
                        first + found.depth[place] >= inside.enter_hi &&
                        first + found.to[place] <= inside.exit_lo;
    hits_.tell(pixel, first + found.depth[place], proved,
               {found.slope[0][place], found.slope[1][place], found.slope[2][place]});
}

/// Leaves a block's open rays undecided.
void BlobTile::leave(Block& block) {
    for_each_bit(block.open, [&](std::size_t place) { hits_.leave(pixel_of(block, place)); });
    block.open = 0;
}

}  // namespace zeroset
