#pragma once

#include "engine/num/interval.hpp"
#include "tests/support/rays.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Surfaces whose roots on a ray are known in closed form: in the box, in regions, in both
// projections.

namespace zeroset::test {

/// The first root at or beyond `from` on a ray, or infinity.
using RootFrom = std::function<double(const Ray& ray, double from)>;

struct Analytic {
    std::string name, text;
    RootFrom first_root;
    Camera camera;
    Box clip;
    Region region = {};
};

inline double first_of(std::vector<double> roots, double from) {
    std::ranges::sort(roots);
    const auto found = std::ranges::lower_bound(roots, from);
    return found == roots.end() ? infinity : *found;
}

/// Real roots of a t^2 + 2 b t + c.
inline std::vector<double> quadratic(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const double far = -b - std::copysign(std::sqrt(discriminant), b);
    return {far / a, c / far};
}

inline std::vector<double> sphere_roots(const Ray& ray, double radius) {
    return quadratic(1.0, glm::dot(ray.eye, ray.direction),
                     glm::dot(ray.eye, ray.eye) - radius * radius);
}

inline double plane_root(const Ray& ray, const glm::dvec3& normal, double offset) {
    return (offset - glm::dot(normal, ray.eye)) / glm::dot(normal, ray.direction);
}

inline double torus_distance(const glm::dvec3& p, double ring, double tube) {
    return std::abs(std::hypot(std::hypot(p.x, p.y) - ring, p.z) - tube);
}

/// The first root by steps as long as the distance to the torus, which skip no root.
inline double torus_root(const Ray& ray, double from) {
    for (double t = from; t < ray.t_out + 1.0;) {
        const double step = torus_distance(ray.at(t), 1.0, 0.5);
        t += step;
        if (step < 1e-13) return t;
    }
    return infinity;
}

inline double sphere_root(const Ray& ray, double from) {
    return first_of(sphere_roots(ray, 1.0), from);
}

inline double slanted_root(const Ray& ray, double from) {
    return first_of({plane_root(ray, {0.3, -0.5, 1.0}, 0.2)}, from);
}

/// Scenes with parallel rays, also from inside the clip box and along an axis.
inline std::vector<Analytic> parallel_scenes() {
    const Box cube = Box::cube(2);
    Camera usual = default_camera(cube);
    Camera within{{0.1, -0.2, 0.15}, {0.4, 0.2, 0.25}, {0, 0, 1}, 2.4};
    Camera down{{0.25, 0, 7}, {0.25, 0, 0}, {0, 1, 0}, 0.5};
    Camera far{{4, -10, 6}, {0, 0.1, 0}, {0, 0, 1}, 0.3};
    for (Camera* camera : {&usual, &within, &down, &far})
        camera->projection = Projection::Orthographic;
    const char* const ball = "x^2 + y^2 + z^2 = 1";
    const char* const slanted = "0.3*x - 0.5*y + z = 0.2";
    const char* const torus = "(x^2+y^2+z^2+0.75)^2 = 4*(x^2+y^2)";
    return {{"parallel: sphere", ball, sphere_root, usual, cube},
            {"parallel: sphere before the eye's plane", ball, sphere_root, within, cube},
            {"parallel: sphere from above", ball, sphere_root, down, cube},
            {"parallel: sphere from far away", ball, sphere_root, far, cube},
            {"parallel: plane", slanted, slanted_root, usual, cube},
            {"parallel: plane from within", slanted, slanted_root, within, cube},
            {"parallel: plane from above, cut by the box",
             slanted,
             slanted_root,
             down,
             {{-0.5, -0.4, -2}, {0.6, 0.7, 2}}},
            {"parallel: torus", torus, torus_root, usual, cube},
            {"parallel: torus from above", torus, torus_root, down, cube}};
}

/// Scenes cut by balls and by sections without caps.
inline std::vector<Analytic> region_scenes() {
    const Box cube = Box::cube(2);
    const Camera usual = default_camera(cube);
    const Camera within{{0.1, -0.2, 0.15}, {1, 0.5, 0.25}, {0, 0, 1}, 1.5};
    Camera down{{0.25, 0, 7}, {0.25, 0, 0}, {0, 1, 0}, 0.5};
    down.projection = Projection::Orthographic;
    const Region ball{Ball{{0.2, -0.3, 0.4}, 0.9}, {}};
    const Region half{{}, {make_section({1, 0, 0}, 0.3, false)}};
    const Region wedge{
        {}, {make_section({1, -2, 0.5}, 0.3, false), make_section({0, 0, 1}, 0.4, false)}};
    const Region all{Ball{{0, 0, 0}, 1.3}, wedge.sections};
    std::vector<Analytic> scenes;
    for (const auto& [name, region] :
         {std::pair{"ball", &ball}, {"half", &half}, {"wedge", &wedge}, {"all", &all}}) {
        for (const auto& [view, camera] :
             {std::pair{"usual", &usual}, {"within", &within}, {"down", &down}}) {
            const std::string of = std::string(name) + ", " + view + ": ";
            scenes.push_back(
                {of + "sphere", "x^2 + y^2 + z^2 = 1", sphere_root, *camera, cube, *region});
            scenes.push_back(
                {of + "plane", "0.3*x - 0.5*y + z = 0.2", slanted_root, *camera, cube, *region});
        }
    }
    return scenes;
}

inline std::vector<Analytic> analytic_scenes() {
    const Box cube = Box::cube(2);
    const Camera usual = default_camera(cube);
    const Camera inside{{0.1, -0.2, 0.15}, {1, 0.5, 0.25}, {0, 0, 1}, 1.5};
    const RootFrom shells = [](const Ray& ray, double from) {
        return std::min(first_of(sphere_roots(ray, 1.5), from),
                        first_of(sphere_roots(ray, 1.4999), from));
    };
    const RootFrom pair = [](const Ray& ray, double from) {
        return first_of({plane_root(ray, {0, 1, 0}, 0.5), plane_root(ray, {0, 1, 0}, 0.5001)},
                        from);
    };
    return {
        {"sphere", "x^2 + y^2 + z^2 = 1", sphere_root, usual, cube},
        {"sphere from inside", "x^2 + y^2 + z^2 = 1", sphere_root, inside, cube},
        {"sphere cut by the box",
         "x^2 + y^2 + z^2 = 1",
         sphere_root,
         usual,
         {{-0.7, -2, -0.8}, {2, 0.3, 2}}},
        {"two close spheres", "(x^2+y^2+z^2-1.5^2)*(x^2+y^2+z^2-1.4999^2)", shells, usual, cube},
        {"plane", "0.3*x - 0.5*y + z = 0.2", slanted_root, usual, cube},
        {"plane from nearby", "0.3*x - 0.5*y + z = 0.2", slanted_root, inside, cube},
        {"two close planes", "(y-0.5)*(y-0.5001)", pair, usual, cube},
        {"torus", "(x^2+y^2+z^2+0.75)^2 = 4*(x^2+y^2)", torus_root, usual, cube},
        {"torus from its hole", "(1-sqrt(x^2+y^2))^2 + z^2 = 0.25", torus_root, inside, cube}};
}

}  // namespace zeroset::test
