#include "engine/trace/patch/patch_tracer.hpp"

#include "engine/real/unbounded.hpp"
#include "engine/trace/patch/patch_found.hpp"
#include "engine/trace/patch/patch_tile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace zeroset {

namespace {

/// Asks for the first hits of a tile of the image.
void ask(const Tile& tile, const TileRays& rays, TileQuest& quest) {
    quest.wish = TileQuest::Wish::FirstHits;
    quest.cols = tile.cols;
    quest.rows = tile.rows;
    quest.u.resize(tile_size);
    quest.v.resize(tile_size);
    for (int i = 0; i < tile_size; ++i) {
        quest.u[static_cast<std::size_t>(i)] = rays.u(i);
        quest.v[static_cast<std::size_t>(i)] = rays.v(i);
    }
    quest.to.clear();
    if (tile.limits == nullptr) return;
    quest.to.assign(tile_pixels, -unbounded);
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col)
            quest.to[pixel_index(col, row)] = rays.limit(pixel_index(col, row));
    }
}

/// Memory that a thread keeps from tile to tile.
struct KeptTile {
    TileQuest quest;
    TileAnswer answer;
};

/// Whether the rays of a tile of the image may meet the patch, as far as its largest parts tell.
bool may_meet(const TraceFrame& frame, const TileRays& rays, const Tile& tile) {
    const PatchTree& tree = tree_of(frame);
    const Box clip = tree.within(frame.scene.clip);
    const SightAxes axes = axes_of(rays);
    const RayBounds bounds{.u_lo = rays.u(0.0),
                           .u_hi = rays.u(tile.cols - 1),
                           .v_lo = rays.v(tile.rows - 1),
                           .v_hi = rays.v(0.0)};
    const auto meets = [&](const PatchNode& node) {
        const auto form = form_within(node.form, clip);
        return form && !is_beside(sight_of(*form, axes), axes, bounds);
    };
    const PatchNode::Children* const parts = tree.parts(tree.root());
    return parts == nullptr ? meets(tree.root()) : std::ranges::any_of(parts->nodes, meets);
}

/// The normal of a hit, or one that faces the eye where there is none.
std::array<float, 3> normal_of(const PatchHit& hit, const ViewFrame& view, double u, double v) {
    const double size = glm::dot(hit.normal, hit.normal);
    const bool is_known = size > 0.0 && size < unbounded;
    const glm::dvec3 normal =
        is_known ? hit.normal : -(view.forward + u * view.right + v * view.up);
    return float_gradient({normal.x, normal.y, normal.z});
}

void put_hit(const PatchHit& hit, TileHits::Pixel at, const TileRays& rays, double u, double v,
             TileHits& hits) {
    const std::size_t pixel = at.index();
    const bool is_unsettled = hit.unsettled < hit.s;
    if (is_unsettled) {
        hits.mark_unsettled(at, rays.distance_before(hit.unsettled, u, v));
        hits.certificate[pixel] = Certificate::Undecided;
    }
    if (!hit.is_hit()) return;
    hits.any = true;
    hits.depth[pixel] = static_cast<float>(rays.distance_at(hit.s, u, v));
    hits.certificate[pixel] =
        hit.is_proved && !is_unsettled ? Certificate::Certified : Certificate::Undecided;
    const auto normal = normal_of(hit, rays.axes(), u, v);
    for (std::size_t k = 0; k < 3; ++k)
        hits.gradient[k][pixel] = normal[k];
}

}  // namespace

void trace_tile_patch(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                      Counters& counters) {
    assert(tile.places == nullptr);
    thread_local KeptTile kept;
    const TileRays rays(frame, tile);
    if (!may_meet(frame, rays, tile)) return;
    ask(tile, rays, kept.quest);
    TileAnswer& answer = kept.answer;
    PatchTile(frame, rays, kept.quest, answer, counters).run();
    if (frame.stopped()) return hits.leave_undecided(tile);
    const bool are_others = put_found({.u = kept.quest.u.data(),
                                       .v = kept.quest.v.data(),
                                       .reach = answer.reaches(),
                                       .found = answer.found(),
                                       .look_distance = rays.look_distance(),
                                       .cols = tile.cols,
                                       .rows = tile.rows,
                                       .blocks = answer.touched()},
                                      hits);
    if (!are_others) return;
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const std::size_t pixel = pixel_index(col, row);
            const LeafFound& found = answer.found()[pixel];
            const bool is_put = found.state != RayState::Kept && std::isfinite(found.normal[0]);
            if (found.state == RayState::Open || is_put) continue;
            put_hit(answer.hit(pixel),
                    {.col = static_cast<std::int16_t>(col), .row = static_cast<std::int16_t>(row)},
                    rays, rays.u(col), rays.v(row), hits);
        }
    }
}

void follow_patch(const TraceFrame& frame, const TileRays& rays, std::span<FollowedRays> blocks,
                  Counters& counters) {
    assert(blocks.size() == tile_blocks);
    thread_local KeptTile kept;
    TileQuest& quest = kept.quest;
    quest.wish = TileQuest::Wish::AnyHits;
    for (std::vector<double>* const numbers : {&quest.u, &quest.v, &quest.to})
        numbers->resize(tile_pixels);
    const double per_distance = 1.0 / rays.distance();
    for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
        const FollowedRay& ray = ray_of(blocks, pixel);
        const bool is_wanted = ray.from < ray.to;
        quest.u[pixel] = is_wanted ? ray.u * per_distance : 0.0;
        quest.v[pixel] = is_wanted ? ray.v * per_distance : 0.0;
        quest.to[pixel] = is_wanted ? ray.to : -unbounded;
    }
    PatchTile(frame, rays, quest, kept.answer, counters).run();
    for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
        const PatchHit hit = kept.answer.hit(pixel);
        const double to = quest.to[pixel];
        const bool is_open = !hit.is_proved && (hit.is_hit() || hit.unsettled < to);
        ray_of(blocks, pixel).found = hit.is_hit() && hit.is_proved ? RayFinding::Root
                                      : is_open || (to > -unbounded && frame.stopped())
                                          ? RayFinding::Unknown
                                          : RayFinding::Free;
    }
}

}  // namespace zeroset
