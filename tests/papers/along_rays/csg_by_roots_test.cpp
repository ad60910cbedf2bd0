#include "engine/render/render.hpp"
#include "papers/along_rays/csg_parts.hpp"
#include "tests/engine/render/hooked_kernel.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// Solids by the roots of their parts, against balls and half-spaces whose roots on a ray are known
// in closed form, and combined by sets of points.

namespace zeroset::test::csg_by_roots_test {
namespace {

/// A solid: its text, whether it holds a point, and the roots of all its parts on a ray.
struct Solid {
    std::string text;
    std::function<bool(const glm::dvec3&)> holds;
    std::function<std::vector<double>(const Ray&)> roots;
};

std::string number(double value) { return "(" + std::to_string(value) + ")"; }

Solid ball(const glm::dvec3& centre, double radius) {
    const auto square = [](const char* name, double at) {
        return "(" + std::string(name) + " - " + number(at) + ")^2";
    };
    return {.text = square("x", centre.x) + " + " + square("y", centre.y) + " + " +
                    square("z", centre.z) + " - " + number(radius) + "^2",
            .holds = [=](const glm::dvec3& p) { return glm::length(p - centre) < radius; },
            .roots =
                [=](const Ray& ray) {
                    const glm::dvec3 from = ray.eye - centre;
                    const double middle = -glm::dot(from, ray.direction);
                    const double gap = glm::length(from + middle * ray.direction);
                    if (gap > radius) return std::vector<double>{};
                    const double half = std::sqrt((radius - gap) * (radius + gap));
                    return std::vector<double>{middle - half, middle + half};
                }};
}

Solid half_space(const glm::dvec3& normal, double offset) {
    return {.text = number(normal.x) + "x + " + number(normal.y) + "y + " + number(normal.z) +
                    "z - " + number(offset),
            .holds = [=](const glm::dvec3& p) { return glm::dot(p, normal) < offset; },
            .roots =
                [=](const Ray& ray) {
                    const double t =
                        (offset - glm::dot(normal, ray.eye)) / glm::dot(normal, ray.direction);
                    return std::vector<double>{t};
                }};
}

enum class Operation : std::uint8_t { Union, Intersection, Difference };

Solid combined(Operation operation, const Solid& a, const Solid& b) {
    const auto join = [operation](bool in_a, bool in_b) {
        switch (operation) {
            case Operation::Union: return in_a || in_b;
            case Operation::Intersection: return in_a && in_b;
            case Operation::Difference: break;
        }
        return in_a && !in_b;
    };
    const std::string function = operation == Operation::Union ? "min(" : "max(";
    const std::string second = operation == Operation::Difference ? ", -(" : ", (";
    return {.text = function + a.text + second + b.text + "))",
            .holds = [=](const glm::dvec3& p) { return join(a.holds(p), b.holds(p)); },
            .roots =
                [=](const Ray& ray) {
                    std::vector<double> roots = a.roots(ray);
                    std::ranges::copy(b.roots(ray), std::back_inserter(roots));
                    return roots;
                }};
}

/// The first root of the solid in the box: the first place at which what is before it and what is
/// behind it differ. `gap`: the least distance of any two roots of parts before it, and from it.
struct FirstRoot {
    double t = infinity;
    double gap = infinity;
};

FirstRoot first_root(const Solid& solid, const Ray& ray) {
    FirstRoot first;
    if (!(ray.t_in < ray.t_out)) return first;
    std::vector<double> roots = solid.roots(ray);
    roots.push_back(ray.t_in);
    roots.push_back(ray.t_out);
    std::ranges::sort(roots);
    const auto holds = [&](double a, double b) { return solid.holds(ray.at(0.5 * (a + b))); };
    for (std::size_t i = 1; i < roots.size(); ++i)
        first.gap = std::min(first.gap, roots[i] - roots[i - 1]);
    for (std::size_t i = 1; i + 1 < roots.size(); ++i) {
        if (roots[i] <= ray.t_in || roots[i] >= ray.t_out) continue;
        if (holds(roots[i - 1], roots[i]) == holds(roots[i], roots[i + 1])) continue;
        first.t = roots[i];
        break;
    }
    return first;
}

struct Drawn {
    Scene scene;
    Camera camera;
    Framebuffer frame;

