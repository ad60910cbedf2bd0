#include "engine/antialias/ray_stretches.hpp"
#include "engine/kernel/batches.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

// Where f comes nearest to 0 on stretches of rays: many at once, one in each lane of a vector.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/antialias/find_least.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/simd/vectors-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Numbers about the stretches at work, in columns. A place is a depth, f there with the sign that
/// it has at the stretch's near end, and df/ds.
struct LeastColumns {
    std::vector<double> u, v;                     ///< of the rays
    std::vector<double> s;                        ///< where f is asked for
    std::vector<double> sign, size;               ///< of f at the ends: 1 or -1, and the larger
    std::vector<double> whether;                  ///< 1: RayStretch::only_whether
    std::vector<double> lo_s, lo_f, lo_slope;     ///< a place with df/ds below 0
    std::vector<double> hi_s, hi_f, hi_slope;     ///< and one with df/ds above
    std::vector<double> at, least;                ///< the least f so far
    std::vector<double> by_col, by_row;           ///< as in RayStretch
    std::vector<double> index;                    ///< of the stretch
    std::array<std::vector<double>, 3> x;         ///< points
    std::array<std::vector<double>, 3> gradient;  ///< and what is said of them
    std::vector<double> f;
    std::size_t count = 0;

    void for_each(const auto& visit) {
        for (std::vector<double>* const column :
             {&u, &v, &s, &sign, &size, &whether, &lo_s, &lo_f, &lo_slope, &hi_s, &hi_f, &hi_slope,
              &at, &least, &by_col, &by_row, &index})
            visit(*column);
    }
    void resize(std::size_t stretches) {
        count = stretches;
        const std::size_t room = padded(stretches) + lanes<double>;
        if (u.size() >= room) return;
        for_each([room](std::vector<double>& column) { column.resize(room); });
        for (std::size_t axis = 0; axis < 3; ++axis) {
            x[axis].resize(room);
            gradient[axis].resize(room);
        }
        f.resize(room);
    }
};

/// The search for the least f of some stretches.
class LeastSearch {
    using Vec = V<double>;
    using Mask = M<double>;

public:
    LeastSearch(const TraceFrame& frame, const TileRays& rays, std::span<RayStretch> stretches,
                Counters& counters)
        : frame_(frame), rays_(rays), stretches_(stretches), counters_(counters), at_(room()) {}

    void run();

private:
    /// What f does at a place of the rays of a vector.
    struct Place {
        Vec s, f, slope, by_col, by_row;
    };
    /// A thread's: one object at a time uses it.
    static LeastColumns& room() {
        thread_local LeastColumns kept;
        return kept;
    }
    static Vec load(const std::vector<double>& column, std::size_t i) {
        return hn::LoadU(d<double>, column.data() + i);
    }
    static void store(Vec x, std::vector<double>& column, std::size_t i) {
        hn::StoreU(x, d<double>, column.data() + i);
    }
    static Vec set(double x) { return hn::Set(d<double>, x); }

    /// Evaluates f at all places asked for.
    void evaluate();
    /// How the points of a vector of rays change with s, on an axis.
    [[nodiscard]] Vec direction(int axis, Vec u, Vec v) const {
        const ViewFrame& view = rays_.axes();
        return hn::MulAdd(u, set(view.right[axis]),
                          hn::MulAdd(v, set(view.up[axis]), set(view.forward[axis])));
    }
    /// What was evaluated, times a sign.
    [[nodiscard]] Place place(std::size_t i, Vec sign) const;
    void begin();
    /// Takes the places, and drops what is known well enough.
    void take();
    /// The places to ask for next.
    void choose(int step);
    /// Whether the least f is known to a millionth of f at the ends, or as well as 1e-4 pixels
    /// beside it.
    [[nodiscard]] Mask is_narrow(std::size_t i) const;
    void write(std::size_t i);

    const TraceFrame& frame_;
    const TileRays& rays_;
    std::span<RayStretch> stretches_;
    Counters& counters_;
    LeastColumns& at_;
};

void LeastSearch::evaluate() {
    constexpr std::size_t at_once = 256;
    counters_.value += at_.count;
    // Repeat the last place up to whole batches.
    const std::size_t size = padded(at_.count);
    for (std::vector<double>* const column : {&at_.u, &at_.v, &at_.s})
        std::fill(column->begin() + static_cast<std::ptrdiff_t>(at_.count),
                  column->begin() + static_cast<std::ptrdiff_t>(size), (*column)[at_.count - 1]);
    const ViewFrame& view = rays_.axes();
    for (std::size_t i = 0; i < size; i += lanes<double>) {
        const Vec u = load(at_.u, i);
        const Vec v = load(at_.v, i);
        for (int axis = 0; axis < 3; ++axis) {
            const Vec across = hn::MulAdd(u, set(view.right[axis]), hn::Mul(v, set(view.up[axis])));
            const Vec base = hn::MulAdd(set(rays_.distance()), across, set(rays_.base()[axis]));
            const Vec along = hn::Add(set(view.forward[axis]), across);
            store(hn::MulAdd(load(at_.s, i), along, base), at_.x[static_cast<std::size_t>(axis)],
                  i);
        }
    }
    for (std::size_t i = 0; i < size; i += at_once) {
        frame_.kernel.value(ValueBatchOf<double>{
            .size = std::min(at_once, size - i),
            .x = {&at_.x[0][i], &at_.x[1][i], &at_.x[2][i]},
            .uniforms = frame_.scene.uniforms.points<double>(),
            .f = &at_.f[i],
            .gradient = {&at_.gradient[0][i], &at_.gradient[1][i], &at_.gradient[2][i]}});
    }
}

