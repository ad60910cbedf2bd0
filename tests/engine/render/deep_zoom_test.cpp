#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/render/render.hpp"
#include "engine/render/tracers.hpp"
#include "engine/scene/precision.hpp"
#include "tests/support/exact_ray.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

// A walk from the whole surface down to a point of it, by smaller and smaller boxes and by a camera
// that comes nearer and nearer: what is said of each ray, against f in 256 bits along the ray.

namespace zeroset::test::deep_zoom_test {
namespace {

constexpr int image_size = 12;
constexpr double d_stop = 13.0;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A surface and where to begin to look for a point of it.
struct Place {
    std::string name, text;
    double half_edge;
    glm::dvec3 start;
};

const std::vector<Place>& places() {
    static const std::vector<Place> all{
        {"sphere", "x^2 + y^2 + z^2 = 1", 2.0, {0.41, -0.63, 0.57}},
        {"tangle", "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8", 3.0, {0.93, -1.17, 1.31}},
        {"gyroid", "sin(x)cos(y) + sin(y)cos(z) + sin(z)cos(x) = 0.3", 4.0, {0.71, -1.93, 0.37}},
        {"klein",
         "(x^2+y^2+z^2+2y-1)((x^2+y^2+z^2-2y-1)^2-8z^2) + 16x z(x^2+y^2+z^2-2y-1)",
         5.0,
         {0.77, 0.61, 2.13}}};
    return all;
}

/// A surface, a point of it to the last bits of double, and a direction to look at it from.
struct Stand {
    std::string name;
    Expr expr;
    double half_edge;
    glm::dvec3 point, towards_eye;
};

Stand stand_at(const Place& place) {
    auto expr = parse(place.text);
    if (!expr) throw std::invalid_argument(place.text + ": " + expr.error().reason);
    Stand stand{place.name, std::move(*expr), place.half_edge, place.start, {}};
    glm::dvec3 gradient;
    for (int step = 0; step < 30; ++step) {
        const glm::dvec3& p = stand.point;
        const Dual<double> f = value_at(stand.expr, {p.x, p.y, p.z, 0.0});
        for (std::size_t i = 0; i < 3; ++i)
            gradient[static_cast<int>(i)] = f.slope[i].value_or(0.0);
        stand.point -= f.value / glm::dot(gradient, gradient) * gradient;
    }
    const glm::dvec3 normal = glm::normalize(gradient);
    stand.towards_eye = glm::normalize(normal + 0.6 * glm::cross(normal, {0.3, 0.8, -0.5}));
    return stand;
}

/// A view of `side` world units around the point.
struct View {
    Box clip;
    Camera camera;
};

Camera camera_at(const Stand& stand, double side) {
    Camera camera;
    camera.look_at = stand.point;
    camera.eye = stand.point + 2.5 * side * stand.towards_eye;
    camera.up = {0.2, 0.3, 0.9};
    camera.fov_rad = 0.5;
    return camera;
}

View small_box(const Stand& stand, double side) {
    const glm::dvec3 half(0.5 * side);
    return {{stand.point - half, stand.point + half}, camera_at(stand, side)};
}

View near_camera(const Stand& stand, double side) {
    return {Box::cube(stand.half_edge), camera_at(stand, 0.4 * side)};
}

/// One pixel's ray, and f along it. Distances are from the eye.
class Ray {
public:
    Ray(const Stand& stand, const View& view, int col, int row)
        : expr_(stand.expr), exact_(view.camera, image_size, image_size, col, row) {
        const glm::dvec3 direction = glm::normalize(
            ViewFrame(view.camera)
                .direction(pixel_centre(col, row), {.width = image_size, .height = image_size}));
        for (int i = 0; i < 3; ++i) {
            const double a = (view.clip.lo[i] - view.camera.eye[i]) / direction[i];
            const double b = (view.clip.hi[i] - view.camera.eye[i]) / direction[i];
            in = std::max(in, std::min(a, b));
            out = std::min(out, std::max(a, b));
        }
    }

    [[nodiscard]] int sign_at(double distance) const {
        const std::array<MpfrNumber, 3> p = exact_.at(MpfrNumber(distance / exact_.length()));
        return reference(expr_, {p[0], p[1], p[2], MpfrNumber(0.0)}).value.sign();
    }
    /// Whether f has different signs at places from `from` to `to`, close to the ends, too.
    [[nodiscard]] bool surely_has_root(double from, double to) const {
        if (!(from < to)) return false;
        const int first = sign_at(from);
        for (int step = 1; step <= 8; ++step) {
            if (sign_at(from + 0.125 * step * (to - from)) != first) return true;
        }
        for (double share = 0.1; share > 1e-11; share *= 0.1) {
            if (sign_at(from + share * (to - from)) != first) return true;
        }
        return false;
    }

