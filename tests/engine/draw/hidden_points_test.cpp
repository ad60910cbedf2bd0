#include "engine/draw/space_function.hpp"
#include "tests/engine/draw/drawings.hpp"
#include "tests/support/random_numbers.hpp"

#include <cmath>
#include <optional>

// Hidden parts of silhouettes against the roots on their rays, counted by many samples.

namespace zeroset::test::hidden_points_test {
namespace {

/// A closed surface of degree four with holes and random bumps.
std::string random_quartic(RandomNumbers& random) {
    std::string text = "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8";
    for (const char* const term : {"x^2 y", "y^2 z", "z^2 x", "x y z", "y z", "x y"})
        text += " + (" + std::to_string(random.uniform(-0.4, 0.4)) + ") " + term;
    return text + " = 0";
}

/// The facts that samples tell of a silhouette's ray.
struct RayFacts {
    int touches = 0;       ///< places where it touches the surface, up to the drawing's tolerance
    bool hidden = false;   ///< it crosses the surface before the last of these
    bool unclear = false;  ///< roots are too near to that
};

RayFacts facts_of(const TextScene& of, const Page& page, const PageRay& ray) {
    constexpr int samples = 3000;
    constexpr double beside = 0.06;
    const double far = 2.0 * glm::length(ray.origin);
    RayFacts facts;
    std::vector<double> roots;
    double touch = 0.0;
    std::optional<ValueAndGradient> last;
    for (int i = 0; i < samples; ++i) {
        const double t = far * i / samples;
        const glm::dvec3 at = ray.origin + t * ray.direction;
        const ValueAndGradient here = value_at(of.scene.surfaces[0].kernel, of.scene.uniforms, at);
        if (last && here.value * last->value < 0.0) roots.push_back(t);
        const double steepness = glm::length(here.gradient);
        const bool turns =
            last &&
            glm::dot(here.gradient, ray.direction) * glm::dot(last->gradient, ray.direction) < 0.0;
        if (turns && std::abs(here.value) < 0.3 * steepness / page.scale(at)) {
            ++facts.touches;
            touch = t;
        }
        last = here;
    }
    for (const double root : roots) {
        facts.hidden = facts.hidden || root < touch - beside;
        facts.unclear = facts.unclear || std::abs(root - touch + beside) < 0.5 * beside;
    }
    return facts;
}

TEST(HiddenPoints, AreBehindRootsOfTheirRays) {
    RandomNumbers random(5);
    int hidden = 0;
    int seen = 0;
    for (int i = 0; i < 3; ++i) {
        const TextScene of({random_quartic(random)}, Box::cube(3));
        const Camera camera = default_camera(Box::cube(3));
        const LineDrawing drawing = of.draw(camera, only(CurveKind::Silhouette));
        EXPECT_TRUE(drawing.in_time());
        const Page page(camera, drawing.size);
        for (const DrawnPath& path : drawing.paths) {
            const glm::dvec2 first = path.pieces.front()[0];
            const glm::dvec2 end = path.pieces.back()[3];
            for (const Bezier& piece : path.pieces) {
                for (const double t : {0.2, 0.5, 0.8}) {
                    const glm::dvec2 at = point_of(piece, t);
                    const double from_end =
                        std::min(glm::distance(at, first), glm::distance(at, end));
                    if (!path.closed && from_end < 2.0) continue;
                    const RayFacts facts = facts_of(of, page, page_ray(page, at));
                    if (facts.touches != 1 || facts.unclear) continue;
                    ++(path.hidden ? hidden : seen);
                    EXPECT_EQ(path.hidden, facts.hidden) << i << ": " << at.x << " " << at.y;
                }
            }
        }
    }
    EXPECT_GT(hidden, 10);
    EXPECT_GT(seen, 50);
}

}  // namespace
}  // namespace zeroset::test::hidden_points_test
