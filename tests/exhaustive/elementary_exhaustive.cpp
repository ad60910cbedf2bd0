#include "engine/base/parallel.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/real/rounding.hpp"
#include "jit/compile.hpp"
#include "tests/support/elementary_functions.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/random_expression.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

// Every finite float through every elementary function of one argument, by the code that kernels
// call, in the widest registers of this machine: the greatest error, and whether the range that a
// kernel gives for [a, a] encloses the true value at every float a.
//
//     elementary_exhaustive [--every N] [FUNCTION...]      (one of N stretches only)
//
// The close value is the C library's in double. glibc states at most 4 ulp of double for all of
// these functions, 2^-50 of the value; `reference_error` confirms it at one float of a stretch,
// by MPFR. `allowance` is 32 times that, and in units of a float's last place 2^-21. Therefore
//   - a range that encloses the close value and the allowance on both sides encloses the true
//     value; any other is decided by MPFR;
//   - an error that, by the close value, is not above the greatest one so far by 2^-20 ulp exceeds
//     it by less than 2^-19 ulp; any other is measured by MPFR. The table's maximum, rounded up to
//     the third decimal, is that of all floats.
// sin, tan and their like are odd, cos and cosh even: one close value serves a and -a.

namespace zeroset::test {
namespace {

constexpr double allowance = 0x1p-45;
constexpr double reference_error = 0x1p-50;
constexpr double least_progress = 0x1p-20;

constexpr std::size_t stretch = std::size_t{1} << 14U;
constexpr std::size_t positive_floats = 0x7F80'0000;  // with 0, without infinity and NaN
constexpr std::size_t stretches = positive_floats / stretch;

enum class Symmetry : std::uint8_t { None, Odd, Even };

/// Facts about a function beside its values.
struct Shape {
    Symmetry symmetry = Symmetry::None;
    bool has_poles = false;  ///< an infinite close value is no value; otherwise it is a large one
    double least = -infinity;
    double most = infinity;
};

Shape shape_of(Elementary function) {
    switch (function) {
        case Elementary::Sin: return {Symmetry::Odd, false, -1, 1};
        case Elementary::Cos: return {Symmetry::Even, false, -1, 1};
        case Elementary::Tanh: return {Symmetry::Odd, false, -1, 1};
        case Elementary::Cosh: return {Symmetry::Even, false, 1};
        case Elementary::Exp: return {Symmetry::None, false, 0};
        case Elementary::Acosh: return {Symmetry::None, false, 0};
        case Elementary::Acos: return {Symmetry::None, false, 0};
        case Elementary::Log:
        case Elementary::Log10:
        case Elementary::Log2: return {Symmetry::None, true};
        case Elementary::Atanh: return {Symmetry::Odd, true};
        case Elementary::Tan:
        case Elementary::Asin:
        case Elementary::Atan:
        case Elementary::Cbrt:
        case Elementary::Sinh:
        case Elementary::Asinh: return {Symmetry::Odd};
        case Elementary::Atan2: break;
    }
    return {};
}

struct Findings {
    double ulps = 0.0;
    float at = 0.0F;
    std::uint64_t floats = 0;
    std::uint64_t not_enclosed = 0;
    float not_enclosed_at = 0.0F;
    double close_error = 0.0;  ///< of the C library, relative

    void add(const Findings& other) {
        if (other.ulps > ulps) {
            ulps = other.ulps;
            at = other.at;
        }
        floats += other.floats;
        not_enclosed += other.not_enclosed;
        if (other.not_enclosed != 0) not_enclosed_at = other.not_enclosed_at;
        close_error = std::max(close_error, other.close_error);
    }
};

/// A stretch of floats with all that is computed of them.
struct Stretch {
    std::vector<float> a = std::vector<float>(stretch);
    std::vector<float> neg_a = a;
    std::vector<float> zero = a;
    std::vector<float> result = a;
    std::vector<float> neg_lo = a;
    std::vector<float> hi = a;
    std::vector<std::uint32_t> defined = std::vector<std::uint32_t>(stretch);
    std::vector<double> close = std::vector<double>(stretch);
};

/// 2^-23 of the power of two that is not above `size`, a normal number.
double ulp_of(double size) {
    constexpr std::uint64_t exponent_bits = 0x7FF0'0000'0000'0000;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) & exponent_bits) * 0x1p-23;
}

class Survey {
public:
    Survey(const Function<float>& function, Kernel kernel)
        : function_(function), shape_(shape_of(function.id)), kernel_(std::move(kernel)) {
        uniforms_.set(0, 0.0);
    }