auto LeastSearch::place(std::size_t i, Vec sign) const -> Place {
    const ViewFrame& view = rays_.axes();
    const Vec u = load(at_.u, i);
    const Vec v = load(at_.v, i);
    const Vec s = load(at_.s, i);
    Vec slope = set(0.0);
    Vec right = set(0.0);
    Vec up = set(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const Vec g = hn::Mul(sign, load(at_.gradient[static_cast<std::size_t>(axis)], i));
        slope = hn::MulAdd(g, direction(axis, u, v), slope);
        right = hn::MulAdd(g, set(view.right[axis]), right);
        up = hn::MulAdd(g, set(view.up[axis]), up);
    }
    const Vec pixel = hn::Mul(set(rays_.pixel()), hn::Add(set(rays_.distance()), s));
    return {.s = s,
            .f = hn::Mul(sign, load(at_.f, i)),
            .slope = slope,
            .by_col = hn::Mul(pixel, right),
            .by_row = hn::Neg(hn::Mul(pixel, up))};
}

void LeastSearch::begin() {
    at_.resize(stretches_.size());
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
        const RayStretch& stretch = stretches_[i];
        at_.u[i] = rays_.u(stretch.col);
        at_.v[i] = rays_.v(stretch.row);
        at_.s[i] = stretch.from;
        at_.whether[i] = stretch.only_whether ? 1.0 : 0.0;
        at_.index[i] = static_cast<double>(i);
    }
    evaluate();
    for (std::size_t i = 0; i < at_.count; i += lanes<double>) {
        const Vec f = load(at_.f, i);
        const Vec sign = hn::IfThenElse(hn::Ge(f, set(0.0)), set(1.0), set(-1.0));
        const Place near = place(i, sign);
        store(sign, at_.sign, i);
        store(near.s, at_.lo_s, i);
        store(near.f, at_.lo_f, i);
        store(near.slope, at_.lo_slope, i);
        store(near.s, at_.at, i);
        store(near.f, at_.least, i);
        store(near.by_col, at_.by_col, i);
        store(near.by_row, at_.by_row, i);
    }
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
        stretches_[i].near = at_.f[i];
        at_.s[i] = stretches_[i].to;
    }
    evaluate();
    for (std::size_t i = 0; i < at_.count; i += lanes<double>) {
        const Place far = place(i, load(at_.sign, i));
        store(far.s, at_.hi_s, i);
        store(far.f, at_.hi_f, i);
        store(far.slope, at_.hi_slope, i);
        const Vec least = load(at_.least, i);
        store(hn::Max(hn::Abs(least), hn::Abs(far.f)), at_.size, i);
        const Mask lower = hn::Lt(far.f, least);
        store(hn::IfThenElse(lower, far.s, load(at_.at, i)), at_.at, i);
        store(hn::IfThenElse(lower, far.f, least), at_.least, i);
        store(hn::IfThenElse(lower, far.by_col, load(at_.by_col, i)), at_.by_col, i);
        store(hn::IfThenElse(lower, far.by_row, load(at_.by_row, i)), at_.by_row, i);
    }
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
        stretches_[i].far = at_.f[i];
        stretches_[i].inner = false;
        write(i);
    }
}

void LeastSearch::write(std::size_t i) {
    RayStretch& stretch = stretches_[static_cast<std::size_t>(at_.index[i])];
    stretch.least = at_.least[i];
    stretch.at = at_.at[i];
    stretch.by_col = at_.by_col[i];
    stretch.by_row = at_.by_row[i];
}

auto LeastSearch::is_narrow(std::size_t i) const -> Mask {
    const Vec by_pixel = hn::Max(hn::Abs(load(at_.by_col, i)), hn::Abs(load(at_.by_row, i)));
    const Vec enough = hn::Max(hn::Mul(set(1e-7), load(at_.size, i)), hn::Mul(set(1e-4), by_pixel));
    const Vec slope = hn::Min(hn::Neg(load(at_.lo_slope, i)), load(at_.hi_slope, i));
    const Vec error = hn::Mul(hn::Sub(load(at_.hi_s, i), load(at_.lo_s, i)), slope);
    const Mask has_root =
        hn::And(hn::Gt(load(at_.whether, i), set(0.0)), hn::Lt(load(at_.least, i), set(0.0)));
    return hn::Or(hn::Le(error, enough), has_root);
}