    double in = 0.0, out = infinity;  ///< of the box

private:
    const Expr& expr_;
    ExactRay exact_;
};

/// How far from the root a depth may be: the bracket of a hit and its neighbours, a float's
/// rounding, and what the coordinates cannot tell apart.
double depth_tolerance(const View& view, double depth) {
    const double size = view.clip.size();
    const double seen = std::min(size, glm::distance(view.camera.eye, view.camera.look_at));
    const double cell = std::exp2(-d_stop) * std::clamp(depth, seen, size);
    const double ulp = 0x1p-50 * glm::length(view.camera.look_at);
    return 7.0 * std::max(cell, ulp) + 1e-6 * depth;
}

struct Tally {
    int must_hit = 0, certified = 0, undecided = 0;
};

void check_pixel(const Ray& ray, const View& view, Certificate certificate, double depth,
                 Tally& tally) {
    const double edge = depth_tolerance(view, ray.in);
    const bool must_hit = ray.surely_has_root(ray.in + edge, ray.out - edge);
    tally.must_hit += must_hit ? 1 : 0;
    tally.undecided += certificate == Certificate::Undecided ? 1 : 0;
    if (certificate == Certificate::Miss) {
        EXPECT_FALSE(must_hit) << "missed between " << ray.in << " and " << ray.out;
        return;
    }
    if (!std::isfinite(depth)) return;
    const double tolerance = depth_tolerance(view, depth);
    EXPECT_FALSE(ray.surely_has_root(ray.in + edge, depth - tolerance))
        << "behind a root: " << depth << " of " << ray.in << " to " << ray.out;
    if (certificate != Certificate::Certified) return;
    tally.certified += must_hit ? 1 : 0;
    EXPECT_NE(ray.sign_at(depth - tolerance), ray.sign_at(depth + tolerance))
        << "no root within " << tolerance << " of " << depth;
}

Tally check_view(const Stand& stand, const View& view, std::string_view tracer) {
    Scene scene{{{.kernel = interpret(stand.expr)}}, view.clip, {}};
    scene.uniforms.set(0, 0.0);
    TraceSettings settings;
    settings.tracer = tracer;
    settings.stop.value = d_stop;
    settings.threads = 2;
    Framebuffer frame(image_size, image_size);
    render_frame(scene, view.camera, settings, frame);
    Tally tally;
    for (int row = 0; row < image_size; ++row) {
        for (int col = 0; col < image_size; ++col) {
            SCOPED_TRACE(std::to_string(col) + "," + std::to_string(row));
            const std::size_t i = frame.index(col, row);
            check_pixel(Ray(stand, view, col, row), view, frame.certificate[i],
                        static_cast<double>(frame.depth[i]), tally);
        }
    }
    return tally;
}

using MakeView = View (*)(const Stand&, double side);

struct Way {
    const char* name;
    MakeView view;
};

class DeepZoom : public ::testing::TestWithParam<std::tuple<Way, Tracer>> {
protected:
    static View view(const Stand& stand, double side) {
        return std::get<Way>(GetParam()).view(stand, side);
    }
    static std::string_view tracer() { return std::get<Tracer>(GetParam()).name; }
};

TEST_P(DeepZoom, ShowsASmoothSurfaceDownToANanobox) {
    for (const Place& place : places()) {
        const Stand stand = stand_at(place);
        for (double side = 2.0 * stand.half_edge; side > 0.5e-9;
             side *= is_long_run() ? 0.1 : 1e-3) {
            SCOPED_TRACE(stand.name + ", side " + std::to_string(std::log10(side)));
            const View seen = view(stand, side);
            const Tally tally = check_view(stand, seen, tracer());
            const Precision precision =
                wanted_precision(seen.clip, ViewFrame(seen.camera), {StopRule::DStop, d_stop});
            EXPECT_TRUE(precision == Precision::Double || side > 1e-2);
            EXPECT_GT(tally.must_hit, 10);
            // f has several signs in a slice of the whole surface at its rim.
            EXPECT_GE(tally.certified, (side > 1.0 ? 0.6 : 0.98) * tally.must_hit);
        }
    }
}

TEST_P(DeepZoom, IsNeverWrongBelowWhatDoubleCanTellApart) {
    for (const Place& place : places()) {
        const Stand stand = stand_at(place);
        for (double side = 1e-11; side > 0.5e-15; side *= is_long_run() ? 0.1 : 1e-4) {
            SCOPED_TRACE(stand.name + ", side " + std::to_string(std::log10(side)));
            const View seen = view(stand, side);
            if (camera_defect(seen.camera) == nullptr) check_view(stand, seen, tracer());
        }
    }
}

class DeepZoomEnd : public ::testing::TestWithParam<Tracer> {};

TEST_P(DeepZoomEnd, IsUndecided) {
    for (const Place& place : places()) {
        const Stand stand = stand_at(place);
        const Tally near = check_view(stand, near_camera(stand, 2e-14), GetParam().name);
        EXPECT_EQ(near.certified, 0) << stand.name;
        EXPECT_GT(near.undecided, 30) << stand.name;
        const Tally tally = check_view(stand, small_box(stand, 1e-15), GetParam().name);
        EXPECT_EQ(tally.certified, 0) << stand.name;
        EXPECT_GT(tally.undecided, 30) << stand.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, DeepZoom,
                         ::testing::Combine(::testing::Values(Way{"small_box", small_box},
                                                              Way{"near_camera", near_camera}),
                                            ::testing::ValuesIn(proving_tracers_to_try())),
                         [](const auto& way) {
                             return std::get<Way>(way.param).name + std::string("_") +
                                    test_name(std::string(std::get<Tracer>(way.param).name));
                         });
INSTANTIATE_TEST_SUITE_P(AllTracers, DeepZoomEnd, ::testing::ValuesIn(proving_tracers_to_try()),
                         [](const auto& tracer) {
                             return test_name(std::string(tracer.param.name));
                         });

}  // namespace
}  // namespace zeroset::test::deep_zoom_test
