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
void count_slice(const Sample* samples, std::size_t count, Histogram& parts) {
    const double last = static_cast<double>(parts.counts.size() - 1);
    for (std::size_t i = 0; i < count; ++i) {
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

}  // namespace zeroset
