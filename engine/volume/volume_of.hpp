#pragma once

#include "engine/real/field_answers.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/unbounded.hpp"
#include "engine/volume/spline.hpp"
#include "engine/volume/trilinear.hpp"
#include "engine/volume/volume.hpp"
#include "engine/volume/volume_lanes.hpp"

#include <type_traits>
#include <utility>
#include <vector>

// The questions to a volume of samples of one type.

namespace zeroset {

/// `Between` says what it is between the samples: Trilinear, CubicSpline.
template <class Between>
class VolumeOf final : public Volume {
public:
    using Source = typename Between::Source;

    VolumeOf(std::shared_ptr<const Source> source, const VolumeOptions& options, std::string text)
        : Volume(volume_data(source), options, std::move(text)),
          source_(std::move(source)),
          between_(*source_),
          map_(data().map()),
          outside_(options.outside),
          constant_(options.constant) {}

    [[nodiscard]] const SplineData* spline() const override {
        if constexpr (std::is_same_v<Source, SplineData>) {
            return source_.get();
        } else {
            return nullptr;
        }
    }

    void values(int derivative, const float* in, float* out, int lanes) const override {
        values_of(derivative, in, out, lanes);
    }
    void values(int derivative, const double* in, double* out, int lanes) const override {
        values_of(derivative, in, out, lanes);
    }
    void ranges(int derivative, const float* in, float* out, int lanes) const override {
        ranges_of(derivative, in, out, lanes);
    }
    void ranges(int derivative, const double* in, double* out, int lanes) const override {
        ranges_of(derivative, in, out, lanes);
    }
    void forms(const float* in, float* out, int lanes) const override { forms_of(in, out, lanes); }
    void forms(const double* in, double* out, int lanes) const override {
        forms_of(in, out, lanes);
    }

private:
    /// The type that points are computed in: the indices shall be good to the last places of a
    /// kernel.
    template <class Real>
    using WideOf = std::conditional_t<std::is_same_v<Real, float>, double, long double>;

    /// A point with derivatives in the world's axes.
    template <class Wide>
    struct PointJet {
        Wide value = std::numeric_limits<Wide>::quiet_NaN();
        std::array<Wide, 3> slope{};
        std::array<std::array<Wide, 3>, 3> bend{};
    };
    template <class Wide>
    [[nodiscard]] PointJet<Wide> place(const std::array<double, 3>& point, int order) const;
    template <class Wide>
    void turn(PointJet<Wide>& result, const InterpolationPoint<Wide>& point,
              const std::array<bool, 3>& moves, int order) const;

    template <class Real>
    void values_of(int derivative, const Real* in, Real* out, int lanes) const;
    template <class Real>
    void ranges_of(int derivative, const Real* in, Real* out, int lanes) const;
    template <class Real>
    void forms_of(const Real* in, Real* out, int lanes) const;

    /// ValueBounds over the box as it is seen from outside the grid, too.
    struct Seen {
        InterpolationRange range{};
        bool somewhere = true, everywhere = true, continuous = true;
        bool smooth = true;  ///< neither holes nor jumps
    };
    [[nodiscard]] Seen seen(const IndexBox& box, bool with_slopes) const;
    [[nodiscard]] ValueBounds derivative_bounds(const IndexBox& box, const Seen& over,
                                                int derivative) const;
    [[nodiscard]] ValueBounds world_slope(const std::array<ValueBounds, 3>& slopes,
                                          std::size_t axis) const;
    template <class Wide>
    [[nodiscard]] ValueBounds at_middle(const std::array<double, 3>& middle, const IndexBox& box,
                                        const Seen& over) const;

    std::shared_ptr<const Source> source_;
    Between between_;
    IndexMap map_;
    Outside outside_;
    double constant_;
};

/// a + b, where both are sums of products that were rounded: widened by that.
inline ValueBounds scaled_sum(const ValueBounds& sum, double factor, const ValueBounds& term) {
    if (factor == 0) return sum;
    const double a = factor * (factor > 0 ? term.lo : term.hi);
    const double b = factor * (factor > 0 ? term.hi : term.lo);
    const ValueBounds result{.lo = sum.lo + a, .hi = sum.hi + b};
    return result.widened(4 * unit_of<double> *
                          (result.size() + std::max(std::abs(a), std::abs(b))));
}

template <class Between>
template <class Wide>
auto VolumeOf<Between>::place(const std::array<double, 3>& point, int order) const
    -> PointJet<Wide> {
    std::array<Wide, 3> index{};
    std::array<bool, 3> moves{true, true, true};
    PointJet<Wide> result;
    for (std::size_t i = 0; i < 3; ++i) {
        index[i] = index_of<Wide>(map_, i, point);
        const auto end = static_cast<Wide>(data().samples().size[i] - 1);
        if (index[i] >= 0 && index[i] <= end) continue;
        const double slack = index_roundings * unit_of<double> * terms_of(map_, i, sizes_of(point));
        if (index[i] >= -static_cast<Wide>(slack) && index[i] <= end + static_cast<Wide>(slack)) {
            index[i] = index[i] > 0 ? end : 0;  // on the grid's border but for a rounding
            continue;
        }
        if (outside_ == Outside::Undefined || std::isnan(index[i])) return result;
        if (outside_ == Outside::Constant) {
            result.value = static_cast<Wide>(constant_);
            return result;
        }
        moves[i] = false;
        index[i] = index[i] > 0 ? end : 0;
    }
    const auto inside = between_.template at<Wide>(index, order > 0);
    result.value = inside.value;
    turn(result, inside, moves, order);
    return result;
}

/// Derivatives by the indices, of those that move with the point, as derivatives in the world.
template <class Between>
template <class Wide>
void VolumeOf<Between>::turn(PointJet<Wide>& result, const InterpolationPoint<Wide>& point,
                             const std::array<bool, 3>& moves, int order) const {
    const auto& m = map_.index_from_world;
    const auto by = [&](std::size_t i, std::size_t axis) {
        return moves[i] ? static_cast<Wide>(m[i][axis]) : Wide{0};
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 3; ++i)
            result.slope[axis] += by(i, axis) * point.slope[i];
    }
    if (order < 1) return;
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t j = (i + 1) % 3;
                const std::size_t k = (i + 2) % 3;
                result.bend[a][b] +=
                    point.bend.mixed[i] * (by(j, a) * by(k, b) + by(k, a) * by(j, b)) +
                    point.bend.own[i] * (by(i, a) * by(i, b));
            }
        }
    }
}

