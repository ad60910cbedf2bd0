#include "engine/render/render.hpp"
#include "engine/render/tracers.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

// Each tracer on surfaces of known form: certificates, depths and misses, ray by ray.

namespace zeroset::test::tracer_test {
namespace {

/// A tracer may look for the opposite sign a few cells behind the one where it stopped.
constexpr double bracket_cells = 4.0;

/// Compares a pixel with what is there. `cell` is the width of the finest slice.
void check_pixel(const Analytic& scene, const Ray& ray, Certificate certificate, double depth,
                 double cell) {
    const double rounding = 3e-6;
    const double margin = bracket_cells * cell * ray.stretch() + rounding;
    const bool in_box = ray.t_in < ray.t_out;
    const double early =
        in_box ? scene.first_root(ray, std::max(ray.t_in - margin, ray.t_first)) : infinity;
    const double first = in_box ? scene.first_root(ray, ray.t_in) : infinity;
    const bool hit = first < ray.t_out - margin && early == first && first > ray.t_in + margin;
    const bool miss = early > ray.t_out + margin;
    if (hit) {
        EXPECT_NE(certificate, Certificate::Miss) << "root at " << first;
        EXPECT_LE(depth, first + margin) << "behind the first root";
    }
    if (certificate == Certificate::Certified) {
        EXPECT_FALSE(miss) << "certified at " << depth << " where there is nothing";
        EXPECT_LE(std::abs(depth - first), margin) << "root at " << first << ", shown at " << depth;
    }
    EXPECT_TRUE(certificate != Certificate::Miss || depth == infinity) << depth;
}

void check_scene(const Analytic& analytic, const std::string& tracer, double d_stop) {
    Framebuffer frame(41, 31);
    Scene scene = scene_of(analytic.text, analytic.clip);
    scene.region = analytic.region;
    render_frame(scene, analytic.camera, settings_at(tracer, d_stop), frame);
    const double cell = analytic.clip.size() * std::exp2(-d_stop);
    for (int row = 0; row < frame.height; ++row) {
        for (int col = 0; col < frame.width; ++col) {
            SCOPED_TRACE(analytic.name + ", pixel " + std::to_string(col) + "," +
                         std::to_string(row) + ", d_stop " + std::to_string(d_stop));
            const std::size_t i = frame.index(col, row);
            check_pixel(analytic,
                        Ray(analytic.camera, analytic.clip, col, row, frame, analytic.region),
                        frame.certificate[i], static_cast<double>(frame.depth[i]), cell);
        }
    }
}

class TracerTest : public ::testing::TestWithParam<std::string> {};

TEST_P(TracerTest, AgreesWithClosedForms) {
    for (const Analytic& scene : analytic_scenes()) {
        for (const double d_stop : {8.0, 12.0, 19.0})
            check_scene(scene, GetParam(), d_stop);
    }
}

TEST_P(TracerTest, AgreesWithClosedFormsOnParallelRays) {
    for (const Analytic& scene : parallel_scenes()) {
        for (const double d_stop : {8.0, 14.0, 19.0})
            check_scene(scene, GetParam(), d_stop);
    }
}

TEST_P(TracerTest, AgreesWithClosedFormsInRegions) {
    for (const Analytic& scene : region_scenes()) {
        for (const double d_stop : {8.0, 19.0})
            check_scene(scene, GetParam(), d_stop);
    }
}

TEST_P(TracerTest, CertifiesMostOfASimpleSurface) {
    Framebuffer frame(64, 64);
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    render_frame(scene, default_camera(scene.clip), settings_at(GetParam(), 16), frame);
    const CertificateCounts counts = count_certificates(frame);
    EXPECT_GT(counts.certified, 150U);
    EXPECT_LT(counts.undecided, counts.certified / 20);
}

struct Shown {
    std::vector<bool> hits, certified;
};

Shown shown_at(const Scene& scene, const std::string& tracer, double d_stop) {
    Framebuffer frame(50, 50);
    render_frame(scene, default_camera(scene.clip), settings_at(tracer, d_stop), frame);
    Shown shown;
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        shown.hits.push_back(std::isfinite(static_cast<double>(frame.depth[i])));
        shown.certified.push_back(frame.certificate[i] == Certificate::Certified);
    }
    return shown;
}

constexpr const char* nested_search_texts[] = {"x^2 + y^2 + z^2 = 1",
                                               "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8",
                                               "x^2*y^2 + y^2*z^2 + x^2*z^2 + x*y*z"};

TEST_P(TracerTest, ACoarserSearchShowsAllThatAFinerOneCertifies) {
    for (const char* text : nested_search_texts) {
        const Scene scene = scene_of(text, Box::cube(2));
        const Shown finest = shown_at(scene, GetParam(), 18);
        EXPECT_GT(std::ranges::count(finest.certified, true), 10) << text;
        for (const double d_stop : {15.0, 12.0, 9.0, 6.0}) {
            const Shown coarser = shown_at(scene, GetParam(), d_stop);
            for (std::size_t i = 0; i < coarser.hits.size(); ++i) {
                EXPECT_TRUE(coarser.hits[i] || !finest.certified[i])
                    << text << ", d_stop " << d_stop << ": " << i;
            }
        }
    }
}

/// Its cells are nested.
TEST(KBisection, ACoarserSearchShowsAllThatAFinerOneShows) {
    for (const char* text : nested_search_texts) {
        const Scene scene = scene_of(text, Box::cube(2));
        std::vector<bool> finer = shown_at(scene, "k-bisection", 18).hits;
        for (const double d_stop : {15.0, 12.0, 9.0, 6.0}) {
            const std::vector<bool> hits = shown_at(scene, "k-bisection", d_stop).hits;
            for (std::size_t i = 0; i < hits.size(); ++i) {
                EXPECT_TRUE(hits[i] || !finer[i]) << text << ", d_stop " << d_stop << ": " << i;
            }
            EXPECT_GE(std::ranges::count(hits, true), std::ranges::count(finer, true));
            finer = hits;
        }
    }
}

TEST_P(TracerTest, DrawsATangentPlaneWithoutACertificate) {
    Framebuffer frame(40, 40);
    const Scene scene = scene_of("(x - y + z)^2", Box::cube(2));
    render_frame(scene, default_camera(scene.clip), settings_at(GetParam(), 12), frame);
    const CertificateCounts counts = count_certificates(frame);
    EXPECT_EQ(counts.certified, 0U);
    EXPECT_GT(counts.undecided, 100U);
}

TEST_P(TracerTest, DrawsNoWallAtAPole) {
    const Scene scene = scene_of("1/(x - y^2) - z", Box::cube(2));
    const Camera camera{{3, -5, 2}, {0, 0, 0}, {0, 0, 1}, 0.8};
    Framebuffer frame(80, 80);
    render_frame(scene, camera, settings_at(GetParam(), 14), frame);
    int hits = 0;
    for (int row = 0; row < frame.height; ++row) {
        for (int col = 0; col < frame.width; ++col) {
            const auto t = static_cast<double>(frame.depth[frame.index(col, row)]);
            if (!std::isfinite(t)) continue;
            ++hits;
            const glm::dvec3 p = Ray(camera, scene.clip, col, row, frame).at(t);
            EXPECT_GT(std::abs(p.x - p.y * p.y), 0.49) << col << "," << row;  // |z| <= 2
        }
    }
    EXPECT_GT(hits, 500);
}

TEST_P(TracerTest, NeverCertifiesAPoleAlone) {
    Framebuffer frame(40, 40);
    const Scene scene = scene_of("1/(x + 0.1*y + 0.01*z)", Box::cube(2));
    render_frame(scene, default_camera(scene.clip), settings_at(GetParam(), 14), frame);
    EXPECT_EQ(count_certificates(frame).certified, 0U);
    EXPECT_TRUE(std::ranges::none_of(
        frame.depth, [](float t) { return std::isfinite(static_cast<double>(t)); }));
}

TEST_P(TracerTest, DrawsTheSameOnAnyThreads) {
    const Scene scene = scene_of("x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + 0.5", Box::cube(1.5));
    Framebuffer frames[2] = {Framebuffer(150, 130), Framebuffer(150, 130)};
    Counters counters[2];
    for (int i = 0; i < 2; ++i) {
        TraceSettings settings = settings_at(GetParam(), 10);
        settings.threads = i + 1;
        counters[i] = render_frame(scene, default_camera(scene.clip), settings, frames[i]);
    }
    EXPECT_EQ(frames[0].depth, frames[1].depth);
    EXPECT_EQ(frames[0].color, frames[1].color);
    EXPECT_EQ(frames[0].certificate, frames[1].certificate);
    EXPECT_EQ(counters[0].range, counters[1].range);
    EXPECT_EQ(counters[0].form, counters[1].form);
    EXPECT_GT(counters[0].range + counters[0].form, 0U);
    EXPECT_GE(counters[0].value, count_certificates(frames[0]).certified);
}

TEST_P(TracerTest, DrawsImagesOfAnySize) {
    const Scene scene = scene_of("x - y + z = 0.1", Box::cube(2));
    const Camera camera = default_camera(scene.clip);
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 70}, {65, 2}, {64, 64}, {129, 63}}) {
        Framebuffer frame(width, height);
        std::ranges::fill(frame.color, 0U);
        render_frame(scene, camera, settings_at(GetParam(), 8), frame);
        EXPECT_EQ(std::ranges::count(frame.color, 0U), 0) << width << "x" << height;
        EXPECT_EQ(frame.certificate[frame.index(width / 2, height / 2)], Certificate::Certified);
    }
}

