// Checks every tracer against the oracles, ray by ray, on the gallery and on random surfaces:
// tracer_oracle_test at any size. Exits with 1 if a claim of a tracer is wrong.

#include "engine/render/tracers.hpp"
#include "tests/oracle/ray_audit.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <iterator>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

namespace zeroset::test {
namespace {

constexpr const char* usage =
    "usage: ray_checks [--size N] [--dstop N] [--rays N] [--edges N] [--bits N]\n"
    "                  [--surfaces N] [--seed S] [--gallery 0|1] [--cut 0|1]\n"
    "                  [--commands 0|1] [--threads N] [TRACER...]\n"
    "Checks these tracers, all that prove what they show if none is given.\n"
    "  --size      width and height of the pictures, 128 if not given\n"
    "  --rays      of each picture, at random; 0, the default: all\n"
    "  --edges     of each picture, besides those, at random where neighbours differ\n"
    "  --bits      certified depths are at most 2^-N of the clip box off the first root; 0, the\n"
    "              default: what tracers promise\n"
    "  --surfaces  number of random surfaces, 200 if not given\n"
    "  --gallery   whether the gallery is checked, too; 1 if not given\n"
    "  --cut       1: in random regions, half of them in orthographic views\n"
    "  --commands  1: only prints the command lines that draw the surfaces\n"
    "  --threads   all cores if not given\n";

struct Options {
    std::size_t size = 128;
    std::size_t d_stop = 16;
    std::size_t rays = 0;
    std::size_t edges = 0;
    std::size_t bits = 0;
    std::size_t surfaces = 200;
    std::size_t seed = 1;
    std::size_t gallery = 1;
    std::size_t cut = 0;
    std::size_t commands = 0;
    std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    std::vector<Tracer> tracers;
};

std::size_t* option_named(Options& options, std::string_view name) {
    if (name == "--size") return &options.size;
    if (name == "--dstop") return &options.d_stop;
    if (name == "--rays") return &options.rays;
    if (name == "--edges") return &options.edges;
    if (name == "--bits") return &options.bits;
    if (name == "--surfaces") return &options.surfaces;
    if (name == "--seed") return &options.seed;
    if (name == "--gallery") return &options.gallery;
    if (name == "--cut") return &options.cut;
    if (name == "--commands") return &options.commands;
    return name == "--threads" ? &options.threads : nullptr;
}

std::optional<Options> options_of(const std::vector<std::string_view>& arguments) {
    Options options;
    for (std::size_t i = 0; i < arguments.size(); i += 2) {
        if (const Tracer* const tracer = find_tracer(arguments[i])) {
            options.tracers.push_back(*tracer);
            --i;
            continue;
        }
        std::size_t* const number = option_named(options, arguments[i]);
        if (number == nullptr || i + 1 == arguments.size()) return std::nullopt;
        const std::string_view value = arguments[i + 1];
        const auto [end, error] =
            std::from_chars(value.data(), value.data() + value.size(), *number);
        if (error != std::errc{} || end != value.data() + value.size()) return std::nullopt;
    }
    if (options.tracers.empty())
        std::ranges::copy_if(tracers(), std::back_inserter(options.tracers), &Tracer::proves);
    return options;
}

void print_commands(const std::vector<AuditSurface>& surfaces, const AuditSettings& settings) {
    for (const AuditSurface& surface : surfaces)
        std::printf("%s\n", command_line(surface, settings).c_str());
}

AuditReport audit_all(const std::vector<AuditSurface>& surfaces, const AuditSettings& settings,
                      std::size_t threads) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    AuditReport total;
    const auto work = [&] {
        for (std::size_t i = next++; i < surfaces.size(); i = next++) {
            const AuditReport report = audit(surfaces[i], settings);
            const std::scoped_lock lock(mutex);
            std::printf("%-20s %s\n", surfaces[i].name.c_str(), report.text().c_str());
            std::fflush(stdout);
            total += report;
        }
    };
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < threads; ++i)
        workers.emplace_back(work);
    workers.clear();
    return total;
}

int check(const Options& options) {
    std::vector<AuditSurface> surfaces = random_surfaces(options.surfaces, options.seed);
    if (options.gallery != 0) {
        const auto classics = gallery_surfaces();
        surfaces.insert(surfaces.begin(), classics.begin(), classics.end());
    }
    if (options.cut != 0) surfaces = cut_open(std::move(surfaces), options.seed);
    std::size_t failures = 0;
    for (const Tracer& tracer : options.tracers) {
        const AuditSettings settings{.tracer = std::string(tracer.name),
                                     .size_px = static_cast<int>(options.size),
                                     .d_stop = static_cast<double>(options.d_stop),
                                     .rays = options.rays,
                                     .edge_rays = options.edges,
                                     .depth_bits = static_cast<double>(options.bits)};
        if (options.commands != 0) {
            print_commands(surfaces, settings);
            continue;
        }
        const AuditReport report = audit_all(surfaces, settings, options.threads);
        for (const std::string& failure : report.failures)
            std::printf("%s\n", failure.c_str());
        std::printf("%s, %zu surfaces: %s\n", settings.tracer.c_str(), surfaces.size(),
                    report.text().c_str());
        failures += report.failures.size();
    }
    return failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace zeroset::test

int main(int argc, char** argv) {
    using namespace zeroset::test;
    const auto options = options_of({argv + 1, argv + argc});
    if (!options || options->size == 0 || options->threads == 0) {
        std::fputs(usage, stderr);
        return 2;
    }
    return check(*options);
}
