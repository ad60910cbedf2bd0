#include "engine/noise/cellular.hpp"

#include "engine/real/unbounded.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

/// Bounds the rounding errors of distances below 8, amply counted.
constexpr double distance_error = 0x1p-46;
/// How far off cells are looked at: those beyond are at least 2 away, and two points nearer.
constexpr int reach = 2;
constexpr int most_cells_in_line = 2;
/// Cells in the order in which they are looked at: the near ones first.
constexpr std::array<int, 2 * reach + 1> order{0, -1, 1, -2, 2};

double square(double x) { return x * x; }

/// Second derivatives of the distance: (1 - u u^T)/d for the unit vector u from the point.
double bend_of(double u, double v, bool same, double d) { return ((same ? 1 : 0) - u * v) / d; }

}  // namespace

namespace {

/// Where the point of the cell with this hash is in it.
std::array<double, 3> point_of(std::uint32_t hash) {
    std::array<double, 3> point{};
    for (std::uint32_t axis = 0; axis < 3; ++axis)
        point[axis] = share_of_bits(with_coordinate(hash, axis + 1));
    return point;
}

}  // namespace

std::array<double, 3> Cellular::point_in(const std::array<std::uint32_t, 3>& cell) const {
    std::uint32_t hash = start_;
    for (const std::uint32_t coordinate : cell)
        hash = with_coordinate(hash, coordinate);
    return point_of(hash);
}

namespace {

/// The points of cells nearest to a place.
class Nearest {
public:
    struct Found {
        double square = unbounded;
        std::array<double, 3> from{};  ///< from the cell's point to the place
    };

    Nearest(const LatticePlace& place, int rank, std::uint32_t start) : place_(place), rank_(rank) {
        for (const int i : order) {
            if (!is_beyond(gap(0, i))) look_in(hash_at(start, 0, i), i);
        }
    }

    /// The nearest point, or of rank 2 the second nearest.
    [[nodiscard]] const Found& found() const { return rank_ == 1 ? nearest_ : second_; }

private:
    /// Looks at the cells at a step along the first axis.
    void look_in(std::uint32_t hash, int i) {
        const double x = gap(0, i);
        for (const int j : order) {
            const double y = gap(1, j);
            if (is_beyond(x + y)) continue;
            const std::uint32_t in_y = hash_at(hash, 1, j);
            for (const int k : order) {
                if (!is_beyond(x + y + gap(2, k))) look_at(hash_at(in_y, 2, k), {i, j, k});
            }
        }
    }
    void look_at(std::uint32_t hash, const std::array<int, 3>& steps) {
        const auto inside = point_of(hash);
        Found found;
        for (std::size_t i = 0; i < 3; ++i)
            found.from[i] = place_.share[i] - (steps[i] + inside[i]);
        found.square = square(found.from[0]) + square(found.from[1]) + square(found.from[2]);
        if (found.square < nearest_.square) {
            second_ = nearest_;
            nearest_ = found;
        } else if (found.square < second_.square) {
            second_ = found;
        }
    }
    [[nodiscard]] std::uint32_t hash_at(std::uint32_t hash, std::size_t axis, int step) const {
        return with_coordinate(hash, place_.cell[axis] + static_cast<std::uint32_t>(step));
    }
    /// The square of the distance from the cells at a step along an axis.
    [[nodiscard]] double gap(std::size_t axis, int step) const {
        const double t = place_.share[axis];
        return step == 0 ? 0 : square(step > 0 ? step - t : t - (step + 1));
    }
    /// Whether cells are beyond the one of the rank; a little more is looked at.
    [[nodiscard]] bool is_beyond(double gap_square) const {
        return gap_square > found().square + distance_error;
    }

    const LatticePlace& place_;
    int rank_;
    Found nearest_{}, second_{};
};

}  // namespace

PointAnswer Cellular::at(const std::array<double, 3>& point, bool with_bends) const {
    const LatticePlace place = lattice_place(point);
    const Nearest nearest(place, rank_, start_);
    const Nearest::Found& found = nearest.found();
    PointAnswer answer{.value = std::sqrt(found.square)};
    if (answer.value == 0) return answer;  // on the point itself: no direction is away from it
    for (std::size_t i = 0; i < 3; ++i)
        answer.slope[i] = found.from[i] / answer.value;
    for (std::size_t a = 0; with_bends && a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b)
            answer.bend[a][b] = bend_of(answer.slope[a], answer.slope[b], a == b, answer.value);
    }
    return answer;
}