template <class Between>
template <class Real>
void VolumeOf<Between>::values_of(int derivative, const Real* in, Real* out, int lanes) const {
    using Wide = WideOf<Real>;
    constexpr Wide unknown = std::numeric_limits<Wide>::quiet_NaN();
    const int order = order_of(derivative);
    const auto axes = axes_of(derivative);
    const LanesOf<Between> vectors(between_, map_);
    const AnsweredLanes answered = order == 0 ? vectors.values(in, out, lanes) : AnsweredLanes();
    if (answered.all(lanes)) return;
    // A first derivative is to the last bit the slope that the function itself is told with.
    std::vector<Real> function(order == 1 ? FieldValue::answers * static_cast<std::size_t>(lanes)
                                          : 0);
    const AnsweredLanes has_slopes =
        order == 1 ? vectors.values(in, function.data(), lanes) : AnsweredLanes();
    const NearestLongDouble guard;
    for (int lane = 0; lane < lanes; ++lane) {
        if (answered.has(lane)) continue;
        const PointJet<Wide> at = place<Wide>(question_lane(in, FieldValue::x, lanes, lane), order);
        std::array<Wide, 4> answer{at.value, at.slope[0], at.slope[1], at.slope[2]};
        if (order == 1) {
            const auto& row = at.bend[axes[0]];
            const std::size_t slope =
                (FieldValue::slope + axes[0]) * static_cast<std::size_t>(lanes) +
                static_cast<std::size_t>(lane);
            answer = {has_slopes.has(lane) ? static_cast<Wide>(function[slope]) : at.slope[axes[0]],
                      row[0], row[1], row[2]};
        } else if (order > 1) {
            answer = {at.bend[axes[0]][axes[1]], unknown, unknown, unknown};
        }
        if (std::isnan(at.value) || order > highest_order) answer.fill(unknown);
        for (std::size_t i = 0; i < answer.size(); ++i) {
            out[i * static_cast<std::size_t>(lanes) + static_cast<std::size_t>(lane)] =
                static_cast<Real>(answer[i]);
        }
    }
}

template <class Between>
auto VolumeOf<Between>::seen(const IndexBox& box, bool with_slopes) const -> Seen {
    const bool inside = box.surely_inside();
    Seen result;
    if (outside_ != Outside::Edge && box.surely_outside()) {
        const bool defined = outside_ == Outside::Constant;
        const double value = defined ? constant_ : 0;
        result.range.value = {value, value};
        result.range.largest = std::abs(value);
        result.somewhere = result.everywhere = defined;
        result.smooth = defined;
        return result;
    }
    result.range = between_.range(box, with_slopes);
    result.somewhere = result.range.somewhere;
    result.everywhere = !result.range.holes;
    result.smooth = !result.range.holes;
    if (inside) return result;
    if (outside_ == Outside::Edge) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (box.outside[i]) result.range.slopes[i] = {};
            if (box.leaves[i]) result.range.slopes[i].add({});
        }
    } else if (outside_ == Outside::Undefined) {
        result.everywhere = false;
        result.somewhere = result.somewhere && !box.surely_outside();
    } else {
        const ValueBounds beyond{.lo = constant_, .hi = constant_};
        if (result.somewhere) {
            result.range.value.add(beyond);
        } else {
            result.range.value = beyond;
        }
        result.range.largest = std::max(result.range.largest, std::abs(constant_));
        for (ValueBounds& slope : result.range.slopes)
            slope.add({});
        result.somewhere = true;
        result.continuous = result.smooth = false;
    }
    return result;
}

template <class Between>
ValueBounds VolumeOf<Between>::world_slope(const std::array<ValueBounds, 3>& slopes,
                                           std::size_t axis) const {
    ValueBounds sum;
    for (std::size_t i = 0; i < 3; ++i)
        sum = scaled_sum(sum, map_.index_from_world[i][axis], slopes[i]);
    return sum;
}

