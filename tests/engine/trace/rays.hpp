#pragma once

#include "engine/expr/interpret.hpp"
#include "engine/expr/parse.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/trace/scene.hpp"
#include "engine/trace/tracer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

// What the tests of the tracers share: scenes, settings, and the ray of a pixel in double.

namespace zeroset::test {

inline Scene scene_of(const std::string& text, const Box& clip) {
    const auto expr = parse(text);
    if (!expr) {
        ADD_FAILURE() << text << ": " << expr.error().reason;
        return {};
    }
    Scene scene{{interpret(*expr)}, clip, {}};
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
    glm::dvec3 eye, direction;        ///< of length 1
    double t_in = 0.0, t_out = -1.0;  ///< the part in the clip box and in front of the eye

    Ray(const Camera& camera, const Box& clip, int col, int row, const Framebuffer& frame)
        : eye(camera.eye),
          direction(glm::normalize(
              ViewFrame(camera).direction(col + 0.5, row + 0.5, frame.width, frame.height))) {
        t_out = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            const double a = (clip.lo[i] - eye[i]) / direction[i];
            const double b = (clip.hi[i] - eye[i]) / direction[i];
            t_in = std::max(t_in, std::min(a, b));
            t_out = std::min(t_out, std::max(a, b));
        }
    }
    [[nodiscard]] glm::dvec3 at(double t) const { return eye + t * direction; }
    /// Distance along the ray for 1 along its dominant axis.
    [[nodiscard]] double stretch() const {
        const glm::dvec3 size = glm::abs(direction);
        return 1.0 / std::max({size.x, size.y, size.z});
    }
};

inline std::vector<std::string> tracer_names() {
    std::vector<std::string> names;
    for (const Tracer& tracer : tracers())
        names.emplace_back(tracer.name);
    return names;
}

/// The tracer's name as part of a test's name.
inline std::string test_name(std::string tracer) {
    std::ranges::replace(tracer, '-', '_');
    return tracer;
}

}  // namespace zeroset::test
