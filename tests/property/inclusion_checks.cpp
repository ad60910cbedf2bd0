// Random inclusion checks by the hundred million, on all cores: operators, helpers and whole
// formulas in float and double against the reference of 256 bits, beam forms of whole formulas
// against MPFI. The same seed makes the same checks, whatever the number of threads. Exits with 1
// if a claim is wrong.

#include "app/cli/report.hpp"
#include "engine/interpret/interpret.hpp"
#include "jit/compile.hpp"
#include "tests/oracle/form_inclusion.hpp"
#include "tests/property/expression_inclusion.hpp"
#include "tests/property/helper_inclusion.hpp"
#include "tests/property/operator_inclusion.hpp"

#include <mpfr.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

namespace zeroset::test {
namespace {

constexpr const char* usage =
    "usage: inclusion_checks [--checks N] [--seed S] [--threads N] [--forms 0|1]\n"
    "  --checks   points to check at least, 100000000 if not given\n"
    "  --threads  all cores if not given\n"
    "  --forms    1: only beam forms\n";

struct Options {
    std::uint64_t checks = 100'000'000;
    std::uint64_t seed = 1;
    std::uint64_t threads = std::max(1U, std::thread::hardware_concurrency());
    std::uint64_t forms = 0;
};

std::optional<Options> options_of(const std::vector<std::string_view>& arguments) {
    Options options;
    for (std::size_t i = 0; i + 1 < arguments.size(); i += 2) {
        std::uint64_t* const number = arguments[i] == "--checks"    ? &options.checks
                                      : arguments[i] == "--seed"    ? &options.seed
                                      : arguments[i] == "--threads" ? &options.threads
                                      : arguments[i] == "--forms"   ? &options.forms
                                                                    : nullptr;
        if (number == nullptr) return std::nullopt;
        const std::string_view value = arguments[i + 1];
        const auto [end, error] =
            std::from_chars(value.data(), value.data() + value.size(), *number);
        if (error != std::errc{} || end != value.data() + value.size()) return std::nullopt;
    }
    if (arguments.size() % 2 != 0 || options.threads == 0) return std::nullopt;
    return options;
}

enum Group : std::uint8_t {
    OperatorsFloat,
    OperatorsDouble,
    HelpersFloat,
    HelpersDouble,
    FormulasFloat,
    FormulasDouble,
    FormsFloat,
    FormsDouble,
    FormsOfCode,
    GroupCount
};
constexpr std::array<const char*, GroupCount> group_names{
    "operators in float", "operators in double", "helpers in float",
    "helpers in double",  "formulas in float",   "formulas in double",
    "forms in float",     "forms in double",     "forms of machine code"};

using Tallies = std::array<InclusionTally, GroupCount>;

template <class Real>
void check_operators(OperatorRange<Real> range, int boxes, RandomNumbers& random,
                     InclusionTally& tally) {
    for (const OpInfo& info : operators()) {
        for (int i = 0; i < boxes; ++i) {
            const Node node = random_operator_node(info, random);
            check_operator(range, node, Inputs<Real>(info, random), random, tally);
        }
    }
}

template <class Real>
void check_helpers(RandomNumbers& random, InclusionTally& tally) {
    for (const Helper<Real>& helper : helpers<Real>()) {
        for (int i = 0; i < 20; ++i)
            check_helper(helper, random, tally);
    }
}

template <class Real>
void check_formulas(RandomNumbers& random, InclusionTally& tally) {
    for (int i = 0; i < 36; ++i)
        check_random_expression<Real>(1 + i % 6, random, tally);
}

template <class Real>
void check_forms_of(int formulas, RandomNumbers& random, InclusionTally& tally) {
    for (int i = 0; i < formulas; ++i)
        check_forms<Real>(interpret, 1 + i % 6, 2, random, tally);
}

Kernel compiled(const Expr& expr) {
    auto kernel = jit::compile(expr, {.with_double = true});
    if (!kernel) std::abort();
    return *kernel;
}

/// Checks many cells of one formula, as it took long to compile.
void check_forms_of_code(RandomNumbers& random, InclusionTally& tally) {
    const int depth = random.between(1, 6);
    if (random.one_in(2)) {
        check_forms<float>(compiled, depth, 20, random, tally);
    } else {
        check_forms<double>(compiled, depth, 20, random, tally);
    }
}

void check_all_forms(RandomNumbers& random, Tallies& tallies) {
    check_forms_of<float>(12, random, tallies[FormsFloat]);
    check_forms_of<double>(12, random, tallies[FormsDouble]);
    if (random.one_in(2)) check_forms_of_code(random, tallies[FormsOfCode]);
}

/// Makes about ten thousand checks.
Tallies checked_chunk(std::uint64_t seed, bool only_forms) {
    RandomNumbers random(seed);
    Tallies tallies;
    check_all_forms(random, tallies);
    if (only_forms) return tallies;
    check_operators<float>(scalar_range<float>, 12, random, tallies[OperatorsFloat]);
    check_operators<double>(block_range, 10, random, tallies[OperatorsDouble]);
    check_operators<double>(scalar_range<double>, 2, random, tallies[OperatorsDouble]);
    check_helpers<float>(random, tallies[HelpersFloat]);
    check_helpers<double>(random, tallies[HelpersDouble]);
    check_formulas<float>(random, tallies[FormulasFloat]);
    check_formulas<double>(random, tallies[FormulasDouble]);
    return tallies;
}

std::uint64_t total(const Tallies& tallies) {
    std::uint64_t checks = 0;
    for (const InclusionTally& tally : tallies)
        checks += tally.checks;
    return checks;
}

/// Runs chunks of checks on all threads and adds up their tallies in the order of their seeds.
class Run {
public:
    explicit Run(const Options& options) : options_(options) {}

