// The rays of a tile on a leaf: as linear_zeros and zero_test (patch_sight.hpp) say it of one ray,
// with S by the polynomials of its model.
//   g = (a - u (distance + s), b - v (distance + s))
// Newton's method in float settles most rays, each by itself (patch_newton-inl.hpp); Krawczyk's
// test of the whole leaf in double those for which that is too coarse. A leaf that leaves rays open
// is halved, again and again, by shifts of its polynomials: each half goes on with those of them
// that its linear form does not reject.

#include "engine/trace/patch/patch_leaf.hpp"

#include "engine/real/unbounded.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/patch/patch_leaf.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/patch/patch_lists-inl.hpp"
#include "engine/trace/patch/patch_pieces-inl.hpp"
#include "engine/trace/patch/patch_solver-inl.hpp"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Krawczyk's test has to contract by this on all of a box.
constexpr double contracting_norm = 0.7;
/// Newton's method is not tried on boxes that bend more than this.
constexpr double bent_norm = 8.0;
constexpr int most_halvings = 14;
class LeafTracer {
public:
    LeafTracer(const SightAxes& axes, const LeafRays& rays, const LeafClip& clip, LeafLists& lists,
               LeafTaker& taker)
        : axes_(axes), rays_(rays), clip_(clip), lists_(axes, rays, lists), taker_(taker) {
        flip_ = glm::dot(glm::cross(axes.right, axes.up), axes.forward) < 0.0 ? -1.0F : 1.0F;
    }

    void trace(const LeafSight& leaf, const LeafPixels& pixels) {
        // Choose the degree that the tolerance asks for, and prefetch its terms.
        Piece piece;
        piece.value_error = leaf.value_error;
        set_degree(piece, leaf.sizes, rays_.tolerance);
        fetch(leaf.model, piece.degree);
        // Many parts are hidden in all their pixels: nothing else is done for these.
        const bool is_outlined = pixels.outline != nullptr;
        const std::size_t gathered = is_outlined ? lists_.gather(pixels, leaf.near) : 0;
        if (is_outlined && gathered == 0 && pixels.others.empty()) return;
        // Turn the polynomials into the view's axes, and set the linear form.
        turn(leaf.model, axes_, piece);
        measure(piece);
        piece.box = leaf.box;
        piece.halvings = 0;
        lower_first_degree(piece, rays_.tolerance);
        see(piece);
        trace_listed(piece, lists_.list(piece, pixels, gathered));
    }

    [[nodiscard]] const LeafCount& count() const { return count_; }

private:
    /// Says early that a model is going to be read.
    static void fetch(const PatchModel& model, int degree) {
        for (const auto& terms : model.terms) {
            for (std::size_t i = 0; i < terms_of(degree); i += 8)
                hwy::Prefetch(terms.data() + i);
        }
    }
    /// Goes on with those of some rays that may meet a piece.
    void trace_listed(Piece& piece, const RaySpan& some) {
        if (some.count == 0) return;
        // Bound how the derivatives vary over the piece, for all of the rays.
        const SightRays around = lists_.bounds_of(some);
        piece.contraction = contraction_of(piece.sight, around);
        RaySpan open = some;
        // Solve rays by Newton's method; on flat pieces, the others by Krawczyk's test.
        if (piece.contraction.norm <= bent_norm) {
            const FloatTerms floats(piece);
            open.count = solve_bent(Newton(piece, floats, axes_, rays_.tolerance, around),
                                    piece.first_degree, some);
            if (open.count == 0) return;
            if (piece.contraction.norm <= contracting_norm) open.count = solve(piece, floats, open);
        }
        if (open.count == 0) return;
        // Leave rays open that halves would not settle.
        if (piece.halvings >= most_halvings || is_all_error(piece, axes_, around))
            return leave(open, piece.sight.depths().near);
        // Halve the piece, and go on with the nearer half first.
        const PatchSight& sight = piece.sight;
        const bool along_p = halves_along_p(piece, around.middle);
        const double forward = along_p ? sight.kp.z : sight.kq.z;
        for (const double sign : forward > 0.0 ? std::array{-1.0, 1.0} : std::array{1.0, -1.0}) {
            Piece half;
            halve(piece, along_p, sign, half);
            lower_degree(half, rays_.tolerance);
            see(half);
            trace_listed(half, lists_.list(half, open));
        }
    }

