#include "engine/special/line_field.hpp"

#include "engine/real/field_answers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace zeroset {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr ValueBounds nothing_known{.lo = -unbounded, .hi = unbounded};
/// How often a field can be differentiated and still have slopes.
constexpr int most_shifted = 2;
/// How many lanes are answered at once.
constexpr int most_lanes = 16;

/// The value that narrow bounds tell, else NaN.
double told_by(const ValueBounds& of) {
    const double value = of.lo + 0.5 * (of.hi - of.lo);
    return of.hi - of.lo <= error_beyond ? value : unknown;
}

/// Points of a line, evaluated together.
class LinePoints {
public:
    LinePoints(const PiecedLine& line, int order) : line_(line), order_(order) {}

    void add(double x) {
        const bool left = x < 0;
        const Pieces* const pieces = left ? line_.left.get() : line_.right.get();
        const bool is_defined = pieces != nullptr && (x != 0 || line_.left);
        const Piece* const piece = is_defined ? pieces->piece(std::abs(x)) : nullptr;
        x_[count_] = x;
        place_[count_] = known_;
        if (piece != nullptr)
            samples_[known_++] = {.piece = piece,
                                  .t = (std::abs(x) - piece->middle) * piece->per_half};
        has_piece_[count_++] = piece != nullptr;
    }
    void evaluate() { zeroset::evaluate(std::span(samples_).first(known_), order_); }

    [[nodiscard]] bool is_known(std::size_t n) const { return has_piece_[n]; }
    /// The derivative of the order at point n, or with `next` 1 the one after it.
    [[nodiscard]] double value(std::size_t n, int next) const {
        const PieceSample& sample = samples_[place_[n]];
        return sign(n, order_ + next) * (next == 0 ? sample.value : sample.slope);
    }
    [[nodiscard]] double error(std::size_t n, int next) const {
        return samples_[place_[n]].piece->errors[static_cast<std::size_t>(order_ + next)];
    }
    [[nodiscard]] ValueBounds bounds(std::size_t n, int next) const {
        if (is_known(n)) {
            const double at = value(n, next);
            return ValueBounds{.lo = at, .hi = at}.widened(error(n, next));
        }
        const bool left = x_[n] < 0;
        const Pieces* const pieces = left ? line_.left.get() : line_.right.get();
        if (pieces == nullptr || !(std::abs(x_[n]) >= pieces->function().end)) return nothing_known;
        ValueBounds beyond = pieces->function().beyond(order_ + next);
        if (sign(n, order_ + next) < 0) beyond = {.lo = -beyond.hi, .hi = -beyond.lo};
        return beyond;
    }

private:
    [[nodiscard]] double sign(std::size_t n, int order) const {
        return x_[n] < 0 ? line_.sign(order) : 1;
    }

    static constexpr std::size_t most = 3 * most_lanes;
    const PiecedLine& line_;
    int order_;
    std::size_t count_ = 0, known_ = 0;
    std::array<double, most> x_{};
    std::array<std::size_t, most> place_{};
    std::array<bool, most> has_piece_{};
    std::array<PieceSample, most> samples_{};
};

/// The part of a range right of 0, and the mirrored part left of it.
struct Side {
    const Pieces* pieces;
    double lo, hi;
};

template <class Visit>
void for_each_side(const PiecedLine& line, double lo, double hi, const Visit& visit) {
    if (hi >= 0) visit(Side{.pieces = line.right.get(), .lo = std::max(lo, 0.0), .hi = hi}, false);
    if (lo < 0 && line.left)
        visit(Side{.pieces = line.left.get(), .lo = std::max(-hi, 0.0), .hi = -lo}, true);
}

/// Ranges of a line over boxes.
class LineBoxes {
public:
    LineBoxes(const PiecedLine& line, int order)
        : line_(line), order_(order), points_(line, order) {}

    /// Adds a box.
    void add(double lo, double hi) {
        if (std::isnan(lo)) lo = -unbounded;
        if (std::isnan(hi)) hi = unbounded;
        boxes_[count_++] = {lo, hi};
        points_.add(lo);
        points_.add(hi);
    }
    /// Adds points, as many as there are boxes, behind all of these.
    void add_point(double x) { points_.add(x); }
    void evaluate() { points_.evaluate(); }

