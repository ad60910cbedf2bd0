#include "jit/llvm/lower.hpp"

#include "engine/algebra/algebra.hpp"
#include "engine/algebra/frustum.hpp"
#include "engine/algebra/graph_facts.hpp"
#include "engine/kernel/kernel.hpp"
#include "jit/llvm/batch_function.hpp"
#include "jit/llvm/contract.hpp"
#include "jit/llvm/switch_lanes.hpp"

#include <llvm/Transforms/Utils/Local.h>

#include <cstddef>

namespace zeroset::jit {
namespace {

/// The switch board for the algebra of a range or form kernel.
template <class Batch>
SwitchLanes switch_lanes(BatchFunction& function, const Expr& expr, std::span<const Facts> facts) {
    using Held = decltype(Batch::held);
    return SwitchLanes(function, offsetof(Batch, held) + offsetof(Held, words),
                       offsetof(Batch, held) + offsetof(Held, stride), offsetof(Batch, branches),
                       count_switches(switches_of(expr, facts)));
}

template <class Real>
void lower_range(const Expr& expr, std::span<const Facts> facts, const VectorKind& kind,
                 llvm::Module& module) {
    using Batch = RangeBatchOf<Real>;
    BatchFunction function(module, symbol_of(KernelKind::Range), kind, offsetof(Batch, size));
    std::array<llvm::Value*, 3> neg_lo{};
    std::array<llvm::Value*, 3> hi{};
    for (std::size_t i = 0; i < 3; ++i) {
        neg_lo[i] = function.array(offsetof(Batch, neg_lo) + i * sizeof(Real*));
        hi[i] = function.array(offsetof(Batch, hi) + i * sizeof(Real*));
    }
    llvm::Value* const uniforms = function.array(offsetof(Batch, uniforms));
    llvm::Value* const f_neg_lo = function.array(offsetof(Batch, f_neg_lo));
    llvm::Value* const f_hi = function.array(offsetof(Batch, f_hi));
    llvm::Value* const continuous = function.array(offsetof(Batch, continuous));

    // Read constants, coordinates and uniforms.
    const auto leaf = [&](const Node& node, const Facts& fact) -> Enclosure<Lanes> {
        if (fact.constant) {
            const auto box = fact.constant_box<Real>();
            return {.range = {.neg_lo = function.splat(static_cast<double>(box.neg_lo)),
                              .hi = function.splat(static_cast<double>(box.hi))}};
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v < 3)
            return {.range = {.neg_lo = function.load(neg_lo[v]), .hi = function.load(hi[v])}};
        return {.range = {.neg_lo = function.load_uniform(uniforms, 2 * (v - 3)),
                          .hi = function.load_uniform(uniforms, 2 * (v - 3) + 1)}};
    };
    auto switches = switch_lanes<Batch>(function, expr, facts);
    IntervalAlgebra<Lanes> algebra(&switches);
    const Enclosure<Lanes> f = evaluate(
        expr, facts, algebra, leaf, [&] { function.go_to_body(); }, [&] { function.count_node(); });
    // Write the answer of each box.
    const Interval<Lanes> range = answer(f);
    function.store(f_neg_lo, range.neg_lo);
    function.store(f_hi, range.hi);
    function.store(continuous,
                   conjunction(f.everywhere, f.continuous).value_or(function.everywhere()));
    if (has_branches(expr)) switches.store();
    function.finish();
}

template <class Real>
void lower_form(const Expr& expr, std::span<const Facts> facts, const VectorKind& kind,
                KernelKind part, llvm::Module& module) {
    using Batch = FormBatchOf<Real>;
    BatchFunction function(module, symbol_of(part), kind, offsetof(Batch, size));
    const auto array = [&](std::size_t offset) { return function.array(offset); };
    const std::array in{array(offsetof(Batch, u)), array(offsetof(Batch, v)),
                        array(offsetof(Batch, s)), array(offsetof(Batch, s_radius))};
    llvm::Value* const frustum = array(offsetof(Batch, frustum));
    llvm::Value* const uniforms = array(offsetof(Batch, uniforms));
    const std::array k{array(offsetof(Batch, k)), array(offsetof(Batch, k) + sizeof(Real*)),
                       array(offsetof(Batch, k) + 2 * sizeof(Real*))};
    const std::array out{array(offsetof(Batch, c)),        array(offsetof(Batch, e)),
                         array(offsetof(Batch, r)),        array(offsetof(Batch, slope_neg_lo)),
                         array(offsetof(Batch, slope_hi)), array(offsetof(Batch, continuous)),
                         array(offsetof(Batch, nowhere))};
    const auto view = frustum_lanes<Lanes>(
        [&](std::size_t index) { return function.load_uniform(frustum, index); });
    std::optional<CellLanes<Lanes>> cell;

    // Read constants, uniforms and coordinates over the cell.
    const auto leaf = [&](const Node& node, const Facts& fact) -> BeamValue<Lanes> {
        if (fact.constant) {
            return constant_form<Lanes>(
                fact, Real{}, [&](Real x) { return function.splat(static_cast<double>(x)); });
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) {
            return uniform_form<Lanes>({.neg_lo = function.load_uniform(uniforms, 2 * (v - 3)),
                                        .hi = function.load_uniform(uniforms, 2 * (v - 3) + 1)});
        }
        return part == KernelKind::RayForm ? coordinate_on_rays(view, *cell, v)
                                           : coordinate(view, *cell, v);
    };
    auto switches = switch_lanes<Batch>(function, expr, facts);
    if (part == KernelKind::RayForm && count_switches(switches_of(expr, facts)) > 0) {
        switches.make_cuts(offsetof(Batch, cut_from), offsetof(Batch, cut_to));
    }
    BeamAlgebra<Lanes> algebra(&switches);
    const auto varying = [&] {
        function.go_to_body();
        cell = {function.load(in[0]), function.load(in[1]), function.load(in[2]),
                function.load(in[3])};
    };
    const BeamValue<Lanes> f =
        evaluate(expr, facts, algebra, leaf, varying, [&] { function.count_node(); });
    // Write the form, the range of the slope and the masks.
    const FormResult<Lanes> result = form_result(f);
    for (std::size_t i = 0; i < 3; ++i)
        function.store(k[i], result.k[i]);
    function.store(out[0], result.c);
    function.store(out[1], result.e);
    function.store(out[2], result.r);
    function.store(out[3], result.slope.neg_lo);
    function.store(out[4], result.slope.hi);
    function.store(out[5], result.continuous.value_or(function.everywhere()));
    function.store(out[6], no(result.somewhere.value_or(function.everywhere())));
    if (has_branches(expr)) switches.store();
    function.finish();
}

template <class Real>
void lower_value(const Expr& expr, std::span<const Facts> facts, const VectorKind& kind,
                 KernelKind part, llvm::Module& module) {
    using Batch = ValueBatchOf<Real>;
    BatchFunction function(module, symbol_of(part), kind, offsetof(Batch, size));
    const bool with_gradient = part == KernelKind::Value;
    std::array<llvm::Value*, 3> x{};
    std::array<llvm::Value*, 3> gradient{};
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = function.array(offsetof(Batch, x) + i * sizeof(Real*));
        gradient[i] = function.array(offsetof(Batch, gradient) + i * sizeof(Real*));
    }
    llvm::Value* const uniforms = function.array(offsetof(Batch, uniforms));
    llvm::Value* const value = function.array(offsetof(Batch, f));

