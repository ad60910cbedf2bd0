#include "tests/engine/render/domain_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace zeroset::test {
namespace {

using std::numbers::pi;

/// How far off a pole or a jump f is sure to be computed on its own side.
constexpr double off_the_jump = 1e-12;

/// f where lo < x < hi.
Piece strip(double lo, double hi, Field f) {
    return {std::move(f),
            [=](const glm::dvec3& p) { return std::min(p.x - lo, hi - p.x) - off_the_jump; }};
}

Piece everywhere(Field f) {
    return {std::move(f), [](const glm::dvec3&) { return 1.0; }};
}

/// Strips of width `period` from `first` on across the clip box, f given for each.
std::vector<Piece> strips(double first, double period,
                          const std::function<Field(int number)>& field) {
    std::vector<Piece> pieces;
    for (int k = 0; first + k * period < 2.0; ++k)
        pieces.push_back(strip(first + k * period, first + (k + 1) * period, field(k)));
    return pieces;
}

std::vector<Piece> steps(double first, double height) {
    return strips(first, 1.0, [=](int k) {
        return [=](const glm::dvec3& p) { return height + k - 0.1 - p.y; };
    });
}

double graph(double value, const glm::dvec3& p) { return value - p.y; }

std::vector<DomainScene> scenes_with_poles() {
    const Field pole = [](const glm::dvec3& p) { return 1.0 / (p.x - p.y * p.y) - p.z; };
    const Field right = [](const glm::dvec3& p) { return p.x - p.y * p.y - off_the_jump; };
    const Field left = [](const glm::dvec3& p) { return p.y * p.y - p.x - off_the_jump; };
    const Field tan = [](const glm::dvec3& p) { return graph(std::tan(p.x), p); };
    const Field half_tan = [](const glm::dvec3& p) { return graph(-0.5 * std::tan(p.x), p); };
    const Field cot = [](const glm::dvec3& p) { return graph(1.0 / std::tan(p.x), p); };
    const Field one = [](const glm::dvec3& p) { return graph(1.0, p); };
    const auto all = [](double first, const Field& f) {
        return strips(first, pi, [=](int) { return f; });
    };
    return {{"1/(x-y^2) - z", {{pole, right}, {pole, left}}},
            {"tan(x) = y", all(-1.5 * pi, tan)},
            {"-tan(x)/2 = y", all(-1.5 * pi, half_tan)},
            {"cot(x) = y", all(-pi, cot)},
            {"x/x = y", {strip(-9, 0, one), strip(0, 9, one)}}};
}

std::vector<DomainScene> scenes_with_jumps() {
    const auto by_sign = [](double below, double above) {
        return std::vector<Piece>{strip(-9, 0, [=](const glm::dvec3& p) { return below - p.y; }),
                                  strip(0, 9, [=](const glm::dvec3& p) { return above - p.y; })};
    };
    const auto third = strips(-2, 1, [](int k) {
        return [=](const glm::dvec3& p) { return (k - 2) / 3.0 - 0.5 * p.y; };
    });
    const auto saw = strips(
        -2, 1, [](int k) { return [=](const glm::dvec3& p) { return graph(p.x + 2 - k, p); }; });
    const Field angle = [](const glm::dvec3& p) { return std::atan2(p.y, p.x) - p.z; };
    const Piece above{angle, [](const glm::dvec3& p) { return p.y - off_the_jump; }};
    const Piece below{angle, [](const glm::dvec3& p) { return -p.y - off_the_jump; }};
    std::vector<Piece> stairs;
    for (int i = -2; i < 2; ++i) {
        for (int k = -2; k < 2; ++k) {
            stairs.push_back({[=](const glm::dvec3& p) { return i + k - 0.1 - p.z; },
                              [=](const glm::dvec3& p) {
                                  return std::min({p.x - i, i + 1 - p.x, p.y - k, k + 1 - p.y});
                              }});
        }
    }
    return {
        {"floor(x) = y + 0.1", steps(-2, -2)},     {"ceil(x) = y + 0.1", steps(-2, -1)},
        {"round(x) = y + 0.1", steps(-2.5, -2)},   {"floor(x)/3 = y/2", third},
        {"floor(x) + floor(y) = z + 0.1", stairs}, {"mod(x, 1) = y", saw},
        {"sign(x) = y", by_sign(-1, 1), true},     {"if(x > 0, 1 + y, y - 1) = 0", by_sign(1, -1)},
        {"atan2(y, x) = z", {above, below}}};
}

std::vector<DomainScene> scenes_with_ends() {
    const Field root = [](const glm::dvec3& p) { return graph(std::sqrt(p.x), p); };
    const Field log = [](const glm::dvec3& p) { return graph(std::log(p.x), p); };
    const Field asin = [](const glm::dvec3& p) { return graph(std::asin(p.x), p); };
    const Field acos = [](const glm::dvec3& p) { return graph(std::acos(p.x), p); };
    const Field atanh = [](const glm::dvec3& p) { return graph(std::atanh(p.x), p); };
    const Field acosh = [](const glm::dvec3& p) { return graph(std::acosh(p.x), p); };
    const Field saddle = [](const glm::dvec3& p) { return p.z - p.x * p.y; };
    return {{"sqrt(x) - y", {strip(0, 9, root)}},   {"x^0.5 = y", {strip(0, 9, root)}},
            {"ln(x) = y", {strip(0, 9, log)}},      {"asin(x) = y", {strip(-1, 1, asin)}},
            {"acos(x) = y", {strip(-1, 1, acos)}},  {"atanh(x) = y", {strip(-1, 1, atanh)}},
            {"acosh(x) = y", {strip(1, 9, acosh)}}, {"z = x*y {x > 0}", {strip(0, 9, saddle)}}};
}

std::vector<DomainScene> continuous_scenes() {
    const Field cube_root = [](const glm::dvec3& p) { return graph(std::cbrt(p.x), p); };
    const Field size = [](const glm::dvec3& p) { return graph(std::abs(p.x), p); };
    const Field kinks = [](const glm::dvec3& p) {
        return std::min(p.x, p.y) - std::max(p.x, p.z) / 2;
    };
    const Field bowl = [](const glm::dvec3& p) { return graph(p.x * p.x - 1.9, p); };
    return {{"x^(1/3) = y", {everywhere(cube_root)}},
            {"abs(x) = y", {everywhere(size)}},
            {"min(x, y) = max(x, z)/2", {everywhere(kinks)}},
            {"x^2 - 1.9 = y", {everywhere(bowl)}}};
}

constexpr double least_on_the_way = 0.02;  ///< |f| before the root
constexpr double least_at_ends = 0.2;      ///< |f| where a piece begins or ends
constexpr double off_the_end = 0.1;        ///< of a root from the ends of its piece, along the ray
constexpr double least_slope = 0.3;        ///< |df/dt| at a simple root

/// Where the sign of g changes in [a, b]; the end on the side of b.
double change_of(const std::function<double(double)>& g, double a, double b) {
    const bool positive = g(b) >= 0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (a + b);
        ((g(middle) >= 0) == positive ? b : a) = middle;
    }
    return b;
}

