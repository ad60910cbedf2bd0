// The rays of a tile on a leaf: as linear_zeros and zero_test (patch_sight.hpp) say it of one ray,
// with S by the polynomials of its model.
//   g = (a - u (distance + s), b - v (distance + s))
// A leaf that Krawczyk's test does not contract on is halved, again and again, by shifts of its
// polynomials: each half goes on with those rays that its linear form does not reject.

#include "engine/trace/patch/patch_leaf.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/patch/patch_leaf.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/trace/patch/patch_pieces-inl.hpp"
#include "engine/trace/patch/patch_solver-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

/// Boxes are halved until Krawczyk's test contracts by this.
constexpr double flat_norm = 0.7;
constexpr int most_halvings = 14;

/// Some rays of the lists: from `first` on.
struct Range {
    std::size_t first, count;
};

class LeafTracer {
public:
    LeafTracer(const SightAxes& axes, const LeafRays& rays, double tolerance, LeafLists& lists,
               LeafTaker& taker)
        : axes_(axes), rays_(rays), tolerance_(tolerance), lists_(lists), taker_(taker) {
        flip_ = glm::dot(glm::cross(axes.right, axes.up), axes.forward) < 0.0 ? -1.0 : 1.0;
    }

    /// Lists the rays through some pixels.
    std::size_t list(const TileRect& rect, double near, std::size_t count) {
        const D d;
        const hn::RebindToSigned<D> di;
        const auto first_col = static_cast<std::size_t>(rect.col) / width * width;
        const auto end_col = static_cast<std::size_t>(rect.end_col);
        const auto end_row = static_cast<std::size_t>(rect.end_row);
        lists_.reserve(count, (end_row - static_cast<std::size_t>(rect.row)) * (end_col + width));
        for (auto row = static_cast<std::size_t>(rect.row); row < end_row; ++row) {
            for (std::size_t col = first_col; col < end_col; col += width) {
                const std::size_t at = row * rays_.row_size + col;
                Mask wanted = hn::And(hn::Le(number(near), hn::LoadU(d, rays_.reach + at)),
                                      hn::FirstN(d, end_col - col));
                if (col < static_cast<std::size_t>(rect.col))
                    wanted =
                        hn::AndNot(hn::FirstN(d, static_cast<std::size_t>(rect.col) - col), wanted);
                const std::size_t some = hn::CountTrue(d, wanted);
                if (some == 0) continue;
                const auto pixels = hn::Iota(di, static_cast<std::int64_t>(at));
                hn::StoreU(squeezed(hn::LoadU(d, rays_.u + at), wanted), d, u_at(count));
                hn::StoreU(squeezed(hn::LoadU(d, rays_.v + at), wanted), d, v_at(count));
                hn::StoreU(hn::BitCast(di, squeezed(hn::BitCast(d, pixels), wanted)), di,
                           lists_.pixel.data() + count);
                count += some;
            }
        }
        return count;
    }

    /// Lists the rays through some more pixels.
    std::size_t list(std::span<const std::size_t> pixels, std::size_t count) {
        lists_.reserve(count, pixels.size());
        for (const std::size_t pixel : pixels) {
            lists_.u[count] = rays_.u[pixel];
            lists_.v[count] = rays_.v[pixel];
            lists_.pixel[count++] = static_cast<std::int64_t>(pixel);
        }
        return count;
    }

    /// Goes on with those of some rays that may meet a piece.
    void trace(Piece& piece, const Range& before) {
        const double near = piece.sight.depths().near;
        const Range some = keep(piece, before, near);
        if (some.count == 0) return;
        piece.contraction = contraction_of(piece.sight, bounds_of(some));
        Range open = some;
        if (piece.contraction.norm <= flat_norm) open.count = solve(piece, some);
        if (open.count == 0) return;
        if (piece.halvings >= most_halvings) return leave(open, near);
        const PatchSight& sight = piece.sight;
        const auto bend = [](const glm::dvec3& by) { return by.x + by.y; };
        const bool along_p = bend(sight.dp_radius) + 0x1p-20 * bend(glm::abs(sight.dp)) >=
                             bend(sight.dq_radius) + 0x1p-20 * bend(glm::abs(sight.dq));
        const double forward = along_p ? sight.kp.z : sight.kq.z;
        for (const double sign : forward > 0.0 ? std::array{-1.0, 1.0} : std::array{1.0, -1.0}) {
            Piece half;
            halve(piece, along_p, sign, half);
            see(half);
            trace(half, open);
        }
    }