    Drawn(const std::string& text, const Camera& from, int size)
        : scene(scene_of(text, Box::cube(4))), camera(from), frame(size, size) {
        render_frame(scene, camera, settings_at("csg-by-roots", 20), frame);
    }
    [[nodiscard]] Ray ray(std::size_t i) const {
        return {camera, scene.clip, static_cast<int>(i) % frame.width,
                static_cast<int>(i) / frame.width, frame};
    }
};

/// From the left, along x: the middle ray meets x at t = x + 5.
Camera along_x() {
    return {.eye = {-5, 0, 0}, .look_at = {0, 0, 0}, .up = {0, 0, 1}, .fov_rad = 0.6};
}

/// A ball that the middle ray is in between these t.
Solid ball_between(double from, double to) {
    return ball({0.5 * (from + to) - 5.0, 0, 0}, 0.5 * (to - from));
}

double middle_root(const std::string& text) {
    const Drawn drawn(text, along_x(), 21);
    const std::size_t middle = drawn.frame.depth.size() / 2;
    EXPECT_NE(drawn.frame.certificate[middle], Certificate::Undecided) << text;
    return static_cast<double>(drawn.frame.depth[middle]);
}

/// The roots that the thesis's rule takes, max(t1, t2) for unions and min(t1, t2) for the others,
/// are wrong here, and so are those of the rule the other way round.
TEST(CsgByRoots, IsRightWhereThePrintedRuleIsNot) {
    const Solid near = ball_between(2, 4);
    const Solid far = ball_between(3, 5);
    EXPECT_NEAR(middle_root(combined(Operation::Union, near, far).text), 2.0, 1e-4);
    EXPECT_NEAR(middle_root(combined(Operation::Intersection, near, far).text), 3.0, 1e-4);
    EXPECT_NEAR(middle_root(combined(Operation::Difference, far, near).text), 4.0, 1e-4);
    EXPECT_NEAR(middle_root(combined(Operation::Difference, near, far).text), 2.0, 1e-4);
    const Solid behind = ball_between(6, 7);
    EXPECT_EQ(middle_root(combined(Operation::Intersection, near, behind).text), infinity);
    const Solid pair = combined(Operation::Union, near, behind);
    EXPECT_NEAR(middle_root(combined(Operation::Intersection, ball_between(5, 8), pair).text), 6.0,
                1e-4);
    // The near ball is cut away, and the far one is whole.
    EXPECT_NEAR(middle_root(combined(Operation::Difference, pair, ball_between(1.5, 4.5)).text),
                6.0, 1e-4);
}

/// Parts that only touch 0, or are 0 in the same place, neither hide a root nor make one.
TEST(CsgByRoots, NeedsNoCareWherePartsTouch0) {
    EXPECT_NEAR(middle_root("max(x^2 + y^2 + z^2 - 1, -(x + 2)^2)"), 4.0, 1e-4);
    EXPECT_NEAR(middle_root("max(x^2 + y^2 + z^2 - 1, x^2 + y^2 + z^2 - 1 + 0y)"), 4.0, 1e-4);
    EXPECT_NEAR(middle_root("min(x^2 + y^2 + z^2 - 1, (x + 2)^2 + 0.5)"), 4.0, 1e-4);
    EXPECT_NEAR(middle_root("max(x^2 + y^2 + z^2 - 1, 1/(x + 2) - 9)"), 4.0, 1e-4);
}

Solid random_solid(RandomNumbers& random, int depth) {
    if (depth == 0) {
        const auto coordinate = [&] { return random.uniform(-1.5, 1.5); };
        const glm::dvec3 at(coordinate(), coordinate(), coordinate());
        if (random.one_in(4)) return half_space(at, random.uniform(-0.5, 0.5));
        return ball(at, random.uniform(0.4, 1.8));
    }
    const Solid a = random_solid(random, depth - 1);
    const Solid b = random_solid(random, random.between(0, depth - 1));
    return combined(static_cast<Operation>(random.below(3)), a, b);
}

/// Each certified hit is the solid's first root, and no ray that has one is shown as empty.
TEST(CsgByRoots, AgreesWithSetsOfPoints) {
    RandomNumbers random(22);
    constexpr double near = 1e-3;
    std::size_t certified = 0;
    for (int run = 0; run < 60; ++run) {
        const Solid solid = random_solid(random, 1 + run % 3);
        const glm::dvec3 eye(random.uniform(5, 7), random.uniform(-4, 4), random.uniform(-4, 4));
        const Drawn drawn(solid.text, {.eye = eye, .fov_rad = 0.7}, 24);
        for (std::size_t i = 0; i < drawn.frame.depth.size(); ++i) {
            SCOPED_TRACE(solid.text + ", pixel " + std::to_string(i));
            const FirstRoot first = first_root(solid, drawn.ray(i));
            const auto depth = static_cast<double>(drawn.frame.depth[i]);
            if (first.gap < near) continue;
            if (drawn.frame.certificate[i] == Certificate::Certified) {
                EXPECT_NEAR(depth, first.t, near);
                ++certified;
            }
            if (first.t < infinity) {
                EXPECT_NE(drawn.frame.certificate[i], Certificate::Miss) << first.t;
                EXPECT_LE(depth, first.t + near);
            } else {
                EXPECT_NE(drawn.frame.certificate[i], Certificate::Certified);
            }
        }
    }
    EXPECT_GT(certified, 8000U);
}

/// f itself is asked only where a part has a root.
TEST(CsgByRoots, SearchesPartsOneByOne) {
    const Solid two = combined(Operation::Difference, ball({0, 0, 0}, 1), ball({0.5, 0, 0}, 0.8));
    std::atomic<int> whole{0};
    std::atomic<int> parts{0};
    Scene scene = scene_of(two.text, Box::cube(4));
    Kernel& kernel = scene.surfaces[0].kernel;
    const std::vector<Kernel> own = kernel.memory->of<CsgParts>()->kernels();
    ASSERT_EQ(own.size(), 2U);
    kernel = hooked(kernel, [&] { ++whole; });
    kernel.memory = std::make_shared<KernelMemory>();
    kernel.memory->of<CsgParts>()->set([&] {
        std::vector<Kernel> made;
        for (const Kernel& part : own)
            made.push_back(hooked(part, [&] { ++parts; }));
        return made;
    });
    kernel.specializer = nullptr;
    Framebuffer frame(20, 20);
    render_frame(scene, along_x(), settings_at("csg-by-roots", 20), frame);
    const int by_roots = whole;
    EXPECT_GT(parts, by_roots);
    whole = 0;
    render_frame(scene, along_x(), settings_at("mrfro", 20), frame);
    EXPECT_LT(by_roots, whole);
}

TEST(CsgByRoots, IsMrfroOnAFormulaWithoutParts) {
    const Scene scene = scene_of("x^4 + y^4 + z^4 - 1.2x^2 = 0.3", Box::cube(2));
    EXPECT_TRUE(scene.surfaces[0].kernel.memory->of<CsgParts>()->kernels().empty());
    Framebuffer by_roots(40, 40);
    Framebuffer mrfro(40, 40);
    const Camera camera = default_camera(scene.clip);
    const Counters a = render_frame(scene, camera, settings_at("csg-by-roots", 20), by_roots);
    const Counters b = render_frame(scene, camera, settings_at("mrfro", 20), mrfro);
    EXPECT_EQ(a.range, b.range);
    EXPECT_EQ(by_roots.depth, mrfro.depth);
    EXPECT_EQ(by_roots.certificate, mrfro.certificate);
}

}  // namespace
}  // namespace zeroset::test::csg_by_roots_test