    void leave(const RaySpan& rays, double near) {
        for (std::size_t i = rays.first; i < rays.first + rays.count; ++i)
            taker_.leave(lists_.pixel(i), near, LeafLeft::Tangent);
    }

    /// Solves the rays of a piece in float. Moves those left open to the front of the list and
    /// returns how many they are.
    std::size_t solve_bent(const Newton& newton, int first_degree, const RaySpan& rays) {
        return with_degree(first_degree, [&](auto degree) HWY_ATTR {
            return newton.with_squares() ? solve_bent_by<degree(), true>(newton, rays)
                                         : solve_bent_by<degree(), false>(newton, rays);
        });
    }
    template <int degree, bool with_squares>
    std::size_t solve_bent_by(const Newton& newton, const RaySpan& rays);
    /// Solves the rays of a piece in double where Krawczyk's test contracts; returns as solve_bent.
    std::size_t solve(const Piece& piece, const FloatTerms& floats, const RaySpan& rays) {
        const Solver solver(piece, floats, axes_, rays_.tolerance);
        return with_degree(piece.degree, [&](auto degree) HWY_ATTR {
            return solve_by<degree()>(piece, solver, rays);
        });
    }
    template <int degree>
    std::size_t solve_by(const Piece& piece, const Solver& solver, const RaySpan& rays);
    /// Takes those hits among twice as many rays as vectors have numbers, from `at` on, that count.
    void take_hits(const SolverEnd& end, std::size_t at, LaneBits real);
    /// The lanes whose places are in the box of what counts.
    [[nodiscard]] M<double> in_box(V<double> u, V<double> v, V<double> s) const;
    void put_normals(const FloatPoint& at, LeafFound* found) const;
    /// Puts hits that count.
    void put_found(const LeafFound* found, const double* s, const std::int32_t* pixels,
                   LaneBits hits) const;
    /// Takes the certain hits of Newton's method that count.
    void take_found(const RaysOnPiece& rays, const NewtonEnd& end, std::size_t at, LaneBits hits);

    const SightAxes& axes_;
    const LeafRays& rays_;
    const LeafClip& clip_;
    RayLists lists_;
    LeafTaker& taker_;
    float flip_;
    LeafCount count_;
};

template <int degree>
std::size_t LeafTracer::solve_by(const Piece& piece, const Solver& solver, const RaySpan& rays) {
    count_.evaluations += rays.count;
    std::size_t left = 0;
    for (std::size_t first = 0; first < rays.count; first += lanes<float>) {
        const std::size_t at = rays.first + first;
        // Load two vectors of rays, with the places where their search begins.
        SolverEnd end;
        const auto u = RayLists::pair(lists_.u(at));
        const auto v = RayLists::pair(lists_.v(at));
        const auto p = doubles_of(hn::LoadU(d<float>, lists_.p(at)));
        const auto q = doubles_of(hn::LoadU(d<float>, lists_.q(at)));
        for (std::size_t i = 0; i < 2; ++i) {
            end.halves[i].line = {.u = u[i], .v = v[i]};
            end.halves[i].place = {.p = p[i], .q = q[i]};
        }
        solver.solve<degree>(end);
        const LaneBits real = RayLists::first_bits(rays.count - first);
        const auto bits = [&](auto mask_of_half) HWY_ATTR {
            return real & (bits_of(d<double>, mask_of_half(end.halves[0].test)) |
                           bits_of(d<double>, mask_of_half(end.halves[1].test)) << lanes<double>);
        };
        // Take the hits, and leave rays for which the model is too coarse.
        take_hits(end, at, real);
        LaneBits wide = bits([](const Test& test) HWY_ATTR { return test.wide; });
        LaneBits open = ~wide & bits([](const Test& test) HWY_ATTR {
            return hn::Not(hn::Or(test.none, test.found));
        });
        for (; wide != 0; wide &= wide - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(wide));
            taker_.leave(lists_.pixel(at + lane), piece.sight.depths().near, LeafLeft::Coarse);
        }
        // Move the rays that are still open to the front of the list.
        for (; open != 0; open &= open - 1)
            lists_.copy(at + static_cast<std::size_t>(std::countr_zero(open)), rays.first + left++);
    }
    return left;
}