    [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

private:
    double* u_at(std::size_t i) { return lists_.u.data() + i; }
    double* v_at(std::size_t i) { return lists_.v.data() + i; }

    void leave(const Range& rays, double near) {
        for (std::size_t i = rays.first; i < rays.first + rays.count; ++i)
            taker_.leave(static_cast<std::size_t>(lists_.pixel[i]), near, LeafLeft::Tangent);
    }

    /// Lists those rays again, behind them, that the piece's linear form does not reject, with
    /// where it has their zeros.
    Range keep(const Piece& piece, const Range& rays, double near) {
        const D d;
        const hn::RebindToSigned<D> di;
        const LinearForm form(piece.sight, axes_);
        Range kept{.first = rays.first + rays.count, .count = 0};
        lists_.reserve(kept.first, rays.count + width);
        for (std::size_t i = 0; i < rays.count; i += width) {
            const std::size_t at = rays.first + i;
            const Mask real = hn::FirstN(d, rays.count - i);
            const auto pixel = hn::IfThenElseZero(hn::RebindMask(di, real),
                                                  hn::LoadU(di, lists_.pixel.data() + at));
            const Vector reach = hn::GatherIndex(d, rays_.reach, pixel);
            const Mask wanted = hn::And(real, hn::Le(number(near), reach));
            if (hn::AllFalse(d, wanted)) continue;
            const Vector u = hn::LoadU(d, u_at(at));
            const Vector v = hn::LoadU(d, v_at(at));
            const Zeros zeros = form.zeros(u, v);
            const Mask left = hn::AndNot(zeros.none, wanted);
            const std::size_t some = hn::CountTrue(d, left);
            if (some == 0) continue;
            const std::size_t to = kept.first + kept.count;
            const Vector zero = number(0.0);
            const Vector p = hn::IfThenElse(zeros.known, zeros.p, zero);
            const Vector q = hn::IfThenElse(zeros.known, zeros.q, zero);
            hn::StoreU(squeezed(u, left), d, u_at(to));
            hn::StoreU(squeezed(v, left), d, v_at(to));
            hn::StoreU(squeezed(p, left), d, lists_.p.data() + to);
            hn::StoreU(squeezed(q, left), d, lists_.q.data() + to);
            hn::StoreU(hn::BitCast(di, squeezed(hn::BitCast(d, pixel), left)), di,
                       lists_.pixel.data() + to);
            kept.count += some;
        }
        // Lanes behind the last ray repeat it.
        const std::size_t end = kept.first + kept.count;
        for (std::vector<double>* const numbers : {&lists_.u, &lists_.v, &lists_.p, &lists_.q}) {
            if (kept.count == 0) break;
            hn::StoreU(number((*numbers)[end - 1]), d, numbers->data() + end);
        }
        return kept;
    }

    /// Rays that surround those of the list.
    SightRays bounds_of(const Range& rays) {
        const D d;
        Vector u_lo = hn::LoadU(d, u_at(rays.first));
        Vector v_lo = hn::LoadU(d, v_at(rays.first));
        Vector u_hi = u_lo;
        Vector v_hi = v_lo;
        for (std::size_t i = width; i < rays.count; i += width) {
            const Vector u = hn::LoadU(d, u_at(rays.first + i));
            const Vector v = hn::LoadU(d, v_at(rays.first + i));
            u_lo = hn::Min(u_lo, u);
            u_hi = hn::Max(u_hi, u);
            v_lo = hn::Min(v_lo, v);
            v_hi = hn::Max(v_hi, v);
        }
        const auto range = [&](Vector lo, Vector hi) HWY_ATTR {
            const double least = hn::GetLane(hn::MinOfLanes(d, lo));
            const double most = hn::GetLane(hn::MaxOfLanes(d, hi));
            const double middle = 0.5 * least + 0.5 * most;
            return std::array{middle, std::max(most - middle, middle - least)};
        };
        const auto [u, u_radius] = range(u_lo, u_hi);
        const auto [v, v_radius] = range(v_lo, v_hi);
        return {.middle = {.u = u, .v = v}, .u_radius = u_radius, .v_radius = v_radius};
    }

    /// Solves the rays of a piece. Those that are left come first afterwards; returns how many.
    std::size_t solve(const Piece& piece, const Range& rays);
    /// Hands over the hits among a vector of rays, from `at` on, where `real` has bits.
    void take_hits(const Piece& piece, const Polynomial& depth, const Solver::End& end,
                   std::size_t at, LaneBits real) const;

    const SightAxes& axes_;
    const LeafRays& rays_;
    double tolerance_;
    LeafLists& lists_;
    LeafTaker& taker_;
    double flip_;
    std::size_t evaluations_ = 0;
};

inline void LeafTracer::take_hits(const Piece& piece, const Polynomial& depth,
                                  const Solver::End& end, std::size_t at, LaneBits real) const {
    const D d;
    const PatchSight& sight = piece.sight;
    const Test& test = end.test;
    const Slopes z = slopes_of(depth, end.p, end.q);
    const Vector s = hn::MulAdd(number(sight.dp.z), test.step_p,
                                hn::MulAdd(number(sight.dq.z), test.step_q, z.value));
    // dS/dp x dS/dq in the axes, then in the world.
    const Vector ap = hn::MulAdd(end.u, z.by_p, end.f1.by_p);
    const Vector aq = hn::MulAdd(end.u, z.by_q, end.f1.by_q);
    const Vector bp = hn::MulAdd(end.v, z.by_p, end.f2.by_p);
    const Vector bq = hn::MulAdd(end.v, z.by_q, end.f2.by_q);
    const Vector flip = number(flip_);
    const Vector a = hn::Mul(flip, hn::NegMulAdd(z.by_p, bq, hn::Mul(bp, z.by_q)));
    const Vector b = hn::Mul(flip, hn::NegMulAdd(ap, z.by_q, hn::Mul(z.by_p, aq)));
    const Vector c = hn::Mul(flip, hn::NegMulAdd(bp, aq, hn::Mul(ap, bq)));
    HWY_ALIGN double numbers[5][width];
    hn::Store(s, d, numbers[3]);
    hn::Store(test.s_radius, d, numbers[4]);
    for (int k = 0; k < 3; ++k) {
        const Vector across =
            hn::MulAdd(a, number(axes_.right[k]), hn::Mul(b, number(axes_.up[k])));
        hn::Store(hn::MulAdd(c, number(axes_.forward[k]), across), d, numbers[k]);
    }
    const LaneBits inside = bits_of(d, end.inside);
    LaneBits hits = real & bits_of(d, hn::AndNot(end.outside, test.found));
    for (; hits != 0; hits &= hits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(hits));
        taker_.take({.pixel = static_cast<std::size_t>(lists_.pixel[at + lane]),
                     .is_inside = (inside >> lane & 1U) != 0,
                     .s = numbers[3][lane],
                     .s_radius = numbers[4][lane],
                     .normal = {numbers[0][lane], numbers[1][lane], numbers[2][lane]}});
    }
}

