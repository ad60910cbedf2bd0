#pragma once

#include "engine/real/field.hpp"
#include "engine/real/scalar.hpp"
#include "engine/real/unbounded.hpp"
#include "engine/volume/lanes.hpp"
#include "engine/volume/trilinear.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

// The questions to a volume in vectors of lanes (lanes.hpp), where they are the usual ones: points
// and small boxes within the grid, away from holes. All others are left to be answered one by one.
// A lane is answered alike among whatever others, to the last bit.

namespace zeroset {

/// The lanes of a question that are answered.
class AnsweredLanes {
public:
    static constexpr int most = 256;

    void add(int first, std::uint32_t bits) {
        for (; bits != 0; bits &= bits - 1)
            bits_.set(static_cast<std::size_t>(first + std::countr_zero(bits)));
    }
    [[nodiscard]] bool has(int lane) const {
        return lane < most && bits_.test(static_cast<std::size_t>(lane));
    }
    [[nodiscard]] bool all(int lanes) const {
        return bits_.count() == static_cast<std::size_t>(lanes);
    }

private:
    std::bitset<most> bits_;
};

template <class Sample>
class VolumeLanes {
public:
    VolumeLanes(const Trilinear<Sample>& trilinear, const IndexMap& map)
        : trilinear_(trilinear), map_(map) {}

    // Each answers the function itself in some lanes, as Field says, and tells which.
    template <class Real>
    AnsweredLanes values(const Real* in, Real* out, int lanes) const {
        return in_chunks(lanes, [&](int first, int count) {
            return values_at(Columns<const Real>{in + first, lanes, count},
                             Columns<Real>{out + first, lanes, count});
        });
    }
    template <class Real>
    AnsweredLanes ranges(const Real* in, Real* out, int lanes) const {
        return in_chunks(lanes, [&](int first, int count) {
            return ranges_at(Columns<const Real>{in + first, lanes, count},
                             Columns<Real>{out + first, lanes, count});
        });
    }
    /// `unit`: of the values at the middles.
    template <class Real>
    AnsweredLanes forms(const Real* in, Real* out, int lanes, double unit) const {
        return in_chunks(lanes, [&](int first, int count) {
            return forms_at(Columns<const Real>{in + first, lanes, count},
                            Columns<Real>{out + first, lanes, count}, unit);
        });
    }

private:
    /// Columns of numbers of some lanes.
    template <class Real>
    struct Columns {
        Real* first;
        int lanes, count;

        [[nodiscard]] Real& at(std::size_t column, std::size_t lane) const {
            return first[column * static_cast<std::size_t>(lanes) + lane];
        }
        /// Copies a column, or its negative; 0 in the lanes beyond.
        void copy_to(Lanes16& to, std::size_t column, double sign = 1) const {
            const auto used = static_cast<std::size_t>(count);
            for (std::size_t lane = 0; lane < used; ++lane)
                to[lane] = sign * static_cast<double>(at(column, lane));
            std::fill(to + used, to + most_lanes, 0.0);
        }
    };

    /// The parts of boxes of some lanes, and their hulls.
    struct Parts {
        CellParts parts;
        std::array<std::uint8_t, CellParts::most> lane;
        FormLanes forms;
        std::uint32_t holes = 0;  ///< bits of lanes
    };

    template <class Ask>
    static AnsweredLanes in_chunks(int lanes, const Ask& ask) {
        AnsweredLanes answered;
        if (lanes > AnsweredLanes::most) return answered;
        for (int first = 0; first < lanes; first += static_cast<int>(most_lanes)) {
            const int count = std::min(lanes - first, static_cast<int>(most_lanes));
            answered.add(first, ask(first, count));
        }
        return answered;
    }
    static std::uint32_t bits_for(int count) { return (std::uint32_t{1} << count) - 1; }
    template <class Real>
    static constexpr Digits digits_for =
        std::is_same_v<Real, float> ? Digits::Double : Digits::TwoDoubles;

    void load_corners(PointLanes& points, std::uint32_t wanted) const;
    std::uint32_t enclose(const BoxLanes& boxes, std::uint32_t wanted, Parts& parts) const;
    bool add_box(const BoxLanes& boxes, std::size_t lane, Parts& parts) const;
    void add_part(const BoxLanes& boxes, std::size_t lane, const std::array<std::int64_t, 3>& cell,
                  Parts& parts) const;
    static void flush(Parts& parts);

    template <class Real>
    [[nodiscard]] std::uint32_t values_at(const Columns<const Real>& in,
                                          const Columns<Real>& out) const;
    template <class Real>
    [[nodiscard]] std::uint32_t ranges_at(const Columns<const Real>& in,
                                          const Columns<Real>& out) const;
    template <class Real>
    [[nodiscard]] std::uint32_t forms_at(const Columns<const Real>& in, const Columns<Real>& out,
                                         double unit) const;

