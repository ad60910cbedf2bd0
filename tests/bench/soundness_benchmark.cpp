#include "engine/algebra/algebra.hpp"
#include "engine/algebra/graph_facts.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "jit/compile.hpp"
#include "jit/llvm/batch_function.hpp"
#include "jit/llvm/orc.hpp"
#include "pipeline/gallery.hpp"
#include "tests/bench/plain_algebra.hpp"
#include "tests/bench/samples.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The cost of soundness: the engine's range kernels, (-lo, hi) in upward rounding, against plain
// ones, (lo, hi) to nearest, of the same graph by the same compiler and of the same lanes, turn by
// turn in one run. For each algebraic surface of the gallery: ns for 8 boxes of the sound kernel,
// of the careful plain one, which is as wide where nothing is known, and of the bare one; the
// ratios of the first to the others, and at the end the geometric means of the ratios.

namespace zeroset::test {
namespace {

using Clock = std::chrono::steady_clock;

/// Whether the plain algebra knows the operator.
bool is_algebraic(Op op) {
    static constexpr Op known[] = {Op::Constant, Op::Variable, Op::Negate, Op::Add,
                                   Op::Subtract, Op::Multiply, Op::Divide, Op::IntPower,
                                   Op::Sqrt,     Op::Abs,      Op::Min,    Op::Max};
    return std::ranges::find(known, op) != std::end(known);
}

PlainRange plain_apply(const PlainAlgebra& plain, const Node& node, const Operand<PlainRange>& a,
                       const Operand<PlainRange>& b) {
    if (node.op == Op::Negate) return PlainAlgebra::negate(a.value);
    if (node.op == Op::Add) return PlainAlgebra::add(a.value, b.value);
    if (node.op == Op::Subtract) return PlainAlgebra::subtract(a.value, b.value);
    if (node.op == Op::Multiply) return plain.multiply(a, b);
    if (node.op == Op::Divide) return plain.divide(a.value, b.value);
    if (node.op == Op::IntPower) return PlainAlgebra::int_power(a, node.number);
    if (node.op == Op::Sqrt) return PlainAlgebra::sqrt(a);
    if (node.op == Op::Abs) return PlainAlgebra::abs(a);
    if (node.op == Op::Min) return PlainAlgebra::min(a.value, b.value);
    return PlainAlgebra::max(a.value, b.value);
}

/// A batch's arrays called neg_lo are those of lo here.
std::unique_ptr<llvm::Module> lower_plain(const Expr& expr, const PlainAlgebra& plain,
                                          const jit::VectorKind& kind, llvm::LLVMContext& context) {
    auto module = std::make_unique<llvm::Module>("plain", context);
    const std::vector<Facts> facts = facts_of(expr);
    jit::BatchFunction function(*module, jit::symbol_of(jit::KernelKind::Range), kind,
                                offsetof(RangeBatch, size));
    const auto array = [&](std::size_t offset, std::size_t i) {
        return function.array(offset + i * sizeof(float*));
    };
    llvm::Value* lo[3];
    llvm::Value* hi[3];
    for (std::size_t i = 0; i < 3; ++i) {
        lo[i] = array(offsetof(RangeBatch, neg_lo), i);
        hi[i] = array(offsetof(RangeBatch, hi), i);
    }
    llvm::Value* const uniforms = array(offsetof(RangeBatch, uniforms), 0);
    llvm::Value* const f_lo = array(offsetof(RangeBatch, f_neg_lo), 0);
    llvm::Value* const f_hi = array(offsetof(RangeBatch, f_hi), 0);

    std::vector<std::optional<PlainRange>> values(expr.nodes().size());
    const auto leaf = [&](const Node& node, const Facts& fact) -> PlainRange {
        if (fact.constant) {
            const auto middle = function.splat(static_cast<double>(fact.middle_float));
            return {middle, middle};
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v < 3) return {function.load(lo[v]), function.load(hi[v])};
        return {function.load_uniform(uniforms, 2 * (v - 3)),
                function.load_uniform(uniforms, 2 * (v - 3) + 1)};
    };
    const auto compute = [&](NodeId id) -> PlainRange {
        const Node& node = expr.node(id);
        if (is_leaf(node, facts[id])) return leaf(node, facts[id]);
        const NodeId b = arity(node.op) < 2 ? node.a : node.b;
        return plain_apply(plain, node, {*values[node.a], facts[node.a]}, {*values[b], facts[b]});
    };
    for (NodeId id = 0; id <= expr.root(); ++id) {
        if (facts[id].uniform) values[id] = compute(id);
    }
    function.go_to_body();
    for (NodeId id = 0; id <= expr.root(); ++id) {
        if (facts[id].uniform) continue;
        values[id] = compute(id);
        function.count_node();
    }
    function.store(f_lo, values.back()->lo);
    function.store(f_hi, values.back()->hi);
    function.finish();
    return module;
}

/// Samples with the plain algebra's boxes, whose lower ends are not negated.
Samples<float> plain_samples(const GalleryItem& item) {
    Samples<float> samples(item);
    for (auto& ends : samples.neg_lo) {
        for (float& end : ends)
            end = -end;
    }
    for (std::size_t i = 0; i < samples.uniforms.neg_lo_hi.size(); i += 2)
        samples.uniforms.neg_lo_hi[i] = -samples.uniforms.neg_lo_hi[i];
    return samples;
}

using RangeCode = void (*)(const void* code, const RangeBatch* batch);

/// A kernel of either kind with its boxes and its rounding mode, timed turn by turn.
template <int mode>
class Side {
public:
    Side(RangeCode code, Samples<float> samples) : code_(code), samples_(std::move(samples)) {}

