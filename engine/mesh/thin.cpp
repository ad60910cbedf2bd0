#include "engine/mesh/field_at_points.hpp"
#include "engine/mesh/mesh_steps.hpp"
#include "engine/mesh/parallel.hpp"
#include "engine/mesh/place_index.hpp"
#include "engine/mesh/thinning.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

// Edges are collapsed tile by tile: a thread has the vertices of one tile, and only those go into
// neighbours whose whole rings lie in it, so that no thread waits for another. Then come tiles
// that lie across the sides of the first ones, then the few vertices that are left.

namespace zeroset {
namespace {

/// Vertices by the costs of their collapses, the cheapest first but for a quarter or so.
class CostQueue {
public:
    CostQueue() : buckets_(std::size_t{1} << bits) {}

    void push(std::uint32_t v, float cost) {
        const std::size_t bucket = bucket_of(cost);
        buckets_[bucket].push_back(v);
        first_ = std::min(first_, bucket);
        ++size_;
    }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    std::uint32_t pop() {
        while (buckets_[first_].empty())
            ++first_;
        const std::uint32_t v = buckets_[first_].back();
        buckets_[first_].pop_back();
        --size_;
        return v;
    }
    /// Whether a cost is among the cheapest that are left, as far as the queue tells them apart.
    [[nodiscard]] bool comes_now(float cost) const { return bucket_of(cost) <= first_; }

private:
    static constexpr unsigned bits = 10;
    /// Four for each doubling: of a float above 0 its exponent and first two bits.
    static std::size_t bucket_of(float cost) {
        return std::bit_cast<std::uint32_t>(std::max(cost, 0.0F)) >> (31U - bits);
    }

    std::vector<std::vector<std::uint32_t>> buckets_;
    std::size_t first_ = (std::size_t{1} << bits) - 1, size_ = 0;
};

/// The states of vertices, which tiles share.
struct VertexStates {
    explicit VertexStates(std::size_t count)
        : costs(count), asked(count, 1), tiles(count), batches(count) {}

    std::vector<float> costs;         ///< by which each waits in a queue
    std::vector<std::uint8_t> asked;  ///< 0: cannot go anywhere, unless something changes beside it
    std::vector<std::uint32_t> tiles;
    /// The last batch with a candidate that changes the triangles there.
    std::vector<std::uint32_t> batches;
    std::atomic<std::uint32_t> next_batch = 1;
};

class TileThinner {
public:
    TileThinner(Thinning& thinning, const MeshSolid& solid, const ThinOptions& options,
                VertexStates& states, std::uint32_t tile)
        : thinning_(thinning), solid_(solid), options_(options), states_(states), tile_(tile) {}
    void run(std::span<const std::uint32_t> vertices);

private:
    /// A collapse whose distance from the surface is to be measured.
    struct Candidate {
        Collapse collapse;
        std::vector<Triangle> triangles;
        std::size_t points_end = 0;  ///< of its points among all
        double far = 0.0;            ///< the greatest distance from the surface so far
    };

    [[nodiscard]] bool is_done() const {
        return options_.most_triangles > 0 &&
               thinning_.mesh().triangles() <= options_.most_triangles;
    }
    [[nodiscard]] bool is_inner(std::uint32_t v);
    void ask(std::uint32_t v);
    void take(std::uint32_t v);
    void fill_batch();
    void measure(bool samples);
    void make_batch();