/// The cells' points about a box that may be the nearest or second nearest of a place in it.
class Cellular::Near {
public:
    struct Candidate {
        std::array<double, 3> from_lo, from_hi;  ///< from the cell's point to the box
        double least, greatest;                  ///< squares of distances

        [[nodiscard]] ValueBounds from(std::size_t axis) const {
            return {.lo = from_lo[axis], .hi = from_hi[axis]};
        }
    };

    Near(const Cellular& noise, const FieldBox& box);

    /// Whether the box is in few cells; else nothing is known.
    [[nodiscard]] bool is_small() const { return small_; }
    /// The range of the distance, without its rounding.
    [[nodiscard]] ValueBounds distance() const {
        return {.lo = std::sqrt(least_[rank_ - 1]), .hi = std::sqrt(greatest_[rank_ - 1])};
    }
    /// Calls visit(candidate) for each that may be the one of the noise's rank.
    void each(auto visit) const {
        const double end = greatest_[rank_ - 1] + distance_error;
        for (std::size_t n = 0; n < count_; ++n) {
            if (all_[n].least <= end && !is_surely_nearest(all_[n])) visit(all_[n]);
        }
    }

private:
    static constexpr std::size_t side = 2 * reach + most_cells_in_line;

    void add(std::uint32_t hash, const std::array<int, 3>& steps);
    [[nodiscard]] std::uint32_t hash_at(std::uint32_t hash, std::size_t axis, int step) const {
        return with_coordinate(hash, cell_[axis] + static_cast<std::uint32_t>(step));
    }
    [[nodiscard]] double gap(std::size_t axis, int step) const;
    /// Whether, for F2, the candidate is nearer than all others everywhere in the box.
    [[nodiscard]] bool is_surely_nearest(const Candidate& candidate) const {
        return rank_ == 2 && candidate.greatest + distance_error < least_[1];
    }

    std::array<std::uint32_t, 3> cell_{};
    std::array<ValueBounds, 3> box_;  ///< from the first cell's corner
    std::size_t rank_;
    bool small_ = true;
    // The two smallest of all candidates.
    std::array<double, 2> least_{unbounded, unbounded}, greatest_{unbounded, unbounded};
    std::array<Candidate, side * side * side> all_;
    std::size_t count_ = 0;
};

namespace {

void take_in(std::array<double, 2>& smallest, double x) {
    if (x < smallest[0]) {
        smallest = {x, smallest[0]};
    } else if (x < smallest[1]) {
        smallest[1] = x;
    }
}

}  // namespace

Cellular::Near::Near(const Cellular& noise, const FieldBox& box)
    : rank_(static_cast<std::size_t>(noise.rank_)) {
    std::array<std::array<int, side>, 3> steps{};
    std::array<int, 3> counts{};
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticeSpan span = LatticeSpan::of(box.lo[i], box.hi[i], most_cells_in_line);
        small_ = small_ && span.cells > 0;
        if (!small_) return;
        cell_[i] = lattice_coordinate(span.first);
        box_[i] = {.lo = box.lo[i] - span.first, .hi = box.hi[i] - span.first};
        // The box's own cells come first.
        const int last = span.cells - 1;
        for (int n = 0; n <= last; ++n)
            steps[i][static_cast<std::size_t>(counts[i]++)] = n;
        for (int far = 1; far <= reach; ++far) {
            steps[i][static_cast<std::size_t>(counts[i]++)] = -far;
            steps[i][static_cast<std::size_t>(counts[i]++)] = last + far;
        }
    }
    const auto is_beyond = [&](double gaps) {
        return gaps > greatest_[rank_ - 1] + distance_error;
    };
    const auto step_at = [&](std::size_t axis, int n) {
        return steps[axis][static_cast<std::size_t>(n)];
    };
    for (int i = 0; i < counts[0]; ++i) {
        const int in_x = step_at(0, i);
        const double x = gap(0, in_x);
        if (is_beyond(x)) continue;
        const std::uint32_t hash_in_x = hash_at(noise.start_, 0, in_x);
        for (int j = 0; j < counts[1]; ++j) {
            const int in_y = step_at(1, j);
            const double y = gap(1, in_y);
            if (is_beyond(x + y)) continue;
            const std::uint32_t hash_in_y = hash_at(hash_in_x, 1, in_y);
            for (int k = 0; k < counts[2]; ++k) {
                const int in_z = step_at(2, k);
                if (is_beyond(x + y + gap(2, in_z))) continue;
                add(hash_at(hash_in_y, 2, in_z), {in_x, in_y, in_z});
            }
        }
    }
}