    /// Runs the batch some times and keeps the least time.
    void run() {
        constexpr int times = 16;
        const RangeBatch batch = samples_.range_batch(f_neg_lo_, f_hi_, continuous_);
        const RoundingGuard<mode> guard;
        const auto start = Clock::now();
        for (int i = 0; i < times; ++i) {
            code_(nullptr, &batch);
            benchmark::ClobberMemory();
        }
        const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
        least_ = std::min(least_, elapsed.count() / (times * items_of_8));
    }
    /// The least time of 8 boxes.
    [[nodiscard]] double least_ns() const { return least_; }

private:
    RangeCode code_;
    Samples<float> samples_;
    std::vector<float> f_neg_lo_ = std::vector<float>(items);
    std::vector<float> f_hi_ = std::vector<float>(items);
    std::vector<std::uint32_t> continuous_ = std::vector<std::uint32_t>(items);
    double least_ = infinity;
};

/// Natural logarithms of the ratios measured, by surface.
struct LogRatios {
    std::map<std::string, double> to_careful, to_bare;
};

LogRatios& log_ratios() {
    static LogRatios all;
    return all;
}

std::expected<std::shared_ptr<const jit::MachineCode>, jit::CompileError> plain_code(
    const Expr& expr, bool careful) {
    return jit::make_code(
        [&](llvm::LLVMContext& context) {
            return lower_plain(expr, PlainAlgebra(careful), {RealType::Float, jit::host_lanes()},
                               context);
        },
        jit::symbol_of(jit::KernelKind::Range), false);
}

void time_all(benchmark::State& state, const GalleryItem& item, const Expr& expr) {
    const auto kernel = jit::compile(expr);
    const auto careful_code = plain_code(expr, true);
    const auto bare_code = plain_code(expr, false);
    if (!kernel || !careful_code || !bare_code) return state.SkipWithError("does not compile");
    Side<FE_UPWARD> sound(kernel->in_float.range.call, Samples<float>(item));
    Side<FE_TONEAREST> careful(reinterpret_cast<RangeCode>((*careful_code)->entry()),
                               plain_samples(item));
    Side<FE_TONEAREST> bare(reinterpret_cast<RangeCode>((*bare_code)->entry()),
                            plain_samples(item));
    for (auto _ : state) {
        sound.run();
        careful.run();
        bare.run();
    }
    const double to_careful = sound.least_ns() / careful.least_ns();
    const double to_bare = sound.least_ns() / bare.least_ns();
    state.counters["sound_ns"] = sound.least_ns();
    state.counters["careful_ns"] = careful.least_ns();
    state.counters["bare_ns"] = bare.least_ns();
    state.counters["to_careful"] = to_careful;
    state.counters["to_bare"] = to_bare;
    log_ratios().to_careful[item.name] = std::log(to_careful);
    log_ratios().to_bare[item.name] = std::log(to_bare);
}

void register_benchmarks() {
    for (const GalleryItem& item : gallery()) {
        const auto expr = parse(item.equation);
        if (!expr) continue;
        const auto known = [](const Node& node) { return is_algebraic(node.op); };
        if (!std::ranges::all_of(expr->nodes(), known)) continue;
        benchmark::RegisterBenchmark(item.name.c_str(), [&item, expr](benchmark::State& state) {
            time_all(state, item, *expr);
        })->Iterations(2000);
    }
}

void print_mean(const char* name, const std::map<std::string, double>& all) {
    double sum = 0.0;
    for (const auto& [surface, log_ratio] : all)
        sum += log_ratio;
    const auto count = static_cast<double>(all.size());
    if (count > 0) {
        std::printf("geometric mean of %g ratios to %s: %.3f\n", count, name,
                    std::exp(sum / count));
    }
}

}  // namespace
}  // namespace zeroset::test

int main(int argc, char** argv) {
    zeroset::test::register_benchmarks();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    zeroset::test::print_mean("careful", zeroset::test::log_ratios().to_careful);
    zeroset::test::print_mean("bare", zeroset::test::log_ratios().to_bare);
}
