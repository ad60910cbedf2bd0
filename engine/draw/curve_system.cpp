#include "engine/draw/curve_system.hpp"

#include "engine/draw/symmetric.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

// Cells are judged by their linearization: with M the inverse of the two equations' derivatives
// across the curve, in the middle of what they may be, M F(p) = M F(c) + M J (p - c) for some J
// among the derivatives in the box, or for the gradients of linear enclosures, with their errors.
// Where M J is near enough to 1 across the curve, two points on a plane across it cannot both be
// zeros; where M F(c) is larger than M J (p - c) can be, none is.

namespace zeroset {
namespace {

/// A matrix of `rows` gradients as middles and radii.
struct GradientBounds {
    std::array<glm::dvec3, 3> middle{}, radius{};
    std::array<double, 3> value{}, value_radius{};
    std::size_t rows = 2;

    [[nodiscard]] bool is_bounded() const {
        for (std::size_t i = 0; i < rows; ++i) {
            for (int k = 0; k < 3; ++k) {
                if (!std::isfinite(middle.at(i)[k]) || !std::isfinite(radius.at(i)[k]))
                    return false;
            }
            if (!std::isfinite(value.at(i)) || !std::isfinite(value_radius.at(i))) return false;
        }
        return true;
    }
};

/// Allows for the rounding of a few operations to nearest.
constexpr double rounding_slack = 1e-12;

/// Weights of three gradients in their combinations at right angles, the largest first.
std::array<glm::dvec3, 3> main_weights(const std::array<glm::dvec3, 3>& gradients) {
    glm::dmat3 products(0.0);
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k)
            products[i][k] = glm::dot(gradients.at(static_cast<std::size_t>(i)),
                                      gradients.at(static_cast<std::size_t>(k)));
    }
    const Eigenvectors all = eigenvectors_of(products);
    return {all.vectors[0], all.vectors[1], all.vectors[2]};
}

/// Three equations as combinations of which the first two tell most.
GradientBounds reduced(const GradientBounds& all) {
    if (all.rows == 2) return all;
    GradientBounds two;
    const auto weights = main_weights(all.middle);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double weight = weights.at(i)[static_cast<int>(k)];
            two.middle.at(i) += weight * all.middle.at(k);
            two.radius.at(i) += std::abs(weight) * all.radius.at(k);
            two.value.at(i) += weight * all.value.at(k);
            two.value_radius.at(i) += std::abs(weight) * all.value_radius.at(k);
        }
        two.value_radius.at(i) += rounding_slack * std::abs(two.value.at(i));
    }
    two.rows = 3;
    return two;
}

/// Whether the third equation surely has no zero in a box with this half diagonal.
bool excludes_third(const GradientBounds& all, const glm::dvec3& half) {
    if (all.rows < 3) return false;
    const double reach = glm::dot(glm::abs(all.middle[2]) + all.radius[2], half);
    const double value = std::abs(all.value[2]);
    return value > all.value_radius[2] + reach + rounding_slack * (value + reach);
}

/// Whether three functions surely have at most one common zero, and so no curve of them.
bool is_isolated(const GradientBounds& all) {
    if (all.rows < 3) return false;
    const glm::dmat3 rows = glm::transpose(glm::dmat3(all.middle[0], all.middle[1], all.middle[2]));
    const glm::dmat3 inverse = glm::inverse(rows);
    for (int i = 0; i < 3; ++i) {
        double off = 0.0;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3& radius = all.radius.at(static_cast<std::size_t>(k));
            off += std::abs(inverse[k][i]) * (radius.x + radius.y + radius.z);
        }
        if (!(off < 1.0 - 1e-6)) return false;
    }
    return true;
}

/// The two equations' derivatives across the curve, and their inverse.
struct Across {
    std::array<glm::dvec3, 2> normals;  ///< at right angles
    std::array<glm::dvec3, 2> dual;     ///< the columns of M
    glm::dvec3 tangent;
};
std::optional<Across> across_of(const GradientBounds& two) {
    const glm::dvec3& a = two.middle[0];
    const glm::dvec3& b = two.middle[1];
    const glm::dvec3 across = glm::cross(a, b);
    const double size = glm::length(across);
    if (!(size > 1e-12 * glm::length(a) * glm::length(b))) return std::nullopt;
    const glm::dvec3 tangent = across / size;
    const glm::dvec3 normal = glm::normalize(a);
    return Across{.normals = {normal, glm::cross(tangent, normal)},
                  .dual = {glm::cross(b, tangent) / size, glm::cross(tangent, a) / size},
                  .tangent = tangent};
}

/// One row of M F and M J, along a normal.
struct Row {
    glm::dvec3 spread{0.0};
    double value = 0.0, value_radius = 0.0;