/// A part of a ray within a piece, and f at places along it, both ends included.
struct Walk {
    std::vector<double> t, f;

    Walk(const Piece& piece, const Ray& ray, double from, double to) {
        constexpr int count = 60;
        for (int i = 0; i <= count; ++i) {
            t.push_back(from + (to - from) * i / count);
            f.push_back(piece.f(ray.at(t.back())));
        }
    }
    [[nodiscard]] std::optional<double> first_root(const Piece& piece, const Ray& ray) const {
        for (std::size_t i = 1; i < t.size(); ++i) {
            if ((f[i - 1] < 0) == (f[i] < 0)) continue;
            const auto along = [&](double at) { return piece.f(ray.at(at)); };
            return change_of(along, t[i - 1], t[i]);
        }
        return std::nullopt;
    }
};

/// The parts of a ray within a piece.
std::vector<Walk> walks_in(const Piece& piece, const Ray& ray) {
    constexpr int count = 96;
    const auto inside = [&](double t) { return piece.inside(ray.at(t)); };
    const auto at = [&](int i) { return ray.t_in + (ray.t_out - ray.t_in) * i / count; };
    std::vector<Walk> walks;
    double begin = ray.t_in;
    for (int i = 1; i <= count; ++i) {
        const bool was = inside(at(i - 1)) >= 0;
        const bool is = inside(at(i)) >= 0;
        if (!was && is) begin = change_of(inside, at(i - 1), at(i));
        const bool ends = was && (!is || i == count);
        if (ends) {
            const double end = is ? at(i) : change_of(inside, at(i), at(i - 1));
            walks.emplace_back(piece, ray, begin, end);
        }
        if (!was && is && i == count) walks.emplace_back(piece, ray, begin, at(i));
    }
    return walks;
}