    [[nodiscard]] bool is_somewhere(std::size_t n) const { return line_.left || boxes_[n][1] > 0; }
    [[nodiscard]] bool is_everywhere(std::size_t n) const { return line_.left || boxes_[n][0] > 0; }

    /// The range of the derivative of the order, or with `next` 1 of the one after it.
    [[nodiscard]] ValueBounds range(std::size_t n, int next) const {
        const auto [lo, hi] = boxes_[n];
        const int order = order_ + next;
        if (!(lo <= hi) || order > highest_ranged_order) return nothing_known;
        ValueBounds all{.lo = unbounded, .hi = -unbounded};
        if (points_.is_known(2 * n)) all.add(points_.bounds(2 * n, next));
        if (points_.is_known(2 * n + 1)) all.add(points_.bounds(2 * n + 1, next));
        for_each_side(line_, lo, hi, [&](const Side& side, bool mirrored) {
            ValueBounds inner{.lo = unbounded, .hi = -unbounded};
            side.pieces->add_inner(side.lo, side.hi, order, inner);
            if (mirrored && line_.sign(order) < 0) inner = {.lo = -inner.hi, .hi = -inner.lo};
            all.add(inner);
        });
        return all.lo <= all.hi ? all : nothing_known;
    }
    [[nodiscard]] double error(std::size_t n) const {
        const auto [lo, hi] = boxes_[n];
        double error = 0;
        for_each_side(line_, lo, hi, [&](const Side& side, bool /*mirrored*/) {
            error = std::max(error, side.pieces->error_over(side.lo, side.hi, order_));
        });
        return error;
    }
    [[nodiscard]] ValueBounds at_point(std::size_t n) const {
        return points_.bounds(2 * count_ + n, 0);
    }

private:
    const PiecedLine& line_;
    int order_;
    LinePoints points_;
    std::size_t count_ = 0;
    std::array<std::array<double, 2>, most_lanes> boxes_{};
};

/// Calls visit(first lane, number of lanes) for groups of lanes.
void for_each_group(int lanes, const auto& visit) {
    for (int first = 0; first < lanes; first += most_lanes)
        visit(first, std::min(most_lanes, lanes - first));
}

template <class Real>
double question(const Real* in, std::size_t column, int lanes, int lane) {
    return static_cast<double>(
        in[column * static_cast<std::size_t>(lanes) + static_cast<std::size_t>(lane)]);
}

/// The order of a derivative by the first operand alone; none where it is by another one, and so 0.
std::optional<int> order_by_x(int derivative) {
    const auto times = times_of(derivative);
    return times[1] == 0 && times[2] == 0 ? std::optional(times[0]) : std::nullopt;
}

template <class Real>
void answer_values(const PiecedLine& line, std::optional<int> order, const Real* in, Real* out,
                   int lanes) {
    for_each_group(lanes, [&](int first, int count) {
        LinePoints points(line, std::min(order.value_or(0), highest_ranged_order));
        for (int lane = first; lane < first + count; ++lane)
            points.add(question(in, FieldValue::x, lanes, lane));
        points.evaluate();
        for (int lane = first; lane < first + count; ++lane) {
            const auto n = static_cast<std::size_t>(lane - first);
            AnswerLane<Real> result(out, lanes, lane);
            for (std::size_t i = 0; i < FieldValue::answers; ++i)
                result.set(i, 0.0);
            if (!order) continue;
            const bool known = *order <= highest_ranged_order;
            const auto number = [&](int next) {
                if (!known) return unknown;
                return points.is_known(n) ? points.value(n, next) : told_by(points.bounds(n, next));
            };
            result.set(FieldValue::value, number(0));
            result.set(FieldValue::slope, number(1));
        }
    });
}