    const Tallies& run() {
        std::vector<std::jthread> threads;
        for (std::uint64_t i = 0; i < options_.threads; ++i)
            threads.emplace_back([this] { work(); });
        threads.clear();
        return tallies_;
    }

private:
    void work() {
        while (!done_) {
            const std::uint64_t chunk = next_++;
            const Tallies found =
                checked_chunk((options_.seed << 32U) + chunk, options_.forms != 0);
            std::unique_lock lock(mutex_);
            turn_.wait(lock, [&] { return chunk == finished_; });
            if (!done_) add(found);
            ++finished_;
            turn_.notify_all();
        }
        mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);  // which would leak at the end of the thread
    }
    void add(const Tallies& found) {
        for (std::size_t group = 0; group < GroupCount; ++group)
            tallies_.at(group) += found.at(group);
        const std::uint64_t checks = total(tallies_);
        if (finished_ % 1000 == 999) {
            std::printf("%llu checks\n", static_cast<unsigned long long>(checks));
            std::fflush(stdout);
        }
        done_ = checks >= options_.checks;
    }

    const Options options_;
    std::atomic<std::uint64_t> next_ = 0;
    std::atomic<bool> done_ = false;
    std::mutex mutex_;
    std::condition_variable turn_;
    std::uint64_t finished_ = 0;
    Tallies tallies_;
};

int report(const Tallies& tallies) {
    std::uint64_t failures = 0;
    for (std::size_t group = 0; group < GroupCount; ++group) {
        const InclusionTally& tally = tallies.at(group);
        failures += tally.failures;
        std::printf("%-20s %12llu checks, %llu failures\n", group_names.at(group),
                    static_cast<unsigned long long>(tally.checks),
                    static_cast<unsigned long long>(tally.failures));
        if (tally.failures != 0) std::printf("the first: %s\n", tally.first.c_str());
    }
    std::printf("%-20s %12llu checks, %llu failures\n", "all",
                static_cast<unsigned long long>(total(tallies)),
                static_cast<unsigned long long>(failures));
    return failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace zeroset::test

int main(int argc, char** argv) {
    using namespace zeroset::test;
    const auto options = options_of({argv + 1, argv + argc});
    if (!options) {
        std::fputs(usage, stderr);
        return 2;
    }
    return report(Run(*options).run());
}
