#include "engine/render/render.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/only_target.hpp"
#include "tests/support/patch_scenes.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

// Parametric surfaces against closed forms: no hit is missed, none is wrong.

namespace zeroset::test::patch_tracer_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Where a ray meets the surface: all distances.
using Roots = std::function<std::vector<double>(const Ray& ray)>;

struct PatchCase {
    std::string name;
    std::array<std::string, 3> texts;
    Roots roots;
    Camera camera;
    Box clip = Box::cube(2);
    Region region = {};
    std::optional<std::array<double, 6>> own_box = std::nullopt;
};

std::vector<double> unit_sphere_roots(const Ray& ray) { return sphere_roots(ray, 1.0); }

/// The box that a sphere is cut to by itself.
constexpr std::array<double, 6> own_box{-0.7, 2.0, -2.0, 0.3, -0.8, 2.0};

std::vector<double> cut_sphere_roots(const Ray& ray) {
    std::vector<double> roots;
    for (const double t : unit_sphere_roots(ray)) {
        const glm::dvec3 at = ray.at(t);
        if (at.x >= own_box[0] && at.x <= own_box[1] && at.y >= own_box[2] && at.y <= own_box[3] &&
            at.z >= own_box[4] && at.z <= own_box[5])
            roots.push_back(t);
    }
    return roots;
}

/// The square -1 < x, y < 1 of the plane z = 0.3 x.
std::vector<double> square_roots(const Ray& ray) {
    const double t = plane_root(ray, {-0.3, 0.0, 1.0}, 0.0);
    const glm::dvec3 at = ray.at(t);
    if (std::abs(at.x) > 1.0 || std::abs(at.y) > 1.0) return {};
    return {t};
}

std::vector<double> torus_roots(const Ray& ray) {
    const double t = torus_root(ray, ray.t_in);
    return {t};
}

/// f on the ray by its signs at many places and bisection.
std::vector<double> sign_changes(const Ray& ray, const std::function<double(double)>& f) {
    constexpr int places = 1500;
    std::vector<double> roots;
    const double step = (ray.t_out - ray.t_in) / places;
    for (int i = 0; i < places; ++i) {
        double lo = ray.t_in + i * step;
        double hi = lo + step;
        if (f(lo) * f(hi) > 0.0) continue;
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * lo + 0.5 * hi;
            (f(lo) * f(middle) <= 0.0 ? hi : lo) = middle;
        }
        roots.push_back(0.5 * lo + 0.5 * hi);
    }
    return roots;
}

/// The roots of a quadric f(x, y, z) = 0 where |z| < 1.
std::vector<double> quadric_roots(const Ray& ray, double (*f)(double x, double y, double z)) {
    std::vector<double> roots = quadratic_roots(ray, [&](double t) {
        const glm::dvec3 at = ray.at(t);
        return f(at.x, at.y, at.z);
    });
    std::erase_if(roots, [&](double t) { return !(std::abs(ray.at(t).z) < 1.0); });
    return roots;
}

std::vector<double> cone_roots(const Ray& ray) {
    return quadric_roots(ray, [](double x, double y, double z) { return x * x + y * y - z * z; });
}
std::vector<double> hyperboloid_roots(const Ray& ray) {
    return quadric_roots(ray,
                         [](double x, double y, double z) { return x * x + y * y - z * z - 0.25; });
}
std::vector<double> saddle_roots(const Ray& ray) {
    return quadric_roots(ray, [](double x, double y, double z) { return x * x - y * y - z; });
}

/// Whitney's umbrella (u v, u, v^2), |u|, |v| < 1.
std::vector<double> umbrella_roots(const Ray& ray) {
    std::vector<double> roots = sign_changes(ray, [&](double t) {
        const glm::dvec3 at = ray.at(t);
        return at.x * at.x - at.y * at.y * at.z;
    });
    std::erase_if(roots, [&](double t) {
        const glm::dvec3 at = ray.at(t);
        return !(at.z > 0.0 && at.z < 1.0 && std::abs(at.y) < 1.0);
    });
    return roots;
}

