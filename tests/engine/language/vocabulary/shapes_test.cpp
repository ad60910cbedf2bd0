// Compares the words of shapes.def with plain arithmetic that is written otherwise: distances by
// the nearest point, moves by the point from where a shape was moved.

#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>

namespace zeroset::test::shapes_test {
namespace {

using Point = std::array<double, 3>;
using Reference = std::function<double(const Point&)>;

/// A call as it is typed, whose value is a number, and what that is.
struct Typed {
    std::string text;
    Reference value;
};

double length_of(double a, double b, double c = 0) { return std::sqrt(a * a + b * b + c * c); }

/// The signed distance from what |q| <= 0 holds in all of its two or three parts: how far each part
/// is beyond a side.
double beyond(std::initializer_list<double> parts) {
    double squares = 0;
    double largest = -INFINITY;
    for (const double part : parts) {
        const double out = part > 0 ? part : 0;
        squares += out * out;
        largest = std::max(largest, part);
    }
    return largest > 0 ? std::sqrt(squares) : largest;
}

double box(const Point& p, double a, double b, double c) {
    return beyond({std::abs(p[0]) - a, std::abs(p[1]) - b, std::abs(p[2]) - c});
}

/// The distance from a segment, by bisection of the slope of the squared distance along it.
double segment(const Point& p, const Point& a, const Point& b) {
    const auto slope = [&](double t) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += (a[i] + t * (b[i] - a[i]) - p[i]) * (b[i] - a[i]);
        return sum;
    };
    double low = 0;
    double high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (slope(middle) < 0 ? low : high) = middle;
    }
    return length_of(a[0] + low * (b[0] - a[0]) - p[0], a[1] + low * (b[1] - a[1]) - p[1],
                     a[2] + low * (b[2] - a[2]) - p[2]);
}

/// The edges of a box, bar by bar.
double frame(const Point& p, const Point& size, double t) {
    double nearest = INFINITY;
    for (std::size_t along = 0; along < 3; ++along) {
        const std::size_t u = (along + 1) % 3;
        const std::size_t v = (along + 2) % 3;
        for (const double su : {-1.0, 1.0}) {
            for (const double sv : {-1.0, 1.0}) {
                nearest = std::min(nearest, beyond({std::abs(p[along]) - size[along],
                                                    std::abs(p[u] - su * (size[u] - t)) - t,
                                                    std::abs(p[v] - sv * (size[v] - t)) - t}));
            }
        }
    }
    return nearest;
}

