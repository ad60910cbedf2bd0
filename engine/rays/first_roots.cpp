#include "engine/rays/first_roots.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/rays/root_search.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace zeroset {
namespace {

/// A root on its way to the digits of double.
struct Seeker {
    std::size_t ray;
    RootBracket bracket;
    double at;
    double step = 0.0;  ///< the last one
    bool done = false;
    glm::dvec3 gradient{0.0};  ///< at the last point

    /// Takes f at `at`; `slope`: df/dt there.
    void take(double f, double slope);
};

void Seeker::take(double f, double slope) {
    if (std::isnan(f) || bracket.sign_before == 0) {
        step = bracket.to - bracket.from;
        done = true;
        return;
    }
    const double tiny = 0x1p-48 * (std::abs(bracket.from) + std::abs(bracket.to));
    const double newton = at - f / slope;
    if (std::abs(newton - at) <= tiny) {
        step = tiny;
        done = true;
        return;
    }
    const bool is_before = f * bracket.sign_before > 0.0;
    (is_before ? bracket.from : bracket.to) = at;
    const bool fits = newton > bracket.from && newton < bracket.to;
    const double next = fits ? newton : 0.5 * bracket.from + 0.5 * bracket.to;
    step = std::abs(next - at);
    done = step <= tiny;
    at = next;
}

class Polish {
public:
    Polish(const TraceFrame& surface, std::span<const SceneRay> rays, Counters& counters)
        : surface_(surface), rays_(rays), counters_(counters) {}

    void run(std::span<Seeker> seekers) {
        constexpr int most_steps = 12;
        for (int step = 0; step < most_steps && !surface_.stopped(); ++step) {
            open_.clear();
            for (Seeker& seeker : seekers) {
                if (!seeker.done) open_.push_back(&seeker);
            }
            if (open_.empty()) return;
            advance();
        }
    }

private:
    void advance();

    const TraceFrame& surface_;
    std::span<const SceneRay> rays_;
    Counters& counters_;
    std::vector<Seeker*> open_;
    PointBatch<double> batch_;
};

void Polish::advance() {
    batch_.resize(open_.size());
    for (std::size_t i = 0; i < open_.size(); ++i) {
        const glm::dvec3 point = rays_[open_[i]->ray].at(open_[i]->at);
        batch_.set(i, point.x, point.y, point.z);
    }
    batch_.pad();
    counters_.value += open_.size();
    batch_.evaluate(surface_.kernel.in_double.value, surface_.scene.uniforms.points<double>(),
                    [this] { return surface_.stopped(); });
    for (std::size_t i = 0; i < open_.size(); ++i) {
        Seeker& seeker = *open_[i];
        seeker.gradient = {batch_.gradient(0, i), batch_.gradient(1, i), batch_.gradient(2, i)};
        const glm::dvec3 along = rays_[seeker.ray].direction;
        seeker.take(batch_.f(i), glm::dot(seeker.gradient, along));
    }
}

/// Finds the surface's first roots that are nearer than the hits so far. `rays`: within the clip
/// box and the region.
void find_nearer(const TraceFrame& surface, std::uint8_t number, std::span<const SceneRay> rays,
                 std::span<RayHit> hits, Counters& counters) {
    std::vector<Seeker> seekers;
    for (std::size_t i = 0; i < rays.size() && !surface.stopped(); ++i) {
        SceneRay ray = rays[i];
        ray.to = std::min(ray.to, hits[i].t);
        if (!(ray.from < ray.to)) continue;
        const RootFinding found =
            search_ray(surface, ray, ray.own == number, RootWish::First, counters);
        if (found.unsettled) hits[i].certificate = Certificate::Undecided;
        if (found.bracket)
            seekers.push_back({.ray = i, .bracket = *found.bracket, .at = found.bracket->guess});
    }
    Polish(surface, rays, counters).run(seekers);
    for (const Seeker& seeker : seekers) {
        RayHit& hit = hits[seeker.ray];
        if (!(seeker.at < hit.t)) continue;
        const bool is_proved =
            seeker.bracket.is_proved && hit.certificate != Certificate::Undecided;
        hit = {.t = seeker.at,
               .surface = number,
               .certificate = is_proved ? Certificate::Certified : Certificate::Undecided,
               .error = seeker.step,
               .gradient = seeker.gradient};
    }
}

}  // namespace

void find_first_hits(std::span<const TraceFrame> surfaces, std::span<const SceneRay> rays,
                     std::span<RayHit> hits, Counters& counters) {
    assert(hits.size() == rays.size());
    std::ranges::fill(hits, RayHit());
    std::vector<SceneRay> inside;
    inside.reserve(rays.size());
    for (const SceneRay& ray : rays)
        inside.push_back(clipped(ray, surfaces.front().scene));
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        find_nearer(surfaces[i], static_cast<std::uint8_t>(i), inside, hits, counters);
}

void find_blocked(std::span<const TraceFrame> surfaces, std::span<const SceneRay> rays,
                  std::span<std::uint8_t> blocked, Counters& counters) {
    assert(blocked.size() == rays.size());
    std::ranges::fill(blocked, std::uint8_t{0});
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const SceneRay ray = clipped(rays[k], surfaces.front().scene);
        if (!(ray.from < ray.to)) continue;
        for (std::size_t i = 0; i < surfaces.size() && blocked[k] == 0; ++i) {
            if (surfaces[i].stopped()) return;
            const RootFinding found =
                search_ray(surfaces[i], ray, ray.own == i, RootWish::Any, counters);
            blocked[k] = found.bracket ? 1 : 0;
        }
    }
}

}  // namespace zeroset