/// The Moebius strip of ring 1 and half width 0.5, by its cubic.
std::vector<double> moebius_roots(const Ray& ray) {
    const auto f = [&](double t) {
        const auto [x, y, z] = std::array{ray.at(t).x, ray.at(t).y, ray.at(t).z};
        return -y + x * x * y + y * y * y - 2 * x * z - 2 * x * x * z - 2 * y * y * z + y * z * z;
    };
    std::vector<double> roots;
    for (const double t : sign_changes(ray, f)) {
        const glm::dvec3 at = ray.at(t);
        const double u = std::atan2(at.y, at.x);
        const double aside = std::hypot(at.x, at.y) - 1.0;
        const double v = aside * std::cos(0.5 * u) + at.z * std::sin(0.5 * u);
        const double off = aside * std::sin(0.5 * u) - at.z * std::cos(0.5 * u);
        if (std::abs(v) < 0.5 && std::abs(off) < 1e-6) roots.push_back(t);
    }
    return roots;
}

/// The helicoid (r cos z, r sin z), 0 < r < 1.5, |z| < pi / 2.
std::vector<double> helicoid_roots(const Ray& ray) {
    const auto f = [&](double t) {
        const glm::dvec3 at = ray.at(t);
        return at.x * std::sin(at.z) - at.y * std::cos(at.z);
    };
    std::vector<double> roots;
    for (const double t : sign_changes(ray, f)) {
        const glm::dvec3 at = ray.at(t);
        const double r = at.x * std::cos(at.z) + at.y * std::sin(at.z);
        if (r > 0.0 && r < 1.5 && std::abs(at.z) < 0.5 * pi) roots.push_back(t);
    }
    return roots;
}

std::vector<PatchCase> cases() {
    const Box cube = Box::cube(2);
    const Camera usual = default_camera(Box::cube(1.2));
    const Camera inside{{0.1, -0.2, 0.15}, {1, 0.5, 0.25}, {0, 0, 1}, 1.5};
    Camera down{{0.25, 0, 7}, {0.25, 0, 0}, {0, 1, 0}, 0.5};
    down.projection = Projection::Orthographic;
    const std::array<std::string, 3> sphere{"cos(pi*(x-1/2))*cos(2*pi*y)",
                                            "cos(pi*(x-1/2))*sin(2*pi*y)", "sin(pi*(x-1/2))"};
    const std::array<std::string, 3> torus{"(1+cos(2*pi*x)/2)*cos(2*pi*y)",
                                           "(1+cos(2*pi*x)/2)*sin(2*pi*y)", "sin(2*pi*x)/2"};
    const std::array<std::string, 3> square{"2*x-1", "2*y-1", "0.3*(2*x-1)"};
    const std::array<std::string, 3> moebius{"(1+(y-1/2)*cos(pi*x))*cos(2*pi*x)",
                                             "(1+(y-1/2)*cos(pi*x))*sin(2*pi*x)",
                                             "(y-1/2)*sin(pi*x)"};
    const std::array<std::string, 3> helicoid{"1.5*x*cos(pi*(y-1/2))", "1.5*x*sin(pi*(y-1/2))",
                                              "pi*(y-1/2)"};
    const std::array<std::string, 3> cone{"(2*x-1)*cos(2*pi*y)", "(2*x-1)*sin(2*pi*y)", "2*x-1"};
    const std::array<std::string, 3> hyperboloid{
        "0.5*cosh(3*x-3/2)*cos(2*pi*y)", "0.5*cosh(3*x-3/2)*sin(2*pi*y)", "0.5*sinh(3*x-3/2)"};
    const std::array<std::string, 3> saddle{"4*x-2", "4*y-2", "(4*x-2)^2-(4*y-2)^2"};
    const std::array<std::string, 3> umbrella{"(2*x-1)*(2*y-1)", "2*x-1", "(2*y-1)^2"};
    const Box slab{{-2, -2, -1}, {2, 2, 1}};
    const Region ball{Ball{{0.2, -0.3, 0.4}, 0.9}, {}};
    const Region half{{}, {make_section({1, 0, 0}, 0.3, false)}};
    return {{"sphere", sphere, unit_sphere_roots, usual},
            {"sphere from inside", sphere, unit_sphere_roots, inside},
            {"parallel: sphere", sphere, unit_sphere_roots, down},
            {"sphere cut by the box",
             sphere,
             unit_sphere_roots,
             usual,
             {{-0.7, -2, -0.8}, {2, 0.3, 2}}},
            {"sphere cut by a box of its own", sphere, cut_sphere_roots, usual, cube, {}, own_box},
            {"sphere in a ball", sphere, unit_sphere_roots, usual, cube, ball},
            {"half a sphere", sphere, unit_sphere_roots, usual, cube, half},
            {"square", square, square_roots, usual},
            {"square from above", square, square_roots, down},
            {"torus", torus, torus_roots, usual},
            {"torus from above", torus, torus_roots, down},
            {"cone", cone, cone_roots, usual},
            {"cone from above", cone, cone_roots, down},
            {"hyperboloid", hyperboloid, hyperboloid_roots, usual, slab},
            {"saddle", saddle, saddle_roots, usual, slab},
            {"saddle from inside", saddle, saddle_roots, inside, slab},
            {"umbrella", umbrella, umbrella_roots, usual},
            {"Moebius strip", moebius, moebius_roots, usual},
            {"helicoid", helicoid, helicoid_roots, usual},
            {"helicoid from inside", helicoid, helicoid_roots, inside}};
}