    const auto leaf = [&](const Node& node, const Facts& fact) -> Dual<Lanes> {
        if (fact.constant) {
            return {.value = function.splat(static_cast<double>(fact.constant_point<Real>())),
                    .slope = {}};
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) return {.value = function.load_uniform(uniforms, v - 3), .slope = {}};
        Dual<Lanes> variable{.value = function.load(x[v]), .slope = {}};
        if (with_gradient) variable.slope.set(v, function.splat(1.0));
        return variable;
    };
    DualAlgebra<Lanes> algebra;
    const Dual<Lanes> f = evaluate(
        expr, facts, algebra, leaf, [&] { function.go_to_body(); }, [&] { function.count_node(); });
    function.store(value, f.value);
    for (std::size_t i = 0; with_gradient && i < 3; ++i) {
        function.store(gradient[i], f.slope[i].value_or(function.splat(0.0)));
    }
    function.finish();
}

/// Rays of pixels: the point (x, y, z) at depth s is origin + s direction.
struct RayLanes {
    std::array<Lanes, 3> origin, direction;

    [[nodiscard]] std::array<Lanes, 3> at(const Lanes& s) const {
        return {fused(s, direction[0], origin[0]), fused(s, direction[1], origin[1]),
                fused(s, direction[2], origin[2])};
    }
};

/// A RaysOf<Real> whose numbers are loaded once, before the loop.
class RayBundle {
public:
    using Layout = RaysOf<char>;

