#pragma once

#include "engine/volume/corner_values.hpp"
#include "engine/volume/index_box.hpp"
#include "engine/volume/interpolation.hpp"
#include "engine/volume/volume.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

// Trilinear interpolation of the samples of one type: values at points, enclosures over boxes. All
// of it in any rounding mode: enclosures are widened by bounds of the rounding errors.

namespace zeroset {

/// Roundings of values and slopes between samples, amply counted.
inline constexpr double mixing_roundings = 32;

template <class Sample>
class Trilinear {
public:
    using Source = VolumeData;
    using Range = InterpolationRange;
    template <class Wide>
    using Point = InterpolationPoint<Wide>;
    /// First derivatives jump where cells meet.
    static constexpr bool joins_smoothly = false;
    static constexpr double roundings = mixing_roundings;
    /// Bounds the errors of values in long double, in units of double.
    static constexpr double share_of_errors = 0x1p-8;

    explicit Trilinear(const VolumeData& data)
        : data_(static_cast<const Sample*>(data.samples().data.get())),
          size_(data.samples().size),
          map_(data.map()),
          pyramid_(data.pyramid<Sample>()) {}

    [[nodiscard]] IndexBox box(const std::array<double, 3>& lo,
                               const std::array<double, 3>& hi) const {
        return index_box(map_, size_, lo, hi);
    }

    [[nodiscard]] Range range(const IndexBox& box, bool with_slopes) const;

    /// The second derivatives by the indices, over the box.
    [[nodiscard]] Bends<ValueBounds> bends(const IndexBox& box) const;
    /// At indices within the grid.
    template <class Wide>
    [[nodiscard]] Point<Wide> at(const std::array<Wide, 3>& index, bool with_bends = true) const;

    [[nodiscard]] const GridSize& size() const { return size_; }
    /// Encloses the samples of the cells, from few bricks: those about them, too.
    [[nodiscard]] SampleRange sample_range(const CellSpan& cells) const {
        return pyramid_.range(cells);
    }
    /// Puts the samples at the corners of a cell into every `step`-th number from `out` on.
    void load_corners(const std::array<std::int64_t, 3>& cell, double* out,
                      std::size_t step) const {
        const auto width = static_cast<std::int64_t>(size_[0]);
        const std::int64_t slice = width * static_cast<std::int64_t>(size_[1]);
        const Sample* const base = sample(cell[0], cell[1], cell[2]);
        for (std::size_t edge = 0; edge < 4; ++edge) {
            const Sample* const row = base + (edge % 2 == 1 ? width : 0) + (edge >= 2 ? slice : 0);
            out[2 * edge * step] = static_cast<double>(row[0]);
            out[(2 * edge + 1) * step] = static_cast<double>(row[1]);
        }
    }

private:
    [[nodiscard]] const Sample* sample(std::int64_t i, std::int64_t j, std::int64_t k) const {
        const auto width = static_cast<std::int64_t>(size_[0]);
        const auto height = static_cast<std::int64_t>(size_[1]);
        return data_ + (k * height + j) * width + i;
    }
    /// `range` of a box in one cell without holes; nothing where there is one.
    [[nodiscard]] std::optional<Range> range_in_cell(const IndexBox& box) const;
    /// The samples about the box, or nothing where there are too many.
    [[nodiscard]] std::optional<CornerValues> corners(const IndexBox& box) const;
    static void narrow(CornerValues& values, const IndexBox& box, std::size_t axis) {
        values.narrow(axis, box.from[axis] - static_cast<double>(box.cells.first[axis]),
                      box.to[axis] - static_cast<double>(box.cells.last[axis]));
    }
    static ValueBounds bounds(const CornerValues& values, double error) {
        const SampleRange range = values.range();
        return ValueBounds{.lo = range.lo, .hi = range.hi}.widened(error);
    }

