// Whether f may be 0 on stretches of rays in cells, a ray a lane: by its Bernstein coefficients, in
// floats. What floats make of them is not told here (block_lanes.cpp).

#if defined(ZEROSET_CELL_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ZEROSET_CELL_LANES_INL
#undef ZEROSET_CELL_LANES_INL
#else
#define ZEROSET_CELL_LANES_INL
#endif

#include "engine/real/lanes-inl.hpp"
#include "engine/trace/voxels/slab_lanes.hpp"

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Two places of rays in their cells along an axis, as parts of its edge.
struct Stretch {
    V<float> from, to;
};

HWY_INLINE Stretch mixed(V<float> low, V<float> high, const Stretch& share) {
    const V<float> step = hn::Sub(high, low);
    return {.from = hn::MulAdd(share.from, step, low), .to = hn::MulAdd(share.to, step, low)};
}

using Indices = hn::Vec<hn::RebindToSigned<Tag<float>>>;

/// Numbers and their right neighbours, from anywhere.
class Neighbours {
public:
    using Four = std::array<V<float>, 4>;
#if HWY_TARGET <= HWY_AVX2
    /// Loaded four side by side, a ray at a time, and turned: gathering them takes long.
    explicit HWY_INLINE Neighbours(Indices index) {
        hn::StoreU(index, hn::RebindToSigned<Tag<float>>(), index_.data());
    }
    [[nodiscard]] HWY_INLINE Four load(const float* from) const {
        const Tag<float> tag;
        const hn::RepartitionToWide<Tag<float>> pairs;
        const V<float> r0 = every_fourth(from, 0);
        const V<float> r1 = every_fourth(from, 1);
        const V<float> r2 = every_fourth(from, 2);
        const V<float> r3 = every_fourth(from, 3);
        const auto low01 = hn::BitCast(pairs, hn::InterleaveLower(tag, r0, r1));
        const auto low23 = hn::BitCast(pairs, hn::InterleaveLower(tag, r2, r3));
        const auto high01 = hn::BitCast(pairs, hn::InterleaveUpper(tag, r0, r1));
        const auto high23 = hn::BitCast(pairs, hn::InterleaveUpper(tag, r2, r3));
        return {hn::BitCast(tag, hn::InterleaveLower(pairs, low01, low23)),
                hn::BitCast(tag, hn::InterleaveUpper(pairs, low01, low23)),
                hn::BitCast(tag, hn::InterleaveLower(pairs, high01, high23)),
                hn::BitCast(tag, hn::InterleaveUpper(pairs, high01, high23))};
    }

private:
    [[nodiscard]] HWY_INLINE hn::Vec<hn::Full128<float>> four(const float* from,
                                                              std::size_t ray) const {
        return hn::LoadU(hn::Full128<float>(), from + index_[ray]);
    }
    /// The four numbers of the ray `first`, of the fourth after it, and so on.
    [[nodiscard]] HWY_INLINE V<float> every_fourth(const float* from, std::size_t first) const {
        const Tag<float> tag;
#if HWY_TARGET == HWY_AVX2
        return hn::Combine(tag, four(from, first + 4), four(from, first));
#else
        const hn::Half<Tag<float>> half;
        return hn::Combine(tag, hn::Combine(half, four(from, first + 12), four(from, first + 8)),
                           hn::Combine(half, four(from, first + 4), four(from, first)));
#endif
    }

    alignas(64) std::array<std::int32_t, lanes<float>> index_;
#else
    explicit HWY_INLINE Neighbours(Indices index) : index_(index) {}
    [[nodiscard]] HWY_INLINE Four load(const float* from) const {
        const Tag<float> tag;
        return {hn::GatherIndex(tag, from, index_), hn::GatherIndex(tag, from + 1, index_),
                hn::GatherIndex(tag, from + 2, index_), hn::GatherIndex(tag, from + 3, index_)};
    }

private:
    Indices index_;
#endif
};

/// Whether some number may lie within +-error of 0, or between two numbers on both sides.
template <std::size_t count>
HWY_INLINE M<float> may_be_within(const std::array<V<float>, count>& numbers, float error) {
    const Tag<float> tag;
    V<float> least = numbers[0];
    V<float> most = numbers[0];
    for (std::size_t i = 1; i < count; ++i) {
        least = hn::Min(least, numbers[i]);
        most = hn::Max(most, numbers[i]);
    }
    // Not "outside", so that a NaN is no proof
    return hn::Not(hn::Or(hn::Gt(least, hn::Set(tag, error)), hn::Lt(most, hn::Set(tag, -error))));
}

/// Cells between eight samples. The coefficients are means of f with the three places at either end
/// (ray_cubic.cpp).
struct TrilinearCells {
    static constexpr std::size_t support = 2;