    /// The floats of a stretch and their negatives.
    void visit(std::size_t index) {
        thread_local Stretch floats;
        Findings found;
        {
            const std::scoped_lock lock(mutex_);
            found.ulps = total_.ulps;
            found.at = total_.at;
        }
        for (std::size_t i = 0; i < stretch; ++i)
            floats.a[i] = std::bit_cast<float>(static_cast<std::uint32_t>(index * stretch + i));
        approximate(floats);
        examine(floats, found);
        for (float& a : floats.a)
            a = -a;
        reflect(floats);
        examine(floats, found);
        const std::scoped_lock lock(mutex_);
        total_.add(found);
    }

    /// Prints the table's line; whether all is as promised.
    [[nodiscard]] bool report() const {
        const double bound = float_format.bound(function_.id).ulp;
        const bool good = total_.ulps < bound && total_.not_enclosed == 0 &&
                          total_.close_error <= reference_error;
        std::printf("%-6s %11llu floats  worst %.6f ulp at %a  bound %.1f  %s\n", function_.name,
                    static_cast<unsigned long long>(total_.floats), total_.ulps,
                    static_cast<double>(total_.at), bound, good ? "enclosed" : "FAILED");
        if (total_.not_enclosed != 0) {
            std::printf("  not enclosed: %llu, one at %a\n",
                        static_cast<unsigned long long>(total_.not_enclosed),
                        static_cast<double>(total_.not_enclosed_at));
        }
        if (total_.close_error > reference_error) {
            std::printf("  the C library is off by %a of the value\n", total_.close_error);
        }
        std::fflush(stdout);
        return good;
    }

private:
    void approximate(Stretch& floats) const {
        for (std::size_t i = 0; i < stretch; ++i) {
            const double a{floats.a[i]};
            floats.close[i] = function_.close(a, a);
        }
    }
    /// Approximates as `approximate` does, from the values at the negatives.
    void reflect(Stretch& floats) const {
        if (shape_.symmetry == Symmetry::None) return approximate(floats);
        if (shape_.symmetry == Symmetry::Even) return;
        for (double& close : floats.close)
            close = -close;
    }

    /// Computes as kernels do, in their rounding mode.
    void compute(Stretch& floats) const {
        for (std::size_t i = 0; i < stretch; ++i)
            floats.neg_a[i] = -floats.a[i];
        const auto [code, lanes, call] = wide_code<float>(
            function_.id, static_cast<std::size_t>(jit::host_lanes()) * sizeof(float));
        const RangeBatch batch{stretch,
                               {floats.neg_a.data(), floats.zero.data(), floats.zero.data()},
                               {floats.a.data(), floats.zero.data(), floats.zero.data()},
                               uniforms_.boxes<float>(),
                               floats.neg_lo.data(),
                               floats.hi.data(),
                               floats.defined.data()};
        const UpwardRounding upward;
        for (std::size_t i = 0; i < stretch; i += lanes)
            call(code, 1, &floats.a[i], &floats.a[i], &floats.result[i]);
        kernel_.range(batch);
    }

    void examine(Stretch& floats, Findings& found) const {
        compute(floats);
        found.floats += stretch;
        for (std::size_t i = 0; i < stretch; ++i) {
            if (!is_enclosed(floats, i)) {
                ++found.not_enclosed;
                found.not_enclosed_at = floats.a[i];
            }
            measure(floats.a[i], floats.result[i], floats.close[i], found);
        }
        measure_close(floats, found);
    }

