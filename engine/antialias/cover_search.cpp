#include "engine/antialias/cover_search.hpp"

#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/sample_drafts.hpp"
#include "engine/antialias/square_cells.hpp"
#include "engine/antialias/square_edges.hpp"
#include "engine/antialias/square_field.hpp"

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>

namespace zeroset {
namespace {

class CoverSearch {
public:
    CoverSearch(std::span<const TraceFrame> surfaces, const TileRays& rays, Counters& counters);

    void search(std::span<const TileHits> hits, std::vector<MixedPixel>& pixels,
                std::vector<CoverSample>& out);

private:
    using State = Front::State;
    /// The next step for a square, which is about one surface.
    enum class Step : std::uint8_t { Evaluate, Edge, Crease, Divide, Close };
    struct Choice {
        Step step;
        std::size_t surface;
    };
    /// A surface, and what is to be done about it, at once for many squares.
    struct Work {
        const TraceFrame& frame;
        SampleDrafts drafts;
        SquareEdges edges;
        std::vector<std::size_t> at_cells, at_edges;  ///< squares

        Work(const TraceFrame& of, std::size_t surface, SquareField& field, Counters& counters)
            : frame(of),
              drafts(static_cast<std::uint8_t>(surface)),
              edges(of, surface, field, drafts, counters) {}
        Work(const Work&) = delete;
    };

    [[nodiscard]] Choice choose(std::size_t square);
    void sort_work();
    /// Decides all squares that are at edges: the more at once, the fuller are the vectors.
    void decide_edges();
    /// Goes on with the open squares until each is closed or divided.
    void finish_level();
    [[nodiscard]] bool stopped() const { return work_.front().frame.stopped(); }

    Counters& counters_;
    SquareField field_;
    std::vector<std::size_t> open_;  ///< squares
    std::deque<Work> work_;          ///< of each surface
    /// Pixels all of which show what their own rays hit.
    std::bitset<std::size_t{tile_size} * tile_size> whole_;
};

CoverSearch::CoverSearch(std::span<const TraceFrame> surfaces, const TileRays& rays,
                         Counters& counters)
    : counters_(counters), field_(rays, surfaces.size()) {
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        work_.emplace_back(surfaces[i], i, field_, counters);
}

/// The depth before which a surface surely has no root on any ray of a pixel.
float first_root(const PixelCover& cover, std::size_t pixel) {
    constexpr float none = std::numeric_limits<float>::infinity();
    if (!cover.known) return -none;
    if (!cover.marked) return none;
    return std::min({cover.from[pixel], cover.other_from[pixel], cover.unknown_from(pixel)});
}

auto CoverSearch::choose(std::size_t square) -> Choice {
    const std::span<Front> fronts = field_.fronts(square);
    std::size_t first = fronts.size();
    for (std::size_t i = 0; i < fronts.size(); ++i) {
        if (fronts[i].state == State::Gone) continue;
        if (first == fronts.size() || fronts[i].free_to() < fronts[first].free_to()) first = i;
    }
    if (first == fronts.size()) return {.step = Step::Close, .surface = first};
    const Front& front = fronts[first];
    if (front.state == State::Going) return {.step = Step::Evaluate, .surface = first};
    // Surfaces that may begin before this front ends are searched first.
    const CoverSquare& at = field_.square(square);
    for (std::size_t i = 0; i < fronts.size(); ++i) {
        if (i == first || fronts[i].state == State::Gone || fronts[i].free_to() >= front.to)
            continue;
        if (fronts[i].state == State::Going) return {.step = Step::Evaluate, .surface = i};
        if (!at.is_ray() && at.level < last_level) return {.step = Step::Divide, .surface = i};
    }
    if (!at.is_ray() && at.level < at.least_level) return {.step = Step::Divide, .surface = first};
    if (front.state == State::Edged) return {.step = Step::Edge, .surface = first};
    const bool uneven = front.turn > most_turn_of(work_[first].frame);
    if (uneven && !at.is_ray() && at.level < last_color_level)
        return {.step = Step::Crease, .surface = first};
    if (field_.shows_hit(square, front)) {
        whole_.set(at.pixel);
    } else {
        work_[first].drafts.seek(at, front);
    }
    return {.step = Step::Close, .surface = first};
}

void CoverSearch::sort_work() {
    for (Work& work : work_)
        work.at_cells.clear();
    for (const std::size_t square : open_) {
        const Choice choice = choose(square);
        switch (choice.step) {
            case Step::Evaluate: work_[choice.surface].at_cells.push_back(square); break;
            case Step::Edge: work_[choice.surface].at_edges.push_back(square); break;
            case Step::Crease: work_[choice.surface].edges.add_uneven(square); break;
            case Step::Divide: field_.divide(square); break;
            case Step::Close: break;
        }
    }
    open_.clear();
}

void CoverSearch::finish_level() {
    open_.clear();
    for (std::size_t i = 0; i < field_.size(); ++i)
        open_.push_back(i);
    while (!open_.empty() && !stopped()) {
        sort_work();
        for (std::size_t i = 0; i < work_.size(); ++i) {
            Work& work = work_[i];
            advance_fronts(work.frame, i, field_, work.at_cells, counters_);
            open_.insert(open_.end(), work.at_cells.begin(), work.at_cells.end());
        }
        if (open_.empty()) decide_edges();
    }
}

void CoverSearch::decide_edges() {
    for (Work& work : work_) {
        work.edges.decide(work.at_edges, open_);
        work.at_edges.clear();
    }
}

void CoverSearch::search(std::span<const TileHits> hits, std::vector<MixedPixel>& pixels,
                         std::vector<CoverSample>& out) {
    std::vector<float> first_roots(work_.size(), -std::numeric_limits<float>::infinity());
    for (const MixedPixel& pixel : pixels) {
        for (std::size_t i = 0; i < hits.size(); ++i)
            first_roots[i] = first_root(hits[i].cover, pixel.pixel);
        field_.begin(pixel, first_roots);
    }
    do {
        finish_level();
    } while (!stopped() && field_.go_down());
    if (stopped()) return;
    std::erase_if(pixels, [this](const MixedPixel& pixel) { return whole_[pixel.pixel]; });
    for (const Work& work : work_)
        work.drafts.write(work.frame, field_.rays(), out, counters_);
}

}  // namespace

void find_cover(std::span<const TraceFrame> surfaces, const Tile& tile,
                std::span<const TileHits> hits, std::vector<MixedPixel>& pixels,
                std::vector<CoverSample>& out, Counters& counters) {
    if (pixels.empty()) return;
    Tile all = tile;
    all.limits = nullptr;
    const TileRays rays(surfaces.front(), all);
    CoverSearch(surfaces, rays, counters).search(hits, pixels, out);
}

}  // namespace zeroset
