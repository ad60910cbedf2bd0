#include "engine/language/parse.hpp"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <string>

// From text to graphs: bytes a second of CPU time of read_program, which has a thread of its own,
// for long texts.

namespace zeroset {
namespace {

constexpr std::size_t size = ProgramLimits::text / 4;

/// Copies of what `part(i)` makes, up to the size of a text.
template <class Part>
std::string text_of(std::string text, Part part) {
    for (int i = 1;; ++i) {
        const std::string next = part(i);
        if (text.size() + next.size() > size) return text;
        text += next;
    }
}

std::string number(int i) { return std::to_string(i); }

std::string polynomial() {
    return text_of("x", [](int i) {
        return " + " + number(i) + "x^" + number(i % 13) + "*y^" + number(i / 13 % 11) + " z^" +
               number(i / 143 % 7);
    });
}

std::string statements() {
    return text_of("x + y + z = 1", [](int i) {
        const std::string name = "c_" + number(i);
        return "\n" + name + " = " + (i % 10 == 1 ? "2" : "c_" + number(i - 1) + "/3") +
               " + sqrt(" + number(i) + ") # one of the many values of this text, with its reason";
    });
}

std::string several_surfaces() {
    std::string text = "x^2 + y^2 = 1";
    for (int i = 2; i < 100; ++i)
        text += "\n(x - " + number(i) + ")^2 + (y + a)^2 + z^2 = 1/4, z < x/" + number(i);
    return text;
}

std::string deep() {
    std::string text = "x";
    for (int i = 1; i < 990; ++i)
        text = "sin(y + " + number(i) + text + ")";
    return text;
}

std::string functions_and_sums() {
    return text_of(
        "f(u, v) = u^2 - 3u v + sin(v)\ng(u) = sum(f(u, i)/i, i, 1, 3)\nz = 0", [](int i) {
            return " + f(x - " + number(i) + ", g(y)) prod(x - j, j, 1, " + number(1 + i % 4) + ")";
        });
}

std::string latex() {
    return text_of("x", [](int i) {
        return " + \\frac{" + number(i) + "x^{2}}{\\sqrt{y + " + number(i) +
               "}} \\cdot \\left( \\sin z - \\pi \\right)";
    });
}

void time_reading(benchmark::State& state, const std::string& text) {
    for (auto _ : state) {
        const auto program = read_program(text);
        if (!program) {
            state.SkipWithError(program.error().reason.c_str());
            return;
        }
        benchmark::DoNotOptimize(program->surfaces.front().root());
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

const bool registered = [] {
    const auto add = [](const char* name, const std::string& text) {
        benchmark::RegisterBenchmark((std::string("read/") + name).c_str(),
                                     [text](benchmark::State& state) { time_reading(state, text); })
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime();
    };
    add("polynomial", polynomial());
    add("statements", statements());
    add("several_surfaces", several_surfaces());
    add("deep", deep());
    add("functions_and_sums", functions_and_sums());
    add("latex", latex());
    return true;
}();

}  // namespace
}  // namespace zeroset