    explicit RayBundle(auto read) {
        for (std::size_t i = 0; i < sizeof(Layout); ++i)
            numbers_.push_back(read(i));
    }
    [[nodiscard]] RayLanes of(const Lanes& col, const Lanes& row) const {
        const auto line = [&](std::size_t base, std::size_t by_col, std::size_t by_row) {
            return fused(row, numbers_[by_row], fused(col, numbers_[by_col], numbers_[base]));
        };
        const auto origin = [&](std::size_t i) {
            return line(offsetof(Layout, origin) + i, offsetof(Layout, origin_by_col) + i,
                        offsetof(Layout, origin_by_row) + i);
        };
        const auto direction = [&](std::size_t i) {
            return line(offsetof(Layout, direction) + i, offsetof(Layout, direction_by_col) + i,
                        offsetof(Layout, direction_by_row) + i);
        };
        return {.origin = {origin(0), origin(1), origin(2)},
                .direction = {direction(0), direction(1), direction(2)}};
    }

private:
    std::vector<Lanes> numbers_;
};

template <class Real>
void lower_newton(const Expr& expr, std::span<const Facts> facts, const VectorKind& kind,
                  llvm::Module& module) {
    using Batch = NewtonBatchOf<Real>;
    BatchFunction function(module, symbol_of(KernelKind::Newton), kind, offsetof(Batch, size));
    const auto array = [&](std::size_t offset) { return function.array(offset); };
    const std::array in{array(offsetof(Batch, col)), array(offsetof(Batch, row)),
                        array(offsetof(Batch, from)), array(offsetof(Batch, to)),
                        array(offsetof(Batch, s))};
    const std::array gradient{array(offsetof(Batch, gradient)),
                              array(offsetof(Batch, gradient) + sizeof(Real*)),
                              array(offsetof(Batch, gradient) + 2 * sizeof(Real*))};
    llvm::Value* const per_slope = array(offsetof(Batch, per_slope));
    llvm::Value* const uniforms = array(offsetof(Batch, uniforms));
    llvm::Value* const more_steps = function.count(offsetof(Batch, more_steps));
    const Lanes small_step = function.member_uniform(offsetof(Batch, small_step));
    llvm::Value* const rays = array(offsetof(Batch, rays));
    const RayBundle bundle([&](std::size_t i) { return function.load_uniform(rays, i); });
    std::optional<StepLoop> loop;
    std::optional<RayLanes> ray;
    std::optional<std::array<Lanes, 3>> x;

    const auto leaf = [&](const Node& node, const Facts& fact) -> Dual<Lanes> {
        if (fact.constant) {
            return {.value = function.splat(static_cast<double>(fact.constant_point<Real>())),
                    .slope = {}};
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) return {.value = function.load_uniform(uniforms, v - 3), .slope = {}};
        Dual<Lanes> variable{.value = (*x)[v], .slope = {}};
        variable.slope.set(v, function.splat(1.0));
        return variable;
    };
    const auto varying = [&] {
        function.go_to_body();
        ray = bundle.of(function.load_floats(in[0]), function.load_floats(in[1]));
        loop.emplace(function.begin_steps(function.load(in[4]), more_steps));
        x = ray->at(loop->s);
    };
    DualAlgebra<Lanes> algebra;
    const Dual<Lanes> f =
        evaluate(expr, facts, algebra, leaf, varying, [&] { function.count_node(); });
    // Make one Newton step along the ray, kept in [from, to]; repeat while it is far.
    const auto by = [&](std::size_t i) { return f.slope[i].value_or(function.splat(0.0)); };
    const Lanes along =
        fused(by(0), ray->direction[0], fused(by(1), ray->direction[1], by(2) * ray->direction[2]));
    const Lanes from = function.load(in[2]);
    const Lanes to = function.load(in[3]);
    const Lanes per_along = function.splat(1.0) / along;
    const Lanes next = minimum(maximum(loop->s - f.value * per_along, from), to);
    const LaneMask far = both(magnitude(next - loop->s) > small_step, from <= to);
    function.end_steps(*loop, next, far);
    function.store(in[4], next);
    function.store(per_slope, per_along);
    for (std::size_t i = 0; i < 3; ++i)
        function.store(gradient[i], by(i));
    function.finish();
}

void lower_ray_value(const Expr& expr, std::span<const Facts> facts, const VectorKind& kind,
                     llvm::Module& module) {
    using Batch = RayValueBatch;
    BatchFunction function(module, symbol_of(KernelKind::RayValue), kind, offsetof(Batch, size));
    const auto array = [&](std::size_t offset) { return function.array(offset); };
    const std::array in{array(offsetof(Batch, col)), array(offsetof(Batch, row)),
                        array(offsetof(Batch, per_slope)), array(offsetof(Batch, s))};
    llvm::Value* const value = array(offsetof(Batch, f));
    llvm::Value* const steps = function.count(offsetof(Batch, steps));
    const Lanes lo = function.member_uniform(offsetof(Batch, lo));
    const Lanes hi = function.member_uniform(offsetof(Batch, hi));
    llvm::Value* const uniforms = array(offsetof(Batch, uniforms));
    llvm::Value* const rays = array(offsetof(Batch, rays));
    const RayBundle bundle([&](std::size_t i) { return function.load_uniform(rays, i); });
    std::optional<StepLoop> loop;
    std::optional<std::array<Lanes, 3>> x;

    const auto leaf = [&](const Node& node, const Facts& fact) -> Dual<Lanes> {
        if (fact.constant)
            return {.value = function.splat(fact.constant_point<double>()), .slope = {}};
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) return {.value = function.load_uniform(uniforms, v - 3), .slope = {}};
        return {.value = (*x)[v], .slope = {}};
    };
    const auto varying = [&] {
        function.go_to_body();
        const RayLanes ray = bundle.of(function.load_floats(in[0]), function.load_floats(in[1]));
        loop.emplace(function.begin_steps(function.load(in[3]), steps));
        x = ray.at(loop->s);
    };
    DualAlgebra<Lanes> algebra;
    const Dual<Lanes> f =
        evaluate(expr, facts, algebra, leaf, varying, [&] { function.count_node(); });
    // Make one Newton step with the given reciprocal of the slope, kept in [lo, hi].
    const Lanes newton = loop->s - f.value * function.load_floats(in[2]);
    const Lanes next = minimum(maximum(newton, lo), hi);
    function.end_steps(*loop, next, function.everywhere());
    function.store(in[3], loop->s);
    function.store(value, f.value);
    function.finish();
}

