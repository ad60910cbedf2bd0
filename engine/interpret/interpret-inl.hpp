// The interpreter's loops over blocks of lanes, for registers of some bytes. Included by one
// translation unit for each, which has included the standard library before.

#pragma once

#include "engine/algebra/algebra.hpp"
#include "engine/algebra/frustum.hpp"
#include "engine/interpret/block_board-inl.hpp"
#include "engine/interpret/block_choice.hpp"
#include "engine/interpret/interpret_code.hpp"
#include "engine/interpret/interpret_points-inl.hpp"
#include "engine/interpret/part_values.hpp"
#include "engine/real/block.hpp"
#include "engine/tape/tape.hpp"

#include <new>
#include <type_traits>

namespace zeroset {
namespace {

static_assert(batch_multiple * sizeof(float) % block_bytes == 0);

template <class Algebra, class Board>
Algebra algebra_with(Board& board) {
    if constexpr (std::is_constructible_v<Algebra, Board*>) {
        return Algebra(&board);
    } else {
        return Algebra();
    }
}

/// Makes choices as other operators are made.
struct NoChoices {
    template <class Algebra, class Values, class Value>
    bool operator()(Algebra& /*algebra*/, const Tape::Step& /*step*/, std::size_t /*item*/,
                    const Values& /*of*/, Value* /*place*/) const {
        return false;
    }
};

/// Evaluates the tape over `size` items by blocks of some lanes. `leaf(node, facts, item)` makes
/// the value of a variable or a constant subexpression, for a uniform one whatever the item;
/// `part(shape, part, item)` that of a part; `finish(root, item)` takes the results.
/// `board` is told of switches. `choose(algebra, step, item, operand, place)`, with a function that
/// gives operands, is asked for choices that are not uniform; it answers whether it made them in
/// their place.
template <class Algebra, std::size_t lanes, class Board, class Leaf, class OfPart, class Finish,
          class Choose = NoChoices>
void interpret_blocks(const Tape& tape, std::size_t size, Board&& board, Leaf leaf, OfPart part,
                      Finish finish, Choose choose = {}) {
    using Value = typename Algebra::Value;
    static_assert(std::is_trivially_destructible_v<Value>);
    auto algebra = algebra_with<Algebra>(board);
    static_assert(alignof(Value) <= Scratch::alignment);
    const Scratch scratch(tape.slots() * sizeof(Value));
    auto* const values = static_cast<Value*>(scratch.data());
    const std::span<const Tape::Step> steps = tape.steps();
    const Parts& parts = tape.graph()->parts;
    const auto compute = [&](const Tape::Step& step, std::size_t item) {
        const Node& node = tape.node(step);
        const Facts& facts = tape.facts(step);
        Value* const value = values + step.slot;
        const auto operand = [&](std::size_t k) {
            const Tape::Step& of = steps[step.operands[k]];
            return Operand<Value>{values[of.slot], tape.facts(of)};
        };
        // Made in its place, which no operand has: copying would cost as much as computing.
        if (const std::uint32_t index = tape.part(step); index != Parts::none) {
            const Part& of = parts.parts[index];
            new (value) Value(part(parts.shapes[of.shape], of, item));
            return;
        }
        if (is_leaf(node, facts)) {
            new (value) Value(leaf(node, facts, item));
            return;
        }
        if (step.choice != Tape::no_choice && choose(algebra, step, item, operand, value)) return;
        enter_switch(algebra, step.own_switch);
        const int operands = arity(node.op);
        new (value) Value(apply(algebra, node, operand(0), operand(operands < 2 ? 0 : 1),
                                operand(operands < 3 ? 0 : 2)));
    };
    for (const Tape::Step& step : steps.first(tape.uniform_steps()))
        compute(step, 0);
    const auto varying = steps.subspan(tape.uniform_steps());
    for (std::size_t item = 0; item < size; item += lanes) {
        board.begin(item);
        for (const Tape::Step& step : varying)
            compute(step, item);
        board.end();
        finish(values[tape.root().slot], item);
    }
}

template <class Real, std::size_t bytes>
void interpret_range(const void* code, const RangeBatchOf<Real>* batch) {
    using Lanes = Block<Real, bytes>;
    const auto leaf = [&](const Node& node, const Facts& facts, std::size_t i) -> Enclosure<Lanes> {
        if (facts.constant) {
            const auto box = facts.constant_box<Real>();
            return {{Lanes::splat(box.neg_lo), Lanes::splat(box.hi)}};
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v < 3) return {{load<Lanes>(batch->neg_lo[v] + i), load<Lanes>(batch->hi[v] + i)}};
        return {{Lanes::splat(batch->uniforms[2 * (v - 3)]),
                 Lanes::splat(batch->uniforms[2 * (v - 3) + 1])}};
    };
    const auto of_part = [&](const PartShape& shape, const Part& part, std::size_t i) {
        return part_range<Real, bytes>(shape, part, *batch, i);
    };
    const auto finish = [&](const Enclosure<Lanes>& f, std::size_t i) {
        const Interval<Lanes> range = answer(f);
        store(batch->f_neg_lo + i, range.neg_lo);
        store(batch->f_hi + i, range.hi);
        store<Real>(batch->continuous + i, conjunction(f.everywhere, f.continuous), true);
    };
    interpret_blocks<IntervalAlgebra<Lanes>, Lanes::lanes>(
        *static_cast<const Tape*>(code), batch->size,
        BlockBoard<Real, bytes>(batch->held, batch->branches), leaf, of_part, finish);
}

/// Stores the results of the block of cells from i on.
template <class Lanes, class Real>
void store_form(const FormResult<Lanes>& result, const FormBatchOf<Real>& batch, std::size_t i) {
    store(batch.c + i, result.c);
    for (std::size_t k = 0; k < 3; ++k)
        store(batch.k[k] + i, result.k[k]);
    store(batch.e + i, result.e);
    store(batch.r + i, result.r);
    store(batch.slope_neg_lo + i, result.slope.neg_lo);
    store(batch.slope_hi + i, result.slope.hi);
    store<Real>(batch.continuous + i, result.continuous, true);
    std::optional<BlockMask> nowhere = result.somewhere;
    if (nowhere) nowhere = no(*nowhere);
    store<Real>(batch.nowhere + i, nowhere, false);
}

/// How a choice by conditions falls; `of` returns its operands.
ChoiceBits choice_of_condition(Op op, const auto& of) {
    if (op == Op::And || op == Op::Or) return choice_by_logic(op, of(0).value, of(1).value);
    return choice_by_condition(op, of(op == Op::If ? 0 : 1).value);
}

/// `record`: of how choices fall; then the form may be that of a function with the same signs and
/// zeros.
template <class Real, std::size_t bytes>
void interpret_cells(const Tape& tape, const FormBatchOf<Real>* batch, bool on_rays,
                     ChoiceRecord* record) {
    using Lanes = Block<Real, bytes>;
    const auto view = frustum_lanes<Lanes>(
        [&](std::size_t index) { return Lanes::splat(batch->frustum[index]); });
    const auto leaf = [&](const Node& node, const Facts& facts, std::size_t i) -> BeamValue<Lanes> {
        if (facts.constant) {
            return constant_form<Lanes>(facts, Real{}, [](Real x) { return Lanes::splat(x); });
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) {
            return uniform_form<Lanes>({Lanes::splat(batch->uniforms[2 * (v - 3)]),
                                        Lanes::splat(batch->uniforms[2 * (v - 3) + 1])});
        }
        return coordinate<Lanes>(view,
                                 {load<Lanes>(batch->u + i), load<Lanes>(batch->v + i),
                                  load<Lanes>(batch->s + i), load<Lanes>(batch->s_radius + i)},
                                 v);
    };
    BlockBoard<Real, bytes> board(batch->held, batch->branches, batch->cut_from, batch->cut_to);
    const auto of_part = [&](const PartShape& shape, const Part& part, std::size_t i) {
        BeamValue<Lanes> value;
        board.report_kink(part_form<Real, bytes>(shape, part, *batch, i, on_rays, value));
        return value;
    };
    const auto finish = [&](const BeamValue<Lanes>& f, std::size_t i) {
        store_form(form_result(f), *batch, i);
    };
    const auto choose = [&](BeamAlgebra<Lanes>& algebra, const Tape::Step& step, std::size_t i,
                            const auto& of, BeamValue<Lanes>* place) {
        const Op op = tape.node(step).op;
        const bool extreme = op == Op::Min || op == Op::Max || op == Op::SmoothMin;
        const auto tell = [&](Tape::Index choice, const ChoiceBits& bits) {
            record->bits[i / Lanes::lanes * record->choices + choice] = bits;
        };
        if (!extreme) {
            if (record != nullptr) tell(step.choice, choice_of_condition(op, of));
            return false;
        }
        ChoiceBits left_out{};
        if (record != nullptr) {
            const Band band = band_of_alternative(op, step.band);
            left_out = choice_by_band(op, of(0).value, of(1).value, band);
        }
        const ChoiceBits bits = make_extreme(algebra, op, of(0), of(1), left_out, place);
        if (step.height > 0) narrow_to(step.height, *place);
        if (record == nullptr) return true;
        tell(step.choice, bits);
        if (step.tells != Tape::no_choice) tell(step.tells, left_out);
        return true;
    };
    interpret_blocks<BeamAlgebra<Lanes>, Lanes::lanes>(tape, batch->size, board, leaf, of_part,
                                                       finish, choose);
}

template <class Real, std::size_t bytes>
void interpret_form(const void* code, const FormBatchOf<Real>* batch) {
    interpret_cells<Real, bytes>(*static_cast<const Tape*>(code), batch, false, nullptr);
}

template <class Real, std::size_t bytes>
void interpret_ray_form(const void* code, const FormBatchOf<Real>* batch) {
    interpret_cells<Real, bytes>(*static_cast<const Tape*>(code), batch, true, nullptr);
}

template <class Real, std::size_t bytes>
void record_form(const Tape& tape, const FormBatchOf<Real>& batch, ChoiceRecord& record) {
    interpret_cells<Real, bytes>(tape, &batch, false, &record);
}

template <class Real, std::size_t bytes>
constexpr InterpreterCode::In<Real> functions_in() {
    return {
#define ZEROSET_KERNEL_FUNCTION(name, kind, Batch) .name = interpret_##name<Real, bytes>,
#include "engine/kernel/kernel_functions.def"
        .record = record_form<Real, bytes>,
    };
}

template <std::size_t bytes>
constexpr InterpreterCode interpreter_code_of() {
    return {.in_float = functions_in<float, bytes>(),
            .in_double = functions_in<double, bytes>(),
            .ray_value = interpret_ray_value<bytes>,
            .points = interpret_point_values<double, bytes>};
}

}  // namespace
}  // namespace zeroset
