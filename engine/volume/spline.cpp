#include "engine/volume/spline.hpp"

#include "engine/base/parallel.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

// The coefficients of the cubic B-spline through samples by two recursive filters along each axis
// [Unser93, part II], started exactly for samples that are mirrored at their ends.

namespace zeroset {
namespace {

constexpr double pole = std::numbers::sqrt3 - 2;
constexpr double gain = 6;

/// Rows of numbers that are filtered together: row i of `count` begins at i * width.
struct Rows {
    std::span<double> numbers;
    std::size_t count, width;

    [[nodiscard]] std::span<double> row(std::size_t i) const {
        return numbers.subspan(i * width, width);
    }
};

/// Adds `factor` times a row to another.
void add(std::span<double> to, double factor, std::span<const double> from) {
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] += factor * from[i];
}

/// Along each column of the rows, samples to coefficients.
void filter(const Rows& rows) {
    const std::size_t last = rows.count - 1;
    // The first one: all samples before it, whose period is 2 * last, in a geometric series.
    std::vector<double> first(rows.width);
    double power = 1;
    for (std::size_t i = 0; i < 2 * last && power != 0; ++i) {
        add(first, power, rows.row(i <= last ? i : 2 * last - i));
        power *= pole;
    }
    const double all = gain / (1 - std::pow(pole, 2.0 * static_cast<double>(last)));
    for (std::size_t i = 0; i < rows.width; ++i)
        rows.row(0)[i] = all * first[i];
    for (std::size_t n = 1; n <= last; ++n) {
        for (double& number : rows.row(n))
            number *= gain;
        add(rows.row(n), pole, rows.row(n - 1));
    }
    for (std::size_t i = 0; i < rows.width; ++i) {
        double& end = rows.row(last)[i];
        end = pole / (pole * pole - 1) * (end + pole * rows.row(last - 1)[i]);
    }
    for (std::size_t n = last; n-- > 0;) {
        for (std::size_t i = 0; i < rows.width; ++i)
            rows.row(n)[i] = pole * (rows.row(n + 1)[i] - rows.row(n)[i]);
    }
}

/// The coefficients of a grid in memory, padded by one on each side.
template <class Number>
class Grid {
public:
    Grid(const GridSize& samples, Number* numbers)
        : width_(samples[0] + 2),
          height_(samples[1] + 2),
          depth_(samples[2] + 2),
          numbers_(numbers) {}

    /// The coefficient of sample (i, j, k).
    [[nodiscard]] Number& at(std::uint64_t i, std::uint64_t j, std::uint64_t k) const {
        return numbers_[((k + 1) * height_ + j + 1) * width_ + i + 1];
    }

