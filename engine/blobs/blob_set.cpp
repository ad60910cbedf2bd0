#include "engine/blobs/blob_set.hpp"

#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

constexpr std::size_t most_in_leaf = 6;
/// How many nodes are looked at for a large box.
constexpr int most_visits = 200;
/// Makes supports larger by far more than they are rounded.
constexpr double slack = 1 + 0x1p-40;

}  // namespace

void BlobSet::Sums::add(const Sums& other) {
    above += other.above;
    below += other.below;
    per_radius += other.per_radius;
    per_square += other.per_square;
}

BlobSet::BlobSet(std::span<const Blob> blobs, double reach) {
    std::vector<Blob> sorted(blobs.begin(), blobs.end());
    nodes_.reserve(2 * sorted.size() / most_in_leaf + 2);
    build(sorted, 0, reach);
    for (const Blob& blob : sorted) {
        for (std::size_t i = 0; i < 3; ++i)
            center_[i].push_back(blob.center[i]);
        radius_.push_back(blob.radius);
        per_square_.push_back(1 / (blob.radius * blob.radius));
        strength_.push_back(blob.strength);
        size_per_radius_.push_back(std::abs(blob.strength) / blob.radius);
    }
    std::vector<double> radii = radius_;
    if (radii.empty()) return;
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::ranges::nth_element(radii, middle);
    usual_support_ = 2 * std::sqrt(reach) * *middle;
    least_radius_ = *std::ranges::min_element(radii);
}

/// Adds the node of some blobs, of which `first` are before, and sorts them.
void BlobSet::build(std::span<Blob> blobs, std::uint32_t first, double reach) {
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    Node node{.first = first, .last = first + static_cast<std::uint32_t>(blobs.size())};
    node.lo.fill(unbounded);
    node.hi.fill(-unbounded);
    std::array<double, 3> least = node.lo;
    std::array<double, 3> greatest = node.hi;
    for (const Blob& blob : blobs) {
        const double support = std::sqrt(reach) * blob.radius;
        for (std::size_t i = 0; i < 3; ++i) {
            const double margin = support * slack + std::abs(blob.center[i]) * (slack - 1);
            node.lo[i] = std::min(node.lo[i], blob.center[i] - margin);
            node.hi[i] = std::max(node.hi[i], blob.center[i] + margin);
            least[i] = std::min(least[i], blob.center[i]);
            greatest[i] = std::max(greatest[i], blob.center[i]);
        }
        const double size = std::abs(blob.strength);
        (blob.strength > 0 ? node.sums.above : node.sums.below) += blob.strength;
        node.sums.per_radius += size / blob.radius;
        node.sums.per_square += size / (blob.radius * blob.radius);
    }
    if (blobs.size() > most_in_leaf) {
        std::size_t axis = 0;
        for (std::size_t i = 1; i < 3; ++i) {
            if (greatest[i] - least[i] > greatest[axis] - least[axis]) axis = i;
        }
        const std::size_t half = blobs.size() / 2;
        std::ranges::nth_element(blobs, blobs.begin() + static_cast<std::ptrdiff_t>(half), {},
                                 [&](const Blob& blob) { return blob.center[axis]; });
        build(blobs.first(half), first, reach);
        node.right = static_cast<std::uint32_t>(nodes_.size());
        build(blobs.subspan(half), first + static_cast<std::uint32_t>(half), reach);
    }
    nodes_[at] = node;
}

BlobSet::Sums BlobSet::near_sums(const std::array<double, 3>& lo,
                                 const std::array<double, 3>& hi) const {
    Sums sums;
    std::array<std::uint32_t, most_depth> open{};
    std::size_t count = 1;
    for (int visits = 0; count > 0; ++visits) {
        const std::uint32_t at = open[--count];
        const Node& node = nodes_[at];
        if (!node.meets(lo, hi)) continue;
        if (node.right == 0 || visits >= most_visits) {
            sums.add(node.sums);
            continue;
        }
        open[count++] = node.right;
        open[count++] = at + 1;
    }
    return sums;
}

}  // namespace zeroset
