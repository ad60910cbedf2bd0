#include "engine/trace/hit_gradients.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/real/rounding.hpp"
#include "engine/trace/jumps.hpp"
#include "engine/trace/tile_costs.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/view/pixel_ray.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace zeroset {
namespace {

/// f and its gradient at a point.
struct Sample {
    double f;
    glm::dvec3 gradient;

    [[nodiscard]] bool has_gradient() const {
        const double size =
            std::max({std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z)});
        return size > 0.0 && std::isfinite(size);
    }
};

/// f at points, in double. A union's parts are asked one by one: the least tells.
class PointValues {
public:
    explicit PointValues(const TraceFrame& frame) : frame_(frame) {}

    std::vector<Sample> at(std::span<const glm::dvec3> points) {
        set(points);
        std::vector<Sample> samples(points.size(), {.f = std::numeric_limits<double>::infinity(),
                                                    .gradient = glm::dvec3(0.0)});
        if (frame_.union_members.empty()) take(frame_.kernel, samples);
        for (const UnionMember& part : frame_.union_members)
            take(*part.kernel, samples);
        return samples;
    }

private:
    void set(std::span<const glm::dvec3> points) {
        batch_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            batch_.set(i, points[i].x, points[i].y, points[i].z);
        batch_.pad();
    }
    void take(const Kernel& kernel, std::span<Sample> samples) {
        batch_.evaluate(kernel.in_double.value, frame_.scene.uniforms.points<double>(),
                        [this] { return frame_.stopped(); });
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double f = batch_.f(i);
            if (!(f <= samples[i].f) && std::isfinite(samples[i].f)) continue;
            samples[i] = {
                .f = f,
                .gradient = {batch_.gradient(0, i), batch_.gradient(1, i), batch_.gradient(2, i)}};
        }
    }

    const TraceFrame& frame_;
    PointBatch<double> batch_;
};

/// A hit on its way to a gradient.
struct Seeker {
    std::size_t pixel;
    glm::dvec3 start, direction;
    double pixel_size;  ///< world units at the hit
    Trend trend;
    double lo, hi;                     ///< the root's bracket, along the ray from `start`
    double next;                       ///< where f is asked for
    std::optional<glm::dvec3> before;  ///< the gradient nearest before the root

    [[nodiscard]] glm::dvec3 at(double offset) const { return start + offset * direction; }
    /// Whether f goes along the ray as it is known to.
    [[nodiscard]] bool fits(const Sample& sample) const {
        const double along = glm::dot(sample.gradient, direction);
        return sample.has_gradient() && along * static_cast<double>(trend) > 0.0;
    }
    /// Takes what f is at `next`; whether more is to be asked. `tiny`: what numbers tell apart.
    bool narrow(const Sample& sample, double tiny);
};

bool Seeker::narrow(const Sample& sample, double tiny) {
    if (std::isnan(sample.f)) return false;
    const double step = -sample.f / glm::dot(sample.gradient, direction);
    const bool is_before = sample.f * static_cast<double>(trend) <= 0.0;
    if (is_before && fits(sample)) before = sample.gradient;
    (is_before ? lo : hi) = next;
    if ((before && is_before && std::abs(step) <= 4 * tiny) || hi - lo <= 2 * tiny) return false;
    // A little before the root, where the branch is the one that leads there.
    const double newton = next + step - tiny;
    next = newton > lo && newton < hi ? newton : 0.5 * lo + 0.5 * hi;
    return true;
}

TileHits::PointErrors errors_in(const TileRays& rays) {
    return {.bracket = rays.tolerance(), .depth = rays.depth_error()};
}