template <class Real>
void lower_part(const Expr& expr, const VectorKind& kind, KernelKind part, llvm::Module& module) {
    const std::vector<Facts> facts = facts_of(expr);
    switch (part) {
        case KernelKind::Range: return lower_range<Real>(expr, facts, kind, module);
        case KernelKind::Value:
        case KernelKind::Points: return lower_value<Real>(expr, facts, kind, part, module);
        case KernelKind::Form: return lower_form<Real>(expr, facts, kind, part, module);
        case KernelKind::RayForm: return lower_form<Real>(expr, facts, kind, part, module);
        case KernelKind::Newton: return lower_newton<Real>(expr, facts, kind, module);
        case KernelKind::RayValue: return lower_ray_value(expr, facts, kind, module);
    }
}

/// Removes instructions that nothing uses; LLVM would do it later, at a higher price.
void remove_unused(llvm::Module& module) {
    for (llvm::Function& function : module) {
        for (llvm::BasicBlock& block : llvm::reverse(function)) {
            for (llvm::Instruction& instruction :
                 llvm::make_early_inc_range(llvm::reverse(block))) {
                if (llvm::isInstructionTriviallyDead(&instruction)) instruction.eraseFromParent();
            }
        }
    }
}

/// Whether products and sums of the part are fused; the others have the bits of the interpreter.
bool contracts(KernelKind part) {
    switch (part) {
        case KernelKind::Form:
        case KernelKind::RayForm:
        case KernelKind::Newton:
        case KernelKind::RayValue: return true;
        case KernelKind::Range:
        case KernelKind::Value:
        case KernelKind::Points: return false;
    }
    return false;
}

}  // namespace

std::unique_ptr<llvm::Module> lower(const Expr& expr, const VectorKind& kind, KernelKind part,
                                    llvm::LLVMContext& context) {
    auto module = std::make_unique<llvm::Module>("zeroset", context);
    if (kind.type == RealType::Float) {
        lower_part<float>(expr, kind, part, *module);
    } else {
        lower_part<double>(expr, kind, part, *module);
    }
    remove_unused(*module);
    if (contracts(part)) contract(*module);
    return module;
}

}  // namespace zeroset::jit