std::map<std::string, Typed> shapes() {
    return {
        {"sphere",
         {"sphere(1.5)", [](const Point& p) { return length_of(p[0], p[1], p[2]) - 1.5; }}},
        {"ellipsoid",
         {"ellipsoid((1, 2, 0.5))",
          [](const Point& p) { return (length_of(p[0], p[1] / 2, p[2] * 2) - 1) * 0.5; }}},
        {"box", {"box((0.5, 1, 1.5))", [](const Point& p) { return box(p, 0.5, 1, 1.5); }}},
        {"rounded_box",
         {"rounded_box((1, 1.5, 2), 0.25)",
          [](const Point& p) { return box(p, 0.75, 1.25, 1.75) - 0.25; }}},
        {"box_frame",
         {"box_frame((1, 1.5, 0.75), 0.125)",
          [](const Point& p) { return frame(p, {1, 1.5, 0.75}, 0.125); }}},
        {"cylinder",
         {"cylinder(1, 0.5)",
          [](const Point& p) {
              return beyond({length_of(p[0], p[1]) - 1, std::abs(p[2]) - 0.5});
          }}},
        {"capsule",
         {"capsule((0, 0, -1), (1, 0.5, 1), 0.3)",
          [](const Point& p) { return segment(p, {0, 0, -1}, {1, 0.5, 1}) - 0.3; }}},
        {"cone",
         {"cone(1, 2)",
          [](const Point& p) {
              // The distance from the line through (1, 0) and (0, 2), by two of its points.
              const double r = length_of(p[0], p[1]);
              const double side = (r - 1) * (2 - 0) - (p[2] - 0) * (0 - 1);
              return std::max(side / length_of(1, 2), -p[2]);
          }}},
        {"torus",
         {"torus(1.5, 0.5)",
          [](const Point& p) {
              const double angle = std::atan2(p[1], p[0]);
              const Point ring{1.5 * std::cos(angle), 1.5 * std::sin(angle), 0};
              return length_of(p[0] - ring[0], p[1] - ring[1], p[2]) - 0.5;
          }}},
        {"prism",
         {"prism(6, 1, 0.5)",
          [](const Point& p) {
              const double third = std::numbers::pi / 3;
              double angle = std::atan2(p[1], p[0]);
              angle -= third * std::round(angle / third);
              return std::max(length_of(p[0], p[1]) * std::cos(angle) - 1, std::abs(p[2]) - 0.5);
          }}},
        {"octahedron",
         {"octahedron(1.25)",
          [](const Point& p) {
              return (std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]) - 1.25) / std::sqrt(3.0);
          }}},
        {"link",
         {"link(0.5, 1, 0.25)",
          [](const Point& p) {
              const double z = p[2] - std::clamp(p[2], -0.5, 0.5);
              const double ring = length_of(p[0], z) - 1;
              return length_of(ring, p[1]) - 0.25;
          }}},
        {"halfspace",
         {"halfspace((1, 2, 2), 0.5)",
          [](const Point& p) { return (p[0] + 2 * p[1] + 2 * p[2]) / 3 - 0.5; }}},
        {"plane",
         {"plane((1, 0, -2), (2, 1, 2))",
          [](const Point& p) { return (2 * (p[0] - 1) + p[1] + 2 * (p[2] + 2)) / 3; }}},
        {"gyroid",
         {"gyroid((x, y, z))",
          [](const Point& p) {
              double sum = 0;
              for (std::size_t i = 0; i < 3; ++i)
                  sum += std::sin(p[i]) * std::cos(p[(i + 1) % 3]);
              return sum;
          }}},
        {"schwarz_p",
         {"schwarz_p((x, y, z))",
          [](const Point& p) { return std::cos(p[0]) + std::cos(p[1]) + std::cos(p[2]); }}},
        {"schwarz_d",
         {"schwarz_d((x, y, z))",
          [](const Point& p) {
              return std::cos(p[2]) * std::sin(p[0] + p[1]) +
                     std::sin(p[2]) * std::cos(p[0] - p[1]);
          }}},
        {"neovius",
         {"neovius((x, y, z))",
          [](const Point& p) {
              const double a = std::cos(p[0]);
              const double b = std::cos(p[1]);
              const double c = std::cos(p[2]);
              return 3 * (a + b + c) + 4 * a * b * c;
          }}},
        {"schoen_iwp",
         {"schoen_iwp((x, y, z))",
          [](const Point& p) {
              double sum = 0;
              for (std::size_t i = 0; i < 3; ++i) {
                  const double q = p[(i + 1) % 3];
                  sum += std::cos(p[i] + q) + std::cos(p[i] - q) - std::cos(2 * p[i]);
              }
              return sum;
          }}},
    };
}

std::map<std::string, Typed> moves_and_blends() {
    return {
        // A point at (1, 0, 0), turned by 0.7 about z, is at (cos 0.7, sin 0.7, 0).
        {"rotate",
         {"sphere(rotate((x, y, z), (0, 0, 2), 0.7) - (1, 0, 0), 0.5)",
          [](const Point& p) {
              return length_of(p[0] - std::cos(0.7), p[1] - std::sin(0.7), p[2]) - 0.5;
          }}},
        {"scale",
         {"2*box(scale((x, y, z), 2), (0.5, 1, 1.5))",
          [](const Point& p) { return box(p, 1, 2, 3); }}},
        {"mirror",
         {"sphere(mirror((x, y, z), (3, 0, 0)) - (1, 0.5, 0), 0.5)",
          [](const Point& p) {
              return std::min(length_of(p[0] - 1, p[1] - 0.5, p[2]),
                              length_of(p[0] + 1, p[1] - 0.5, p[2])) -
                     0.5;
          }}},
        {"repeat",
         {"sphere(repeat((x, y, z), (2, 0, 3)), 0.5)",
          [](const Point& p) {
              double nearest = INFINITY;
              for (int i = -5; i <= 5; ++i) {
                  for (int k = -5; k <= 5; ++k)
                      nearest = std::min(nearest, length_of(p[0] - 2 * i, p[1], p[2] - 3 * k));
              }
              return nearest - 0.5;
          }}},
        {"twist",
         {"sphere(twist((x, y, z), 2) - (1, 0, 0.5), 0.5)",
          [](const Point& p) {
              // The ball's centre at height z is at the angle 2z.
              const double angle = 2 * p[2];
              return length_of(p[0] - std::cos(angle), p[1] - std::sin(angle), p[2] - 0.5) - 0.5;
          }}},
        {"bend",
         {"length(bend((x, y, z), 0.5))",
          [](const Point& p) { return length_of(p[0], p[1], p[2]); }}},
        {"thicken", {"thicken(x + y, 0.25)", [](const Point& p) { return p[0] + p[1] - 0.25; }}},
        {"shell",
         {"shell(sphere(1), 0.5)",
          [](const Point& p) {
              const double r = length_of(p[0], p[1], p[2]);
              return std::max(r - 1.25, 0.75 - r);
          }}},
        {"chamfer_union",
         {"chamfer_union(x, y, 1)",
          [](const Point& p) {
              return std::min({p[0], p[1], (p[0] + p[1] - 1) / std::sqrt(2.0)});
          }}},
    };
}

