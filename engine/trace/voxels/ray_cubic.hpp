#pragma once

#include <array>
#include <cstddef>

namespace zeroset {

/// f along a stretch of a ray, less its level, by its Bernstein coefficients: f lies between the
/// least and the largest of them, and is the first and the last at the ends.
template <std::size_t count>
struct RayPolynomial {
    std::array<double, count> b{};
    double from = 0, to = 0;  ///< depths
};
using RayCubic = RayPolynomial<4>;
using RayNonic = RayPolynomial<10>;  ///< of degree 9, as a tricubic spline's is

/// A trilinear cell's corners, less the level: bit 0 of a place says whether it is at the far end
/// along the first axis, bit 1 along the second, bit 2 along the third.
using CellCorners = std::array<double, 8>;

/// The cubic on a stretch whose ends lie at the places `at_from` and `at_to` in the cell, as parts
/// of its edges.
RayCubic ray_cubic(const CellCorners& corners, const std::array<double, 3>& at_from,
                   const std::array<double, 3>& at_to, double from, double to);

/// The slopes of f along the cell's axes at a place in it.
std::array<double, 3> cell_slopes(const CellCorners& corners, const std::array<double, 3>& at);

/// The first root along a ray, stretch by stretch, front to back, of numbers that are known to
/// +-`error`. Between two stretches that are given, f must be farther from 0 than that, if
/// anything is between them.
class FirstRoot {
public:
    FirstRoot() = default;
    /// `finest`: the widest bracket that certifies a root; stretches are divided to a fourth of it.
    FirstRoot(double error, double finest) : error_(error), finest_(finest) {}

    /// Takes in that f was above 0, or below, before the first stretch that is looked at.
    void begin_above() { side_ = Side::Above; }
    void begin_below() { side_ = Side::Below; }

    /// Looks at the next stretch; true: the search has ended in a root or a place that may be one.
    bool look(const RayCubic& f);
    bool look(const RayNonic& f);
    /// Looks at what is left open at the end of the last stretch; true as above.
    bool finish();

    /// Whether f may be 0 at the end of the last stretch.
    [[nodiscard]] bool is_open() const { return open_; }

    [[nodiscard]] double depth() const { return depth_; }
    /// Whether it is proved to be the first root: f has opposite signs at both ends of [from, to],
    /// no wider than `finest`, and none before.
    [[nodiscard]] bool is_proved() const { return proved_; }
    [[nodiscard]] double from() const { return from_; }
    [[nodiscard]] double to() const { return to_; }

private:
    enum class Side : signed char { Below = -1, Unknown = 0, Above = 1 };

    [[nodiscard]] Side side_of(double value) const;
    template <std::size_t count>
    bool look_on(const RayPolynomial<count>& f);
    template <std::size_t count>
    bool look_at(const RayPolynomial<count>& f, int halvings);
    /// Takes in that f has this sign on a stretch that begins there.
    bool meet(Side side, double from);
    /// Finds the root where f goes from one side to the other without turning.
    template <std::size_t count>
    bool find_monotone(const RayPolynomial<count>& f);
    bool end(double from, double to, bool proved);

    double error_ = 0, finest_ = 0;
    Side side_ = Side::Unknown;  ///< of f, where it was known last
    bool open_ = false;          ///< whether f may be 0 from open_from_ on
    double open_from_ = 0, open_to_ = 0;
    double depth_ = 0, from_ = 0, to_ = 0;
    bool proved_ = false;
};

}  // namespace zeroset