template <int degree, bool with_squares>
std::size_t LeafTracer::solve_bent_by(const Newton& newton, const RaySpan& rays) {
    count_.evaluations += rays.count;
    std::size_t left = 0;
    for (std::size_t i = 0; i < rays.count; i += lanes<float>) {
        const std::size_t at = rays.first + i;
        const RaysOnPiece some{.u = RayLists::pair(lists_.u(at)),
                               .v = RayLists::pair(lists_.v(at)),
                               .p = hn::LoadU(d<float>, lists_.p(at)),
                               .q = hn::LoadU(d<float>, lists_.q(at)),
                               .spread = hn::LoadU(d<float>, lists_.spread(at))};
        const NewtonEnd end = newton.solve<degree, with_squares>(some);
        const LaneBits real = RayLists::first_bits(rays.count - i);
        const LaneBits found = real & bits_of(d<float>, end.found);
        if (found != 0) take_found(some, end, at, found);
        for (LaneBits open = real & ~found & ~bits_of(d<float>, end.none); open != 0;
             open &= open - 1)
            lists_.copy(at + static_cast<std::size_t>(std::countr_zero(open)), rays.first + left++);
    }
    return left;
}

inline void LeafTracer::take_found(const RaysOnPiece& rays, const NewtonEnd& end, std::size_t at,
                                   LaneBits hits) {
    HWY_ALIGN double s[lanes<float>];
    // Drop hits behind the rays' reaches, or outside of the box.
    hits &= lists_.within_reach(at, end.s);
    for (std::size_t half = 0; half < 2; ++half) {
        hn::Store(end.s[half], d<double>, s + half * lanes<double>);
        if (clip_.window != LeafWindow::Box) continue;
        const M<double> in = in_box(rays.u[half], rays.v[half], end.s[half]);
        hits &= ~(bits_of(d<double>, hn::Not(in)) << (half * lanes<double>));
    }
    if (hits == 0) return;
    count_.hits += static_cast<std::size_t>(std::popcount(hits));
    // Compute the normals; store the hits at once where none is to be judged.
    LeafFound found[lanes<float>];
    put_normals(end.at, found);
    if (clip_.window != LeafWindow::Judged && rays_.to == nullptr)
        return put_found(found, s, lists_.pixels_at(at), hits);
    for (; hits != 0; hits &= hits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(hits));
        const std::size_t pixel = lists_.pixel(at + lane);
        if (clip_.window == LeafWindow::Judged) {
            const RayState state = taker_.judge({.pixel = pixel,
                                                 .is_inside = true,
                                                 .s = s[lane],
                                                 .s_radius = 0.5 * rays_.tolerance});
            if (state == RayState::Open) continue;
            found[lane].state = state;
        }
        rays_.found[pixel] = found[lane];
        rays_.reach[pixel] = s[lane];
        if (rays_.to == nullptr || found[lane].state != RayState::Proved) continue;
        rays_.reach[pixel] = -unbounded;
        rays_.to[pixel] = -unbounded;
    }
}

inline void LeafTracer::put_found(const LeafFound* found, const double* s,
                                  const std::int32_t* pixels, LaneBits hits) const {
    LeafFound* const to_found = rays_.found;
    double* const to_reach = rays_.reach;
    for (; hits != 0; hits &= hits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(hits));
        const auto pixel = static_cast<std::size_t>(pixels[lane]);
        to_found[pixel] = found[lane];
        to_reach[pixel] = s[lane];
    }
}

inline M<double> LeafTracer::in_box(V<double> u, V<double> v, V<double> s) const {
    // Rounding may shift a place by this.
    const double spare = 8.0 * axes_.error;
    const V<double> along = hn::Add(s, number(axes_.distance));
    M<double> inside = hn::Ge(s, number(clip_.first));
    for (int k = 0; k < 3; ++k) {
        const V<double> across =
            hn::MulAdd(u, number(axes_.right[k]), hn::Mul(v, number(axes_.up[k])));
        const V<double> from = hn::MulAdd(s, number(axes_.forward[k]), number(axes_.base[k]));
        const V<double> at = hn::MulAdd(along, across, from);
        inside = hn::And(inside, hn::And(hn::Ge(at, number(clip_.box.lo[k] - spare)),
                                         hn::Le(at, number(clip_.box.hi[k] + spare))));
    }
    return inside;
}