class PatchTracer : public testing::TestWithParam<PatchCase> {};

void expect_first_hits(const PatchCase& c, Way way) {
    const Scene scene = patch_scene(c.texts, way, c.clip, c.region, c.own_box);
    Framebuffer frame(96, 82);
    render_frame(scene, c.camera, settings_at("beams", 22), frame);
    int hits = 0;
    int undecided = 0;
    for (int row = 0; row < frame.height; ++row) {
        for (int col = 0; col < frame.width; ++col) {
            const Ray ray(c.camera, c.clip, col, row, frame, c.region);
            double expected = infinity;
            if (ray.t_in < ray.t_out) {
                for (const double t : c.roots(ray)) {
                    if (t >= ray.t_in && t <= ray.t_out) expected = std::min(expected, t);
                }
            }
            const std::size_t at = frame.index(col, row);
            const double found = static_cast<double>(frame.depth[at]);
            const Certificate certificate = frame.certificate[at];
            if (certificate == Certificate::Undecided) {
                ++undecided;
                continue;
            }
            const std::string where = std::to_string(col) + ", " + std::to_string(row);
            EXPECT_EQ(std::isfinite(expected), std::isfinite(found)) << where;
            if (!std::isfinite(expected) || !std::isfinite(found)) continue;
            EXPECT_NEAR(found, expected, 4e-6 * (1.0 + std::abs(expected))) << where;
            ++hits;
        }
    }
    EXPECT_GT(hits, 300);
    EXPECT_LE(undecided, 2);
}

TEST_P(PatchTracer, FindsTheFirstHits) { expect_first_hits(GetParam(), Way::ByModels); }
TEST_P(PatchTracer, FindsThemWithoutModels) { expect_first_hits(GetParam(), Way::WithoutModels); }

TEST_P(PatchTracer, FindsThemWithEachInstructionSet) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        const OnlyTarget only(target);
        expect_first_hits(GetParam(), Way::ByModels);
    }
}

std::string name_of_case(const testing::TestParamInfo<PatchCase>& info) {
    std::string name = info.param.name;
    std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
    return name;
}

INSTANTIATE_TEST_SUITE_P(ClosedForms, PatchTracer, testing::ValuesIn(cases()), name_of_case);

}  // namespace
}  // namespace zeroset::test::patch_tracer_test