class GradientSearch {
public:
    GradientSearch(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters)
        : frame_(frame), hits_(hits), counters_(counters), values_(frame) {
        const TileHits::PointErrors errors =
            hits.point_errors ? *hits.point_errors : errors_in(TileRays(frame, tile));
        tolerance_ = 4 * errors.bracket + 64 * errors.depth;
        tiny_ = 4 * errors.depth;
        for (const TileHits::Point& point : hits.points) {
            const bool jumps = hits.certificate[point.pixel] == Certificate::Jump;
            (jumps ? jumps_ : seekers_).push_back(seeker(tile, point));
        }
    }
    void run() {
        const std::uint64_t before = counters_.value;
        const std::vector<std::size_t> pixels = searched_pixels();
        search();
        if (counters_.costs == nullptr) return;
        const auto all = static_cast<double>(counters_.value - before);
        for (const std::size_t pixel : pixels)
            counters_.costs->add(pixel, all / static_cast<double>(pixels.size()));
    }

private:
    void search() {
        take_jumps();
        find_trends();
        polish();
        // Before the hit, where it is seen from, not farther than a pixel.
        for (int k = -8; k <= 0 && !seekers_.empty() && !frame_.stopped(); k += 2)
            look_before(std::exp2(k));
        if (frame_.stopped()) {
            face_eye();
        } else if (!seekers_.empty()) {
            take_differences();
        }
    }
    /// Where gradients are searched, if somebody wants to know what that costs.
    [[nodiscard]] std::vector<std::size_t> searched_pixels() const {
        std::vector<std::size_t> pixels;
        if (counters_.costs == nullptr) return pixels;
        for (const std::vector<Seeker>* const some : {&jumps_, &seekers_}) {
            for (const Seeker& seeker : *some)
                pixels.push_back(seeker.pixel);
        }
        return pixels;
    }
    [[nodiscard]] Seeker seeker(const Tile& tile, const TileHits::Point& point) const;
    std::vector<Sample> ask(const std::vector<glm::dvec3>& points) {
        counters_.value += points.size();
        return values_.at(points);
    }
    /// Takes the normals of the surfaces on which f jumps.
    void take_jumps();
    /// Asks f at both ends of the brackets of which nothing is known.
    void find_trends();
    /// Finds the roots through which f is known to go, and its gradients right before them.
    void polish();
    /// Takes gradients at a distance before the hit, in pixels.
    void look_before(double pixels);
    /// Takes differences over a pixel; where those are 0, too, the surface faces the eye.
    void take_differences();
    /// Takes surfaces for ones that face the eye.
    void face_eye() {
        for (const Seeker& seeker : seekers_)
            take(seeker, seeker.trend == Trend::Rising ? seeker.direction : -seeker.direction);
        seekers_.clear();
    }
    void take(const Seeker& seeker, const glm::dvec3& gradient) {
        const auto floats = float_gradient({gradient.x, gradient.y, gradient.z});
        for (std::size_t k = 0; k < 3; ++k)
            hits_.gradient[k][seeker.pixel] = floats[k];
    }

    const TraceFrame& frame_;
    TileHits& hits_;
    Counters& counters_;
    PointValues values_;
    double tolerance_, tiny_;
    std::vector<Seeker> seekers_;  ///< those that have no gradient yet
    std::vector<Seeker> jumps_;    ///< hits that are no roots
};

Seeker GradientSearch::seeker(const Tile& tile, const TileHits::Point& point) const {
    const auto col = static_cast<int>(point.pixel % tile_size);
    const auto row = static_cast<int>(point.pixel / tile_size);
    const PixelRay ray = pixel_ray(frame_.view, tile.place(col, row), frame_.image);
    const glm::dvec3 start(point.position[0], point.position[1], point.position[2]);
    const double depth = glm::dot(start - frame_.view.eye, frame_.view.forward);
    const double away =
        frame_.view.parallel() ? 1.0 : std::max(depth, 0.0) / frame_.view.look_distance;
    return {.pixel = point.pixel,
            .start = start,
            .direction = ray.direction,
            .pixel_size = away * frame_.view.pixel_at_look(frame_.image.height),
            .trend = point.trend,
            .lo = -tolerance_,
            .hi = tolerance_,
            .next = -tiny_,
            .before = std::nullopt};
}

void GradientSearch::take_jumps() {
    if (jumps_.empty()) return;
    std::vector<JumpPlace> places;
    places.reserve(jumps_.size());
    for (const Seeker& seeker : jumps_)
        places.push_back({.position = seeker.start,
                          .direction = seeker.direction,
                          .pixel_size = seeker.pixel_size,
                          .trend = seeker.trend});
    const auto values = [&](const std::vector<glm::dvec3>& points) {
        std::vector<double> result;
        for (const Sample& sample : ask(points))
            result.push_back(sample.f);
        return result;
    };
    const std::vector<glm::dvec3> normals = jump_normals(places, values);
    for (std::size_t i = 0; i < jumps_.size(); ++i)
        take(jumps_[i], normals[i]);
}

