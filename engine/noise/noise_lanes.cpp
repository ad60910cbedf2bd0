// Means of linear functions in vectors of doubles; each function goes through the lanes of its
// arrays, a vector at a time.

#include "engine/noise/noise_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/noise/noise_lanes.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/real/lane_carrier-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// s and s' at t.
struct Fade {
    V<double> value, slope;
};
HWY_INLINE Fade fade_at(V<double> t) {
    const V<double> square = hn::Mul(t, t);
    const V<double> rest = hn::Sub(number(1), t);
    const V<double> inner =
        hn::Add(hn::Mul(t, hn::Sub(hn::Mul(number(6), t), number(15))), number(10));
    return {.value = hn::Mul(hn::Mul(square, t), inner),
            .slope = hn::Mul(number(30), hn::Mul(square, hn::Mul(rest, rest)))};
}

HWY_INLINE V<double> mixed(V<double> a, V<double> b, V<double> s) {
    return hn::Add(a, hn::Mul(s, hn::Sub(b, a)));
}

/// The mean of numbers at the corners of a cell.
HWY_INLINE V<double> mean_of(const V<double> (&at)[8], const Fade (&fades)[3]) {
    V<double> in_z[4];
    for (std::size_t c = 0; c < 4; ++c)
        in_z[c] = mixed(at[c], at[c + 4], fades[2].value);
    const V<double> near = mixed(in_z[0], in_z[2], fades[1].value);
    const V<double> far = mixed(in_z[1], in_z[3], fades[1].value);
    return mixed(near, far, fades[0].value);
}

/// The corners that are not beyond an axis, of which `step` is the difference to those that are.
template <std::size_t axis>
constexpr std::size_t near_corner(std::size_t n) {
    constexpr std::size_t step = std::size_t{1} << axis;
    return (n / step) * 2 * step + n % step;
}

/// The mean of the differences of numbers along an axis.
template <std::size_t axis>
HWY_INLINE V<double> mean_difference(const V<double> (&at)[8], const Fade (&fades)[3]) {
    constexpr std::size_t step = std::size_t{1} << axis;
    V<double> apart[4];
    for (std::size_t n = 0; n < 4; ++n) {
        const std::size_t c = near_corner<axis>(n);
        apart[n] = hn::Sub(at[c + step], at[c]);
    }
    const V<double> upper = fades[axis == 2 ? 1 : 2].value;
    const V<double> lower = fades[axis == 0 ? 1 : 0].value;
    return mixed(mixed(apart[0], apart[2], upper), mixed(apart[1], apart[3], upper), lower);
}

template <std::size_t axis, class Lanes>
HWY_INLINE void store_slope(NoisePoints& points, const Lanes& corners,
                            const V<double> (&functions)[8], const Fade (&fades)[3],
                            bool has_gradients, std::size_t at) {
    V<double> slope = hn::Mul(fades[axis].slope, mean_difference<axis>(functions, fades));
    if (has_gradients) {
        V<double> gradient[8];
        for (std::size_t c = 0; c < 8; ++c)
            gradient[c] = hn::Load(d<double>, corners.gradient[axis][c] + at);
        slope = hn::Add(slope, mean_of(gradient, fades));
    }
    hn::Store(slope, d<double>, points.slope[axis] + at);
}

void mix_noise(NoisePoints& points, bool has_gradients) {
    const auto& corners = points.corners;
    for (std::size_t at = 0; at < points.count; at += lanes<double>) {
        V<double> share[3];
        Fade fades[3];
        for (std::size_t i = 0; i < 3; ++i) {
            share[i] = hn::Load(d<double>, points.share[i] + at);
            fades[i] = fade_at(share[i]);
        }
        V<double> functions[8];
        for (std::size_t c = 0; c < 8; ++c) {
            functions[c] = hn::Load(d<double>, corners.number[c] + at);
            for (std::size_t i = 0; has_gradients && i < 3; ++i) {
                const V<double> slope = hn::Load(d<double>, corners.gradient[i][c] + at);
                functions[c] = hn::Add(functions[c], hn::Mul(slope, share[i]));
            }
        }
        hn::Store(mean_of(functions, fades), d<double>, points.value + at);
        store_slope<0>(points, corners, functions, fades, has_gradients, at);
        store_slope<1>(points, corners, functions, fades, has_gradients, at);
        store_slope<2>(points, corners, functions, fades, has_gradients, at);
    }
}

struct Ends {
    V<double> lo, hi;
};
HWY_INLINE Ends hull_of(V<double> a, V<double> b) {
    return {.lo = minimum(a, b), .hi = maximum(a, b)};
}

/// s and s' from one end of a part to the other.
struct FadeEnds {
    Ends value, slope;
};
HWY_INLINE FadeEnds fade_over(V<double> from, V<double> to) {
    const Fade first = fade_at(from);
    const Fade last = fade_at(to);
    FadeEnds ends{.value = {.lo = first.value, .hi = last.value},
                  .slope = hull_of(first.slope, last.slope)};
    const auto has_top = hn::And(hn::Le(from, number(0.5)), hn::Ge(to, number(0.5)));
    ends.slope.hi = hn::IfThenElse(has_top, number(1.875), ends.slope.hi);
    return ends;
}