template <class Real>
void answer_ranges(const PiecedLine& line, std::optional<int> order, const Real* in, Real* out,
                   int lanes) {
    for_each_group(lanes, [&](int first, int count) {
        LineBoxes boxes(line, std::min(order.value_or(0), highest_ranged_order));
        for (int lane = first; lane < first + count; ++lane) {
            const double lo = -question(in, FieldRange::neg_lo, lanes, lane);
            boxes.add(lo, question(in, FieldRange::hi, lanes, lane));
        }
        boxes.evaluate();
        for (int lane = first; lane < first + count; ++lane) {
            const auto n = static_cast<std::size_t>(lane - first);
            ValueBounds range{};
            if (order) range = *order > highest_ranged_order ? nothing_known : boxes.range(n, 0);
            AnswerLane<Real> result(out, lanes, lane);
            result.set(FieldRange::range, range);
            result.set_mask(FieldRange::somewhere, boxes.is_somewhere(n));
            result.set_mask(FieldRange::everywhere, boxes.is_everywhere(n));
            result.set_mask(FieldRange::continuous, true);
        }
    });
}

template <class Real>
void answer_forms(const PiecedLine& line, int order, const Real* in, Real* out, int lanes) {
    for_each_group(lanes, [&](int first, int count) {
        LineBoxes boxes(line, order);
        for (int lane = first; lane < first + count; ++lane)
            boxes.add(-question(in, FieldForm::neg_lo, lanes, lane),
                      question(in, FieldForm::hi, lanes, lane));
        for (int lane = first; lane < first + count; ++lane)
            boxes.add_point(question(in, FieldForm::middle, lanes, lane));
        boxes.evaluate();
        for (int lane = first; lane < first + count; ++lane) {
            const auto n = static_cast<std::size_t>(lane - first);
            const ValueBounds range = boxes.range(n, 0);
            AnswerLane<Real> result(out, lanes, lane);
            for (std::size_t i = 0; i < FieldForm::answers; ++i)
                result.set(i, 0.0);
            result.set(FieldForm::range, range);
            result.set_mask(FieldForm::somewhere, boxes.is_somewhere(n));
            result.set_mask(FieldForm::everywhere, boxes.is_everywhere(n));
            result.set_mask(FieldForm::continuous, true);
            result.set(FieldForm::at_middle, boxes.at_point(n));
            result.set(FieldForm::slopes, boxes.range(n, 1));
            // Results below the smallest normal number are rounded to denormals.
            constexpr double denormals = std::numeric_limits<Real>::min();
            result.set_above(
                FieldForm::rounding,
                2 * range.size() + denormals + boxes.error(n) / static_cast<double>(unit_of<Real>));
        }
    });
}

}  // namespace

LineField::LineField(std::shared_ptr<const PiecedLine> line, int shift)
    : line_(std::move(line)),
      shift_(shift),
      derivative_(shift < most_shifted ? std::make_shared<LineField>(line_, shift + 1) : nullptr) {}

std::shared_ptr<const LineField> LineField::derivative() const { return derivative_; }

std::string LineField::text() const {
    return line_->name + std::string(static_cast<std::size_t>(shift_), '\'') + line_->arguments;
}

namespace {

std::optional<int> shifted(int derivative, int shift) {
    const auto order = order_by_x(derivative);
    return order ? std::optional(*order + shift) : std::nullopt;
}

}  // namespace

void LineField::values(int derivative, const float* in, float* out, int lanes) const {
    answer_values(*line_, shifted(derivative, shift_), in, out, lanes);
}
void LineField::values(int derivative, const double* in, double* out, int lanes) const {
    answer_values(*line_, shifted(derivative, shift_), in, out, lanes);
}
void LineField::ranges(int derivative, const float* in, float* out, int lanes) const {
    answer_ranges(*line_, shifted(derivative, shift_), in, out, lanes);
}
void LineField::ranges(int derivative, const double* in, double* out, int lanes) const {
    answer_ranges(*line_, shifted(derivative, shift_), in, out, lanes);
}
void LineField::forms(const float* in, float* out, int lanes) const {
    answer_forms(*line_, shift_, in, out, lanes);
}
void LineField::forms(const double* in, double* out, int lanes) const {
    answer_forms(*line_, shift_, in, out, lanes);
}

}  // namespace zeroset
