#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace zeroset {

/// A soft ball about a point.
struct Blob {
    std::array<double, 3> center{};
    double radius = 1;    ///< above 0
    double strength = 1;  ///< other than 0

    bool operator==(const Blob&) const = default;
};

/// Blobs in a tree of boxes that their supports are in. Immutable.
class BlobSet {
public:
    /// `reach`: the square of a support's radius, for radius 1.
    BlobSet(std::span<const Blob> blobs, double reach);

    [[nodiscard]] std::size_t size() const { return radius_.size(); }

    // Numbers of the blobs, in the tree's order.
    [[nodiscard]] const double* center(std::size_t axis) const { return center_[axis].data(); }
    [[nodiscard]] const double* radius() const { return radius_.data(); }
    [[nodiscard]] const double* per_square() const { return per_square_.data(); }  ///< 1/r^2
    [[nodiscard]] const double* strength() const { return strength_.data(); }
    [[nodiscard]] const double* size_per_radius() const {
        return size_per_radius_.data();
    }  ///< |s|/r

    /// Sums over blobs: of strengths above and below 0, and of |s|/r and |s|/r^2.
    struct Sums {
        double above = 0, below = 0, per_radius = 0, per_square = 0;

        void add(const Sums& other);
        [[nodiscard]] double size() const { return above - below; }
    };
    [[nodiscard]] const Sums& total() const { return nodes_.front().sums; }
    /// Twice the radius of a usual support: boxes that are larger meet many.
    [[nodiscard]] double usual_support() const { return usual_support_; }
    [[nodiscard]] double least_radius() const { return least_radius_; }

    struct Node {
        std::array<double, 3> lo{}, hi{};  ///< the box of all supports
        std::uint32_t first = 0, last = 0;
        std::uint32_t right = 0;  ///< the second child, where the first one follows; 0: a leaf
        Sums sums{};

        /// Whether it has a place in common with the box; false of NaN.
        [[nodiscard]] bool meets(const std::array<double, 3>& other_lo,
                                 const std::array<double, 3>& other_hi) const {
            return lo[0] <= other_hi[0] && other_lo[0] <= hi[0] && lo[1] <= other_hi[1] &&
                   other_lo[1] <= hi[1] && lo[2] <= other_hi[2] && other_lo[2] <= hi[2];
        }
    };
    /// The tree, its root first.
    [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }

    /// Calls visit(first, last) for ranges of blobs, in order, with all that reach into the box.
    void each_near(const std::array<double, 3>& lo, const std::array<double, 3>& hi,
                   auto visit) const {
        std::array<std::uint32_t, most_depth> open;
        std::size_t count = 0;
        open[count++] = 0;
        while (count > 0) {
            const std::uint32_t at = open[--count];
            const Node& node = nodes_[at];
            if (!node.meets(lo, hi)) continue;
            if (node.right == 0) {
                visit(node.first, node.last);
                continue;
            }
            open[count++] = node.right;
            open[count++] = at + 1;
        }
    }
    /// Sums that hold those of all blobs that reach into the box; of large boxes quickly.
    [[nodiscard]] Sums near_sums(const std::array<double, 3>& lo,
                                 const std::array<double, 3>& hi) const;

private:
    static constexpr std::size_t most_depth = 64;

    void build(std::span<Blob> blobs, std::uint32_t first, double reach);

    std::array<std::vector<double>, 3> center_;
    std::vector<double> radius_, per_square_, strength_, size_per_radius_;
    std::vector<Node> nodes_;
    double usual_support_ = 0, least_radius_ = 0;
};

}  // namespace zeroset
