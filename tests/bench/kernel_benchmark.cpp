#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "jit/compile.hpp"
#include "pipeline/gallery.hpp"
#include "tests/bench/samples.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <string>
#include <type_traits>
#include <vector>

// The cost of a kernel, for each surface of the benchmark suite: ns for 8 boxes, ns for 8 points,
// in float and in double, and the time from graph to machine code.

namespace zeroset::test {
namespace {

Kernel kernel_of(const GalleryItem& item, benchmark::State& state, bool with_double) {
    const auto expr = parse(item.equation);
    if (!expr) {
        state.SkipWithError(expr.error().reason.c_str());
        return {};
    }
    auto kernel = jit::compile(*expr, {.with_double = with_double});
    if (!kernel) {
        state.SkipWithError(kernel.error().message.c_str());
        return {};
    }
    return *kernel;
}

void report_per_8(benchmark::State& state) {
    state.counters["per_8"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * items_of_8,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Real>
void time_range(benchmark::State& state, const GalleryItem& item) {
    const Kernel kernel = kernel_of(item, state, std::is_same_v<Real, double>);
    if (!kernel) return;
    const Samples<Real> in(item);
    std::vector<Real> f_neg_lo(items);
    std::vector<Real> f_hi(items);
    std::vector<ContinuityMask<Real>> continuous(items);
    const RangeBatchOf<Real> batch = in.range_batch(f_neg_lo, f_hi, continuous);
    const UpwardRounding upward;
    for (auto _ : state) {
        kernel.range(batch);
        benchmark::ClobberMemory();
    }
    report_per_8(state);
}

template <class Real>
void time_value(benchmark::State& state, const GalleryItem& item) {
    const Kernel kernel = kernel_of(item, state, std::is_same_v<Real, double>);
    if (!kernel) return;
    const Samples<Real> in(item);
    std::array<std::vector<Real>, 4> out;
    for (auto& values : out)
        values.resize(items);
    const ValueBatchOf<Real> batch{items,
                                   {in.x[0].data(), in.x[1].data(), in.x[2].data()},
                                   in.uniforms.template points<Real>(),
                                   out[0].data(),
                                   {out[1].data(), out[2].data(), out[3].data()}};
    const UpwardRounding upward;
    for (auto _ : state) {
        kernel.value(batch);
        benchmark::ClobberMemory();
    }
    report_per_8(state);
}

/// Each time another graph, so that none comes from the cache.
void time_compile(benchmark::State& state, const GalleryItem& item, bool with_double) {
    static int number = 0;
    for (auto _ : state) {
        state.PauseTiming();
        const auto expr = parse("(" + item.equation.substr(0, item.equation.find('=')) + ") + " +
                                std::to_string(++number));
        state.ResumeTiming();
        if (!expr || !jit::compile(*expr, {.with_double = with_double})) {
            state.SkipWithError("does not compile");
            return;
        }
    }
}

void register_benchmarks() {
    for (const GalleryItem& item : gallery()) {
        if (item.group != suite_group) continue;
        const auto add = [&item](const char* what, auto function) {
            return benchmark::RegisterBenchmark(
                (item.name + "/" + what).c_str(),
                [function, &item](benchmark::State& state) { function(state, item); });
        };
        add("range", time_range<float>);
        add("value", time_value<float>);
        add("range_double", time_range<double>);
        add("value_double", time_value<double>);
        // Compiling has a thread of its own, which CPU time would miss.
        const auto compile = [](bool with_double) {
            return [with_double](benchmark::State& state, const GalleryItem& each) {
                time_compile(state, each, with_double);
            };
        };
        add("compile", compile(false))->Unit(benchmark::kMillisecond)->UseRealTime();
        add("compile_both", compile(true))->Unit(benchmark::kMillisecond)->UseRealTime();
    }
}

}  // namespace
}  // namespace zeroset::test

int main(int argc, char** argv) {
    zeroset::test::register_benchmarks();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
}