std::map<std::string, Typed> of_vectors() {
    return {
        {"dot",
         {"dot((x, y, z), (1, 2, 3))", [](const Point& p) { return p[0] + 2 * p[1] + 3 * p[2]; }}},
        {"cross",
         {"dot(cross((x, y, z), (1, 2, 3)), (1, 10, 100))",
          [](const Point& p) {
              return (3 * p[1] - 2 * p[2]) + 10 * (p[2] - 3 * p[0]) + 100 * (2 * p[0] - p[1]);
          }}},
        {"normalize",
         {"normalize((x, y, z)).y",
          [](const Point& p) { return p[1] / length_of(p[0], p[1], p[2]); }}},
        {"distance",
         {"distance((x, y, z), (1, 0, 2))",
          [](const Point& p) { return length_of(p[0] - 1, p[1], p[2] - 2); }}},
        // i j = k, j i = -k.
        {"quaternion_product",
         {"quaternion_product((0, x, 0, 0), (0, 0, y, 0)).w + "
          "3*quaternion_product((0, 0, y, 0), (0, z, 0, 0)).w + "
          "5*quaternion_product((1, 2, x, z), (1, -2, -x, -z)).x",
          [](const Point& p) {
              return p[0] * p[1] - 3 * p[1] * p[2] + 5 * (1 + 4 + p[0] * p[0] + p[2] * p[2]);
          }}},
        {"quaternion_square",
         {"sum(quaternion_square((x, y, z, 0.5)) - "
          "quaternion_product((x, y, z, 0.5), (x, y, z, 0.5))) + x",
          [](const Point& p) { return p[0]; }}},
        {"bulb_power",
         {"dot(bulb_power((x, y, z), 8), (1, 10, 100))",
          [](const Point& p) {
              const double r = length_of(p[0], p[1], p[2]);
              const double up = 8 * std::acos(p[2] / r);
              const double around = 8 * std::atan2(p[1], p[0]);
              return std::pow(r, 8) * (std::sin(up) * std::cos(around) +
                                       10 * std::sin(up) * std::sin(around) + 100 * std::cos(up));
          }}},
    };
}

