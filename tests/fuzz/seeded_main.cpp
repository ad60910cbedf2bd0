// A fuzzer of the formula language that works with every compiler: mutates the corpus with the
// words of the dictionary. Each text is tried in a child process, so that a crash, too, is found,
// minimised and written to a file.

#include "engine/language/parse.hpp"
#include "tests/fuzz/isolated.hpp"
#include "tests/fuzz/language_target.hpp"
#include "tests/fuzz/minimise.hpp"
#include "tests/fuzz/mutator.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset::test {
namespace {

constexpr const char* usage =
    "usage: language_fuzz [--runs N] [--seconds N] [--seed S] [--timeout S] [FILE...]\n"
    "  FILE       tries these texts only\n"
    "  --timeout  a text that takes longer is a failure; 0, the default: no limit\n";

struct Options {
    std::size_t runs = 0;  ///< 0: no limit
    std::size_t seconds = 0;
    std::size_t seed = 1;
    std::size_t timeout_s = 0;
    std::vector<std::string> files;
};

std::optional<Options> options_of(const std::vector<std::string>& arguments) {
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        std::size_t* const number = argument == "--runs"      ? &options.runs
                                    : argument == "--seconds" ? &options.seconds
                                    : argument == "--seed"    ? &options.seed
                                    : argument == "--timeout" ? &options.timeout_s
                                                              : nullptr;
        if (number == nullptr) {
            if (argument.starts_with("--")) return std::nullopt;
            options.files.push_back(argument);
            continue;
        }
        if (++i == arguments.size()) return std::nullopt;
        const std::string& value = arguments[i];
        const auto [end, error] =
            std::from_chars(value.data(), value.data() + value.size(), *number);
        if (error != std::errc{} || end != value.data() + value.size()) return std::nullopt;
    }
    return options;
}

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> corpus() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(ZEROSET_FUZZ_DIR "/corpus"))
        paths.push_back(entry.path());
    std::ranges::sort(paths);  // so that equal seeds make equal runs
    std::vector<std::string> texts;
    for (const auto& path : paths)
        texts.push_back(contents(path));
    return texts;
}

/// Minimises the failing text and writes it to a file in the current folder.
void report(const Failure& failure, const Isolated& isolated) {
    std::printf("%s\n", failure.reason.c_str());
    const std::string small = minimised(failure.text, [&](const std::string& text) {
        return isolated.failure_of(text).has_value();
    });
    const auto smallest = isolated.failure_of(small);
    const std::string name =
        "language_fuzz_failure_" + std::to_string(std::hash<std::string>{}(small)) + ".txt";
    std::ofstream(name, std::ios::binary) << small;
    std::printf("minimised to %zu bytes: %s\nwritten to %s\n", small.size(),
                smallest ? smallest->reason.c_str() : "(fails no more)", name.c_str());
}

int try_files(const Options& options, const Isolated& isolated) {
    int failures = 0;
    for (const std::string& path : options.files) {
        const auto failure = isolated.failure_of(contents(path));
        std::printf("%s: %s\n", path.c_str(), failure ? failure->reason.c_str() : "good");
        if (failure) ++failures;
    }
    return failures == 0 ? 0 : 1;
}

int fuzz(const Options& options, const Isolated& isolated) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(options.seconds);
    Mutator mutator(corpus(), read_dictionary(contents(ZEROSET_FUZZ_DIR "/language.dict")));
    RandomNumbers random(options.seed);
    std::size_t runs = 0;
    std::size_t formulas = 0;
    const auto next = [&](bool tried) -> std::optional<std::string> {
        static std::string last;
        if (tried && read_program(last)) {
            mutator.keep(last, random);
            ++formulas;
        }
        const bool runs_left = options.runs == 0 || runs < options.runs;
        const bool time_left = options.seconds == 0 || Clock::now() < end;
        if (!runs_left || !time_left) {
            std::printf("%zu texts are good, %zu of them formulas\n", runs, formulas);
            return std::nullopt;
        }
        ++runs;
        last = mutator.next(random);
        return last;
    };
    const auto failure = isolated.first_failure(next);
    if (!failure) return 0;
    report(*failure, isolated);
    return 1;
}

}  // namespace
}  // namespace zeroset::test

int main(int argc, char** argv) {
    using namespace zeroset::test;
    const auto options = options_of({argv + 1, argv + argc});
    if (!options || (options->runs == 0 && options->seconds == 0 && options->files.empty())) {
        std::fputs(usage, stderr);
        return 2;
    }
    const Isolated isolated(complaint_about, options->timeout_s);
    return options->files.empty() ? fuzz(*options, isolated) : try_files(*options, isolated);
}
