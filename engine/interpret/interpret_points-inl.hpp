// The interpreter's loops over points and over rays. Included by interpret-inl.hpp.

#pragma once

#include "engine/algebra/algebra.hpp"
#include "engine/algebra/point_algebra.hpp"
#include "engine/interpret/block_board-inl.hpp"
#include "engine/interpret/interpret_code.hpp"
#include "engine/interpret/part_values.hpp"
#include "engine/tape/tape.hpp"

#include <new>
#include <type_traits>

namespace zeroset {
namespace {

/// The number of blocks that go through the tape together: what a step needs besides its operands
/// is looked up once for all.
constexpr std::size_t blocks_at_once = 8;

/// Makes `count` values in their places.
template <class Value, class Make>
void make_each(Value* to, std::size_t count, Make make) {
    for (std::size_t i = 0; i < count; ++i)
        new (to + i) Value(make(i));
}

/// Computes one of the commonest operators on values without slopes, with the bits of `apply`, for
/// some blocks; false, and nothing is done, for all others.
template <class Lanes>
bool compute_common(const Node& node, const Lanes* a, const Lanes* b, std::size_t blocks,
                    Lanes* to) {
    const auto each = [&](auto make) {
        make_each(to, blocks, [&](std::size_t i) { return make(a[i], b[i]); });
        return true;
    };
    const Op op = node.op;
    if (op == Op::Add) return each([](const Lanes& x, const Lanes& y) { return x + y; });
    if (op == Op::Subtract) return each([](const Lanes& x, const Lanes& y) { return x - y; });
    if (op == Op::Multiply) return each([](const Lanes& x, const Lanes& y) { return x * y; });
    if (op == Op::IntPower) {
        const int below = node.number - 1;
        return each([&](const Lanes& x, const Lanes&) { return point_power(x, below) * x; });
    }
    // Duals would compute the one for the value, the other for the slope.
    if (op == Op::Sin || op == Op::Cos) {
        const Elementary function = op == Op::Sin ? Elementary::Sin : Elementary::Cos;
        return each([&](const Lanes& x, const Lanes&) { return elementary(function, x); });
    }
    return false;
}

/// Evaluates the tape over the points of `size` lanes. `leaf`, `part` and `finish` as in
/// interpret_blocks.
template <class Algebra, std::size_t lanes, class Leaf, class OfPart, class Finish>
void interpret_points(const Tape& tape, std::size_t size, Leaf leaf, OfPart part, Finish finish) {
    using Value = typename Algebra::Value;
    static_assert(std::is_trivially_destructible_v<Value>);
    static_assert(alignof(Value) <= Scratch::alignment);
    Algebra algebra;
    const Scratch scratch(tape.slots() * blocks_at_once * sizeof(Value));
    auto* const values = static_cast<Value*>(scratch.data());
    const std::span<const Tape::Step> steps = tape.steps();
    const Parts& parts = tape.graph()->parts;
    const auto compute = [&](const Tape::Step& step, std::size_t first, std::size_t blocks) {
        const Node& node = tape.node(step);
        const Facts& facts = tape.facts(step);
        Value* const to = values + step.slot * blocks_at_once;
        if (const std::uint32_t index = tape.part(step); index != Parts::none) {
            const Part& of = parts.parts[index];
            make_each(to, blocks, [&](std::size_t b) {
                return part(parts.shapes[of.shape], of, first + b * lanes);
            });
            return;
        }
        if (is_leaf(node, facts)) {
            make_each(to, blocks,
                      [&](std::size_t b) { return leaf(node, facts, first + b * lanes); });
            return;
        }
        const auto operands = static_cast<std::size_t>(arity(node.op));
        const auto step_of = [&](std::size_t k) -> const Tape::Step& {
            return steps[step.operands[k < operands ? k : 0]];
        };
        const std::array of{&step_of(0), &step_of(1), &step_of(2)};
        if constexpr (std::is_same_v<Algebra, PointAlgebra<Value>>) {
            const auto values_of = [&](std::size_t k) {
                return values + of[k]->slot * blocks_at_once;
            };
            if (compute_common(node, values_of(0), values_of(1), blocks, to)) return;
        }
        const auto operand = [&](std::size_t k, std::size_t b) {
            return Operand<Value>{values[of[k]->slot * blocks_at_once + b], tape.facts(*of[k])};
        };
        make_each(to, blocks, [&](std::size_t b) {
            return apply(algebra, node, operand(0, b), operand(1, b), operand(2, b));
        });
    };
    for (const Tape::Step& step : steps.first(tape.uniform_steps())) {
        compute(step, 0, 1);
        Value* const to = values + step.slot * blocks_at_once;
        make_each(to + 1, blocks_at_once - 1, [&](std::size_t /*b*/) { return *to; });
    }
    const auto varying = steps.subspan(tape.uniform_steps());
    for (std::size_t first = 0; first < size; first += blocks_at_once * lanes) {
        const std::size_t blocks = std::min(blocks_at_once, (size - first) / lanes);
        for (const Tape::Step& step : varying)
            compute(step, first, blocks);
        const Value* const roots = values + tape.root().slot * blocks_at_once;
        for (std::size_t b = 0; b < blocks; ++b)
            finish(roots[b], first + b * lanes);
    }
}

/// A constant or a uniform at points.
template <class Real, std::size_t bytes>
Block<Real, bytes> uniform_point(const Node& node, const Facts& facts, const Real* uniforms) {
    if (facts.constant) return Block<Real, bytes>::splat(facts.constant_point<Real>());
    return Block<Real, bytes>::splat(uniforms[static_cast<std::size_t>(node.number) - 3]);
}

inline bool is_coordinate(const Node& node, const Facts& facts) {
    return !facts.constant && node.number < 3;
}

template <class Real, std::size_t bytes>
void interpret_value(const void* code, const ValueBatchOf<Real>* batch) {
    using Lanes = Block<Real, bytes>;
    const auto leaf = [&](const Node& node, const Facts& facts, std::size_t i) -> Dual<Lanes> {
        if (!is_coordinate(node, facts))
            return {uniform_point<Real, bytes>(node, facts, batch->uniforms), {}};
        const auto v = static_cast<std::size_t>(node.number);
        Dual<Lanes> variable{load<Lanes>(batch->x[v] + i), {}};
        variable.slope.set(v, Lanes::splat(1));
        return variable;
    };
    const auto of_part = [&](const PartShape& shape, const Part& part, std::size_t i) {
        return part_value<Real, bytes>(shape, part, *batch, i);
    };
    const auto finish = [&](const Dual<Lanes>& f, std::size_t i) {
        store(batch->f + i, f.value);
        for (std::size_t k = 0; k < 3; ++k)
            store(batch->gradient[k] + i, f.slope.has(k) ? f.slope.known(k) : Lanes::splat(0));
    };
    interpret_points<DualAlgebra<Lanes>, Lanes::lanes>(*static_cast<const Tape*>(code), batch->size,
                                                       leaf, of_part, finish);
}

/// Leaves the batch's gradient alone, unless parts have code: they write theirs.
template <class Real, std::size_t bytes>
void interpret_point_values(const void* code, const ValueBatchOf<Real>* batch) {
    using Lanes = Block<Real, bytes>;
    const auto leaf = [&](const Node& node, const Facts& facts, std::size_t i) -> Lanes {
        if (!is_coordinate(node, facts))
            return uniform_point<Real, bytes>(node, facts, batch->uniforms);
        return load<Lanes>(batch->x[static_cast<std::size_t>(node.number)] + i);
    };
    const auto of_part = [&](const PartShape& shape, const Part& part, std::size_t i) {
        return part_value<Real, bytes>(shape, part, *batch, i).value;
    };
    const auto finish = [&](const Lanes& f, std::size_t i) { store(batch->f + i, f); };
    interpret_points<PointAlgebra<Lanes>, Lanes::lanes>(*static_cast<const Tape*>(code),
                                                        batch->size, leaf, of_part, finish);
}

/// a b + c with one rounding on every machine.
template <class Real, std::size_t bytes>
Block<Real, bytes> fused_once(const Block<Real, bytes>& a, const Block<Real, bytes>& b,
                              const Block<Real, bytes>& c) {
    if constexpr (bytes > 16) return fused(a, b, c);
    constexpr std::size_t lanes = Block<Real, bytes>::lanes;
    std::array<Real, lanes> x;
    std::array<Real, lanes> y;
    std::array<Real, lanes> z;
    store(x.data(), a);
    store(y.data(), b);
    store(z.data(), c);
    for (std::size_t i = 0; i < lanes; ++i)
        z[i] = std::fma(x[i], y[i], z[i]);
    return load<Block<Real, bytes>>(z.data());
}

/// Points on the rays of some pixels, and what f is there.
template <class Real, std::size_t bytes>
class RayPoints {
public:
    using Lanes = Block<Real, bytes>;
    static constexpr std::size_t lanes = Lanes::lanes;
    /// The pixels that are evaluated at a time.
    static constexpr std::size_t most_pixels = 4 * Block<float>::lanes;
    static_assert(most_pixels % batch_multiple == 0);
    using Columns = std::array<Lanes, most_pixels / lanes>;