    Thinning& thinning_;
    const MeshSolid& solid_;
    const ThinOptions& options_;
    VertexStates& states_;
    std::uint32_t tile_;
    CostQueue queue_;
    std::vector<Candidate> batch_;
    std::size_t count_ = 0;                 ///< of the batch's candidates
    std::vector<std::uint32_t> put_aside_;  ///< beside a candidate of the batch
    std::uint32_t number_ = 0;              ///< of the batch
    std::vector<std::uint32_t> ring_;
    std::vector<std::uint32_t> collapsed_ring_;  ///< of the vertex that was collapsed
    std::vector<glm::dvec3> points_;
    std::vector<SolidValue> values_;
};

bool TileThinner::is_inner(std::uint32_t v) {
    thinning_.mesh().ring(v, ring_);
    return std::ranges::all_of(ring_,
                               [&](std::uint32_t other) { return states_.tiles[other] == tile_; });
}

void TileThinner::ask(std::uint32_t v) {
    states_.asked[v] = 1;
    // Costs depend on all of the ring, which another thread may be changing beyond the tile.
    if (!is_inner(v)) return;
    states_.costs[v] = thinning_.least_cost(v);
    queue_.push(v, states_.costs[v]);
}

/// Takes a vertex out of the queue: into the batch, back into the queue or aside.
void TileThinner::take(std::uint32_t v) {
    const CollapsibleMesh& mesh = thinning_.mesh();
    if (states_.asked[v] == 0 || mesh.star(v).empty() || !queue_.comes_now(states_.costs[v]))
        return;
    if (!is_inner(v)) return;
    const auto is_taken = [&](std::uint32_t other) { return states_.batches[other] == number_; };
    if (is_taken(v) || std::ranges::any_of(ring_, is_taken)) return put_aside_.push_back(v);
    const Collapse best = thinning_.best_collapse(v);
    if (!best.exists()) {
        states_.asked[v] = 0;
        return;
    }
    if (!queue_.comes_now(best.cost)) {
        states_.costs[v] = best.cost;
        return queue_.push(v, best.cost);
    }
    for (const std::uint32_t other : ring_)
        states_.batches[other] = number_;
    states_.batches[v] = number_;
    if (count_ == batch_.size()) batch_.emplace_back();
    batch_[count_].collapse = best;
    thinning_.new_triangles(best, batch_[count_].triangles);
    ++count_;
}

void TileThinner::fill_batch() {
    constexpr std::size_t most_candidates = 32;
    count_ = 0;
    number_ = states_.next_batch++;
    while (count_ < most_candidates && put_aside_.size() < most_candidates && !queue_.empty())
        take(queue_.pop());
}

/// Measures the candidates in the middles of new triangles and sides; where these are some way off,
/// in samples, too.
void TileThinner::measure(bool samples) {
    constexpr double share_without_samples = 0.3;
    points_.clear();
    for (std::size_t i = 0; i < count_; ++i) {
        Candidate& candidate = batch_[i];
        if (!samples) {
            candidate.far = 0.0;
            thinning_.add_middles(candidate.triangles, candidate.collapse.into, points_);
        } else if (candidate.far > share_without_samples * options_.tolerance &&
                   candidate.far <= options_.tolerance) {
            thinning_.add_samples(candidate.triangles, points_);
        }
        candidate.points_end = points_.size();
    }
    values_.resize(points_.size());
    field_here(solid_, points_, values_, Normals::Without);
    std::size_t i = 0;
    for (std::size_t k = 0; k < count_; ++k) {
        for (; i < batch_[k].points_end; ++i)
            batch_[k].far = std::max(batch_[k].far, values_[i].distance());
    }
}

void TileThinner::make_batch() {
    for (std::size_t i = 0; i < count_; ++i) {
        const Candidate& candidate = batch_[i];
        const std::uint32_t from = candidate.collapse.from;
        if (candidate.far > options_.tolerance || is_done()) {
            states_.asked[from] = 0;
            continue;
        }
        thinning_.mesh().ring(from, collapsed_ring_);
        thinning_.make(candidate.collapse);
        for (const std::uint32_t v : collapsed_ring_)
            ask(v);
    }
}

void TileThinner::run(std::span<const std::uint32_t> vertices) {
    for (const std::uint32_t v : vertices) {
        if (states_.asked[v] != 0 && !thinning_.mesh().star(v).empty()) ask(v);
    }
    while (!queue_.empty() && !is_done() && !options_.work.limit.over()) {
        fill_batch();
        measure(false);
        measure(true);
        make_batch();
        for (const std::uint32_t v : std::exchange(put_aside_, {}))
            queue_.push(v, states_.costs[v]);
    }
}

/// Cubes of about this edge that hold the mesh, moved by a share of it; gives each vertex the
/// number of its cube, and returns the vertices of each.
std::vector<std::vector<std::uint32_t>> tiles_of(const CollapsibleMesh& mesh, double edge,
                                                 double moved, std::vector<std::uint32_t>& tiles) {
    KeyIndex cubes(64);
    std::vector<std::vector<std::uint32_t>> members;
    for (std::uint32_t v = 0; v < mesh.size(); ++v) {
        const glm::dvec3 place = glm::floor((mesh.point(v) - mesh.point(0)) / edge + moved);
        const auto part = [](double x) { return static_cast<std::uint64_t>(x + 0x1p20); };
        tiles[v] = cubes.add(part(place.x) | part(place.y) << 21U | part(place.z) << 42U);
        if (tiles[v] == members.size()) members.emplace_back();
        members[tiles[v]].push_back(v);
    }
    return members;
}

/// The edge of tiles such that threads have some tiles each.
double tile_edge(const CollapsibleMesh& mesh) {
    const auto vertices = static_cast<double>(mesh.triangles()) / 2.0;
    const double vertices_of_tile = std::clamp(vertices / 8.0, 500.0, 8'000.0);
    double area = 0.0;
    for (std::uint32_t v = 0; v < mesh.size(); ++v) {
        for (const std::uint32_t t : mesh.star(v)) {
            const Triangle& triangle = mesh.triangle(t);
            area += glm::length(area_vector(mesh.point(triangle[0]), mesh.point(triangle[1]),
                                            mesh.point(triangle[2]))) /
                    6.0;
        }
    }
    return std::sqrt(area * vertices_of_tile / vertices);
}

}  // namespace

void thin(TriangleMesh& mesh, const MeshSolid& solid, const ThinOptions& options) {
    if (mesh.triangles.empty()) return;
    Thinning thinning(std::move(mesh), options.tolerance);
    VertexStates states(thinning.mesh().size());
    const auto thin_tiles = [&](const std::vector<std::vector<std::uint32_t>>& tiles) {
        parallel_upward(tiles.size(), 1, options.work, [&](std::size_t tile, std::size_t) {
            TileThinner(thinning, solid, options, states, static_cast<std::uint32_t>(tile))
                .run(tiles[tile]);
        });
    };
    std::vector<std::vector<std::uint32_t>> all(1);
    all[0].resize(thinning.mesh().size());
    std::iota(all[0].begin(), all[0].end(), 0U);
    const auto thin_all = [&] {
        // Where the number of triangles ends the work, the cheapest of all must come first.
        if (options.most_triangles == 0) {
            const double edge = tile_edge(thinning.mesh());
            for (const double moved : {0.0, 0.5})
                thin_tiles(tiles_of(thinning.mesh(), edge, moved, states.tiles));
        }
        std::ranges::fill(states.tiles, 0U);
        thin_tiles(all);
    };
    thin_all();
    // A vertex that could go nowhere is asked again only where its ring changes, but what is beyond
    // that counts, too.
    constexpr int most_rounds = 4;
    std::size_t before = 0;
    for (int round = 0; round < most_rounds && before != thinning.mesh().triangles(); ++round) {
        before = thinning.mesh().triangles();
        std::ranges::fill(states.asked, std::uint8_t{1});
        thin_all();
    }
    mesh = thinning.finish();
}

}  // namespace zeroset
