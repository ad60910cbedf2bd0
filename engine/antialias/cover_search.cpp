#include "engine/antialias/cover_search.hpp"

#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/sample_drafts.hpp"
#include "engine/antialias/square_edges.hpp"
#include "engine/antialias/square_field.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/tile_rays.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>

namespace zeroset {

namespace {

class CoverSearch {
public:
    CoverSearch(std::span<const TraceFrame> surfaces, const TileRays& rays, Counters& counters);

    void search(std::span<MixedPixel> pixels, std::vector<CoverSample>& out);

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
    /// The next step where there is one surface.
    [[nodiscard]] Step choose_only(std::size_t square, const Front& front);
    /// The next step where the front of a surface ends before any other begins.
    [[nodiscard]] Step choose_at(std::size_t square, std::size_t surface);
    /// Takes all fronts of the only surface on.
    void advance_all();
    void sort_work();
    /// Goes on with the open squares until each is closed or divided.
    void finish_level();
    [[nodiscard]] bool stopped() const { return work_.front().frame.stopped(); }

    Counters& counters_;
    SquareField field_;
    std::vector<std::size_t> open_;  ///< squares
    std::deque<Work> work_;          ///< of each surface
};

CoverSearch::CoverSearch(std::span<const TraceFrame> surfaces, const TileRays& rays,
                         Counters& counters)
    : counters_(counters), field_(rays, surfaces.size()) {
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        work_.emplace_back(surfaces[i], i, field_, counters);
}

auto CoverSearch::choose(std::size_t square) -> Choice {
    const std::span<Front> fronts = field_.fronts(square);
    if (fronts.size() == 1) return {.step = choose_only(square, fronts.front()), .surface = 0};
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
        if (at.rest != nullptr || (!at.is_ray() && at.level < last_level))
            return {.step = Step::Divide, .surface = i};
    }
    return {.step = choose_at(square, first), .surface = first};
}

auto CoverSearch::choose_only(std::size_t square, const Front& front) -> Step {
    switch (front.state) {
        case State::Going: return Step::Evaluate;
        case State::Gone: return Step::Close;
        case State::Rooted:
        case State::Edged: break;
    }
    return choose_at(square, 0);
}

auto CoverSearch::choose_at(std::size_t square, std::size_t surface) -> Step {
    const CoverSquare& at = field_.square(square);
    const Front& front = field_.fronts(square)[surface];
    if (!at.is_ray() && at.level < at.least_level) {
        const bool is_sheet = front.state == State::Rooted && front.monotone &&
                              !front.is_uneven() && at.rest == nullptr;
        if (!is_sheet) return Step::Divide;
        work_[surface].drafts.add_parts(at, front);
        return Step::Close;
    }
    if (front.state == State::Edged) return at.rest != nullptr ? Step::Divide : Step::Edge;
    if (front.is_uneven()) {
        if (at.rest != nullptr) return Step::Divide;
        if (!at.is_ray() && at.level < last_color_level) return Step::Crease;
    }
    if (field_.is_hit_between(square, front.at, front.to)) {
        field_.leave_plain(square);
    } else {
        work_[surface].drafts.add(at, front);
    }
    return Step::Close;
}

void CoverSearch::advance_all() {
    Work& work = work_.front();
    work.at_cells.clear();
    for (std::size_t i = 0; i < field_.size(); ++i) {
        if (field_.fronts(i).front().state == State::Going) work.at_cells.push_back(i);
    }
    advance_fronts(work.frame, 0, field_, work.at_cells, counters_);
}

void CoverSearch::sort_work() {
    for (Work& work : work_) {
        work.at_cells.clear();
        work.at_edges.clear();
    }
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
    if (field_.is_of_one_surface()) advance_all();
    while (!open_.empty() && !stopped()) {
        sort_work();
        for (std::size_t i = 0; i < work_.size(); ++i) {
            Work& work = work_[i];
            advance_fronts(work.frame, i, field_, work.at_cells, counters_);
            open_.insert(open_.end(), work.at_cells.begin(), work.at_cells.end());
            work.edges.decide(work.at_edges, open_);
        }
    }
}

void CoverSearch::search(std::span<MixedPixel> pixels, std::vector<CoverSample>& out) {
    field_.reserve(pixels.size());
    open_.reserve(pixels.size());
    work_.front().drafts.reserve(pixels.size());
    for (MixedPixel& pixel : pixels) {
        if (pixel.is_sheet()) {
            work_[pixel.surface].drafts.add(pixel);
        } else {
            field_.add(pixel);
        }
    }
    field_.place_all();
    do {
        finish_level();
    } while (!stopped() && field_.go_down());
    if (stopped()) return;
    for (Work& work : work_)
        work.drafts.write(work.frame, field_.rays(), out, counters_);
}

}  // namespace

void find_cover(std::span<const TraceFrame> surfaces, const Tile& tile,
                std::vector<MixedPixel>& pixels, std::vector<CoverSample>& out,
                Counters& counters) {
    if (pixels.empty()) return;
    Tile all = tile;
    all.limits = nullptr;
    const TileRays rays(surfaces.front(), all);
    CoverSearch(surfaces, rays, counters).search(pixels, out);
    std::erase_if(pixels, [](const MixedPixel& pixel) { return pixel.is_plain; });
}

void narrow_limits(const TraceFrame& surface, const Tile& tile, const TileHits& hits,
                   std::vector<float>& limits) {
    const PixelCover& cover = hits.cover;
    if (!cover.known || !cover.is_marked()) return;
    const TileRays rays(surface, tile);
    for (int row = 0; row < tile.rows; ++row) {
        for (int col = 0; col < tile.cols; ++col) {
            const auto at = static_cast<std::size_t>(row * tile_size + col);
            const float to = cover.to[at];
            if (!(to < std::numeric_limits<float>::infinity()) || !(to < cover.other_from[at]))
                continue;
            const double distance =
                rays.distance_at(static_cast<double>(to), rays.u(col), rays.v(row));
            limits[at] = std::min(limits[at], float_above(distance));
        }
    }
}

SquareRay SquareRest::middle() const {
    if (part.share > 0.0) return {.x = part.x, .y = part.y};
    SquareRay sum{.x = 0.0, .y = 0.0};
    double count = 0.0;
    for (std::size_t i = 0; i < square_ray_count; ++i) {
        if (!misses[i]) continue;
        sum.x += square_rays[i].x;
        sum.y += square_rays[i].y;
        count += 1.0;
    }
    return count > 0.0 ? SquareRay{.x = sum.x / count, .y = sum.y / count} : square_middle;
}

}  // namespace zeroset
