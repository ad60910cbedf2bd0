#include "engine/antialias/cover_rules.hpp"
#include "engine/antialias/front_block.hpp"
#include "engine/antialias/square_field.hpp"
#include "engine/kernel/form_cells.hpp"
#include "engine/kernel/form_signs.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/in_precision.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/antialias/square_cells.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include "engine/antialias/front_steps-inl.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

template <class Real>
class SquareCells {
public:
    SquareCells(const TraceFrame& frame, std::size_t surface, SquareField& field)
        : frame_(frame),
          surface_(surface),
          field_(field),
          rays_(field.rays()),
          margin_(upper_end(
              Real{}, std::max(field.width_of(cell_margin, 0.0), 2.0 * rays_.depth_error()))) {}

    /// Takes the fronts of some squares on; `to_end`: until none goes on; else by one cell each.
    void advance(std::span<const std::size_t> squares, bool to_end, Counters& counters);

private:
    /// Takes the first `count` fronts on by a cell each.
    void evaluate(std::size_t count, const FrustumOf<Real>& frustum, const FrontRules<Real>& rules,
                  Counters& counters);
    [[nodiscard]] FrustumOf<Real> frustum_of(const CoverSquare& square) const;
    [[nodiscard]] FrontRules<Real> rules_of(const CoverSquare& square) const;
    void load(std::size_t i, std::size_t square);
    void store(std::size_t i) const { fronts_.store(i, field_.fronts(squares_[i])[surface_]); }
    /// Fills up whole batches behind `count` fronts, with fronts that went on no more where there
    /// are such, else with the last one; returns how many these are.
    std::size_t pad(std::size_t count);
    /// Puts waiting squares in the place of those among the first `count` whose fronts go on no
    /// more; returns how many there are then.
    std::size_t replace_ended(std::size_t count, std::span<const std::size_t>& waiting);
    /// Puts the last one of `count` that goes on in the place of i, and stores those behind it;
    /// returns how many are left.
    std::size_t close_gap(std::size_t i, std::size_t count);
    /// Sets the next cells.
    void place_cells(std::size_t size);
    /// Takes the fronts on by the forms of these cells.
    void take_cells(const FrontRules<Real>& rules, std::size_t size);
    [[nodiscard]] HWY_INLINE CellVerdict<Real> verdict_at(const FrontRules<Real>& rules,
                                                          std::size_t i) const;

    const TraceFrame& frame_;
    std::size_t surface_;
    SquareField& field_;
    const TileRays& rays_;
    Real margin_;  ///< cells are longer than their slabs by this at both ends
    FormCells<Real, FrontBlock<Real>::capacity> cells_;
    std::array<ContinuityMask<Real>, FrontBlock<Real>::capacity> branches_;
    FrontBlock<Real> fronts_;
    std::size_t filled_ = 0;  ///< how many of them hold something
    std::array<std::size_t, FrontBlock<Real>::capacity> squares_;
    /// A bit each: goes on no more.
    std::array<std::uint64_t, FrontBlock<Real>::capacity / 64> ended_;
};

template <class Real>
FrustumOf<Real> SquareCells<Real>::frustum_of(const CoverSquare& square) const {
    FrustumOf<Real> frustum = rays_.frustum<Real>(1);
    // The squares may reach half a pixel beyond the tile, and one of the tile's corners is 32
    // pixels from the image's middle or more.
    for (int i = 0; i < 3; ++i) {
        frustum.size[i] *= static_cast<Real>(1.0 + 1.0 / 16);
        frustum.direction_size[i] *= static_cast<Real>(1.0 + 1.0 / 16);
    }
    if (square.is_ray()) return frustum;
    constexpr double unit = std::numeric_limits<Real>::epsilon();
    const auto most = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
    const double radius = 0.5 * square.side * rays_.pixel();
    frustum.u_radius = upper_end(Real{}, radius + unit * most(rays_.u(-1), rays_.u(tile_size)));
    frustum.v_radius = upper_end(Real{}, radius + unit * most(rays_.v(-1), rays_.v(tile_size)));
    return frustum;
}

template <class Real>
FrontRules<Real> SquareCells<Real>::rules_of(const CoverSquare& square) const {
    const auto number = [](double value) { return upper_end(Real{}, value); };
    return {.fair_width = number(rays_.pixel() * SquareField::fair_side(square)),
            .half_width = number(0.5 * rays_.pixel() * square.side),
            .distance = number(rays_.distance()),
            .margin = margin_};
}

template <class Real>
void SquareCells<Real>::load(std::size_t i, std::size_t square) {
    const CoverSquare& of = field_.square(square);
    cells_.u[i] = static_cast<Real>(rays_.u(SquareField::col_of(of, square_middle)));
    cells_.v[i] = static_cast<Real>(rays_.v(SquareField::row_of(of, square_middle)));
    fronts_.load(i, field_.fronts(square)[surface_]);
    squares_[i] = square;
}

template <class Real>
std::size_t SquareCells<Real>::pad(std::size_t count) {
    const std::size_t size = padded(count, frame_.kernel.lane_multiple);
    for (std::size_t i = std::max(count, filled_); i < size; ++i) {
        cells_.u[i] = cells_.u[count - 1];
        cells_.v[i] = cells_.v[count - 1];
        fronts_.copy(count - 1, i);
    }
    filled_ = std::max(filled_, size);
    return size;
}

