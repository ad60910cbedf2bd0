#pragma once

#include <cstdint>
#include <mutex>

namespace zeroset {

/// Boxes of an image, by what is proved of the beams through them [Florez08, sec. 5.4]. Times are
/// summed over threads.
struct ImageBoxCounters {
    struct Kind {
        std::uint64_t boxes = 0, pixels = 0;
        double ms = 0.0;  ///< of tracing its rays

        Kind& operator+=(const Kind& other) {
            boxes += other.boxes;
            pixels += other.pixels;
            ms += other.ms;
            return *this;
        }
    };
    Kind rejected;    ///< no ray has a root
    Kind included;    ///< all rays have one
    Kind undefined;   ///< neither is proved, and the box is as small as boxes get
    double ms = 0.0;  ///< of finding the boxes

    ImageBoxCounters& operator+=(const ImageBoxCounters& other) {
        rejected += other.rejected;
        included += other.included;
        undefined += other.undefined;
        ms += other.ms;
        return *this;
    }
};

/// The counts of the tracers with boxes on a surface (Kernel::memory). Any thread.
class BoxTally {
public:
    void add(const ImageBoxCounters& counters) {
        const std::scoped_lock lock(mutex_);
        sum_ += counters;
    }
    /// The sum since it was last taken.
    ImageBoxCounters take() {
        const std::scoped_lock lock(mutex_);
        const ImageBoxCounters sum = sum_;
        sum_ = {};
        return sum;
    }

private:
    std::mutex mutex_;
    ImageBoxCounters sum_;
};

}  // namespace zeroset
