#pragma once

#include "engine/real/field_answers.hpp"
#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace zeroset {

/// A function at a point, computed in double.
struct PointAnswer {
    double value = 0;
    std::array<double, 3> slope{};
    std::array<std::array<double, 3>, 3> bend{};  ///< second derivatives; only if asked for
};

/// Bounds of a function over a box.
struct BoxAnswer {
    ValueBounds value{};
    std::array<ValueBounds, 3> slopes{};
    double error = 0;    ///< bounds the rounding error of values anywhere in the box
    bool smooth = true;  ///< whether the slopes are continuous in the box
};

/// Second derivatives over a box, and whether they are continuous there.
struct BendAnswer {
    ValueBounds value{};
    bool smooth = true;
};

/// A box; its ends may be infinite, and lo > hi where nothing is in it.
struct FieldBox {
    std::array<double, 3> lo{}, hi{};
};

/// The most points or boxes that are asked for at once.
inline constexpr std::size_t most_asked = 16;

/// A field that is defined and continuous everywhere. `Function` has
///     PointAnswer at(const std::array<double, 3>& point, bool with_bends) const;
///     void at(std::span<const std::array<double, 3>> points, PointAnswer* answers) const;
///     void over(std::span<const FieldBox> boxes, BoxAnswer* answers) const;
///     BendAnswer bend(const FieldBox& box, const std::array<std::size_t, 2>& axes) const;
/// of finite points, at most `most_asked` at once, to the last bit alike among whatever others.
template <class Function>
class TotalField : public Field {
public:
    TotalField(Function function, std::string text)
        : function_(std::move(function)), text_(std::move(text)) {}

    [[nodiscard]] const Function& function() const { return function_; }

    [[nodiscard]] std::string text() const override { return text_; }
    [[nodiscard]] bool is_total() const override { return true; }
    [[nodiscard]] bool is_continuous() const override { return true; }

    void values(int derivative, const float* in, float* out, int lanes) const override {
        if (derivative == 0) return values_of(in, out, lanes);
        derivatives_of(derivative, in, out, lanes);
    }
    void values(int derivative, const double* in, double* out, int lanes) const override {
        if (derivative == 0) return values_of(in, out, lanes);
        derivatives_of(derivative, in, out, lanes);
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
    using Point = std::array<double, 3>;

    static bool is_finite(const Point& point) {
        return std::ranges::all_of(point, [](double x) { return std::isfinite(x); });
    }
    /// The box of a lane from `column` on; NaN means that nothing is known of that end.
    template <class Real>
    static FieldBox box_of(const Real* in, std::size_t column, int lanes, int lane) {
        FieldBox box{.lo = question_lane(in, column, lanes, lane, -1),
                     .hi = question_lane(in, column + 3, lanes, lane)};
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::isnan(box.lo[i])) box.lo[i] = -unbounded;
            if (std::isnan(box.hi[i])) box.hi[i] = unbounded;
        }
        return box;
    }
    /// Calls visit(first lane, number of lanes) for groups of lanes.
    static void for_each_group(int lanes, const auto& visit) {
        constexpr auto most = static_cast<int>(most_asked);
        for (int first = 0; first < lanes; first += most)
            visit(first, std::min(most, lanes - first));
    }
    /// Answers of the function at points, of which some may not be finite.
    struct Points {
        std::array<Point, most_asked> at;
        std::array<PointAnswer, most_asked> answers;
        std::array<bool, most_asked> known;
        std::size_t count = 0;

        void add(const Point& point) {
            known[count] = is_finite(point);
            at[count] = known[count] ? point : Point{};
            ++count;
        }
    };
    void answer(Points& points) const {
        function_.at(std::span<const Point>(points.at.data(), points.count), points.answers.data());
    }
    template <class Real>
    void values_of(const Real* in, Real* out, int lanes) const;
    template <class Real>
    void derivatives_of(int derivative, const Real* in, Real* out, int lanes) const;
    template <class Real>
    void ranges_of(int derivative, const Real* in, Real* out, int lanes) const;
    template <class Real>
    void forms_of(const Real* in, Real* out, int lanes) const;

    Function function_;
    std::string text_;
};

template <class Function>
template <class Real>
void TotalField<Function>::values_of(const Real* in, Real* out, int lanes) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for_each_group(lanes, [&](int first, int count) {
        Points points;
        for (int lane = first; lane < first + count; ++lane)
            points.add(question_lane(in, FieldValue::x, lanes, lane));
        answer(points);
        for (std::size_t n = 0; n < points.count; ++n) {
            AnswerLane<Real> result(out, lanes, first + static_cast<int>(n));
            const bool known = points.known[n];
            result.set(FieldValue::value, known ? points.answers[n].value : unknown);
            for (std::size_t i = 0; i < 3; ++i)
                result.set(FieldValue::slope + i, known ? points.answers[n].slope[i] : unknown);
        }
    });
}