/// The square of the distance of the box from the cells at a step along an axis.
double Cellular::Near::gap(std::size_t axis, int step) const {
    const double before = box_[axis].lo - (step + 1);
    const double behind = step - box_[axis].hi;
    return square(std::max({before, behind, 0.0}));
}

void Cellular::Near::add(std::uint32_t hash, const std::array<int, 3>& steps) {
    const auto inside = point_of(hash);
    Candidate& candidate = all_[count_++];
    candidate.least = candidate.greatest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double at = steps[i] + inside[i];
        const double lo = box_[i].lo - at;
        const double hi = box_[i].hi - at;
        candidate.from_lo[i] = lo;
        candidate.from_hi[i] = hi;
        candidate.least += square(std::max({lo, -hi, 0.0}));
        candidate.greatest += square(std::max(-lo, hi));
    }
    take_in(least_, candidate.least);
    take_in(greatest_, candidate.greatest);
}

namespace {

/// The range of a quotient by a distance, which is in a unit vector.
ValueBounds direction_of(const ValueBounds& from, const ValueBounds& distance) {
    if (distance.lo <= 0) return {.lo = -1, .hi = 1};
    const auto [low, high] = from.widened(distance_error);
    const double lo = low / (low > 0 ? distance.hi : distance.lo);
    const double hi = high / (high > 0 ? distance.lo : distance.hi);
    return {.lo = std::max(lo - distance_error, -1.0), .hi = std::min(hi + distance_error, 1.0)};
}

ValueBounds distance_of(double least, double greatest) {
    return {.lo = std::max(std::sqrt(least) - distance_error, 0.0),
            .hi = std::sqrt(greatest) + distance_error};
}

}  // namespace

void Cellular::at(std::span<const std::array<double, 3>> points, PointAnswer* answers) const {
    for (const auto& point : points)
        *answers++ = at(point, false);
}

void Cellular::over(std::span<const FieldBox> boxes, BoxAnswer* answers) const {
    for (const FieldBox& box : boxes)
        *answers++ = over(box);
}

BoxAnswer Cellular::over(const FieldBox& box) const {
    BoxAnswer answer{.error = distance_error};
    answer.slopes.fill({.lo = -1, .hi = 1});
    answer.value = {.lo = 0, .hi = 1.7320508075688774};  // sqrt(3), above it
    answer.smooth = false;
    const Near near(*this, box);
    if (!near.is_small()) return answer;
    const ValueBounds found = near.distance();
    answer.value = {.lo = std::max(found.lo - distance_error, 0.0),
                    .hi = std::min(found.hi + distance_error, answer.value.hi)};
    std::size_t count = 0;
    bool touches = false;
    near.each([&](const Near::Candidate& candidate) {
        const ValueBounds distance = distance_of(candidate.least, candidate.greatest);
        touches = touches || distance.lo <= 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const ValueBounds slope = direction_of(candidate.from(i), distance);
            if (count == 0) answer.slopes[i] = slope;
            answer.slopes[i].add(slope);
        }
        ++count;
    });
    answer.smooth = count == 1 && !touches;
    return answer;
}

BendAnswer Cellular::bend(const FieldBox& box, const std::array<std::size_t, 2>& axes) const {
    BendAnswer answer{.value = {.lo = -unbounded, .hi = unbounded}, .smooth = false};
    const Near near(*this, box);
    if (!near.is_small()) return answer;
    std::size_t count = 0;
    near.each([&](const Near::Candidate& candidate) {
        const ValueBounds distance = distance_of(candidate.least, candidate.greatest);
        const ValueBounds u = direction_of(candidate.from(axes[0]), distance);
        const ValueBounds v = direction_of(candidate.from(axes[1]), distance);
        const double delta = axes[0] == axes[1] ? 1 : 0;
        ValueBounds products{.lo = u.lo * v.lo, .hi = u.lo * v.lo};
        for (const double product : {u.lo * v.hi, u.hi * v.lo, u.hi * v.hi})
            products.add({.lo = product, .hi = product});
        const ValueBounds above{.lo = delta - products.hi, .hi = delta - products.lo};
        ValueBounds bend{.lo = -unbounded, .hi = unbounded};
        if (distance.lo > 0) {
            bend = {.lo = above.lo / (above.lo > 0 ? distance.hi : distance.lo),
                    .hi = above.hi / (above.hi > 0 ? distance.lo : distance.hi)};
            bend = bend.widened(bend.size() * 0x1p-48);
        }
        if (count == 0) answer.value = bend;
        answer.value.add(bend);
        ++count;
    });
    answer.smooth = count == 1 && std::isfinite(answer.value.lo) && std::isfinite(answer.value.hi);
    return answer;
}

}  // namespace zeroset
