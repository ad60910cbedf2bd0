#include "engine/real/rounding.hpp"
#include "engine/render/tracers.hpp"
#include "tests/support/exact_ray.hpp"
#include "tests/support/mpfr_number.hpp"
#include "tests/support/only_target.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/real_types.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

// The boxes that a tracer hands to the kernel hold the exact rays: a point of a pixel's ray is
// never lost, with every instruction set of this machine. The kernel of these tests has its zero at
// one point alone, known to 256 bits.

namespace zeroset::test::positions_test {
namespace {

/// A point between two doubles in each coordinate, the same where it is one.
struct Target {
    std::array<double, 3> below, above;

    template <class Real>
    [[nodiscard]] bool is_in(const RangeBatchOf<Real>& batch, std::size_t i) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (-static_cast<double>(batch.neg_lo[axis][i]) > below[axis]) return false;
            if (static_cast<double>(batch.hi[axis][i]) < above[axis]) return false;
        }
        return true;
    }
};

/// f is 1 away from the target, and from -1 to 1 where a box holds it.
template <class Real>
void range_around(const void* code, const RangeBatchOf<Real>* batch) {
    const Target& target = *static_cast<const Target*>(code);
    for (std::size_t i = 0; i < batch->size; ++i) {
        batch->f_hi[i] = 1;
        batch->f_neg_lo[i] = target.is_in(*batch, i) ? Real{1} : Real{-1};
        batch->continuous[i] = static_cast<ContinuityMask<Real>>(-1);
    }
}

Kernel kernel_of(const Target& target) {
    Kernel kernel;
    const auto code = std::make_shared<Target>(target);
    kernel.in_float.range = {range_around<float>, code};
    kernel.in_double.range = {range_around<double>, code};
    kernel.has_double = true;
    return kernel;
}

/// A pixel of an image, and where its ray is looked at.
struct Shot {
    Box clip;
    Camera camera;
    int width = 1, height = 1, col = 0, row = 0;
    double t = 0.0;

    [[nodiscard]] std::string text() const {
        const auto vector = [](const glm::dvec3& v) {
            std::ostringstream out;
            out.precision(17);
            out << v.x << "," << v.y << "," << v.z;
            return out.str();
        };
        std::ostringstream out;
        out << "box " << vector(clip.lo) << " to " << vector(clip.hi) << ", eye "
            << vector(camera.eye) << ", look at " << vector(camera.look_at) << ", fov "
            << camera.fov_rad << ", " << width << "x" << height << ", pixel " << col << "," << row
            << ", t " << t;
        return out.str();
    }
};

Target target_of(const Shot& shot) {
    const ExactRay ray(shot.camera, shot.width, shot.height, shot.col, shot.row);
    const std::array<MpfrNumber, 3> point = ray.at(MpfrNumber(shot.t));
    Target target{};
    for (std::size_t i = 0; i < 3; ++i) {
        target.below[i] = mpfr_get_d(point[i].get(), MPFR_RNDD);
        target.above[i] = mpfr_get_d(point[i].get(), MPFR_RNDU);
    }
    return target;
}

class Shots {
public:
    explicit Shots(std::uint64_t seed) : random_(seed) {}

    /// `distance`: from the origin to the box, in half edges of it.
    Shot shot(double distance) {
        Shot shot;
        const double size = std::exp2(uniform(-12, 8));
        const glm::dvec3 middle = chance(0.3) ? glm::dvec3(0.0) : size * distance * direction();
        const glm::dvec3 half =
            size * glm::dvec3(uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1));
        shot.clip = {middle - half, middle + half};
        shot.camera.fov_rad = std::numbers::pi * uniform(0.02, 0.94);
        shot.width = integer(1, 200);
        shot.height = integer(1, 200);
        shot.col = integer(0, shot.width - 1);
        shot.row = integer(0, shot.height - 1);
        aim(shot.camera, shot.clip);
        return shot;
    }
    double uniform(double lo, double hi) { return random_.uniform(lo, hi); }
    int integer(int lo, int hi) { return random_.between(lo, hi); }
    bool chance(double share) { return random_.uniform() < share; }

private:
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
            const double length = glm::length(v);
            if (length > 0.1 && length < 1.0) return v / length;
        }
    }
    /// A point inside the box, or on the planes of its faces.
    glm::dvec3 place(const Box& clip) {
        glm::dvec3 at;
        for (int i = 0; i < 3; ++i) {
            const double share = chance(0.1) ? integer(0, 1) : uniform(0, 1);
            at[i] = clip.lo[i] + share * (clip.hi[i] - clip.lo[i]);
        }
        return at;
    }
    void aim(Camera& camera, const Box& clip) {
        const glm::dvec3 seen = place(clip);
        camera.eye = chance(0.4) ? place(clip) : seen + clip.size() * uniform(1, 8) * direction();
        camera.look_at = seen;
        camera.up = direction();
        if (!chance(0.3)) return;
        // Rays along an axis and planes of rays across it, to the last bit.
        const int axis = integer(0, 2);
        const double reach = clip.size() * uniform(0.5, 4);
        camera.eye = seen;
        camera.eye[axis] += chance(0.5) ? reach : -reach;
        camera.up = glm::dvec3(0.0);
        camera.up[(axis + integer(1, 2)) % 3] = 1.0;
    }

    RandomNumbers random_;
};