void expect_values(const std::map<std::string, Typed>& words) {
    RandomNumbers random(11);
    for (const auto& [name, typed] : words) {
        const auto expr = parse(typed.text);
        ASSERT_TRUE(expr) << typed.text << ": " << expr.error().reason;
        ASSERT_TRUE(expr->parameters().empty()) << typed.text;
        for (int round = 0; round < 200; ++round) {
            const Point p{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
            const double value = value_at(*expr, {p[0], p[1], p[2], 0}).value;
            const double expected = typed.value(p);
            ASSERT_NEAR(value, expected, 1e-9 * std::max(1.0, std::abs(expected)))
                << typed.text << " at " << p[0] << ", " << p[1] << ", " << p[2];
        }
    }
}

TEST(Words, ShapesAreTheirClosedForms) { expect_values(shapes()); }
TEST(Words, MovesAndBlendsDoAsTheySay) { expect_values(moves_and_blends()); }
TEST(Words, FunctionsOfVectorsAreTheirFormulas) { expect_values(of_vectors()); }

TEST(Words, EachHasAReference) {
    auto known = shapes();
    known.merge(moves_and_blends());
    known.merge(of_vectors());
    for (const Function& function : functions()) {
        // Things have no value, noise, blobs and special functions have other references:
        // tests/engine/language/things_test.cpp, tests/engine/noise, blobs and special; complex
        // numbers and polynomials tests/engine/language/complex_numbers_test.cpp,
        // polynomials_test.cpp.
        const bool is_elsewhere = function.is_thing() || function.is_noise() ||
                                  function.is_of_complex() || function.is_polynomial() ||
                                  function.is_special();
        if (function.is_word() && !is_elsewhere) {
            EXPECT_TRUE(known.contains(std::string(function.name))) << function.name;
        }
    }
}

/// Whether a word's name is free for the text: as a constant, a function and a product's letters.
TEST(Words, GiveWayToDefinitions) {
    for (const Function& function : functions()) {
        if (!function.is_word()) continue;
        const std::string name(function.name);
        const auto value = read_program(name + " = 3; x = " + name + " y");
        ASSERT_TRUE(value) << name << ": " << value.error().reason;
        EXPECT_EQ(value->surfaces.front().canonical(), "x - 3*y") << name;
        const auto defined = read_program(name + "(u, v) = u + 2 v; " + name + "(x, y) = 1");
        ASSERT_TRUE(defined) << name << ": " << defined.error().reason;
        EXPECT_EQ(defined->surfaces.front().canonical(), "x + 2*y - 1") << name;
        const auto once = read_program(name + "(x, y, z) = x + 2 y; " + name + "(x, y, z)");
        ASSERT_TRUE(once) << name << ": " << once.error().reason;
        EXPECT_EQ(once->surfaces.front().canonical(), "x + 2*y") << name;
    }
}

/// A slider may say how many terms a sum has; what there is no term for has no value.
TEST(Words, SumsUpToASliderHaveItsNumberOfTerms) {
    const auto sum = parse("sum(x^i, i, 1, n)");
    const auto least = parse("least((x - i)^2, i, 1, n)");
    ASSERT_TRUE(sum && least);
    for (const double n : {0.0, 1.0, 2.5, 7.0, 32.0}) {
        double expected = 0;
        double nearest = INFINITY;
        for (int i = 1; i <= n; ++i) {
            expected += std::pow(0.9, i);
            nearest = std::min(nearest, (0.9 - i) * (0.9 - i));
        }
        EXPECT_NEAR(value_at(*sum, {0.9, 0, 0, 0}, std::array{n}).value, expected, 1e-12) << n;
        const double value = value_at(*least, {0.9, 0, 0, 0}, std::array{n}).value;
        if (n < 1) {
            EXPECT_TRUE(std::isnan(value));
        } else {
            EXPECT_NEAR(value, nearest, 1e-12) << n;
        }
    }
    EXPECT_TRUE(std::isnan(value_at(*sum, {0.9, 0, 0, 0}, std::array{33.0}).value));
}

/// Vectors, written with parts, mean the same numbers as their formulas written out.
TEST(Words, QuaternionJuliaIsThatOfPlainArithmetic) {
    const auto expr = parse(
        "length(iterate(q, 6, (x, y, z, 0), quaternion_square(q) + (-0.2, 0.6, 0.2, 0.2))) - 2");
    ASSERT_TRUE(expr);
    RandomNumbers random(5);
    for (int round = 0; round < 100; ++round) {
        std::array<double, 4> q{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                                0};
        const double value = value_at(*expr, {q[0], q[1], q[2], 0}).value;
        for (int i = 0; i < 6; ++i) {
            const auto [a, b, c, d] = q;
            q = {a * a - b * b - c * c - d * d - 0.2, 2 * a * b + 0.6, 2 * a * c + 0.2,
                 2 * a * d + 0.2};
        }
        const double expected =
            std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) - 2;
        ASSERT_NEAR(value, expected, 1e-9 * std::max(1.0, std::abs(expected)));
    }
}

}  // namespace
}  // namespace zeroset::test::shapes_test