    const Trilinear<Sample>& trilinear_;
    const IndexMap& map_;
};

/// Calls `visit` with each lane whose bit is set.
void for_each_lane(std::uint32_t bits, const auto& visit) {
    for (; bits != 0; bits &= bits - 1)
        visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Loads the corners about the wanted points; zeros for the others.
template <class Sample>
void VolumeLanes<Sample>::load_corners(PointLanes& points, std::uint32_t wanted) const {
    for (std::size_t lane = 0; lane < most_lanes; ++lane) {
        if ((wanted >> lane & 1U) == 0) {
            for (auto& corner : points.corners)
                corner[lane] = 0;
            continue;
        }
        trilinear_.load_corners({static_cast<std::int64_t>(points.cell[0][lane]),
                                 static_cast<std::int64_t>(points.cell[1][lane]),
                                 static_cast<std::int64_t>(points.cell[2][lane])},
                                &points.corners[0][lane], most_lanes);
    }
}

/// Keeps the lanes whose numbers are finite.
inline std::uint32_t finite_lanes(const Lanes16& numbers, std::uint32_t lanes) {
    std::uint32_t finite = lanes;
    for_each_lane(lanes, [&](std::size_t lane) {
        if (!std::isfinite(numbers[lane])) finite &= ~(std::uint32_t{1} << lane);
    });
    return finite;
}

/// The hull of a lane whose samples are in the range.
inline void set_range(const SampleRange& range, std::size_t lane, FormLanes& forms) {
    const double largest = std::max(std::abs(range.lo), std::abs(range.hi));
    const double error = mixing_roundings * unit_of<double> * largest;
    forms.lo[lane] = range.lo - error;
    forms.hi[lane] = range.hi + error;
    forms.largest[lane] = largest;
    const double apart = range.hi - range.lo + error;
    for (std::size_t i = 0; i < 3; ++i) {
        forms.slope_lo[i][lane] = -apart;
        forms.slope_hi[i][lane] = apart;
    }
}

/// Encloses a lane's box: by its parts in each of its cells, or where they are many by the pyramid;
/// false where there may be holes.
template <class Sample>
bool VolumeLanes<Sample>::add_box(const BoxLanes& boxes, std::size_t lane, Parts& parts) const {
    std::array<std::int64_t, 3> first{};
    std::array<std::int64_t, 3> last{};
    std::int64_t samples = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        first[i] = static_cast<std::int64_t>(boxes.first[i][lane]);
        last[i] = static_cast<std::int64_t>(boxes.last[i][lane]);
        samples *= std::min(last[i] - first[i] + 2, std::int64_t{1} << 16U);
    }
    constexpr std::int64_t most_samples = 36;  // 3 x 2 x 2 cells and so on: measured
    if (samples > most_samples) {
        const SampleRange range = trilinear_.sample_range({first, last});
        if (range.holes || !range.any()) return false;
        set_range(range, lane, parts.forms);
        return true;
    }
    std::array<std::int64_t, 3> cell{};
    for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) {
        for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
            for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0])
                add_part(boxes, lane, cell, parts);
        }
    }
    return true;
}

/// Adds the part of a lane's box in a cell.
template <class Sample>
void VolumeLanes<Sample>::add_part(const BoxLanes& boxes, std::size_t lane,
                                   const std::array<std::int64_t, 3>& cell, Parts& parts) const {
    if (parts.parts.count == CellParts::most) flush(parts);
    const std::size_t at = parts.parts.count++;
    parts.lane[at] = static_cast<std::uint8_t>(lane);
    trilinear_.load_corners(cell, &parts.parts.corners[0][at], CellParts::most);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto origin = static_cast<double>(cell[i]);
        parts.parts.from[i][at] =
            origin == boxes.first[i][lane] ? boxes.from[i][lane] - origin : 0.0;
        parts.parts.to[i][at] = origin == boxes.last[i][lane] ? boxes.to[i][lane] - origin : 1.0;
    }
}

/// Adds what the parts are found to be to the hulls of their lanes.
template <class Sample>
void VolumeLanes<Sample>::flush(Parts& parts) {
    CellParts& of = parts.parts;
    FormLanes& forms = parts.forms;
    enclose_parts(of);
    const auto lower = [](double& end, double x) { end = x < end ? x : end; };
    const auto raise = [](double& end, double x) { end = x > end ? x : end; };
    for (std::size_t at = 0; at < of.count; ++at) {
        const std::size_t lane = parts.lane[at];
        if (!(of.largest[at] <= std::numeric_limits<double>::max()))
            parts.holes |= std::uint32_t{1} << lane;
        lower(forms.lo[lane], of.lo[at]);
        raise(forms.hi[lane], of.hi[at]);
        raise(forms.largest[lane], of.largest[at]);
        for (std::size_t i = 0; i < 3; ++i) {
            lower(forms.slope_lo[i][lane], of.slope_lo[i][at]);
            raise(forms.slope_hi[i][lane], of.slope_hi[i][at]);
        }
    }
    of.count = 0;
}

