#pragma once

#include "engine/kernel/kernel.hpp"
#include "pipeline/gallery.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace zeroset::test {

inline constexpr std::size_t items = 1024;  // fits the nearest cache with all arrays
inline constexpr double items_of_8 = items / 8.0;

/// Boxes of a 64th of the clip box, and points in them, spread over all of it.
template <class Real>
struct Samples {
    std::array<std::vector<Real>, 3> neg_lo;
    std::array<std::vector<Real>, 3> hi;
    std::array<std::vector<Real>, 3> x;
    Uniforms uniforms;

    explicit Samples(const GalleryItem& item) {
        uniforms.set(0, item.w);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<glm::length_t>(axis);
            const double size =
                static_cast<double>(item.clip.hi[k]) - static_cast<double>(item.clip.lo[k]);
            for (std::size_t i = 0; i < items; ++i) {
                // Low-discrepancy: multiples of three irrational numbers.
                constexpr std::array irrational{0.8191725134, 0.6710436067, 0.5497004779};
                double part = static_cast<double>(i) * irrational.at(axis);
                part -= static_cast<double>(static_cast<std::size_t>(part));
                const double lo = static_cast<double>(item.clip.lo[k]) + part * size;
                neg_lo.at(axis).push_back(static_cast<Real>(-lo));
                hi.at(axis).push_back(static_cast<Real>(lo + size / 64));
                x.at(axis).push_back(static_cast<Real>(lo));
            }
        }
    }

    /// The boxes, and room for as many answers.
    RangeBatchOf<Real> range_batch(std::vector<Real>& f_neg_lo, std::vector<Real>& f_hi,
                                   std::vector<ContinuityMask<Real>>& continuous) const {
        return {items,
                {neg_lo[0].data(), neg_lo[1].data(), neg_lo[2].data()},
                {hi[0].data(), hi[1].data(), hi[2].data()},
                uniforms.template boxes<Real>(),
                f_neg_lo.data(),
                f_hi.data(),
                continuous.data()};
    }
};

}  // namespace zeroset::test