    const Sample* data_;
    GridSize size_;
    IndexMap map_;
    const Pyramid<Sample>& pyramid_;
};

template <class Sample>
std::optional<CornerValues> Trilinear<Sample>::corners(const IndexBox& box) const {
    const std::array<std::size_t, 3> count{box.samples(0), box.samples(1), box.samples(2)};
    if (count[0] > CornerValues::most || count[1] > CornerValues::most ||
        count[0] * count[1] > CornerValues::most ||
        count[0] * count[1] * count[2] > CornerValues::most) {
        return std::nullopt;
    }
    CornerValues values(count);
    std::size_t at = 0;
    for (std::size_t k = 0; k < count[2]; ++k) {
        for (std::size_t j = 0; j < count[1]; ++j) {
            const Sample* const row =
                sample(box.cells.first[0], box.cells.first[1] + static_cast<std::int64_t>(j),
                       box.cells.first[2] + static_cast<std::int64_t>(k));
            for (std::size_t i = 0; i < count[0]; ++i)
                values[at++] = static_cast<double>(row[i]);
        }
    }
    return values;
}

/// Eight numbers at the corners of a box, the first axis running fastest.
using BoxCorners = std::array<double, 8>;

/// The numbers where the box is cut down along the axis to the shares from `from` to `to`.
inline BoxCorners narrowed(const BoxCorners& values, std::size_t axis, double from, double to) {
    const std::size_t step = std::size_t{1} << axis;
    BoxCorners result;
    for (std::size_t i = 0; i < 8; ++i) {
        if ((i & step) != 0) continue;
        const double a = values[i];
        const double b = values[i | step];
        result[i] = a * (1 - from) + b * from;
        result[i | step] = a * (1 - to) + b * to;
    }
    return result;
}
inline ValueBounds hull_of(const BoxCorners& values) {
    ValueBounds hull{.lo = values[0], .hi = values[0]};
    for (const double value : values) {
        hull.lo = value < hull.lo ? value : hull.lo;
        hull.hi = value > hull.hi ? value : hull.hi;
    }
    return hull;
}
inline ValueBounds hull_of_differences(const BoxCorners& values, std::size_t axis) {
    const std::size_t step = std::size_t{1} << axis;
    const double first = values[step] - values[0];
    ValueBounds hull{.lo = first, .hi = first};
    for (std::size_t i = 0; i < 8; ++i) {
        if ((i & step) != 0) continue;
        const double difference = values[i | step] - values[i];
        hull.lo = difference < hull.lo ? difference : hull.lo;
        hull.hi = difference > hull.hi ? difference : hull.hi;
    }
    return hull;
}

template <class Sample>
auto Trilinear<Sample>::range_in_cell(const IndexBox& box) const -> std::optional<Range> {
    const auto width = static_cast<std::int64_t>(size_[0]);
    const std::int64_t slice = width * static_cast<std::int64_t>(size_[1]);
    const Sample* const base = sample(box.cells.first[0], box.cells.first[1], box.cells.first[2]);
    BoxCorners values;
    double sizes = 0;
    for (std::size_t edge = 0; edge < 4; ++edge) {
        const Sample* const row = base + (edge % 2 == 1 ? width : 0) + (edge >= 2 ? slice : 0);
        values[2 * edge] = static_cast<double>(row[0]);
        values[2 * edge + 1] = static_cast<double>(row[1]);
        sizes += std::abs(values[2 * edge]) + std::abs(values[2 * edge + 1]);
    }
    if (!(sizes <= std::numeric_limits<double>::max())) return std::nullopt;
    const auto cut = [&](const BoxCorners& of, std::size_t axis) {
        const auto first = static_cast<double>(box.cells.first[axis]);
        return narrowed(of, axis, box.from[axis] - first, box.to[axis] - first);
    };
    const BoxCorners in_z = cut(values, 2);
    const BoxCorners in_yz = cut(in_z, 1);
    Range result;
    result.exact = true;
    const ValueBounds samples = hull_of(values);
    result.largest = samples.size();
    const double error = mixing_roundings * unit_of<double> * result.largest;
    const ValueBounds mixed = hull_of(cut(in_yz, 0));
    result.value = {.lo = std::max(mixed.lo, samples.lo) - error,
                    .hi = std::min(mixed.hi, samples.hi) + error};
    result.slopes = {hull_of_differences(in_yz, 0).widened(error),
                     hull_of_differences(cut(in_z, 0), 1).widened(error),
                     hull_of_differences(cut(cut(values, 0), 1), 2).widened(error)};
    return result;
}

template <class Sample>
auto Trilinear<Sample>::range(const IndexBox& box, bool with_slopes) const -> Range {
    if (box.cells.first == box.cells.last) {
        if (const auto in_cell = range_in_cell(box)) return *in_cell;
    }
    Range result;
    const auto values = corners(box);
    const SampleRange samples = values ? values->range() : pyramid_.range(box.cells);
    result.holes = samples.holes;
    result.somewhere = samples.any();
    if (!samples.any()) return result;
    result.value = {.lo = samples.lo, .hi = samples.hi};
    result.largest = result.value.size();
    const double error = mixing_roundings * unit_of<double> * result.largest;
    if (!values || samples.holes) {
        const double apart = samples.hi - samples.lo + error;
        result.value = result.value.widened(error);
        result.slopes.fill({.lo = -apart, .hi = apart});
        return result;
    }
    result.exact = true;
    CornerValues narrow_in_z = *values;
    narrow(narrow_in_z, box, 2);
    CornerValues narrow_in_yz = narrow_in_z;
    narrow(narrow_in_yz, box, 1);
    CornerValues narrow_in_all = narrow_in_yz;
    narrow(narrow_in_all, box, 0);
    // Between samples nothing is beyond them.
    const ValueBounds mixed = bounds(narrow_in_all, error);
    result.value = {.lo = std::max(mixed.lo, result.value.lo - error),
                    .hi = std::min(mixed.hi, result.value.hi + error)};
    if (!with_slopes) return result;
    narrow_in_yz.differentiate(0);
    result.slopes[0] = bounds(narrow_in_yz, error);
    narrow(narrow_in_z, box, 0);
    narrow_in_z.differentiate(1);
    result.slopes[1] = bounds(narrow_in_z, error);
    CornerValues narrow_in_xy = *values;
    narrow(narrow_in_xy, box, 0);
    narrow(narrow_in_xy, box, 1);
    narrow_in_xy.differentiate(2);
    result.slopes[2] = bounds(narrow_in_xy, error);
    return result;
}

template <class Sample>
Bends<ValueBounds> Trilinear<Sample>::bends(const IndexBox& box) const {
    Bends<ValueBounds> bends;
    const auto values = corners(box);
    const SampleRange samples = values ? values->range() : pyramid_.range(box.cells);
    if (!samples.any()) return bends;
    const double error =
        mixing_roundings * unit_of<double> * std::max(std::abs(samples.lo), std::abs(samples.hi));
    const double apart = 2 * (samples.hi - samples.lo) + error;
    bends.mixed.fill({.lo = -apart, .hi = apart});
    if (!values || samples.holes) return bends;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        CornerValues bend = *values;
        narrow(bend, box, axis);
        bend.differentiate((axis + 1) % 3);
        bend.differentiate((axis + 2) % 3);
        bends.mixed[axis] = bounds(bend, error);
    }
    return bends;
}

