#include "app/cli/timing.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/formula.hpp"
#include "tests/support/csg_scenes.hpp"
#include "tests/support/formulas.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>

// The cost of many parts: unions, differences and smooth unions of 1 to 1000 spheres, all partly
// visible; time of a frame, its ratio to that of 10 parts, its share for a part, and from text to
// first picture.
//   csg_benchmark [--threads N] [--tracer NAME] [--size PIXELS] [--repeat N]
//     [--series NAME] [--parts MOST]

namespace zeroset {
namespace {

struct Options {
    TraceSettings settings{.tracer = "beams", .stop = {{}, 10.0}, .threads = 1};
    int size = 512;
    int repeats = 5;
    int most_parts = 1000;
    std::string_view series;  ///< only this one; all where empty
};

struct Series {
    const char* name;
    std::function<std::string(const std::vector<test::CsgSphere>&)> text;
};

std::string smooth_union(const std::vector<test::CsgSphere>& parts, std::size_t first,
                         std::size_t last) {
    if (last - first == 1) return parts[first].text();
    const std::size_t middle = first + (last - first) / 2;
    return "blend(" + smooth_union(parts, first, middle) + ", " +
           smooth_union(parts, middle, last) + ")";
}

const Series all_series[] = {
    {"union", [](const auto& parts) { return test::combined("min", parts); }},
    {"cube less spheres",
     [](const auto& parts) {
         return "max(max(|x|, |y|, |z|) - 0.8, -" + test::combined("min", parts) + ")";
     }},
    {"smooth union",
     [](const auto& parts) {
         return "blend(a, b) = min(a, b) - max(0.002 - |a - b|, 0)^2 / 0.008; " +
                smooth_union(parts, 0, parts.size()) + " = 0";
     }},
};

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void run(const Series& series, const Options& options) {
    const Camera camera = suite_camera(1.0);
    const Box clip = Box::cube(1.0);
    Framebuffer frame(options.size, options.size);
    std::printf("%-18s %6s %12s %10s %12s %18s %10s %10s\n", series.name, "parts", "frame ms",
                "us a part", "of 10", "first picture ms", "certified", "undecided");
    double of_ten = 0;
    for (const int count : {1, 10, 100, 1000}) {
        if (count > options.most_parts) continue;
        const std::string text = series.text(test::visible_spheres(count, camera.eye));
        const auto start = Clock::now();
        const auto formula = test::compile_formula(text, clip, Precision::Float);
        if (!formula) {
            std::printf("%s", describe(formula.error()).c_str());
            std::exit(1);
        }
        const Scene scene = test::make_scene(*formula, clip, 0.5, {});
        time_frames(scene, camera, options.settings, frame, Repeats{},
                    [] { return RenderWatch{}; });
        const double first_ms = ms_since(start);
        const FrameTiming timing =
            time_frames(scene, camera, options.settings, frame, Repeats{options.repeats},
                        [] { return RenderWatch{}; });
        if (count == 10) of_ten = timing.median_ms;
        const CertificateCounts counts = count_certificates(frame);
        std::printf("%-18s %6d %12.2f %10.1f ", "", count, timing.median_ms,
                    1e3 * timing.median_ms / count);
        if (of_ten > 0) {
            std::printf("%12.2f", timing.median_ms / of_ten);
        } else {
            std::printf("%12s", "");
        }
        std::printf(" %18.1f %10zu %10zu\n", first_ms, counts.certified, counts.undecided);
        std::fflush(stdout);
    }
}

}  // namespace
}  // namespace zeroset

int main(int argc, char** argv) {
    zeroset::Options options;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string_view name = argv[i];
        if (name == "--threads") options.settings.threads = std::atoi(argv[i + 1]);
        if (name == "--tracer") options.settings.tracer = argv[i + 1];
        if (name == "--size") options.size = std::atoi(argv[i + 1]);
        if (name == "--parts") options.most_parts = std::atoi(argv[i + 1]);
        if (name == "--series") options.series = argv[i + 1];
        if (name == "--repeat") options.repeats = std::atoi(argv[i + 1]);
    }
    for (const zeroset::Series& series : zeroset::all_series) {
        if (options.series.empty() || options.series == series.name) zeroset::run(series, options);
    }
}