template <class Function>
template <class Real>
void TotalField<Function>::derivatives_of(int derivative, const Real* in, Real* out,
                                          int lanes) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const int order = order_of(derivative);
    const auto axes = axes_of(derivative);
    for (int lane = 0; lane < lanes; ++lane) {
        const Point point = question_lane(in, FieldValue::x, lanes, lane);
        std::array<double, FieldValue::answers> answer{unknown, unknown, unknown, unknown};
        if (order <= highest_order && is_finite(point)) {
            const PointAnswer at = function_.at(point, true);
            const auto& row = at.bend[axes[0]];
            if (order == 1) answer = {at.slope[axes[0]], row[0], row[1], row[2]};
            if (order == 2) answer[0] = row[axes[1]];
        }
        AnswerLane<Real> result(out, lanes, lane);
        for (std::size_t i = 0; i < answer.size(); ++i)
            result.set(i, answer[i]);
    }
}

template <class Function>
template <class Real>
void TotalField<Function>::ranges_of(int derivative, const Real* in, Real* out, int lanes) const {
    const int order = order_of(derivative);
    const auto axes = axes_of(derivative);
    for_each_group(lanes, [&](int first, int count) {
        std::array<FieldBox, most_asked> boxes;
        std::array<BoxAnswer, most_asked> answers;
        const auto size = static_cast<std::size_t>(count);
        for (std::size_t n = 0; n < size; ++n)
            boxes[n] = box_of(in, FieldRange::neg_lo, lanes, first + static_cast<int>(n));
        if (order < 2)
            function_.over(std::span<const FieldBox>(boxes.data(), size), answers.data());
        for (std::size_t n = 0; n < size; ++n) {
            BendAnswer answer{.value = {.lo = -unbounded, .hi = unbounded}, .smooth = false};
            if (order == 0) answer = {.value = answers[n].value};
            if (order == 1)
                answer = {.value = answers[n].slopes[axes[0]], .smooth = answers[n].smooth};
            if (order == 2) answer = function_.bend(boxes[n], axes);
            AnswerLane<Real> result(out, lanes, first + static_cast<int>(n));
            result.set(FieldRange::range, answer.value);
            result.set_mask(FieldRange::somewhere, true);
            // Where smooth pieces meet a derivative has no value of its own.
            result.set_mask(FieldRange::everywhere, answer.smooth);
            result.set_mask(FieldRange::continuous, answer.smooth);
        }
    });
}

template <class Function>
template <class Real>
void TotalField<Function>::forms_of(const Real* in, Real* out, int lanes) const {
    for_each_group(lanes, [&](int first, int count) {
        std::array<FieldBox, most_asked> boxes;
        std::array<BoxAnswer, most_asked> answers;
        Points middles;
        const auto size = static_cast<std::size_t>(count);
        for (std::size_t n = 0; n < size; ++n) {
            const int lane = first + static_cast<int>(n);
            boxes[n] = box_of(in, FieldForm::neg_lo, lanes, lane);
            middles.add(question_lane(in, FieldForm::middle, lanes, lane));
        }
        function_.over(std::span<const FieldBox>(boxes.data(), size), answers.data());
        answer(middles);
        for (std::size_t n = 0; n < size; ++n) {
            const BoxAnswer& over = answers[n];
            ValueBounds at_middle{.lo = -unbounded, .hi = unbounded};
            if (middles.known[n]) {
                const double value = middles.answers[n].value;
                // The error is that of the box, which the middle may lie a rounding beyond.
                at_middle = ValueBounds{.lo = value, .hi = value}.widened(2 * over.error);
            }
            AnswerLane<Real> result(out, lanes, first + static_cast<int>(n));
            result.set(FieldForm::range, over.value);
            for (const std::size_t mask :
                 {FieldForm::somewhere, FieldForm::everywhere, FieldForm::continuous})
                result.set_mask(mask, true);
            result.set(FieldForm::at_middle, at_middle);
            for (std::size_t i = 0; i < 3; ++i)
                result.set(FieldForm::slopes + 2 * i, over.slopes[i]);
            result.set_above(
                FieldForm::rounding,
                2 * over.value.size() + over.error / static_cast<double>(unit_of<Real>));
        }
    });
}

}  // namespace zeroset