inline std::size_t LeafTracer::solve(const Piece& piece, const Range& rays) {
    const D d;
    const Solver solver(piece, axes_, tolerance_);
    Polynomial depth;
    for (std::size_t i = 0; i < patch_terms; ++i)
        depth.terms[i] = number(piece.terms[i][2]);
    const PatchSight& sight = piece.sight;
    evaluations_ += rays.count;
    std::size_t left = 0;
    for (std::size_t i = 0; i < rays.count; i += width) {
        const std::size_t at = rays.first + i;
        const Solver::End end =
            solver.solve(hn::LoadU(d, u_at(at)), hn::LoadU(d, v_at(at)),
                         hn::LoadU(d, lists_.p.data() + at), hn::LoadU(d, lists_.q.data() + at));
        const LaneBits real =
            rays.count - i >= width ? ~LaneBits{0} : (LaneBits{1} << (rays.count - i)) - 1;
        const Test& test = end.test;
        take_hits(piece, depth, end, at, real);
        LaneBits wide = real & bits_of(d, test.wide);
        LaneBits open = real & ~wide & bits_of(d, hn::Not(hn::Or(test.none, test.found)));
        for (; wide != 0; wide &= wide - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(wide));
            taker_.leave(static_cast<std::size_t>(lists_.pixel[at + lane]), sight.depths().near,
                         LeafLeft::Coarse);
        }
        for (; open != 0; open &= open - 1) {
            const std::size_t from = at + static_cast<std::size_t>(std::countr_zero(open));
            const std::size_t to = rays.first + left++;
            lists_.u[to] = lists_.u[from];
            lists_.v[to] = lists_.v[from];
            lists_.pixel[to] = lists_.pixel[from];
        }
    }
    return left;
}

std::size_t trace(const LeafSight& leaf, const SightAxes& axes, const LeafRays& rays,
                  const LeafPixels& pixels, double tolerance, LeafLists& lists, LeafTaker& taker) {
    Piece piece;
    piece.terms = leaf.terms;
    piece.value_error = leaf.value_error;
    piece.box = leaf.box;
    piece.halvings = 0;
    see(piece);
    LeafTracer tracer(axes, rays, tolerance, lists, taker);
    std::size_t count = tracer.list(pixels.others, 0);
    for (const TileRect& rect : pixels.rects)
        count = tracer.list(rect, piece.sight.depths().near, count);
    tracer.trace(piece, {.first = 0, .count = count});
    return tracer.evaluations();
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {

HWY_EXPORT(trace);

void LeafLists::reserve(std::size_t first, std::size_t more) {
    constexpr std::size_t most_lanes = 8;
    const std::size_t size = first + more + 2 * most_lanes;
    if (size <= u.size()) return;
    for (std::vector<double>* const numbers : {&u, &v, &p, &q})
        numbers->resize(2 * size);
    pixel.resize(2 * size);
}

std::size_t trace_leaf(const LeafSight& leaf, const SightAxes& axes, const LeafRays& rays,
                       const LeafPixels& pixels, double tolerance, LeafLists& lists,
                       LeafTaker& taker) {
    return HWY_DYNAMIC_DISPATCH(trace)(leaf, axes, rays, pixels, tolerance, lists, taker);
}

SightTerms turned_terms(const PatchModel& model, const SightAxes& axes) {
    SightTerms terms;
    for (std::size_t i = 0; i < patch_terms; ++i) {
        const glm::dvec3 term(model.terms[0][i], model.terms[1][i], model.terms[2][i]);
        const glm::dvec3 turned = i == 0 ? axes.place(term) : axes.turned(term);
        terms[i] = {turned.x, turned.y, turned.z, 0.0};
    }
    return terms;
}

}  // namespace zeroset

#endif