    Row(const GradientBounds& two, const Across& across, const glm::dvec3& normal) {
        for (std::size_t i = 0; i < 2; ++i) {
            const double weight = glm::dot(normal, across.dual.at(i));
            spread += std::abs(weight) * two.radius.at(i);
            value += weight * two.value.at(i);
            value_radius += std::abs(weight) * two.value_radius.at(i);
        }
    }
};

/// Whether a box with this half diagonal surely holds no common zero.
bool is_empty(const GradientBounds& two, const glm::dvec3& half) {
    if (excludes_third(two, half)) return true;
    const auto across = across_of(two);
    return across && std::ranges::any_of(across->normals, [&](const glm::dvec3& normal) {
               const Row row(two, *across, normal);
               const double reach = glm::dot(row.spread + glm::abs(normal), half);
               const double slack = rounding_slack * (std::abs(row.value) + reach);
               return std::abs(row.value) > row.value_radius + reach + slack;
           });
}

/// The verdict of the two equations on a box with this half diagonal.
JudgedCell judge_reduced(const GradientBounds& two, const glm::dvec3& half) {
    constexpr double most_off = 0.9;
    if (is_empty(two, half)) return {.state = CellState::Empty};
    const auto across = across_of(two);
    if (!across) return {};
    for (const glm::dvec3& normal : across->normals) {
        const Row row(two, *across, normal);
        double off = 0.0;
        for (const glm::dvec3& other : across->normals)
            off += glm::dot(row.spread, glm::abs(other));
        if (!(off < most_off)) return {};
    }
    return {.state = CellState::Regular, .tangent = across->tangent};
}

bool is_flat(const Box& box) { return glm::any(glm::lessThanEqual(box.hi, box.lo)); }

}  // namespace

bool Linearized::is_usable() const {
    const double size = glm::length(across);
    return std::isfinite(size) && std::isfinite(value.x) && std::isfinite(value.y) &&
           size > 1e-13 * glm::length(gradients[0]) * glm::length(gradients[1]);
}

glm::dvec3 Linearized::step(const glm::dvec3& normal) const {
    const glm::dvec3 by =
        value.x * glm::cross(gradients[1], normal) + value.y * glm::cross(normal, gradients[0]);
    return -by / glm::dot(across, normal);
}

Linearized CurveSystem::at(const glm::dvec3& point) const {
    std::array<ValueAndGradient, 3> all{};
    for (std::size_t i = 0; i < equations_.zero.size(); ++i)
        all.at(i) = equations_.zero[i]->at(point);
    Linearized two{};
    if (equations_.zero.size() == 2) {
        two = {.value = {all[0].value, all[1].value},
               .gradients = {all[0].gradient, all[1].gradient},
               .across = {}};
    } else {
        const auto weights = main_weights({all[0].gradient, all[1].gradient, all[2].gradient});
        for (std::size_t k = 0; k < 3; ++k)
            two.rest += weights[2][static_cast<int>(k)] * all.at(k).value;
        for (int i = 0; i < 2; ++i) {
            for (int k = 0; k < 3; ++k) {
                const double weight = weights.at(static_cast<std::size_t>(i))[k];
                two.value[i] += weight * all.at(static_cast<std::size_t>(k)).value;
                two.gradients[i] += weight * all.at(static_cast<std::size_t>(k)).gradient;
            }
        }
    }
    two.across = glm::cross(two.gradients[0], two.gradients[1]);
    return two;
}

void CurveSystem::sift(std::span<const Box> boxes, std::span<bool> may_hold) const {
    std::ranges::fill(may_hold, true);
    std::vector<Box> left(boxes.begin(), boxes.end());
    std::vector<std::size_t> places(boxes.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::vector<Bounds> bounds(boxes.size());
    for (const CurveEquations::Functions* functions : {&equations_.zero, &equations_.also}) {
        for (const auto& f : *functions) {
            f->enclose(left, bounds);
            std::size_t kept = 0;
            for (std::size_t i = 0; i < left.size(); ++i) {
                if (bounds[i].excludes_zero) {
                    may_hold[places[i]] = false;
                    continue;
                }
                left[kept] = left[i];
                places[kept++] = places[i];
            }
            left.resize(kept);
        }
    }
}

std::vector<bool> CurveSystem::empty_cells(std::span<const Box> boxes) const {
    std::vector<bool> empty(boxes.size(), false);
    if (boxes.empty() || is_flat(boxes.front())) return empty;
    std::vector<GradientBounds> all(boxes.size());
    std::vector<LinearBounds> bounds(boxes.size());
    for (std::size_t row = 0; row < equations_.zero.size(); ++row) {
        equations_.zero[row]->enclose_linear(boxes, bounds);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (bounds[i].nowhere) empty[i] = true;
            all[i].middle.at(row) = bounds[i].gradient;
            all[i].value.at(row) = bounds[i].value;
            all[i].value_radius.at(row) = bounds[i].error;
        }
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        all[i].rows = equations_.zero.size();
        const glm::dvec3 half = 0.5 * (boxes[i].hi - boxes[i].lo);
        if (!empty[i] && all[i].is_bounded()) empty[i] = is_empty(reduced(all[i]), half);
    }
    return empty;
}