void LeastSearch::take() {
    const std::size_t before = at_.count;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < before; i += lanes<double>) {
        const Place next = place(i, load(at_.sign, i));
        const Mask falls = hn::Lt(next.slope, set(0.0));
        const auto put = [&](Mask where, Vec x, std::vector<double>& column) {
            store(hn::IfThenElse(where, x, load(column, i)), column, i);
        };
        put(falls, next.s, at_.lo_s);
        put(falls, next.f, at_.lo_f);
        put(falls, next.slope, at_.lo_slope);
        put(hn::Not(falls), next.s, at_.hi_s);
        put(hn::Not(falls), next.f, at_.hi_f);
        put(hn::Not(falls), next.slope, at_.hi_slope);
        const Mask lower = hn::Not(hn::Gt(next.f, load(at_.least, i)));
        put(lower, next.f, at_.least);
        put(lower, next.s, at_.at);
        put(lower, next.by_col, at_.by_col);
        put(lower, next.by_row, at_.by_row);
        const Mask there = hn::FirstN(d<double>, before - i);
        for (LaneBits bits = bits_of(d<double>, hn::And(lower, there)); bits != 0;
             bits &= bits - 1) {
            const std::size_t k = i + static_cast<std::size_t>(std::countr_zero(bits));
            stretches_[static_cast<std::size_t>(at_.index[k])].inner = true;
            write(k);
        }
        const Mask open = hn::AndNot(is_narrow(i), there);
        const std::size_t more = hn::CountTrue(d<double>, open);
        at_.for_each([&](std::vector<double>& column) {
            hn::CompressStore(load(column, i), open, d<double>, column.data() + kept);
        });
        kept += more;
    }
    at_.count = kept;
}

void LeastSearch::choose(int step) {
    const bool tangents = step % 3 == 1;
    for (std::size_t i = 0; i < at_.count; i += lanes<double>) {
        const Vec a_slope = load(at_.lo_slope, i);
        const Vec b_slope = load(at_.hi_slope, i);
        const Vec a = load(at_.lo_s, i);
        const Vec length = hn::Sub(load(at_.hi_s, i), a);
        const Vec rise = hn::Sub(load(at_.hi_f, i), load(at_.lo_f, i));
        Vec part;
        if (tangents) {
            // Where the tangents at both places meet: where f is least if it has a kink between
            // them, and is straight on both sides.
            part = hn::Div(hn::NegMulAdd(b_slope, length, rise),
                           hn::Mul(hn::Sub(a_slope, b_slope), length));
        } else {
            // Where the cubic through both places with these slopes is least.
            const Vec p = hn::NegMulAdd(set(3.0), hn::Div(rise, length), hn::Add(a_slope, b_slope));
            const Vec square = hn::NegMulAdd(a_slope, b_slope, hn::Mul(p, p));
            const Vec root = hn::Sqrt(hn::Max(square, set(0.0)));
            const Vec over = hn::Sub(hn::Add(b_slope, root), p);
            const Vec under = hn::MulAdd(set(2.0), root, hn::Sub(b_slope, a_slope));
            part = hn::Sub(set(1.0), hn::Div(over, under));
        }
        const Mask within = hn::And(hn::Gt(part, set(0.0)), hn::Lt(part, set(1.0)));  // not if NaN
        part = hn::IfThenElse(within, part, set(0.5));
        part = hn::Min(hn::Max(part, set(0.02)), set(0.98));
        store(hn::MulAdd(part, length, a), at_.s, i);
    }
}

void LeastSearch::run() {
    constexpr int most_steps = 16;
    begin();
    // Go on where df/ds changes its sign.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < at_.count; i += lanes<double>) {
        const Mask open = hn::And(hn::FirstN(d<double>, at_.count - i),
                                  hn::And(hn::Lt(load(at_.lo_slope, i), set(0.0)),
                                          hn::Gt(load(at_.hi_slope, i), set(0.0))));
        const std::size_t more = hn::CountTrue(d<double>, open);
        at_.for_each([&](std::vector<double>& column) {
            hn::CompressStore(load(column, i), open, d<double>, column.data() + kept);
        });
        kept += more;
    }
    at_.count = kept;
    for (int step = 0; step < most_steps && at_.count > 0 && !frame_.stopped(); ++step) {
        choose(step);
        evaluate();
        take();
    }
}

void find_least_here(const TraceFrame& frame, const TileRays& rays, std::span<RayStretch> stretches,
                     Counters& counters) {
    LeastSearch(frame, rays, stretches, counters).run();
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace zeroset {
namespace {

HWY_EXPORT(find_least_here);

}  // namespace

void find_least(const TraceFrame& frame, const TileRays& rays, std::span<RayStretch> stretches,
                Counters& counters) {
    if (stretches.empty()) return;
    HWY_DYNAMIC_DISPATCH(find_least_here)(frame, rays, stretches, counters);
}

}  // namespace zeroset
#endif
