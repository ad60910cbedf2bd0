#include "engine/render/render.hpp"
#include "tests/support/patch_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

// Parametric surfaces whose polynomials are known, in large parts: graphs of quadratic functions
// over parallelograms, and a fine picture of a sphere, against closed forms.

namespace zeroset::test::patch_quadrics_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// z = a u^2 + b u v + c v^2 + d u + e v + f over (x, y) = from + u along_u + v along_v.
struct Graph {
    glm::dvec2 from, along_u, along_v;
    std::array<double, 6> z;

    static Graph random(std::mt19937& numbers) {
        const auto number = [&](double most) {
            // The number as the text has it.
            return std::round(1e4 * std::uniform_real_distribution(-most, most)(numbers)) / 1e4;
        };
        Graph graph{};
        graph.along_u = {1.2 + number(0.8), number(1.5)};
        graph.along_v = {number(1.0), 0.9 + number(0.6)};
        graph.from = {-0.5 * (graph.along_u.x + graph.along_v.x) + number(0.2),
                      -0.5 * (graph.along_u.y + graph.along_v.y) + number(0.2)};
        for (std::size_t i = 0; i < graph.z.size(); ++i)
            graph.z[i] = number(i < 3 ? 2.5 : 1.0);
        return graph;
    }

    [[nodiscard]] std::array<std::string, 3> texts() const {
        const auto text = [](double number) {
            std::array<char, 40> digits{};
            std::snprintf(digits.data(), digits.size(), "(%.17g)", number);
            return std::string(digits.data());
        };
        const auto linear = [&](int axis) {
            return text(from[axis]) + "+" + text(along_u[axis]) + "*x+" + text(along_v[axis]) +
                   "*y";
        };
        return {linear(0), linear(1),
                text(z[0]) + "*x^2+" + text(z[1]) + "*x*y+" + text(z[2]) + "*y^2+" + text(z[3]) +
                    "*x+" + text(z[4]) + "*y+" + text(z[5])};
    }

    /// (u, v) above a point.
    [[nodiscard]] glm::dvec2 place(const glm::dvec3& at) const {
        const double determinant = along_u.x * along_v.y - along_u.y * along_v.x;
        const glm::dvec2 way(at.x - from.x, at.y - from.y);
        return {(way.x * along_v.y - way.y * along_v.x) / determinant,
                (way.y * along_u.x - way.x * along_u.y) / determinant};
    }
    [[nodiscard]] double height(const glm::dvec3& at) const {
        const glm::dvec2 w = place(at);
        return at.z - (z[0] * w.x * w.x + z[1] * w.x * w.y + z[2] * w.y * w.y + z[3] * w.x +
                       z[4] * w.y + z[5]);
    }
};

/// How a ray first meets a graph within what is shown.
double first_root(const Graph& graph, const Ray& ray) {
    double first = infinity;
    if (!(ray.t_in < ray.t_out)) return first;
    const auto height = [&](double t) { return graph.height(ray.at(t)); };
    for (const double t : quadratic_roots(ray, height)) {
        const glm::dvec2 at = graph.place(ray.at(t));
        const bool is_inside = std::min(at.x, at.y) >= 0.0 && std::max(at.x, at.y) <= 1.0;
        if (is_inside && t >= ray.t_in && t <= ray.t_out) first = std::min(first, t);
    }
    return first;
}

struct Counts {
    int hits = 0, misses = 0, undecided = 0;
};

void expect_first_hits(const Graph& graph, const Camera& camera, const Box& clip, Counts& counts) {
    const std::array<std::string, 3> texts = graph.texts();
    SCOPED_TRACE(texts[0] + ", " + texts[1] + ", " + texts[2]);
    Framebuffer frame(200, 150);
    render_frame(patch_scene(texts, Way::ByModels, clip), camera, settings_at("beams", 22), frame);
    for (int i = 0; i < frame.width * frame.height; ++i) {
        const int col = i % frame.width;
        const int row = i / frame.width;
        const double expected = first_root(graph, Ray(camera, clip, col, row, frame, {}));
        const std::size_t at = frame.index(col, row);
        const auto found = static_cast<double>(frame.depth[at]);
        if (frame.certificate[at] == Certificate::Undecided) {
            ++counts.undecided;
            continue;
        }
        const std::string where = std::to_string(col) + ", " + std::to_string(row);
        EXPECT_EQ(std::isfinite(expected), std::isfinite(found)) << where;
        if (!std::isfinite(expected) || !std::isfinite(found)) {
            ++counts.misses;
            continue;
        }
        EXPECT_NEAR(found, expected, 4e-6 * (1.0 + std::abs(expected))) << where;
        ++counts.hits;
    }
}

