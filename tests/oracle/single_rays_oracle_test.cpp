#include "engine/interpret/interpret.hpp"
#include "engine/rays/first_roots.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/traceable.hpp"
#include "tests/oracle/ray_audit.hpp"
#include "tests/support/formulas.hpp"
#include "tests/support/oracle/ray_oracle.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

// The first roots on rays that go anywhere, on random surfaces, against the oracles.

namespace zeroset::test::single_rays_oracle_test {
namespace {

struct Counts {
    int hits = 0, misses = 0, undecided = 0, unknown = 0;
};

SceneRay random_ray(const Box& clip, RandomNumbers& random) {
    const auto point = [&] {
        glm::dvec3 at;  // by turns, as compilers evaluate arguments in different orders
        for (int i = 0; i < 3; ++i)
            at[i] = random.uniform(clip.lo[i], clip.hi[i]);
        return at;
    };
    const glm::dvec3 origin = point();
    return {.origin = origin, .direction = UnitVector(point() - origin)};
}

/// Whether a root is surely between these places, or surely none.
RayTruth truth_between(RayOracle& oracle, const SceneRay& ray, double from, double to) {
    if (!(from < to)) return RayTruth::Empty;
    const RayAnswer answer =
        oracle.answer({.eye = {ray.origin.x, ray.origin.y, ray.origin.z},
                       .direction = {ray.direction.x, ray.direction.y, ray.direction.z},
                       .inner_from = from,
                       .inner_to = to,
                       .outer_from = from,
                       .outer_to = to});
    // A touch may be passed by: neither a certificate nor its absence says otherwise.
    if (answer.truth == RayTruth::Hit && !answer.crosses) return RayTruth::Unknown;
    return answer.truth;
}

void check(const Scene& scene, RayOracle& oracle, const SceneRay& ray, const RayHit& hit,
           Counts& counts) {
    const SceneRay inside = clipped(ray, scene);
    const double spare = 1e-6 * scene.clip.size();
    if (hit.certificate == Certificate::Undecided) {
        ++counts.undecided;
        return;
    }
    const double end = hit.is_hit() ? hit.t : inside.to;
    const RayTruth before = truth_between(oracle, ray, inside.from + spare, end - spare);
    EXPECT_NE(before, RayTruth::Hit) << "there is a root before " << end;
    if (before == RayTruth::Unknown) ++counts.unknown;
    if (!hit.is_hit()) {
        ++counts.misses;
        return;
    }
    ++counts.hits;
    EXPECT_NE(truth_between(oracle, ray, hit.t - spare, hit.t + spare), RayTruth::Empty)
        << "there is no root at " << hit.t;
}

TEST(SingleRaysAgainstOracles, ProofsHoldOnRandomSurfaces) {
    Counts counts;
    RandomNumbers random(5);
    for (const AuditSurface& surface : random_surfaces(100, 17)) {
        const Program program = read_formula(surface.equation).value();
        const Expr& f = program.surfaces.front();
        Scene scene{{{.kernel = interpret(traceable(f))}}, surface.clip, {}};
        scene.uniforms.set(0, surface.w);
        const ViewFrame view(surface.camera);
        const TraceFrame frame =
            trace_frame(scene, scene.surfaces.front(), view, {.width = 64, .height = 64}, {});
        const std::vector<double> uniforms{surface.w};
        RayOracle oracle(f, uniforms);
        std::vector<SceneRay> rays;
        for (int i = 0; i < 60; ++i)
            rays.push_back(random_ray(scene.clip, random));
        std::vector<RayHit> hits(rays.size());
        std::vector<std::uint8_t> blocked(rays.size());
        {
            const UpwardRounding upward;
            Counters counters;
            find_first_hits({&frame, 1}, rays, hits, counters);
            find_blocked({&frame, 1}, rays, blocked, counters);
        }
        for (std::size_t i = 0; i < rays.size(); ++i) {
            SCOPED_TRACE(surface.equation + ", ray " + std::to_string(i));
            check(scene, oracle, rays[i], hits[i], counts);
            if (hits[i].certificate != Certificate::Undecided) {
                EXPECT_EQ(blocked[i] != 0, hits[i].is_hit());
            }
        }
    }
    std::printf("%d hits, %d misses, %d undecided, %d unknown\n", counts.hits, counts.misses,
                counts.undecided, counts.unknown);
    EXPECT_GT(counts.hits, 1000);
    EXPECT_GT(counts.misses, 1000);
    EXPECT_LT(counts.undecided, (counts.hits + counts.misses) / 10);
}

}  // namespace
}  // namespace zeroset::test::single_rays_oracle_test
