// Point sampling along rays [Florez08, sec. 4.3.1 and fig. 4.4, 4.5]: marching, and bisection where
// the sign of f changes. The one that misses roots.
//   h    the length of a step: 2^-8 of the clip box's longest edge along the ray's dominant axis,
//        or the finest stretch where that is longer
// Two roots in a step are passed, and so is one that f only touches; a pole is told from a root by
// the size of f at the place that is found, a jump is not.
//
// Proves nothing: what it hits is undecided, and so is a ray on which it finds nothing.

#include "engine/trace/in_precision.hpp"
#include "papers/along_rays/hit_writer.hpp"
#include "papers/along_rays/ray_field.hpp"
#include "papers/along_rays/root_refinement.hpp"
#include "papers/along_rays/tracers_along_rays.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace zeroset {
namespace {

constexpr int step_halvings = 8;
constexpr std::size_t samples_at_once = 16;  ///< of a ray

/// A ray as far as it has been sampled.
struct Walker {
    std::uint32_t pixel;
    double at;  ///< of the next sample
    double step;
    double before;  ///< f one step before; NaN: not known
};

/// A step in which the sign of f changes.
struct Change {
    std::size_t walker;
    double smallest;  ///< |f| at the nearer of both ends to 0
};

class PointSampler {
public:
    PointSampler(RayField<double>& field, HitWriter& writer) : field_(field), writer_(writer) {}

    void run() {
        begin();
        while (!walkers_.empty()) {
            for (std::size_t first = 0; first < walkers_.size();
                 first += most_tasks / samples_at_once) {
                if (field_.frame->stopped()) return leave();
                const std::size_t count =
                    std::min(most_tasks / samples_at_once, walkers_.size() - first);
                step(first, count);
            }
            std::erase_if(walkers_, [](const Walker& walker) { return std::isinf(walker.at); });
        }
    }

private:
    static constexpr double ended = std::numeric_limits<double>::infinity();

    void begin() {
        for (const std::uint32_t pixel : field_.lines.pixels()) {
            const RayLine& line = field_.lines.of(pixel);
            const double size = field_.frame->scene.clip.size();
            const double step = std::max(std::ldexp(size, -step_halvings) * line.per_size,
                                         field_.lines.finest(line, line.from));
            walkers_.push_back({.pixel = pixel,
                                .at = line.from,
                                .step = step,
                                .before = std::numeric_limits<double>::quiet_NaN()});
        }
    }
    void leave() {
        for (const Walker& walker : walkers_) {
            if (!std::isinf(walker.at))
                writer_.leave_unsettled(walker.pixel, field_.lines.of(walker.pixel).from);
        }
    }
    void sample(std::size_t first, std::size_t count);
    void step(std::size_t first, std::size_t count);
    /// Takes the samples of a walker; notes the first change of the sign.
    void take(std::size_t index, std::size_t first_sample);
    void finish_changes();

    RayField<double>& field_;
    HitWriter& writer_;
    RootRefiner refiner_;
    std::vector<Walker> walkers_;
    std::vector<Change> changes_;
    std::vector<Refinement> refinements_;
    PointBatch<double> batch_;
};

void PointSampler::sample(std::size_t first, std::size_t count) {
    batch_.resize(count * samples_at_once);
    for (std::size_t i = 0; i < count * samples_at_once; ++i) {
        const Walker& walker = walkers_[first + i / samples_at_once];
        const RayLine& line = field_.lines.of(walker.pixel);
        const double s =
            std::min(walker.at + static_cast<double>(i % samples_at_once) * walker.step, line.to);
        const auto [x, y, z] = line.at(s);
        batch_.set(i, x, y, z);
    }
    field_.counters->value += count * samples_at_once;
    for (const Walker& walker : std::span(walkers_).subspan(first, count))
        field_.tell_cost(walker.pixel, samples_at_once);
    field_.frame->kernel.in_double.value(
        batch_.batch(field_.frame->scene.uniforms.points<double>()));
}

void PointSampler::take(std::size_t index, std::size_t first_sample) {
    Walker& walker = walkers_[index];
    const RayLine& line = field_.lines.of(walker.pixel);
    for (std::size_t i = 0; i < samples_at_once; ++i) {
        const double f = batch_.f(first_sample + i);
        const double before = walker.before;
        const double at = std::min(walker.at, line.to);
        walker.before = f;
        walker.at += walker.step;
        if (before * f <= 0.0) {
            changes_.push_back(
                {.walker = index, .smallest = std::min(std::abs(before), std::abs(f))});
            refinements_.push_back({.pixel = walker.pixel,
                                    .from = std::max(at - walker.step, line.from),
                                    .to = at,
                                    .rises = f > before,
                                    .tolerance = 0.25 * field_.lines.finest(line, at)});
            return;
        }
        if (at >= line.to) {
            writer_.leave_unsettled(walker.pixel, line.from);
            walker.at = ended;
            return;
        }
    }
}

void PointSampler::finish_changes() {
    refiner_.run(field_, refinements_);
    if (changes_.empty()) return;
    batch_.resize(changes_.size());
    for (std::size_t k = 0; k < changes_.size(); ++k) {
        const auto [x, y, z] = field_.lines.of(refinements_[k].pixel).at(refinements_[k].root);
        batch_.set(k, x, y, z);
    }
    batch_.pad();
    field_.counters->value += changes_.size();
    for (const Refinement& refinement : refinements_)
        field_.tell_cost(refinement.pixel);
    field_.frame->kernel.in_double.value(
        batch_.batch(field_.frame->scene.uniforms.points<double>()));
    for (std::size_t k = 0; k < changes_.size(); ++k) {
        Walker& walker = walkers_[changes_[k].walker];
        if (std::abs(batch_.f(k)) <= changes_[k].smallest) {
            writer_.push(walker.pixel, refinements_[k].root, false);
            walker.at = ended;
        } else if (walker.at - walker.step >= field_.lines.of(walker.pixel).to) {
            writer_.leave_unsettled(walker.pixel, field_.lines.of(walker.pixel).from);
            walker.at = ended;
        }
    }
}

void PointSampler::step(std::size_t first, std::size_t count) {
    sample(first, count);
    changes_.clear();
    refinements_.clear();
    for (std::size_t i = 0; i < count; ++i)
        take(first + i, i * samples_at_once);
    finish_changes();
}

}  // namespace

void trace_tile_point_sampling(const TraceFrame& frame, const Tile& tile, TileHits& hits,
                               Counters& counters) {
    thread_local const auto kept = std::make_unique<RayField<double>>();
    RayField<double>& field = *kept;
    const TileRays rays(frame, tile);
    field.begin(frame, tile, rays, counters);
    HitWriter writer(rays, field.lines, hits);
    PointSampler(field, writer).run();
}

}  // namespace zeroset