template <class Between>
ValueBounds VolumeOf<Between>::derivative_bounds(const IndexBox& box, const Seen& over,
                                                 int derivative) const {
    const auto axes = axes_of(derivative);
    const int order = order_of(derivative);
    if (order == 1) return world_slope(over.range.slopes, axes[0]);
    if (order > highest_order) return {.lo = -unbounded, .hi = unbounded};
    if (box.surely_outside() && outside_ != Outside::Edge) return {};
    Bends<ValueBounds> bends = between_.bends(box);
    if (!box.surely_inside()) {
        for (std::size_t i = 0; i < 3; ++i) {
            bends.mixed[i].add({});
            bends.own[i].add({});
        }
    }
    const auto& m = map_.index_from_world;
    ValueBounds sum;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        const double turned = m[j][axes[0]] * m[k][axes[1]];
        const double crossed = m[k][axes[0]] * m[j][axes[1]];
        sum = scaled_sum(scaled_sum(sum, turned, bends.mixed[i]), crossed, bends.mixed[i]);
        sum = scaled_sum(sum, m[i][axes[0]] * m[i][axes[1]], bends.own[i]);
    }
    return sum;
}

template <class Between>
template <class Real>
void VolumeOf<Between>::ranges_of(int derivative, const Real* in, Real* out, int lanes) const {
    const LanesOf<Between> vectors(between_, map_);
    const AnsweredLanes answered =
        derivative == 0 ? vectors.ranges(in, out, lanes) : AnsweredLanes();
    for (int lane = 0; lane < lanes; ++lane) {
        if (answered.has(lane)) continue;
        const IndexBox box = between_.box(question_lane(in, FieldRange::neg_lo, lanes, lane, -1),
                                          question_lane(in, FieldRange::hi, lanes, lane));
        const Seen over = seen(box, derivative != 0);
        AnswerLane<Real> answer(out, lanes, lane);
        answer.set(FieldRange::range,
                   derivative == 0 ? over.range.value : derivative_bounds(box, over, derivative));
        answer.set_mask(FieldRange::somewhere, over.somewhere);
        // Where pieces meet a derivative has no value of its own.
        const bool one_piece = over.smooth && box.surely_inside() &&
                               (Between::joins_smoothly || box.cells.first == box.cells.last);
        answer.set_mask(FieldRange::everywhere, over.everywhere && (derivative == 0 || one_piece));
        answer.set_mask(FieldRange::continuous, derivative == 0 ? over.continuous : one_piece);
    }
}

template <class Between>
template <class Wide>
ValueBounds VolumeOf<Between>::at_middle(const std::array<double, 3>& middle, const IndexBox& box,
                                         const Seen& over) const {
    if (!over.smooth) return {.lo = -unbounded, .hi = unbounded};
    const auto value = static_cast<double>(place<Wide>(middle, 0).value);
    if (std::isnan(value)) return {.lo = -unbounded, .hi = unbounded};
    double error = Between::roundings * over.range.largest;
    for (std::size_t i = 0; i < 3; ++i)
        error += index_roundings * box.terms[i] * over.range.slopes[i].size();
    constexpr auto wide_unit = static_cast<double>(unit_of<Wide>);
    return ValueBounds{.lo = value, .hi = value}.widened(2 * wide_unit * error +
                                                         2 * unit_of<double> * std::abs(value));
}

template <class Between>
template <class Real>
void VolumeOf<Between>::forms_of(const Real* in, Real* out, int lanes) const {
    const LanesOf<Between> vectors(between_, map_);
    const AnsweredLanes answered =
        vectors.forms(in, out, lanes, static_cast<double>(unit_of<WideOf<Real>>));
    if (answered.all(lanes)) return;
    const NearestLongDouble guard;
    for (int lane = 0; lane < lanes; ++lane) {
        if (answered.has(lane)) continue;
        const IndexBox box = between_.box(question_lane(in, FieldForm::neg_lo, lanes, lane, -1),
                                          question_lane(in, FieldForm::hi, lanes, lane));
        const Seen over = seen(box, true);
        AnswerLane<Real> answer(out, lanes, lane);
        answer.set(FieldForm::range, over.range.value);
        answer.set_mask(FieldForm::somewhere, over.somewhere);
        answer.set_mask(FieldForm::everywhere, over.everywhere);
        answer.set_mask(FieldForm::continuous, over.continuous);
        answer.set(
            FieldForm::at_middle,
            at_middle<WideOf<Real>>(question_lane(in, FieldForm::middle, lanes, lane), box, over));
        double rounding = over.range.largest;
        for (std::size_t i = 0; i < 3; ++i) {
            answer.set(FieldForm::slopes + 2 * i, world_slope(over.range.slopes, i));
            rounding += box.terms[i] * over.range.slopes[i].size();
        }
        answer.set_above(FieldForm::rounding,
                         2 * over.range.value.size() + Between::share_of_errors * rounding);
    }
}

}  // namespace zeroset