    /// The rays of `count` pixels. Fused: ray_roundings() counts on it.
    void place(const Real* numbers, const float* col, const float* row, std::size_t count) {
        const auto& rays = *reinterpret_cast<const RaysOf<Real>*>(numbers);
        count_ = count;
        for (std::size_t b = 0; b < count / lanes; ++b) {
            const Lanes c = widened(col + b * lanes);
            const Lanes r = widened(row + b * lanes);
            const auto at = [&](Real by_row, Real by_col, Real middle) {
                const Lanes in_row = fused_once(c, Lanes::splat(by_col), Lanes::splat(middle));
                return fused_once(r, Lanes::splat(by_row), in_row);
            };
            for (std::size_t k = 0; k < 3; ++k) {
                origin_[k][b] = at(rays.origin_by_row[k], rays.origin_by_col[k], rays.origin[k]);
                direction_[k][b] =
                    at(rays.direction_by_row[k], rays.direction_by_col[k], rays.direction[k]);
            }
        }
    }

    /// f, by a function of the tape, at these depths.
    template <class Function>
    void evaluate(Function function, const void* tape, const Real* uniforms, const Real* s) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t b = 0; b < count_ / lanes; ++b)
                x_[k][b] = fused_once(load<Lanes>(s + b * lanes), direction_[k][b], origin_[k][b]);
        }
        const ValueBatchOf<Real> batch{
            count_,
            {numbers_of(x_[0]), numbers_of(x_[1]), numbers_of(x_[2])},
            uniforms,
            numbers_of(f_),
            {numbers_of(gradient_[0]), numbers_of(gradient_[1]), numbers_of(gradient_[2])}};
        function(tape, &batch);
    }

    [[nodiscard]] const Lanes& f(std::size_t b) const { return f_[b]; }
    [[nodiscard]] const Lanes& gradient(std::size_t k, std::size_t b) const {
        return gradient_[k][b];
    }
    [[nodiscard]] const Lanes& direction(std::size_t k, std::size_t b) const {
        return direction_[k][b];
    }