bool is_simple(const Piece& piece, const Ray& ray, const Walk& walk, double root) {
    const double slope = (piece.f(ray.at(root + 1e-6)) - piece.f(ray.at(root - 1e-6))) / 2e-6;
    return std::abs(slope) > least_slope && root - walk.t.front() > off_the_end &&
           walk.t.back() - root > off_the_end;
}

}  // namespace

std::vector<DomainScene> domain_scenes() {
    std::vector<DomainScene> scenes = scenes_with_poles();
    for (const auto& more : {scenes_with_jumps(), scenes_with_ends(), continuous_scenes()})
        scenes.insert(scenes.end(), more.begin(), more.end());
    return scenes;
}

Meeting meeting_of(const DomainScene& scene, const Ray& ray) {
    Meeting meeting;
    if (!(ray.t_in < ray.t_out)) return meeting;
    std::vector<std::pair<const Piece*, Walk>> walks;
    for (const Piece& piece : scene.pieces) {
        for (Walk& walk : walks_in(piece, ray))
            walks.emplace_back(&piece, std::move(walk));
    }
    for (const auto& [piece, walk] : walks) {
        const std::optional<double> root = walk.first_root(*piece, ray);
        if (!root || *root > meeting.first) continue;
        meeting.first = *root;
        meeting.clear = is_simple(*piece, ray, walk, *root);
    }
    for (const auto& [piece, walk] : walks) {
        meeting.jumps |= walk.t.back() < std::min(meeting.first, ray.t_out - 1e-9);
        for (std::size_t i = 0; i < walk.t.size(); ++i) {
            const bool on_the_way = walk.t[i] < meeting.first - off_the_end;
            if (on_the_way && !(std::abs(walk.f[i]) > least_on_the_way)) meeting.clear = false;
        }
        const bool ends_before = walk.t.back() < meeting.first;
        if (ends_before && !(std::abs(walk.f.back()) > least_at_ends)) meeting.clear = false;
        const bool begins_before = walk.t.front() < meeting.first;
        if (begins_before && !(std::abs(walk.f.front()) > least_at_ends)) meeting.clear = false;
    }
    return meeting;
}

namespace {

/// The last place in the piece on the way from a point in it to `to`.
glm::dvec3 last_inside(const Piece& piece, const glm::dvec3& point, const glm::dvec3& to) {
    double inside = 0.0;
    double outside = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (inside + outside);
        (piece.inside(glm::mix(point, to, middle)) < 0 ? outside : inside) = middle;
    }
    return glm::mix(point, to, inside);
}

}  // namespace

bool is_near(const DomainScene& scene, const glm::dvec3& point, double reach) {
    constexpr int n = 4;  // places on each side
    for (const Piece& piece : scene.pieces) {
        bool below = false;
        bool above = false;
        for (int i = 0; i < (2 * n + 1) * (2 * n + 1) * (2 * n + 1); ++i) {
            const glm::dvec3 step(i % (2 * n + 1) - n, i / (2 * n + 1) % (2 * n + 1) - n,
                                  i / ((2 * n + 1) * (2 * n + 1)) - n);
            glm::dvec3 p = point + reach / n * step;
            if (piece.inside(p) < 0) {
                if (piece.inside(point) < 0) continue;
                p = last_inside(piece, point, p);
            }
            const double f = piece.f(p);
            below |= f <= 0;
            above |= f >= 0;
        }
        if (below && above) return true;
    }
    return false;
}

}  // namespace zeroset::test