void GradientSearch::find_trends() {
    std::vector<Seeker*> open;
    std::vector<glm::dvec3> points;
    for (Seeker& seeker : seekers_) {
        if (seeker.trend != Trend::Unknown) continue;
        open.push_back(&seeker);
        points.push_back(seeker.at(seeker.lo));
        points.push_back(seeker.at(seeker.hi));
    }
    if (open.empty()) return;
    const std::vector<Sample> samples = ask(points);
    if (frame_.stopped()) return;
    for (std::size_t i = 0; i < open.size(); ++i) {
        const double before = samples[2 * i].f;
        const double behind = samples[2 * i + 1].f;
        if (before < 0.0 && behind > 0.0) open[i]->trend = Trend::Rising;
        if (before > 0.0 && behind < 0.0) open[i]->trend = Trend::Falling;
    }
}

void GradientSearch::polish() {
    constexpr int most_steps = 64;
    std::vector<Seeker*> open;
    for (Seeker& seeker : seekers_) {
        if (seeker.trend != Trend::Unknown) open.push_back(&seeker);
    }
    for (int step = 0; step < most_steps && !open.empty() && !frame_.stopped(); ++step) {
        std::vector<glm::dvec3> points;
        points.reserve(open.size());
        for (const Seeker* seeker : open)
            points.push_back(seeker->at(seeker->next));
        const std::vector<Sample> samples = ask(points);
        if (frame_.stopped()) break;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (open[i]->narrow(samples[i], tiny_)) open[kept++] = open[i];
        }
        open.resize(kept);
    }
    std::erase_if(seekers_, [&](const Seeker& seeker) {
        if (seeker.before) take(seeker, *seeker.before);
        return seeker.before.has_value();
    });
}

void GradientSearch::look_before(double pixels) {
    std::vector<glm::dvec3> points;
    points.reserve(seekers_.size());
    for (const Seeker& seeker : seekers_)
        points.push_back(seeker.at(-pixels * seeker.pixel_size));
    const std::vector<Sample> samples = ask(points);
    if (frame_.stopped()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        Seeker& seeker = seekers_[i];
        // On the way to a root f falls where it is above 0.
        if (seeker.trend == Trend::Unknown && samples[i].f != 0.0)
            seeker.trend = samples[i].f > 0.0 ? Trend::Falling : Trend::Rising;
        if (seeker.fits(samples[i])) {
            take(seeker, samples[i].gradient);
        } else {
            seekers_[kept++] = seeker;
        }
    }
    seekers_.resize(kept);
}

void GradientSearch::take_differences() {
    std::vector<glm::dvec3> points;
    for (const Seeker& seeker : seekers_) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0.0);
            step[axis] = 0.5 * seeker.pixel_size;
            points.push_back(seeker.start + step);
            points.push_back(seeker.start - step);
        }
    }
    const std::vector<Sample> samples = ask(points);
    for (std::size_t i = 0; i < seekers_.size(); ++i) {
        const auto difference = [&](std::size_t axis) {
            return samples[6 * i + 2 * axis].f - samples[6 * i + 2 * axis + 1].f;
        };
        const Sample over_pixel{.f = 0.0,
                                .gradient = {difference(0), difference(1), difference(2)}};
        const double way = seekers_[i].trend == Trend::Rising ? 1.0 : -1.0;
        const bool fits = seekers_[i].fits(over_pixel);
        take(seekers_[i], fits ? over_pixel.gradient : way * seekers_[i].direction);
    }
    seekers_.clear();
}

}  // namespace

void find_gradients(const TraceFrame& frame, const Tile& tile, TileHits& hits, Counters& counters) {
    constexpr float none = std::numeric_limits<float>::infinity();
    std::erase_if(hits.points,
                  [&](const TileHits::Point& point) { return hits.depth[point.pixel] == none; });
    if (!hits.points.empty()) GradientSearch(frame, tile, hits, counters).run();
    hits.points.clear();
}

}  // namespace zeroset
