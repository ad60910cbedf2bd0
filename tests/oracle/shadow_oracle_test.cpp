#include "engine/interpret/interpret.hpp"
#include "engine/light/shade.hpp"
#include "engine/rewrite/traceable.hpp"
#include "engine/view/pixel_ray.hpp"
#include "tests/oracle/ray_audit.hpp"
#include "tests/support/formulas.hpp"
#include "tests/support/oracle/ray_oracle.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/shadow_tile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

// The proofs of find_shadows about single hits of random surfaces, against the oracles.

namespace zeroset::test::shadow_oracle_test {
namespace {

struct Counts {
    int lit = 0, dark = 0, unproved = 0, unknown = 0;
};

/// The ray from a hit to the light, without its first part.
RayQuestion ray_from(const glm::dvec3& hit, const glm::dvec3& to_light, const Box& clip,
                     double without) {
    double out = 1e9;
    for (int i = 0; i < 3; ++i) {
        const double wall = to_light[i] > 0 ? clip.hi[i] : clip.lo[i];
        out = std::min(out, (wall - hit[i]) / to_light[i]);
    }
    const double spare = 1e-5 * clip.size();
    return {.eye = {hit.x, hit.y, hit.z},
            .direction = {to_light.x, to_light.y, to_light.z},
            .inner_from = without,
            .inner_to = out - spare,
            .outer_from = without,
            .outer_to = out + spare};
}

/// A surface traced and lit, and the questions about it.
class ShadowAudit {
public:
    explicit ShadowAudit(const AuditSurface& surface)
        : surface_(surface), program_(read_formula(surface.equation).value()) {}

    void check(int rays, bool singly, RandomNumbers& random, Counts& counts);

private:
    void check_hit(const glm::dvec3& hit, const glm::dvec3& to_light, bool is_dark,
                   RayOracle& oracle, Counts& counts) const;

    const AuditSurface& surface_;
    Program program_;
};

void ShadowAudit::check_hit(const glm::dvec3& hit, const glm::dvec3& to_light, bool is_dark,
                            RayOracle& oracle, Counts& counts) const {
    // A root that hides the hit may be as near as rounding; one that does not is off its own root.
    const double without = (is_dark ? 1e-6 : 1e-3) * surface_.clip.size();
    const RayQuestion question = ray_from(hit, to_light, surface_.clip, without);
    if (question.inner_from >= question.inner_to) return;
    const RayAnswer answer = oracle.answer(question);
    if (answer.truth == RayTruth::Unknown) {
        ++counts.unknown;
        return;
    }
    ++(is_dark ? counts.dark : counts.lit);
    if (is_dark) {
        EXPECT_NE(answer.truth, RayTruth::Empty) << "dark, but there is no root";
    } else if (answer.truth == RayTruth::Hit && answer.crosses) {
        ADD_FAILURE() << "lit, but there is a root at " << answer.from;
    }
}

void ShadowAudit::check(int rays, bool singly, RandomNumbers& random, Counts& counts) {
    const Expr& f = program_.surfaces.front();
    Scene scene{{{.kernel = interpret(traceable(f))}}, surface_.clip, {}};
    scene.uniforms.set(0, surface_.w);
    const ViewFrame view(surface_.camera);
    const ImageSize image{.width = tile_size, .height = tile_size};
    const ShadowTile found =
        shadow_tile({trace_frame(scene, scene.surfaces.front(), view, image, {})},
                    {.col = 0, .row = 0, .cols = tile_size, .rows = tile_size}, singly);
    const TileHits& hits = found.hits.front();
    const std::vector<double> uniforms{surface_.w};
    RayOracle oracle(f, uniforms);
    const UnitVector to_light = key_light(view);
    for (int i = 0; i < rays; ++i) {
        const std::size_t at = random.below(hits.depth.size());
        if (hits.certificate[at] != Certificate::Certified || !std::isfinite(hits.depth[at]))
            continue;
        const int col = static_cast<int>(at % tile_size);
        const int row = static_cast<int>(at / tile_size);
        const PixelRay ray = pixel_ray(view, pixel_centre(col, row), image);
        const glm::dvec3 gradient(hits.gradient[0][at], hits.gradient[1][at], hits.gradient[2][at]);
        const bool shows_both =
            glm::dot(gradient, to_light) * glm::dot(gradient, ray.direction) < 0;
        if (!shows_both) continue;  // the light sees its other side
        if (has_bit(found.shadows.unproved, at)) {
            ++counts.unproved;
            continue;
        }
        SCOPED_TRACE(command_line(surface_, {.tracer = "beams", .size_px = tile_size}) +
                     " --shadows, pixel " + std::to_string(col) + "," + std::to_string(row));
        check_hit(ray.at(static_cast<double>(hits.depth[at])), to_light,
                  has_bit(found.shadows.dark, at), oracle, counts);
    }
}

TEST(ShadowsAgainstOracles, ProofsHoldOnRandomSurfaces) {
    Counts counts;
    RandomNumbers random(7);
    for (const AuditSurface& surface : random_surfaces(120, 11))
        ShadowAudit(surface).check(150, false, random, counts);
    std::printf("%d lit, %d dark, %d unproved, %d unknown\n", counts.lit, counts.dark,
                counts.unproved, counts.unknown);
    EXPECT_GT(counts.lit, 1000);
    EXPECT_GT(counts.dark, 200);
    EXPECT_LT(counts.unproved, (counts.lit + counts.dark) / 20);
}

/// Parts of pixels go to the light one by one, from the hit on.
TEST(ShadowsAgainstOracles, ProofsHoldOfSingleRays) {
    Counts counts;
    RandomNumbers random(8);
    for (const AuditSurface& surface : random_surfaces(60, 12))
        ShadowAudit(surface).check(150, true, random, counts);
    EXPECT_GT(counts.lit, 500);
    EXPECT_GT(counts.dark, 100);
    EXPECT_LT(counts.unproved, (counts.lit + counts.dark) / 20);
}

}  // namespace
}  // namespace zeroset::test::shadow_oracle_test