    /// Whether the kernel's range holds the value at the float, or its mask the lack of one.
    [[nodiscard]] bool is_enclosed(const Stretch& floats, std::size_t i) const {
        const double close = floats.close[i];
        if (std::isnan(close) || (shape_.has_poles && std::isinf(close)))
            return floats.defined[i] == 0;
        const double lo{-floats.neg_lo[i]};
        const double hi{floats.hi[i]};
        if (std::isinf(close)) return close > 0 ? hi == infinity : lo == -infinity;
        const double off = std::abs(close) * allowance + 0x1p-1000;
        if (lo <= std::max(close - off, shape_.least) && std::min(close + off, shape_.most) <= hi)
            return true;
        const Reference truth = exactly(floats.a[i]);
        return truth.defined && !(truth.value < lo) && !(truth.value > hi);
    }

    void measure(float a, float result, double close, Findings& found) const {
        const double size = std::abs(close);
        if (!(size >= smallest && size <= largest) || std::isinf(result)) return;
        const double error = std::abs(close - double{result});
        // Close values beside a power of two: the true one's unit is at least this.
        const double least_ulp = ulp_of(size * (1 - allowance));
        if (error <= (found.ulps + least_progress) * least_ulp) return;
        const Reference truth = exactly(a);
        const auto exponent = static_cast<int>(mpfr_get_exp(truth.value.get()));
        const double exact_error = std::abs((truth.value - MpfrNumber(double{result})).nearest());
        const double ulps = std::ldexp(exact_error, 24 - exponent);
        if (!(ulps > found.ulps)) return;
        found.ulps = ulps;
        found.at = a;
    }

    /// Checks the C library at one float, another one in each stretch.
    void measure_close(const Stretch& floats, Findings& found) const {
        const std::size_t i = std::bit_cast<std::uint32_t>(floats.a[0]) / stretch * 7919 % stretch;
        const double close = floats.close[i];
        if (!std::isfinite(close) || std::abs(close) < std::numeric_limits<double>::min()) return;
        const Reference truth = exactly(floats.a[i]);
        const double error = ((truth.value - MpfrNumber(close)) / truth.value).nearest();
        found.close_error = std::max(found.close_error, std::abs(error));
    }

    [[nodiscard]] Reference exactly(float a) const {
        return reference(function_.op, 3, MpfrNumber(double{a}), MpfrNumber(double{a}));
    }

    static constexpr double smallest = std::numeric_limits<float>::min();
    static constexpr double largest = std::numeric_limits<float>::max();

    Function<float> function_;
    Shape shape_;
    Kernel kernel_;
    Uniforms uniforms_;
    std::mutex mutex_;
    Findings total_;
};

struct Arguments {
    std::size_t every = 1;
    std::vector<std::string_view> functions;  ///< empty: all

    [[nodiscard]] bool wants(std::string_view function) const {
        return functions.empty() || std::ranges::find(functions, function) != functions.end();
    }
};

Arguments arguments_of(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--every" && i + 1 < argc) {
            arguments.every = std::max(1ULL, std::strtoull(argv[++i], nullptr, 10));
        } else {
            arguments.functions.emplace_back(argv[i]);
        }
    }
    return arguments;
}

bool survey(const Function<float>& function, std::size_t every) {
    const auto kernel = jit::compile(operator_on_variables(op_info(function.op)));
    if (!kernel) {
        std::printf("%s: %s\n", function.name, kernel.error().message.c_str());
        return false;
    }
    Survey survey(function, *kernel);
    parallel_for(stretches / every, 0, [&](std::size_t i) { survey.visit(i * every); });
    return survey.report();
}

int run(const Arguments& arguments) {
    bool good = true;
    for (const Function<float>& function : functions<float>()) {
        if (elementary_arity(function.id) != 1 || !arguments.wants(function.name)) continue;
        good = survey(function, arguments.every) && good;
    }
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace zeroset::test

int main(int argc, char** argv) {
    return zeroset::test::run(zeroset::test::arguments_of(argc, argv));
}