template <class Real>
std::size_t SquareCells<Real>::replace_ended(std::size_t count,
                                             std::span<const std::size_t>& waiting) {
    for (std::size_t word = 0; word < ended_.size(); ++word) {
        for (std::uint64_t bits = ended_[word]; bits != 0; bits &= bits - 1) {
            const std::size_t i = 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
            if (i >= count) return count;
            store(i);
            if (waiting.empty()) {
                count = close_gap(i, count);
            } else {
                load(i, waiting.front());
                waiting = waiting.subspan(1);
            }
        }
    }
    return count;
}

template <class Real>
std::size_t SquareCells<Real>::close_gap(std::size_t i, std::size_t count) {
    for (--count; count > i; --count) {
        if ((ended_[count / 64] >> count % 64 & 1U) == 0) break;
        store(count);
    }
    if (count == i) return count;
    cells_.u[i] = cells_.u[count];
    cells_.v[i] = cells_.v[count];
    squares_[i] = squares_[count];
    fronts_.copy(count, i);
    return count;
}

template <class Real>
void SquareCells<Real>::place_cells(std::size_t size) {
    const V<Real> half = number<Real>(0.5);
    const V<Real> margin = number<Real>(margin_);
    for (std::size_t i = 0; i < size; i += lanes<Real>) {
        const V<Real> from = hn::LoadU(d<Real>, &fronts_.at[i]);
        const V<Real> to = next_of(fronts_, i);
        const V<Real> middle = hn::Add(hn::Mul(half, from), hn::Mul(half, to));
        hn::StoreU(middle, d<Real>, &cells_.s[i]);
        const V<Real> radius = hn::Max(hn::Sub(to, middle), hn::Sub(middle, from));
        hn::StoreU(hn::Add(radius, margin), d<Real>, &cells_.s_radius[i]);
    }
}

/// The lanes in whose words a bit is set.
template <class Real>
HWY_INLINE M<Real> bit_at(const ContinuityMask<Real>* words, ContinuityMask<Real> bit) {
    return MarkWords<Real>(hn::LoadU(du<Real>, words)).has(bit);
}

template <class Real>
CellVerdict<Real> SquareCells<Real>::verdict_at(const FrontRules<Real>& rules,
                                                std::size_t i) const {
    const auto numbers = [i](const auto& of) { return hn::LoadU(d<Real>, &of[i]); };
    const CellForm<Real> form{
        .c = numbers(cells_.c),
        .along = numbers(cells_.k[2]),
        .aside = hn::Add(hn::Abs(numbers(cells_.k[0])), hn::Abs(numbers(cells_.k[1]))),
        .error = numbers(cells_.e),
        .middle = numbers(cells_.s),
        .radius = numbers(cells_.s_radius),
        .slope_hi = numbers(cells_.slope_hi),
        .slope_neg_lo = numbers(cells_.slope_neg_lo),
        .continuous = bit_at<Real>(&cells_.continuous[i], 1),
        .nowhere = bit_at<Real>(&cells_.nowhere[i], 1),
        .kinked = bit_at<Real>(&branches_[i], BranchBits::kink)};
    return judge(form, rules, fronts_, i);
}

template <class Real>
void SquareCells<Real>::take_cells(const FrontRules<Real>& rules, std::size_t size) {
    ended_ = {};
    for (std::size_t i = 0; i < size; i += lanes<Real>) {
        const M<Real> ended = step(fronts_, i, verdict_at(rules, i));
        ended_[i / 64] |= std::uint64_t{bits_of(d<Real>, ended)} << i % 64;
    }
}

template <class Real>
void SquareCells<Real>::evaluate(std::size_t count, const FrustumOf<Real>& frustum,
                                 const FrontRules<Real>& rules, Counters& counters) {
    const std::size_t size = pad(count);
    place_cells(size);
    auto batch = cells_.batch(size, frustum, frame_.scene.uniforms.template boxes<Real>());
    batch.branches = branches_.data();
    const bool in_rays = !(rules.half_width > Real{0});
    if (in_rays) {
        frame_.kernel.ray_form(batch);
    } else {
        frame_.kernel.form(batch);
    }
    counters.range += ask_unknown_signs(frame_.kernel.template in<Real>().range, frustum, in_rays,
                                        batch.uniforms, count, cells_);
    take_cells(rules, size);
}

template <class Real>
void SquareCells<Real>::advance(std::span<const std::size_t> squares, bool to_end,
                                Counters& counters) {
    const CoverSquare& model = field_.square(squares.front());
    const FrustumOf<Real> frustum = frustum_of(model);
    const FrontRules<Real> rules = rules_of(model);
    if (!frame_.kernel.branches) branches_.fill(0);
    std::size_t count = 0;
    while ((count > 0 || !squares.empty()) && !frame_.stopped()) {
        while (count < FrontBlock<Real>::capacity && !squares.empty()) {
            load(count++, squares.front());
            squares = squares.subspan(1);
        }
        counters.form += count;
        evaluate(count, frustum, rules, counters);
        if (to_end) {
            count = replace_ended(count, squares);
            continue;
        }
        for (; count > 0; --count)
            store(count - 1);
    }
}

void advance_all(const TraceFrame& frame, std::size_t surface, SquareField& field,
                 std::span<const std::size_t> squares, Counters& counters) {
    in_precision(frame, [&](auto real) {
        SquareCells<decltype(real)>(frame, surface, field)
            .advance(squares, field.is_of_one_surface(), counters);
    });
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(advance_all);

}  // namespace

void advance_fronts(const TraceFrame& frame, std::size_t surface, SquareField& field,
                    std::span<const std::size_t> squares, Counters& counters) {
    if (!squares.empty())
        HWY_DYNAMIC_DISPATCH(advance_all)(frame, surface, field, squares, counters);
}

}  // namespace zeroset

#endif