    /// Slice k from the samples, filtered within it if asked for.
    template <class Sample>
    void take_slice(const Sample* samples, std::uint64_t k, bool filters) const {
        const std::uint64_t columns = width_ - 2;
        const std::uint64_t lines = height_ - 2;
        const Sample* const slice = samples + k * columns * lines;
        std::vector<double> across(columns * lines);  // columns of the slice as rows
        for (std::uint64_t j = 0; j < lines; ++j) {
            for (std::uint64_t i = 0; i < columns; ++i)
                across[i * lines + j] = static_cast<double>(slice[j * columns + i]);
        }
        if (filters) filter({.numbers = across, .count = columns, .width = lines});
        std::vector<double> along(columns * lines);
        for (std::uint64_t j = 0; j < lines; ++j) {
            for (std::uint64_t i = 0; i < columns; ++i)
                along[j * columns + i] = across[i * lines + j];
        }
        if (filters) filter({.numbers = along, .count = lines, .width = columns});
        for (std::uint64_t j = 0; j < lines; ++j) {
            for (std::uint64_t i = 0; i < columns; ++i)
                at(i, j, k) = static_cast<Number>(along[j * columns + i]);
        }
    }
    /// Filters line j of all slices, from slice to slice.
    void filter_slices(std::uint64_t j) const {
        const std::uint64_t columns = width_ - 2;
        const std::uint64_t slices = depth_ - 2;
        std::vector<double> along(columns * slices);
        for (std::uint64_t k = 0; k < slices; ++k) {
            for (std::uint64_t i = 0; i < columns; ++i)
                along[k * columns + i] = static_cast<double>(at(i, j, k));
        }
        filter({.numbers = along, .count = slices, .width = columns});
        for (std::uint64_t k = 0; k < slices; ++k) {
            for (std::uint64_t i = 0; i < columns; ++i)
                at(i, j, k) = static_cast<Number>(along[k * columns + i]);
        }
    }
    /// Fills what lies beyond the grid by what lies as far within it.
    void mirror() const {
        parallel_for(depth_ - 2, 0, [&](std::size_t k) {
            Number* const slice = numbers_ + (k + 1) * height_ * width_;
            for (std::uint64_t j = 1; j + 1 < height_; ++j) {
                Number* const row = slice + j * width_;
                row[0] = row[2];
                row[width_ - 1] = row[width_ - 3];
            }
            std::copy_n(slice + 2 * width_, width_, slice);
            std::copy_n(slice + (height_ - 3) * width_, width_, slice + (height_ - 1) * width_);
        });
        const std::uint64_t slice = height_ * width_;
        std::copy_n(numbers_ + 2 * slice, slice, numbers_);
        std::copy_n(numbers_ + (depth_ - 3) * slice, slice, numbers_ + (depth_ - 1) * slice);
    }

private:
    std::uint64_t width_, height_, depth_;
    Number* numbers_;
};

bool is_exact_in_float(SampleType type) { return size_of(type) <= 2 || type == SampleType::Float; }

template <class Number>
std::shared_ptr<Number> room_for(std::uint64_t count) {
    return {new (std::nothrow) Number[count], [](const Number* room) { delete[] room; }};
}

/// The coefficients, or nothing where there is no memory for them.
template <class Number>
std::shared_ptr<Number> coefficients_of(const Samples& samples, const GridSize& padded,
                                        SplineKind kind) {
    auto room = room_for<Number>(padded[0] * padded[1] * padded[2]);
    if (!room) return room;
    const Grid<Number> grid(samples.size, room.get());
    const bool filters = kind == SplineKind::Interpolating;
    visit_samples(samples, [&](const auto* first) {
        parallel_for(samples.size[2], 0, [&](std::size_t k) {
            const NearestRounding nearest;
            grid.take_slice(first, k, filters);
        });
    });
    if (filters) {
        parallel_for(samples.size[1], 0, [&](std::size_t j) {
            const NearestRounding nearest;
            grid.filter_slices(j);
        });
    }
    grid.mirror();
    return room;
}

/// A spline as it was asked for, while it lives.
using Known = std::map<std::pair<const VolumeData*, SplineKind>, std::weak_ptr<const SplineData>>;

}  // namespace

std::expected<std::shared_ptr<const SplineData>, std::string> SplineData::make(
    const std::shared_ptr<const VolumeData>& volume, SplineKind kind) {
    const Samples& samples = volume->samples();
    if (kind == SplineKind::Interpolating && volume->range().holes) {
        return std::unexpected(
            "some of its samples are no finite numbers, through which no spline goes; type smooth "
            "for one beside the samples, or trilinear");
    }
    GridSize padded = samples.size;
    for (auto& count : padded)
        count += 2;
    std::shared_ptr<SplineData> spline(new SplineData);
    spline->volume_ = volume;
    const auto fill = [&](auto number, SampleType type) {
        using Number = decltype(number);
        const auto numbers = coefficients_of<Number>(samples, padded, kind);
        spline->coefficients_ = {.type = type, .size = padded, .data = numbers};
        if (!numbers) return SampleRange{};
        const auto pyramid = std::make_shared<const Pyramid<Number>>(spline->coefficients_);
        spline->pyramid_ = pyramid;
        return pyramid->range();
    };
    const NearestRounding nearest;
    const SampleRange range = is_exact_in_float(samples.type) ? fill(float{}, SampleType::Float)
                                                              : fill(double{}, SampleType::Double);
    if (!spline->coefficients_.data) {
        return std::unexpected("there is no memory for the " +
                               std::to_string(spline->coefficients_.count()) +
                               " coefficients of its spline");
    }
    if (kind == SplineKind::Interpolating && range.holes)
        return std::unexpected("its samples are too large for a spline through them");
    return spline;
}

std::expected<std::shared_ptr<const SplineData>, std::string> SplineData::of(
    const std::shared_ptr<const VolumeData>& volume, SplineKind kind) {
    static std::mutex mutex;
    static Known known;
    const std::pair key{volume.get(), kind};
    {
        const std::scoped_lock lock(mutex);
        std::erase_if(known, [](const auto& entry) { return entry.second.expired(); });
        const auto kept = known.find(key);
        if (kept != known.end()) {
            if (auto spline = kept->second.lock()) return spline;
        }
    }
    // Not under the lock: a thread that waits for its parts may be given other work that asks here.
    auto spline = make(volume, kind);
    const std::scoped_lock lock(mutex);
    if (spline) known[key] = *spline;
    return spline;
}

}  // namespace zeroset