template <class Sample>
template <class Wide>
auto Trilinear<Sample>::at(const std::array<Wide, 3>& index, bool /*with_bends*/) const
    -> Point<Wide> {
    std::array<std::int64_t, 3> cell{};
    std::array<Wide, 3> t{};
    for (std::size_t i = 0; i < 3; ++i) {
        cell[i] =
            std::min(static_cast<std::int64_t>(index[i]), static_cast<std::int64_t>(size_[i]) - 2);
        t[i] = index[i] - static_cast<Wide>(cell[i]);
    }
    const auto width = static_cast<std::int64_t>(size_[0]);
    const std::int64_t slice = width * static_cast<std::int64_t>(size_[1]);
    const Sample* const base = sample(cell[0], cell[1], cell[2]);
    // On the four edges along i: the value at t and the difference.
    std::array<Wide, 4> on{};
    std::array<Wide, 4> by{};
    for (std::size_t edge = 0; edge < 4; ++edge) {
        const Sample* const row = base + (edge % 2 == 1 ? width : 0) + (edge >= 2 ? slice : 0);
        const auto a = static_cast<Wide>(row[0]);
        const auto b = static_cast<Wide>(row[1]);
        on[edge] = a * (1 - t[0]) + b * t[0];
        by[edge] = b - a;
    }
    const auto mix = [](Wide a, Wide b, Wide s) { return a * (1 - s) + b * s; };
    const Wide below = mix(on[0], on[1], t[1]);
    const Wide above = mix(on[2], on[3], t[1]);
    Point<Wide> point;
    point.value = mix(below, above, t[2]);
    if (!std::isfinite(point.value)) {
        point.value = std::numeric_limits<Wide>::quiet_NaN();
        return point;
    }
    point.slope = {mix(mix(by[0], by[1], t[1]), mix(by[2], by[3], t[1]), t[2]),
                   mix(on[1] - on[0], on[3] - on[2], t[2]), above - below};
    point.bend.mixed = {(on[3] - on[2]) - (on[1] - on[0]),
                        mix(by[2], by[3], t[1]) - mix(by[0], by[1], t[1]),
                        mix(by[1], by[3], t[2]) - mix(by[0], by[2], t[2])};
    return point;
}

}  // namespace zeroset
