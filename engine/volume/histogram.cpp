#include "engine/volume/histogram.hpp"

#include "engine/base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <type_traits>

namespace zeroset {
namespace {

/// The empty parts of a range.
template <class Sample>
Histogram parts_of(const SampleRange& range, std::size_t most) {
    Histogram parts;
    std::size_t count = 1;
    if constexpr (std::is_integral_v<Sample>) {
        const double values = range.hi - range.lo + 1.0;
        parts.width = std::ceil(values / static_cast<double>(most));
        parts.first = range.lo - 0.5;
        count = static_cast<std::size_t>(std::ceil(values / parts.width));
    } else {
        parts.first = range.lo;
        // The difference of two finite numbers may not be one.
        const double width =
            range.hi / static_cast<double>(most) - range.lo / static_cast<double>(most);
        if (width > 0.0) {
            parts.width = width;
            count = most;
        }
    }
    parts.counts.resize(std::max<std::size_t>(count, 1));
    return parts;
}

template <class Sample>
void count_slice(const Sample* samples, std::size_t count, Histogram& parts, std::size_t step = 1) {
    const double last = static_cast<double>(parts.counts.size() - 1);
    for (std::size_t i = 0; i < count; i += step) {
        const auto value = static_cast<double>(samples[i]);
        if (!std::isfinite(value)) continue;
        const double part = std::clamp((value - parts.first) / parts.width, 0.0, last);
        ++parts.counts[static_cast<std::size_t>(part)];
    }
}

}  // namespace

std::optional<Histogram> histogram_of(const Samples& samples, const SampleRange& range,
                                      std::size_t most, const std::atomic<bool>& stop) {
    if (!range.any()) return std::nullopt;
    return visit_samples(
        samples, [&]<class Sample>(const Sample* data) -> std::optional<Histogram> {
            const Histogram empty = parts_of<Sample>(range, most);
            Histogram all = empty;
            std::mutex mutex;
            const auto slice = static_cast<std::size_t>(samples.size[0] * samples.size[1]);
            parallel_for(static_cast<std::size_t>(samples.size[2]), 0, [&](std::size_t k) {
                if (stop) return;
                Histogram own = empty;
                count_slice(data + k * slice, slice, own);
                const std::scoped_lock lock(mutex);
                for (std::size_t i = 0; i < own.counts.size(); ++i)
                    all.counts[i] += own.counts[i];
            });
            if (stop) return std::nullopt;
            return all;
        });
}

std::optional<Histogram> quick_histogram(const Samples& samples, const SampleRange& range,
                                         std::size_t most) {
    if (!range.any()) return std::nullopt;
    return visit_samples(samples, [&]<class Sample>(const Sample* data) {
        constexpr std::size_t most_slices = 32;
        constexpr std::size_t most_in_slice = std::size_t{1} << 14U;
        const auto slice = static_cast<std::size_t>(samples.size[0] * samples.size[1]);
        const auto slices = static_cast<std::size_t>(samples.size[2]);
        const std::size_t taken = std::min(slices, most_slices);
        const std::size_t step = slice / most_in_slice + 1;
        Histogram all = parts_of<Sample>(range, most);
        for (std::size_t n = 0; n < taken; ++n) {
            const std::size_t k = (2 * n + 1) * slices / (2 * taken);
            count_slice(data + k * slice, slice, all, step);
        }
        return std::optional(all);
    });
}

double dividing_value(const Histogram& histogram) {
    double count = 0;
    double sum = 0;  // of the numbers of their parts
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        count += static_cast<double>(histogram.counts[i]);
        sum += static_cast<double>(i) * static_cast<double>(histogram.counts[i]);
    }
    double count_below = 0;
    double sum_below = 0;
    double best = 0;
    double first = 0;  // of the places that are best, which may be many where parts are empty
    double last = 0;
    for (std::size_t i = 0; i + 1 < histogram.counts.size(); ++i) {
        count_below += static_cast<double>(histogram.counts[i]);
        sum_below += static_cast<double>(i) * static_cast<double>(histogram.counts[i]);
        const double count_above = count - count_below;
        if (count_below == 0 || count_above == 0) continue;
        const double apart = (sum - sum_below) / count_above - sum_below / count_below;
        const double between = count_below * count_above * apart * apart;
        if (between > best * (1 + 1e-12)) {
            best = between;
            first = static_cast<double>(i + 1);
        }
        if (between >= best * (1 - 1e-12)) last = static_cast<double>(i + 1);
    }
    if (best == 0)
        return histogram.first +
               0.5 * histogram.width * static_cast<double>(histogram.counts.size());
    return histogram.first + histogram.width * 0.5 * (first + last);
}

}  // namespace zeroset
