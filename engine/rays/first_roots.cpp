#include "engine/rays/first_roots.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/rays/root_search.hpp"
#include "engine/rays/union_rays.hpp"
#include "engine/trace/ways/surface_ways.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>

namespace zeroset {
namespace {

/// A root on its way to the digits of double.
struct Seeker {
    std::size_t task;
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

/// A stretch of a ray that is to be searched.
struct Task {
    std::size_t ray;  ///< among all of them
    SceneRay stretch;
    RayStart start;
};

class Polish {
public:
    Polish(const TraceFrame& surface, std::span<const Task> tasks, Counters& counters)
        : surface_(surface), tasks_(tasks), counters_(counters) {}

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
    std::span<const Task> tasks_;
    Counters& counters_;
    std::vector<Seeker*> open_;
    PointBatch<double> batch_;
};

void Polish::advance() {
    batch_.resize(open_.size());
    for (std::size_t i = 0; i < open_.size(); ++i) {
        const glm::dvec3 point = tasks_[open_[i]->task].stretch.at(open_[i]->at);
        batch_.set(i, point.x, point.y, point.z);
    }
    batch_.pad();
    counters_.value += open_.size();
    batch_.evaluate(surface_.kernel.in_double.value, surface_.scene.uniforms.points<double>(),
                    [this] { return surface_.stopped(); });
    for (std::size_t i = 0; i < open_.size(); ++i) {
        Seeker& seeker = *open_[i];
        seeker.gradient = {batch_.gradient(0, i), batch_.gradient(1, i), batch_.gradient(2, i)};
        const glm::dvec3 along = tasks_[seeker.task].stretch.direction;
        seeker.take(batch_.f(i), glm::dot(seeker.gradient, along));
    }
}

RayStart start_of(const SceneRay& ray, std::uint8_t surface) {
    return ray.own == surface ? RayStart::OnSurface : RayStart::Anywhere;
}

/// How a ray begins in a part of a union that it meets.
RayStart start_in(const UnionRays::Meeting& meeting, std::uint8_t surface) {
    const bool is_own = meeting.at_start && meeting.stretch.own == surface;
    return is_own ? RayStart::NotBelow : RayStart::Anywhere;
}

/// Finds the first roots of a surface, or of a part of a union, that are nearer than the hits so
/// far, which are of all rays.
void find_nearer(const TraceFrame& surface, std::uint8_t number, std::span<const Task> tasks,
                 std::span<RayHit> hits, Counters& counters) {
    std::vector<Seeker> seekers;
    for (std::size_t i = 0; i < tasks.size() && !surface.stopped(); ++i) {
        SceneRay ray = tasks[i].stretch;
        RayHit& hit = hits[tasks[i].ray];
        ray.to = std::min(ray.to, hit.t);
        if (!(ray.from < ray.to)) continue;
        const RootFinding found =
            search_ray(surface, ray, tasks[i].start, RootWish::First, counters);
        if (found.unsettled) hit.certificate = Certificate::Undecided;
        if (found.bracket)
            seekers.push_back({.task = i, .bracket = *found.bracket, .at = found.bracket->guess});
    }
    Polish(surface, tasks, counters).run(seekers);
    for (const Seeker& seeker : seekers) {
        RayHit& hit = hits[tasks[seeker.task].ray];
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

/// The tasks of a part of a union.
struct MemberTask {
    const Kernel* kernel;
    Task task;
};

/// Searches a surface as far as rays need it: whole, or the parts of a union that they meet.
void find_on_surface(const TraceFrame& surface, std::uint8_t number, std::span<const SceneRay> rays,
                     std::span<RayHit> hits, Counters& counters) {
    if (way_of(surface.kernel).find_first(surface, number, rays, hits, counters)) return;
    const UnionRays parts(surface, number, rays);
    std::vector<Task> whole;
    std::vector<MemberTask> of_members;
    std::vector<UnionRays::Meeting> meetings;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!parts.list(rays[i], meetings)) {
            whole.push_back({.ray = i, .stretch = rays[i], .start = start_of(rays[i], number)});
            continue;
        }
        for (const UnionRays::Meeting& meeting : meetings)
            of_members.push_back(
                {.kernel = meeting.kernel,
                 .task = {
                     .ray = i, .stretch = meeting.stretch, .start = start_in(meeting, number)}});
    }
    find_nearer(surface, number, whole, hits, counters);
    std::ranges::stable_sort(of_members, std::less<>(), &MemberTask::kernel);
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < of_members.size() && !surface.stopped();) {
        const Kernel* const kernel = of_members[i].kernel;
        tasks.clear();
        for (; i < of_members.size() && of_members[i].kernel == kernel; ++i)
            tasks.push_back(of_members[i].task);
        find_nearer(surface.with(*kernel, surface.limit), number, tasks, hits, counters);
    }
}

/// Whether a root of the surface lies on the ray, or may.
bool is_blocked(const TraceFrame& surface, std::uint8_t number, const UnionRays& parts,
                const SceneRay& ray, std::vector<UnionRays::Meeting>& meetings,
                Counters& counters) {
    if (!parts.list(ray, meetings))
        return search_ray(surface, ray, start_of(ray, number), RootWish::Any, counters)
            .bracket.has_value();
    return std::ranges::any_of(meetings, [&](const UnionRays::Meeting& meeting) {
        const TraceFrame part = surface.with(*meeting.kernel, surface.limit);
        return search_ray(part, meeting.stretch, start_in(meeting, number), RootWish::Any, counters)
            .bracket.has_value();
    });
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
        find_on_surface(surfaces[i], static_cast<std::uint8_t>(i), inside, hits, counters);
}

void find_blocked(std::span<const TraceFrame> surfaces, std::span<const SceneRay> rays,
                  std::span<std::uint8_t> blocked, Counters& counters) {
    assert(blocked.size() == rays.size());
    std::ranges::fill(blocked, std::uint8_t{0});
    std::vector<SceneRay> inside;
    inside.reserve(rays.size());
    for (const SceneRay& ray : rays)
        inside.push_back(clipped(ray, surfaces.front().scene));
    std::vector<UnionRays::Meeting> meetings;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const auto number = static_cast<std::uint8_t>(i);
        if (way_of(surfaces[i].kernel).find_blocked(surfaces[i], number, inside, blocked, counters))
            continue;
        const UnionRays parts(surfaces[i], number, inside);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const SceneRay& ray = inside[k];
            if (blocked[k] != 0 || !(ray.from < ray.to)) continue;
            if (surfaces[i].stopped()) return;
            blocked[k] = is_blocked(surfaces[i], number, parts, ray, meetings, counters) ? 1 : 0;
        }
    }
}

}  // namespace zeroset