TEST(PatchQuadrics, HaveTheirFirstHits) {
    std::mt19937 numbers(20261127);
    const Box clip = Box::cube(1.6);
    Counts counts;
    for (int i = 0; i < 40; ++i) {
        Camera camera = default_camera(clip);
        camera.eye = {6.0 * std::cos(0.7 * i), 6.0 * std::sin(0.7 * i), i % 3 - 0.8};
        expect_first_hits(Graph::random(numbers), camera, clip, counts);
    }
    EXPECT_GT(counts.hits, 40000);
    EXPECT_GT(counts.misses, 40000);
    EXPECT_LT(counts.undecided, 20);
}

/// Many small leaves, and the whole silhouette.
TEST(PatchQuadrics, FillAFineSphere) {
    const std::array<std::string, 3> sphere{"cos(pi*(x-1/2))*cos(2*pi*y)",
                                            "cos(pi*(x-1/2))*sin(2*pi*y)", "sin(pi*(x-1/2))"};
    const Box clip = Box::cube(1.2);
    const Camera camera = default_camera(clip);
    Framebuffer frame(500, 470);
    render_frame(patch_scene(sphere, Way::ByModels, clip), camera, settings_at("beams", 22), frame);
    int undecided = 0;
    for (int row = 0; row < frame.height; ++row) {
        for (int col = 0; col < frame.width; ++col) {
            const std::size_t at = frame.index(col, row);
            if (frame.certificate[at] == Certificate::Undecided) {
                ++undecided;
                continue;
            }
            const Ray ray(camera, clip, col, row, frame, {});
            const double b = glm::dot(ray.eye, ray.direction);
            const double discriminant = b * b - glm::dot(ray.eye, ray.eye) + 1.0;
            ASSERT_EQ(discriminant >= 0.0, std::isfinite(frame.depth[at])) << col << ", " << row;
            if (discriminant < 0.0) continue;
            EXPECT_NEAR(static_cast<double>(frame.depth[at]), -b - std::sqrt(discriminant), 4e-5)
                << col << ", " << row;
        }
    }
    EXPECT_LE(undecided, 4);
}

/// A cone whose silhouette goes along the diagonals of the picture: all rays there are as good as
/// tangent, and so are those near the tip. However many parts of a leaf leave such a ray, it is
/// searched for once.
TEST(PatchQuadrics, FillAConeAlongItsSilhouette) {
    const std::array<std::string, 3> cone{"(2*y-1)*cos(2*pi*x)", "(2*y-1)*sin(2*pi*x)", "2*y-1"};
    const Box clip = Box::cube(1.5);
    for (const double height : {0.0, 1e-5, 0.3}) {
        SCOPED_TRACE(height);
        Camera camera = default_camera(clip);
        camera.eye = {6.0, 0.0, height};
        camera.look_at = {0.0, 0.0, 0.0};
        Framebuffer frame(128, 128);
        const Counters counters = render_frame(patch_scene(cone, Way::ByModels, clip), camera,
                                               settings_at("beams", 22), frame);
        int undecided = 0;
        for (int i = 0; i < frame.width * frame.height; ++i) {
            const int col = i % frame.width;
            const int row = i / frame.width;
            const std::size_t at = frame.index(col, row);
            if (frame.certificate[at] == Certificate::Undecided) {
                ++undecided;
                continue;
            }
            const Ray ray(camera, clip, col, row, frame, {});
            const auto height_of = [&](double t) {
                const glm::dvec3 point = ray.at(t);
                return point.x * point.x + point.y * point.y - point.z * point.z;
            };
            double first = infinity;
            for (const double t : quadratic_roots(ray, height_of)) {
                const bool is_shown = t >= ray.t_in && t <= ray.t_out;
                if (is_shown && std::abs(ray.at(t).z) <= 1.0) first = std::min(first, t);
            }
            const auto found = static_cast<double>(frame.depth[at]);
            ASSERT_EQ(std::isfinite(first), std::isfinite(found)) << col << ", " << row;
            if (!std::isfinite(first)) continue;
            EXPECT_NEAR(found, first, 4e-5) << col << ", " << row;
        }
        EXPECT_LE(undecided, height > 0.1 ? 2 : 200);
        // With a search for each piece there were twice as many and eight times as many.
        EXPECT_LT(counters.value, 14000U);
        EXPECT_LT(counters.form, 30000U);
    }
}

}  // namespace
}  // namespace zeroset::test::patch_quadrics_test