/// The part of the ray in the box, roughly.
std::array<double, 2> span_of(const Shot& shot) {
    const glm::dvec3 direction = ViewFrame(shot.camera)
                                     .direction(pixel_centre(shot.col, shot.row),
                                                {.width = shot.width, .height = shot.height});
    std::array<double, 2> span{0.0, std::numeric_limits<double>::infinity()};
    for (int i = 0; i < 3; ++i) {
        if (direction[i] == 0.0) continue;
        const double a = (shot.clip.lo[i] - shot.camera.eye[i]) / direction[i];
        const double b = (shot.clip.hi[i] - shot.camera.eye[i]) / direction[i];
        span[0] = std::max(span[0], std::min(a, b));
        span[1] = std::min(span[1], std::max(a, b));
    }
    return span;
}

bool is_in_box(const Target& target, const Box& clip) {
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        if (target.below[i] < clip.lo[axis] || target.above[i] > clip.hi[axis]) return false;
    }
    return true;
}

/// Traces the patch of pixels around the shot's; whether its point was found where it is.
::testing::AssertionResult is_found(const Shot& shot, const Target& target, Precision precision,
                                    int depth, int offset) {
    const Kernel kernel = kernel_of(target);
    const Scene scene{{{.kernel = kernel}}, shot.clip, {}};
    const StopCriterion stop;
    TraceFrame frame = trace_frame(scene, scene.surfaces.front(), ViewFrame(shot.camera),
                                   {.width = shot.width, .height = shot.height}, stop);
    frame.precision = precision;
    frame.depth = {depth, 0};
    const int col = std::max(0, shot.col - offset % 8);
    const int row = std::max(0, shot.row - offset / 8);
    const Tile tile{col, row, std::min(8, shot.width - col), std::min(8, shot.height - row)};
    TileHits hits;
    Counters counters;
    {
        const UpwardRounding upward;
        find_tracer("k-bisection")->trace_tile(frame, tile, hits, counters);
    }
    const int digits = precision == Precision::Float ? 24 : 53;
    const glm::dvec3 far = glm::max(glm::abs(shot.clip.lo), glm::abs(shot.clip.hi));
    const double reach = std::max({far.x, far.y, far.z});
    const double tolerance =
        shot.clip.size() * std::exp2(1 - depth) + reach * std::exp2(6 - digits);
    const TileHits::Pixel wanted{static_cast<std::int16_t>(shot.col - col),
                                 static_cast<std::int16_t>(shot.row - row)};
    for (const TileHits::Point& point : hits.points) {
        if (point.pixel != wanted.index()) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double error = std::abs(point.position[axis] - target.below[axis]);
            if (error > tolerance)
                return ::testing::AssertionFailure() << "found at a distance of " << error;
        }
        return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << "lost";
}

std::vector<std::int64_t> instruction_sets() { return hwy::SupportedAndGeneratedTargets(); }

template <class Real>
class PositionsTest : public ::testing::Test {
protected:
    static constexpr bool is_float = std::is_same_v<Real, float>;
    static constexpr Precision precision = is_float ? Precision::Float : Precision::Double;

    /// Checks `count` points of random rays. `distance` as in Shots::shot.
    void check(int count, double distance, std::uint64_t seed) {
        Shots shots(seed);
        int checked = 0;
        while (checked < count) {
            Shot shot = shots.shot(distance * shots.uniform(0, 1));
            const auto [in, out] = span_of(shot);
            if (!(in < out) || camera_defect(shot.camera) != nullptr) continue;
            const double share = shots.chance(0.2) ? shots.integer(0, 1) : shots.uniform(0, 1);
            shot.t = in + share * (out - in);
            const Target target = target_of(shot);
            if (!is_in_box(target, shot.clip)) continue;
            const int depth = shots.integer(1, is_float ? 22 : 50);
            ASSERT_TRUE(is_found(shot, target, precision, depth, shots.integer(0, 63)))
                << shot.text() << ", depth " << depth;
            ++checked;
        }
    }
};

TYPED_TEST_SUITE(PositionsTest, RealTypes, RealTypeNames);

TYPED_TEST(PositionsTest, HoldTheExactRays) {
    for (const std::int64_t target : instruction_sets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        const OnlyTarget only(target);
        this->check(4000, 3.0, 1);
    }
}

TYPED_TEST(PositionsTest, HoldTheExactRaysFarFromTheOrigin) {
    for (const std::int64_t target : instruction_sets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        const OnlyTarget only(target);
        this->check(2000, this->is_float ? 1e4 : 1e12, 2);
    }
}

}  // namespace
}  // namespace zeroset::test::positions_test