/// Encloses values and slopes over the wanted boxes; returns those of which it is done.
template <class Sample>
std::uint32_t VolumeLanes<Sample>::enclose(const BoxLanes& boxes, std::uint32_t wanted,
                                           Parts& parts) const {
    FormLanes& forms = parts.forms;
    std::ranges::fill(forms.lo, unbounded);
    std::ranges::fill(forms.hi, -unbounded);
    std::ranges::fill(forms.largest, 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        std::ranges::fill(forms.slope_lo[i], unbounded);
        std::ranges::fill(forms.slope_hi[i], -unbounded);
    }
    parts.parts.count = 0;
    std::uint32_t done = 0;
    for_each_lane(wanted, [&](std::size_t lane) {
        if (add_box(boxes, lane, parts)) done |= std::uint32_t{1} << lane;
    });
    flush(parts);
    return done & ~parts.holes;
}

template <class Sample>
template <class Real>
std::uint32_t VolumeLanes<Sample>::values_at(const Columns<const Real>& in,
                                             const Columns<Real>& out) const {
    PointLanes points;
    for (std::size_t c = 0; c < 3; ++c)
        in.copy_to(points.at[c], FieldValue::x + c);
    points.count = static_cast<std::size_t>(in.count);
    place_points(map_, trilinear_.size(), digits_for<Real>, points);
    std::uint32_t lanes = points.inside & bits_for(in.count);
    if (lanes == 0) return 0;
    load_corners(points, lanes);
    mix_points(map_, digits_for<Real>, true, points);
    lanes = finite_lanes(points.value, lanes);
    for_each_lane(lanes, [&](std::size_t lane) {
        out.at(FieldValue::value, lane) = static_cast<Real>(points.value[lane]);
        for (std::size_t c = 0; c < 3; ++c)
            out.at(FieldValue::slope + c, lane) = static_cast<Real>(points.slope[c][lane]);
    });
    return lanes;
}

template <class Sample>
template <class Real>
std::uint32_t VolumeLanes<Sample>::ranges_at(const Columns<const Real>& in,
                                             const Columns<Real>& out) const {
    BoxLanes boxes;
    for (std::size_t c = 0; c < 3; ++c) {
        in.copy_to(boxes.lo[c], FieldRange::neg_lo + c, -1);
        in.copy_to(boxes.hi[c], FieldRange::hi + c);
    }
    boxes.count = static_cast<std::size_t>(in.count);
    place_boxes(map_, trilinear_.size(), boxes);
    Parts parts;
    const std::uint32_t lanes = enclose(boxes, boxes.inside & bits_for(in.count), parts);
    for_each_lane(lanes, [&](std::size_t lane) {
        out.at(FieldRange::range, lane) = upper_end(Real{}, -parts.forms.lo[lane]);
        out.at(FieldRange::range + 1, lane) = upper_end(Real{}, parts.forms.hi[lane]);
        out.at(FieldRange::somewhere, lane) = 1;
        out.at(FieldRange::everywhere, lane) = 1;
        out.at(FieldRange::continuous, lane) = 1;
    });
    return lanes;
}

template <class Sample>
template <class Real>
std::uint32_t VolumeLanes<Sample>::forms_at(const Columns<const Real>& in, const Columns<Real>& out,
                                            double unit) const {
    BoxLanes boxes;
    PointLanes middles;
    for (std::size_t c = 0; c < 3; ++c) {
        in.copy_to(boxes.lo[c], FieldForm::neg_lo + c, -1);
        in.copy_to(boxes.hi[c], FieldForm::hi + c);
        in.copy_to(middles.at[c], FieldForm::middle + c);
    }
    boxes.count = static_cast<std::size_t>(in.count);
    place_boxes(map_, trilinear_.size(), boxes);
    middles.count = boxes.count;
    place_points(map_, trilinear_.size(), digits_for<Real>, middles);
    Parts parts;
    std::uint32_t lanes = enclose(boxes, boxes.inside & middles.inside & bits_for(in.count), parts);
    if (lanes == 0) return 0;
    load_corners(middles, lanes);
    mix_points(map_, digits_for<Real>, false, middles);
    lanes = finite_lanes(middles.value, lanes);
    FormColumns<Real> columns;
    make_forms(map_, boxes, middles, unit, parts.forms, columns);
    for (std::size_t column = 0; column < FieldForm::answers; ++column) {
        for_each_lane(
            lanes, [&](std::size_t lane) { out.at(column, lane) = columns.column[column][lane]; });
    }
    return lanes;
}

/// Answers nothing: all questions are left to be answered one by one.
class NoLanes {
public:
    NoLanes(const auto& /*between*/, const IndexMap& /*map*/) {}
    AnsweredLanes values(const auto* /*in*/, auto* /*out*/, int /*lanes*/) const { return {}; }
    AnsweredLanes ranges(const auto* /*in*/, auto* /*out*/, int /*lanes*/) const { return {}; }
    AnsweredLanes forms(const auto* /*in*/, auto* /*out*/, int /*lanes*/, double /*unit*/) const {
        return {};
    }
};

template <class Between>
struct LanesOfType {
    using Type = NoLanes;
};
template <class Sample>
struct LanesOfType<Trilinear<Sample>> {
    using Type = VolumeLanes<Sample>;
};

/// The questions in vectors to what is `Between` the samples.
template <class Between>
using LanesOf = typename LanesOfType<Between>::Type;

}  // namespace zeroset