/// dS/dp x dS/dq in the axes, then in the world.
inline void LeafTracer::put_normals(const FloatPoint& at, LeafFound* found) const {
    const V<float> flip = hn::Set(d<float>, flip_);
    const auto& [ap, bp, sp] = at.by_p;
    const auto& [aq, bq, sq] = at.by_q;
    const auto cross = [&](V<float> xp, V<float> xq, V<float> yp, V<float> yq) HWY_ATTR {
        return hn::Mul(flip, hn::NegMulAdd(yp, xq, hn::Mul(xp, yq)));
    };
    const V<float> a = cross(bp, bq, sp, sq);
    const V<float> b = cross(sp, sq, ap, aq);
    const V<float> c = cross(ap, aq, bp, bq);
    const V<float> most = hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c));
    const V<float> scale = hn::Div(number<float>(1.0), most);
    V<float> world[3];
    for (int k = 0; k < 3; ++k) {
        const V<float> across =
            hn::MulAdd(a, number<float>(axes_.right[k]), hn::Mul(b, number<float>(axes_.up[k])));
        world[k] = hn::Mul(scale, hn::MulAdd(c, number<float>(axes_.forward[k]), across));
    }
    const hn::RebindToUnsigned<Tag<float>> dw;
    const auto state = hn::Set(dw, static_cast<std::uint32_t>(RayState::Proved));
    hn::StoreInterleaved4(world[0], world[1], world[2], hn::BitCast(d<float>, state), d<float>,
                          found->normal.data());
}

inline void LeafTracer::take_hits(const SolverEnd& end, std::size_t at, LaneBits real) {
    HWY_ALIGN double s[lanes<float>];
    HWY_ALIGN double s_radius[lanes<float>];
    LaneBits hits = 0;
    LaneBits inside = 0;
    // Find the depths of the hits, and which of them count.
    for (std::size_t half = 0; half < 2; ++half) {
        const HalfRays& rays = end.halves[half];
        const Test& test = rays.test;
        hn::Store(test.depth.middle, d<double>, s + half * lanes<double>);
        hn::Store(test.depth.radius, d<double>, s_radius + half * lanes<double>);
        M<double> some = hn::AndNot(test.outside, test.found);
        if (clip_.window == LeafWindow::Box)
            some = hn::And(some, in_box(rays.line.u, rays.line.v, test.depth.middle));
        hits |= bits_of(d<double>, some) << (half * lanes<double>);
        inside |= bits_of(d<double>, test.inside) << (half * lanes<double>);
    }
    hits &= real;
    if (hits == 0) return;
    // Compute the normals, and store the hits that are nearer than the reach.
    LeafFound found[lanes<float>];
    put_normals(end.at, found);
    for (; hits != 0; hits &= hits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(hits));
        const std::size_t pixel = lists_.pixel(at + lane);
        if (s[lane] > rays_.reach[pixel]) continue;
        const bool is_inside = (inside >> lane & 1U) != 0;
        RayState state = is_inside ? RayState::Proved : RayState::Drawn;
        if (clip_.window == LeafWindow::Judged) {
            state = taker_.judge(
                {.pixel = pixel, .is_inside = is_inside, .s = s[lane], .s_radius = s_radius[lane]});
            if (state == RayState::Open) continue;
        }
        found[lane].state = state;
        rays_.found[pixel] = found[lane];
        const bool is_done = rays_.to != nullptr && state == RayState::Proved;
        rays_.reach[pixel] = is_done ? -unbounded : s[lane];
        if (is_done) rays_.to[pixel] = -unbounded;
        ++count_.hits;
    }
}

LeafCount trace(const LeafSight& leaf, const SightAxes& axes, const LeafRays& rays,
                const LeafPixels& pixels, const LeafClip& clip, LeafLists& lists,
                LeafTaker& taker) {
    LeafTracer tracer(axes, rays, clip, lists, taker);
    tracer.trace(leaf, pixels);
    return tracer.count();
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {

HWY_EXPORT(trace);

void LeafLists::reserve(std::size_t first, std::size_t more) {
    constexpr std::size_t most_lanes = 16;
    const std::size_t size = first + more + 3 * most_lanes;
    if (size <= u.size()) return;
    for (std::vector<double>* const all : {&u, &v})
        all->resize(2 * size);
    for (std::vector<float>* const all : floats())
        all->resize(2 * size);
    pixel.resize(2 * size);
}

LeafCount trace_leaf(const LeafSight& leaf, const SightAxes& axes, const LeafRays& rays,
                     const LeafPixels& pixels, const LeafClip& clip, LeafLists& lists,
                     LeafTaker& taker) {
    return HWY_DYNAMIC_DISPATCH(trace)(leaf, axes, rays, pixels, clip, lists, taker);
}

}  // namespace zeroset

#endif
