#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/render/tracers.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "tests/support/long_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

// Helpers of the tests of the tracers: scenes, settings, and the ray of a pixel in double.

namespace zeroset::test {

inline Scene scene_of(const std::string& text, const Box& clip) {
    const auto expr = parse(text);
    if (!expr) {
        ADD_FAILURE() << text << ": " << expr.error().reason;
        return {};
    }
    Scene scene{{{.kernel = interpret(*expr)}}, clip, {}};
    for (const Tracer& tracer : tracers()) {
        if (tracer.needs.read_formula != nullptr)
            tracer.needs.read_formula(scene.surfaces[0].kernel, *expr, false);
    }
    scene.uniforms.set(0, 0.0);
    return scene;
}

inline TraceSettings settings_at(const std::string& tracer, double d_stop) {
    TraceSettings settings;
    settings.tracer = tracer;
    settings.stop.value = d_stop;
    settings.threads = 2;
    return settings;
}

struct Ray {
    glm::dvec3 eye, direction;        ///< `eye` is where t = 0; `direction` has length 1
    double t_first = 0.0;             ///< nothing before it is seen
    double t_in = 0.0, t_out = -1.0;  ///< the visible part, in the clip box and region

    Ray(const Camera& camera, const Box& clip, int col, int row, const Framebuffer& frame,
        const Region& region = {}) {
        const ViewFrame view(camera);
        eye = view.origin(pixel_centre(col, row), {.width = frame.width, .height = frame.height});
        direction = glm::normalize(
            view.direction(pixel_centre(col, row), {.width = frame.width, .height = frame.height}));
        if (view.parallel()) t_first = -infinity;
        t_in = t_first;
        t_out = infinity;
        for (int i = 0; i < 3; ++i) {
            const double a = (clip.lo[i] - eye[i]) / direction[i];
            const double b = (clip.hi[i] - eye[i]) / direction[i];
            narrow(std::min(a, b), std::max(a, b));
        }
        for (const Section& section : region.sections) {
            const double rate = glm::dot(section.normal, direction);
            const double t = place_of(section);
            const bool outside = rate == 0 && glm::dot(section.normal, eye) > section.offset;
            narrow(outside ? infinity : rate < 0 ? t : -infinity, rate > 0 ? t : infinity);
        }
        if (region.ball) {
            const glm::dvec3 from = eye - region.ball->centre;
            const double middle = -glm::dot(from, direction);
            const double gap = glm::length(from + middle * direction);
            const double radius = region.ball->radius;
            const double half = std::sqrt(std::max((radius - gap) * (radius + gap), 0.0));
            narrow(gap > radius ? infinity : middle - half, middle + half);
        }
    }
    /// Distance at which the ray meets the section's plane.
    [[nodiscard]] double place_of(const Section& section) const {
        return (section.offset - glm::dot(section.normal, eye)) /
               glm::dot(section.normal, direction);
    }
    [[nodiscard]] glm::dvec3 at(double t) const { return eye + t * direction; }
    /// Distance along the ray per unit along its dominant axis.
    [[nodiscard]] double stretch() const {
        const glm::dvec3 size = glm::abs(direction);
        return 1.0 / std::max({size.x, size.y, size.z});
    }

private:
    void narrow(double from, double to) {
        t_in = std::max(t_in, from);
        t_out = std::min(t_out, to);
    }
};

/// The first of tracers() that are tested: a program that tests those of papers alone leaves out
/// the product's, before its main function.
inline std::size_t& first_tested_tracer() {
    static std::size_t first = 0;
    return first;
}

/// The tested tracers that draw all formulas.
inline std::vector<Tracer> tracers_of_all_formulas() {
    std::vector<Tracer> all;
    std::ranges::copy_if(tracers().subspan(first_tested_tracer()), std::back_inserter(all),
                         [](const Tracer& tracer) { return tracer.needs.refuses == nullptr; });
    return all;
}

/// The tested tracers that prove what they show.
inline std::vector<Tracer> proving_tracers() {
    std::vector<Tracer> proving;
    std::ranges::copy_if(tracers().subspan(first_tested_tracer()), std::back_inserter(proving),
                         &Tracer::proves);
    return proving;
}

/// The proving tracers that a test of many places tries: in a long run all, else the two usual
/// ones, which come first, and a third of the others.
inline std::vector<Tracer> proving_tracers_to_try() {
    std::vector<Tracer> tried;
    for (std::size_t i = 0; const Tracer& tracer : proving_tracers()) {
        if (is_long_run() || i < 2 || i % 3 == 0) tried.push_back(tracer);
        ++i;
    }
    return tried;
}

/// Names of tracers.
inline std::vector<std::string> names_of(const std::vector<Tracer>& tracers) {
    std::vector<std::string> names;
    for (const Tracer& tracer : tracers)
        names.emplace_back(tracer.name);
    return names;
}
inline std::vector<std::string> tracer_names() { return names_of(proving_tracers()); }

/// The tracer's name as part of a test's name.
inline std::string test_name(std::string tracer) {
    std::ranges::replace(tracer, '-', '_');
    return tracer;
}

}  // namespace zeroset::test