private:
    static Real* numbers_of(Columns& columns) { return reinterpret_cast<Real*>(columns.data()); }
    static Lanes widened(const float* numbers) {
        std::array<Real, lanes> wide;
        std::copy_n(numbers, lanes, wide.begin());
        return load<Lanes>(wide.data());
    }

    std::size_t count_ = 0;
    std::array<Columns, 3> origin_, direction_, x_, gradient_;
    Columns f_;
};

/// One step of `count` pixels from `first` on; whether another is wanted.
template <class Real, std::size_t bytes>
bool take_step(const NewtonBatchOf<Real>& batch, std::size_t first, std::size_t count,
               const RayPoints<Real, bytes>& points) {
    using Lanes = Block<Real, bytes>;
    unsigned again = 0;
    for (std::size_t b = 0; b < count / Lanes::lanes; ++b) {
        const std::size_t i = first + b * Lanes::lanes;
        Lanes slope = Lanes::splat(0);
        for (std::size_t k = 0; k < 3; ++k) {
            slope = slope + points.gradient(k, b) * points.direction(k, b);
            store(batch.gradient[k] + i, points.gradient(k, b));
        }
        const auto s = load<Lanes>(batch.s + i);
        const auto from = load<Lanes>(batch.from + i);
        const auto to = load<Lanes>(batch.to + i);
        const Lanes per_slope = Lanes::splat(1) / slope;
        const Lanes newton = s - points.f(b) * per_slope;
        const Lanes behind = select(newton > from, newton, from);  // `from` where NaN
        const Lanes next = select(to < behind, to, behind);
        const BlockMask far = magnitude(next - s) > Lanes::splat(batch.small_step);
        again |= both(from <= to, far).bits;
        store(batch.per_slope + i, per_slope);
        store(batch.s + i, next);
    }
    return again != 0;
}

template <class Real, std::size_t bytes>
void interpret_newton(const void* code, const NewtonBatchOf<Real>* batch) {
    RayPoints<Real, bytes> points;
    for (std::size_t first = 0; first < batch->size; first += points.most_pixels) {
        const std::size_t count = std::min(points.most_pixels, batch->size - first);
        points.place(batch->rays, batch->col + first, batch->row + first, count);
        for (int step = 0; step <= batch->more_steps; ++step) {
            points.evaluate(interpret_value<Real, bytes>, code, batch->uniforms, batch->s + first);
            if (!take_step(*batch, first, count, points)) break;
        }
    }
}

template <std::size_t bytes>
void interpret_ray_value(const void* code, const RayValueBatch* batch) {
    using Lanes = Block<double, bytes>;
    RayPoints<double, bytes> points;
    for (std::size_t first = 0; first < batch->size; first += points.most_pixels) {
        const std::size_t count = std::min(points.most_pixels, batch->size - first);
        points.place(batch->rays, batch->col + first, batch->row + first, count);
        for (int step = 0;; ++step) {
            double* const s = batch->s + first;
            points.evaluate(interpret_point_values<double, bytes>, code, batch->uniforms, s);
            if (step == batch->steps) break;
            for (std::size_t b = 0; b < count / Lanes::lanes; ++b) {
                const std::size_t i = b * Lanes::lanes;
                std::array<double, Lanes::lanes> per_slope;
                std::copy_n(batch->per_slope + first + i, Lanes::lanes, per_slope.begin());
                const Lanes newton =
                    load<Lanes>(s + i) - points.f(b) * load<Lanes>(per_slope.data());
                const Lanes lo = Lanes::splat(batch->lo);
                const Lanes hi = Lanes::splat(batch->hi);
                const Lanes above = select(newton > lo, newton, lo);  // lo where NaN
                store(s + i, select(hi < above, hi, above));
            }
        }
        for (std::size_t b = 0; b < count / Lanes::lanes; ++b)
            store(batch->f + first + b * Lanes::lanes, points.f(b));
    }
}

}  // namespace
}  // namespace zeroset