    /// Whether f may come to within `error` of 0 on a stretch in a cell: by its Bernstein
    /// coefficients, the means of f with the three places at either end (ray_cubic.cpp).
    static HWY_INLINE M<float> may_be_zero(const float* corners, const SlabSamples& samples,
                                           Indices index, const Stretch& x, const Stretch& y,
                                           const Stretch& z, float error) {
        const Tag<float> tag;
        const std::size_t slice = samples.row * samples.rows;
        const Neighbours at(index);
        const auto edge = [&](std::size_t offset) {
            const auto row = at.load(corners + offset);
            return mixed(row[0], row[1], x);
        };
        // Interpolate along x, then y, then z, at both ends of the stretch.
        const Stretch e0 = edge(0);
        const Stretch e1 = edge(samples.row);
        const Stretch e2 = edge(slice);
        const Stretch e3 = edge(slice + samples.row);
        const Stretch below_from = mixed(e0.from, e1.from, y);  // x at its start, y at both ends
        const Stretch above_from = mixed(e2.from, e3.from, y);
        const Stretch below_to = mixed(e0.to, e1.to, y);
        const Stretch above_to = mixed(e2.to, e3.to, y);
        const Stretch f00 = mixed(below_from.from, above_from.from, z);  // x, y at their starts
        const Stretch f01 = mixed(below_from.to, above_from.to, z);
        const Stretch f10 = mixed(below_to.from, above_to.from, z);
        const Stretch f11 = mixed(below_to.to, above_to.to, z);
        const V<float> third = hn::Set(tag, 1.0F / 3.0F);
        const V<float> b1 = hn::Mul(third, hn::Add(f00.to, hn::Add(f01.from, f10.from)));
        const V<float> b2 = hn::Mul(third, hn::Add(f11.from, hn::Add(f01.to, f10.to)));
        return may_be_within(std::array{f00.from, b1, b2, f11.to}, error);
    }
};

/// Cells of a cubic spline, as spline_ray.cpp has them.
struct SplineCells {
    static constexpr std::size_t support = 4;
    using Cubic = std::array<V<float>, 4>;  ///< scaled coefficients

    /// The weights of the four coefficients along an axis.
    static HWY_INLINE std::array<Cubic, 4> weights(const Stretch& at) {
        const Tag<float> tag;
        const auto number = [&](float x) { return hn::Set(tag, x); };
        const V<float> one = number(1.0F);
        const auto product = [](V<float> x, V<float> y, V<float> z) {
            return hn::Mul(hn::Mul(x, y), z);
        };
        const std::array<std::array<V<float>, 3>, 4> places{{{at.from, at.from, at.from},
                                                             {at.from, at.from, at.to},
                                                             {at.from, at.to, at.to},
                                                             {at.to, at.to, at.to}}};
        std::array<Cubic, 4> result;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [x, y, z] = places[k];
            const V<float> scale = number(k == 0 || k == 3 ? 1.0F / 6 : 3.0F / 6);
            const V<float> cube = product(x, y, z);
            const V<float> square = hn::MulAdd(x, y, hn::Mul(z, hn::Add(x, y)));
            const V<float> line = hn::Add(hn::Add(x, y), z);
            const V<float> thrice = hn::Mul(number(3.0F), cube);
            const V<float> second = hn::NegMulAdd(number(2.0F), square, number(4.0F));
            result[0][k] =
                hn::Mul(scale, product(hn::Sub(one, x), hn::Sub(one, y), hn::Sub(one, z)));
            result[1][k] = hn::Mul(scale, hn::Add(thrice, second));
            result[2][k] = hn::Mul(scale, hn::Sub(hn::Add(hn::Add(one, line), square), thrice));
            result[3][k] = hn::Mul(scale, cube);
        }
        return result;
    }

    template <std::size_t count>
    static HWY_INLINE void add_product(const std::array<V<float>, count>& a, const Cubic& b,
                                       std::array<V<float>, count + 3>& sum) {
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < 4; ++k)
                sum[i + k] = hn::MulAdd(a[i], b[k], sum[i + k]);
        }
    }
    template <std::size_t count>
    static HWY_INLINE std::array<V<float>, count> zeros() {
        std::array<V<float>, count> result;
        result.fill(hn::Zero(Tag<float>()));
        return result;
    }

    static HWY_INLINE M<float> may_be_zero(const float* corners, const SlabSamples& samples,
                                           Indices index, const Stretch& x, const Stretch& y,
                                           const Stretch& z, float error) {
        const Tag<float> tag;
        const auto x_weights = weights(x);
        const auto y_weights = weights(y);
        const auto z_weights = weights(z);
        const Neighbours at(index);
        std::array<V<float>, 10> f = zeros<10>();
        for (std::size_t k = 0; k < 4; ++k) {
            std::array<V<float>, 7> in_slice = zeros<7>();
            for (std::size_t j = 0; j < 4; ++j) {
                const float* const row = corners + (k * samples.rows + j) * samples.row;
                const auto numbers = at.load(row);
                Cubic in_row;
                for (std::size_t n = 0; n < 4; ++n) {
                    const V<float> low = hn::MulAdd(numbers[1], x_weights[1][n],
                                                    hn::Mul(numbers[0], x_weights[0][n]));
                    in_row[n] = hn::MulAdd(numbers[3], x_weights[3][n],
                                           hn::MulAdd(numbers[2], x_weights[2][n], low));
                }
                add_product(in_row, y_weights[j], in_slice);
            }
            add_product(in_slice, z_weights[k], f);
        }
        // Turn scaled coefficients into Bernstein coefficients.
        constexpr std::array<float, 10> per_scale{1,          1.0F / 9,   1.0F / 36, 1.0F / 84,
                                                  1.0F / 126, 1.0F / 126, 1.0F / 84, 1.0F / 36,
                                                  1.0F / 9,   1};
        for (std::size_t k = 0; k < 10; ++k)
            f[k] = hn::Mul(f[k], hn::Set(tag, per_scale[k]));
        return may_be_within(f, error);
    }
};

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