std::vector<bool> CurveSystem::are_continuous(std::span<const Box> boxes) const {
    std::vector<bool> continuous(boxes.size(), true);
    std::vector<Bounds> bounds(boxes.size());
    for (const auto& f : equations_.zero) {
        if (!f->may_jump()) continue;
        f->enclose(boxes, bounds);
        for (std::size_t i = 0; i < boxes.size(); ++i)
            continuous[i] = continuous[i] && bounds[i].continuous;
    }
    return continuous;
}

void CurveSystem::judge(std::span<const Box> boxes, std::span<const Box> around,
                        std::span<JudgedCell> out) const {
    const std::vector<bool> empty = empty_cells(boxes);
    std::vector<Box> left;
    std::vector<Box> left_around;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (empty[i]) continue;
        left.push_back(boxes[i]);
        left_around.push_back(around[i]);
    }
    std::vector<JudgedCell> judged(left.size());
    judge_slopes(left, left_around, judged);
    for (std::size_t i = 0, k = 0; i < boxes.size(); ++i)
        out[i] = empty[i] ? JudgedCell{.state = CellState::Empty} : judged[k++];
}

void CurveSystem::judge_slopes(std::span<const Box> boxes, std::span<const Box> around,
                               std::span<JudgedCell> out) const {
    std::vector<GradientBounds> all(boxes.size());
    std::vector<Box> middles;
    for (const Box& box : boxes)
        middles.push_back({.lo = box.centre(), .hi = box.centre()});
    std::vector<Bounds> bounds(boxes.size());
    for (std::size_t row = 0; row < equations_.zero.size(); ++row) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            equations_.zero[row]->enclose_slope(axis, around, bounds);
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const auto k = static_cast<int>(axis);
                all[i].middle.at(row)[k] = 0.5 * bounds[i].lo + 0.5 * bounds[i].hi;
                all[i].radius.at(row)[k] =
                    (0.5 * bounds[i].hi - 0.5 * bounds[i].lo) * (1.0 + rounding_slack);
            }
        }
        equations_.zero[row]->enclose(middles, bounds);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            all[i].value.at(row) = 0.5 * bounds[i].lo + 0.5 * bounds[i].hi;
            all[i].value_radius.at(row) =
                (0.5 * bounds[i].hi - 0.5 * bounds[i].lo) * (1.0 + rounding_slack);
        }
    }
    const std::vector<bool> continuous = are_continuous(around);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        all[i].rows = equations_.zero.size();
        out[i] = {};
        if (!continuous[i] || !all[i].is_bounded()) continue;
        out[i] = is_isolated(all[i])
                     ? JudgedCell{.state = CellState::Empty}
                     : judge_reduced(reduced(all[i]), 0.5 * (boxes[i].hi - boxes[i].lo));
    }
}

bool CurveSystem::is_zero_of_all(const glm::dvec3& point, const Linearized& there,
                                 double reach) const {
    constexpr double slack = 1e-6;
    if (equations_.zero.size() < 3) return true;
    const double steepness = std::max(glm::length(there.gradients[0]), 1e-300);
    if (!(std::abs(there.rest) <= slack * steepness * reach)) return false;
    return std::ranges::all_of(equations_.also, [&](const auto& f) {
        const ValueAndGradient value = f->at(point);
        const double change = glm::length(value.gradient) + steepness * reach;
        return std::abs(value.value) <= slack * change * reach;
    });
}

std::optional<glm::dvec3> CurveSystem::solve(const glm::dvec3& start, const glm::dvec3* normal,
                                             double reach) const {
    constexpr int most_steps = 12;
    constexpr double noise = 1e-5;  // beside singular points steps end in rounding errors
    glm::dvec3 point = start;
    double last = reach;
    for (int i = 0; i < most_steps; ++i) {
        const Linearized here = at(point);
        if (!here.is_usable()) return std::nullopt;
        const glm::dvec3 step = here.step(normal != nullptr ? *normal : here.across);
        const double length = glm::length(step);
        point += step;
        if (!(glm::length(point - start) <= reach)) return std::nullopt;
        const bool stagnates = length <= noise * reach && length >= 0.5 * last;
        if (length <= 1e-10 * reach + 4e-16 * glm::length(point) || stagnates) {
            if (!is_zero_of_all(point, here, reach)) return std::nullopt;
            return point;
        }
        last = length;
    }
    return std::nullopt;
}

std::optional<glm::dvec3> CurveSystem::point_near(const glm::dvec3& start, const glm::dvec3& normal,
                                                  double reach) const {
    return solve(start, &normal, reach);
}

std::optional<glm::dvec3> CurveSystem::point_near(const glm::dvec3& start, double reach) const {
    return solve(start, nullptr, reach);
}

}  // namespace zeroset