TEST_P(TracerTest, StopsWhenCancelled) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    Framebuffer frame(200, 200);
    const std::atomic<bool> cancel{true};
    const Counters counters =
        render_frame(scene, default_camera(scene.clip), settings_at(GetParam(), 22), frame,
                     {.limit = {.cancel = &cancel}});
    EXPECT_EQ(counters.range, 0U);
    EXPECT_EQ(count_certificates(frame).miss, frame.color.size());
}

/// Counts the calls of a kernel's function; if asked to, it cancels the frame with each.
template <class Batch>
struct Counting {
    KernelFunction<Batch> whole;
    std::atomic<bool>* cancel;
    mutable std::atomic<int> calls = 0;

    static void call(const void* code, const Batch* batch) {
        const auto& self = *static_cast<const Counting*>(code);
        ++self.calls;
        if (self.cancel != nullptr) *self.cancel = true;
        self.whole(*batch);
    }
    Counting(KernelFunction<Batch>& function, std::atomic<bool>* cancels)
        : whole(function), cancel(cancels) {
        function = {call, std::shared_ptr<const void>(this, [](const void*) {})};
    }
};

TEST_P(TracerTest, StopsAmidATile) {
    int calls[2];
    for (const bool cancels : {false, true}) {
        Scene scene = scene_of("sin(9x) sin(9y) sin(9z) = 0.1", Box::cube(2));
        Framebuffer frame(64, 64);
        frame.depth.assign(frame.depth.size(), 7.0F);
        std::atomic<bool> cancel{false};
        const Counting forms(scene.surfaces[0].kernel.in_float.form, cancels ? &cancel : nullptr);
        const Counting ranges(scene.surfaces[0].kernel.in_float.range, cancels ? &cancel : nullptr);
        int tiles = 0;
        render_frame(scene, default_camera(scene.clip), settings_at(GetParam(), 22), frame,
                     {.limit = {.cancel = &cancel}, .on_tile = [&](const PixelRect&) { ++tiles; }});
        EXPECT_EQ(tiles, cancels ? 0 : 1);
        EXPECT_EQ(std::ranges::count(frame.depth, 7.0F), cancels ? 64 * 64 : 0);
        calls[cancels ? 1 : 0] = forms.calls + ranges.calls;
    }
    EXPECT_GE(calls[1], 1);
    EXPECT_LT(2 * calls[1], calls[0]);
}

TEST_P(TracerTest, TellsOfEachTileOnce) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    Framebuffer frame(150, 100);
    std::mutex mutex;
    std::vector<int> told(frame.depth.size());
    render_frame(scene, default_camera(scene.clip), settings_at(GetParam(), 8), frame,
                 {.on_tile = [&](const PixelRect& tile) {
                     const std::scoped_lock lock(mutex);
                     for (int row = tile.row; row < tile.row + tile.rows; ++row) {
                         for (int col = tile.col; col < tile.col + tile.cols; ++col)
                             ++told[frame.index(col, row)];
                     }
                 }});
    EXPECT_EQ(std::ranges::count(told, 1), 150 * 100);
}

INSTANTIATE_TEST_SUITE_P(AllTracers, TracerTest, ::testing::ValuesIn(tracer_names()),
                         [](const auto& tracer) { return test_name(tracer.param); });

TEST(FindTracer, KnowsItsNames) {
    for (const Tracer& tracer : tracers())
        EXPECT_NE(find_tracer(tracer.name), nullptr);
    EXPECT_EQ(find_tracer("magic"), nullptr);
    EXPECT_EQ(find_tracer(TraceSettings().tracer), &usual_tracer());
}

}  // namespace
}  // namespace zeroset::test::tracer_test