/// The ends of the mean of `count` numbers along an axis: at the part's two ends of s.
template <std::size_t count, std::size_t step>
HWY_INLINE void narrow(V<double> (&values)[count], const Ends& s) {
    for (std::size_t c = 0; c < count; ++c) {
        if ((c & step) != 0) continue;
        const V<double> a = values[c];
        const V<double> b = values[c | step];
        values[c] = mixed(a, b, s.lo);
        values[c | step] = mixed(a, b, s.hi);
    }
}
template <std::size_t count>
HWY_INLINE V<double> least_of(const V<double> (&values)[count]) {
    V<double> least = values[0];
    for (std::size_t c = 1; c < count; ++c)
        least = minimum(values[c], least);
    return least;
}
template <std::size_t count>
HWY_INLINE V<double> greatest_of(const V<double> (&values)[count]) {
    V<double> greatest = values[0];
    for (std::size_t c = 1; c < count; ++c)
        greatest = maximum(values[c], greatest);
    return greatest;
}

/// One vector of parts.
class PartVector {
public:
    HWY_INLINE PartVector(NoiseParts& parts, bool has_gradients, std::size_t at)
        : parts_(parts), has_gradients_(has_gradients), at_(at) {
        for (std::size_t i = 0; i < 3; ++i) {
            share_[i] = {.lo = hn::Load(d<double>, parts.from[i] + at),
                         .hi = hn::Load(d<double>, parts.to[i] + at)};
            fade_[i] = fade_over(share_[i].lo, share_[i].hi);
        }
        for (std::size_t c = 0; c < 8; ++c) {
            number_[c] = hn::Load(d<double>, parts.corners.number[c] + at);
            for (std::size_t i = 0; has_gradients && i < 3; ++i)
                gradient_[i][c] = hn::Load(d<double>, parts.corners.gradient[i][c] + at);
        }
    }

    HWY_INLINE void store_value() {
        V<double> lo[8];
        V<double> hi[8];
        for (std::size_t c = 0; c < 8; ++c) {
            lo[c] = hi[c] = number_[c];
            for (std::size_t i = 0; has_gradients_ && i < 3; ++i)
                add(gradient_[i][c], share_[i], lo[c], hi[c]);
        }
        for (auto* const values : {&lo, &hi}) {
            narrow<8, 1>(*values, fade_[0].value);
            narrow<8, 2>(*values, fade_[1].value);
            narrow<8, 4>(*values, fade_[2].value);
        }
        hn::Store(least_of(lo), d<double>, parts_.lo + at_);
        hn::Store(greatest_of(hi), d<double>, parts_.hi + at_);
    }

    template <std::size_t axis>
    HWY_INLINE void store_slope() {
        constexpr std::size_t step = std::size_t{1} << axis;
        V<double> lo[4];
        V<double> hi[4];
        for (std::size_t n = 0; n < 4; ++n) {
            const std::size_t c = near_corner<axis>(n);
            lo[n] = hi[n] = hn::Sub(number_[c + step], number_[c]);
            for (std::size_t i = 0; has_gradients_ && i < 3; ++i)
                add(hn::Sub(gradient_[i][c + step], gradient_[i][c]), share_[i], lo[n], hi[n]);
        }
        for (auto* const values : {&lo, &hi}) {
            narrow<4, 1>(*values, fade_[axis == 0 ? 1 : 0].value);
            narrow<4, 2>(*values, fade_[axis == 2 ? 1 : 2].value);
        }
        const V<double> least = least_of(lo);
        const V<double> greatest = greatest_of(hi);
        const Ends& s = fade_[axis].slope;
        Ends slope{.lo = minimum(hn::Mul(least, s.lo), hn::Mul(least, s.hi)),
                   .hi = maximum(hn::Mul(greatest, s.lo), hn::Mul(greatest, s.hi))};
        if (has_gradients_) {
            V<double> own[8];
            for (std::size_t c = 0; c < 8; ++c)
                own[c] = gradient_[axis][c];
            narrow<8, 1>(own, fade_[0].value);
            narrow<8, 2>(own, fade_[1].value);
            narrow<8, 4>(own, fade_[2].value);
            slope = {.lo = hn::Add(slope.lo, least_of(own)),
                     .hi = hn::Add(slope.hi, greatest_of(own))};
        }
        hn::Store(slope.lo, d<double>, parts_.slope_lo[axis] + at_);
        hn::Store(slope.hi, d<double>, parts_.slope_hi[axis] + at_);
    }

private:
    /// Adds the range of a multiple of a share.
    static HWY_INLINE void add(V<double> slope, const Ends& share, V<double>& lo, V<double>& hi) {
        const V<double> a = hn::Mul(slope, share.lo);
        const V<double> b = hn::Mul(slope, share.hi);
        lo = hn::Add(lo, minimum(a, b));
        hi = hn::Add(hi, maximum(a, b));
    }

    NoiseParts& parts_;
    bool has_gradients_;
    std::size_t at_;
    Ends share_[3];
    FadeEnds fade_[3];
    V<double> number_[8];
    V<double> gradient_[3][8];
};

void enclose_noise(NoiseParts& parts, bool has_gradients) {
    for (std::size_t at = 0; at < parts.count; at += lanes<double>) {
        PartVector part(parts, has_gradients, at);
        part.store_value();
        part.store_slope<0>();
        part.store_slope<1>();
        part.store_slope<2>();
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(mix_noise);
HWY_EXPORT(enclose_noise);

}  // namespace

void mix_noise(NoisePoints& points, bool has_gradients) {
    HWY_DYNAMIC_DISPATCH(mix_noise)(points, has_gradients);
}
void enclose_noise(NoiseParts& parts, bool has_gradients) {
    HWY_DYNAMIC_DISPATCH(enclose_noise)(parts, has_gradients);
}

}  // namespace zeroset

#endif
