#include "engine/appearance/path_hits.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/trace/hit_gradients.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// How far a depth may be from the root, as TileHits has them.
double depth_error(const TraceFrame& surface, double depth) {
    const double cell = std::ldexp(surface.scene.clip.size(), -surface.depth.wanted);
    return 4.0 * cell + 0x1p-21 * (std::abs(depth) + glm::length(surface.view.eye));
}

/// Takes hits along their rays to where f is 0.
class Sharpener {
public:
    Sharpener(const TraceFrame& surface, std::span<PathHit> hits, Counters& counters)
        : surface_(surface), hits_(hits), counters_(counters) {
        starts_.reserve(hits.size());
        for (const PathHit& hit : hits)
            starts_.push_back(hit.hit.t);
    }
    void run() {
        constexpr int steps = 3;
        batch_.resize(hits_.size());
        for (int step = 0; step < steps && !surface_.stopped(); ++step)
            advance();
    }

private:
    void advance() {
        for (std::size_t i = 0; i < hits_.size(); ++i) {
            const glm::dvec3 point = hits_[i].point();
            batch_.set(i, point.x, point.y, point.z);
        }
        batch_.pad();
        counters_.value += hits_.size();
        batch_.evaluate(surface_.kernel.in_double.value, surface_.scene.uniforms.points<double>(),
                        [this] { return surface_.stopped(); });
        for (std::size_t i = 0; i < hits_.size(); ++i)
            take(i);
    }
    void take(std::size_t i) {
        PathHit& at = hits_[i];
        if (at.is_cap) return;
        const glm::dvec3 gradient(batch_.gradient(0, i), batch_.gradient(1, i),
                                  batch_.gradient(2, i));
        const double step = -batch_.f(i) / glm::dot(gradient, glm::dvec3(at.path.ray.direction));
        const double next = at.hit.t + step;
        const double allowed = depth_error(surface_, starts_[i]);
        if (!(std::abs(next - starts_[i]) <= 2.0 * allowed)) return;
        at.hit.t = next;
        at.hit.error = std::min(
            std::abs(step) + 0x1p-46 * (std::abs(next) + glm::length(at.path.ray.origin)), allowed);
    }

    const TraceFrame& surface_;
    std::span<PathHit> hits_;
    Counters& counters_;
    std::vector<double> starts_;
    PointBatch<double> batch_;
};

}  // namespace

glm::dvec3 PathHit::normal() const {
    const glm::dvec3 along = path.ray.direction;
    const double size =
        std::max({std::abs(hit.gradient.x), std::abs(hit.gradient.y), std::abs(hit.gradient.z)});
    if (!(size > 0.0) || !std::isfinite(size)) return -along;
    const glm::dvec3 normal = glm::normalize(hit.gradient / size);
    return glm::dot(normal, along) > 0.0 ? -normal : normal;
}

void add_first_hits(const TraceFrame& surface, std::uint8_t number, const Tile& tile,
                    const TileHits& hits, std::vector<PathHit>& out) {
    const auto add = [&](std::size_t pixel, const PixelRay& ray, double distance) {
        out.push_back({.path = {.ray = {.origin = ray.origin, .direction = ray.direction},
                                .pixel = pixel,
                                .weight = glm::vec3(1.0F)},
                       .hit = {.t = distance,
                               .surface = number,
                               .certificate = hits.certificate[pixel],
                               .error = depth_error(surface, distance),
                               .gradient = hits.gradient_at(pixel)},
                       .is_cap = hits.is_cap(pixel),
                       .is_first = true});
    };
    for_each_hit(surface, tile, hits, add);
}

void sharpen(const TraceFrame& surface, std::span<PathHit> hits, Counters& counters) {
    if (!hits.empty()) Sharpener(surface, hits, counters).run();
}

}  // namespace zeroset
