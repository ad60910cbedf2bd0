#include "engine/trace/blobs/blob_kernel.hpp"

#include "engine/antialias/cover_search.hpp"
#include "engine/kernel/form_cells.hpp"
#include "engine/kernel/point_batch.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "engine/trace/blobs/blob_way.hpp"
#include "engine/trace/tile_rays.hpp"
#include "tests/support/alike_frames.hpp"
#include "tests/support/blob_scenes.hpp"
#include "tests/support/random_numbers.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

// The answers of the balls near a tile's pixels for cells, points and whole pixels, against the
// field itself; and of a ball alone the area that it covers of each pixel.

namespace zeroset::test::blob_kernel_test {
namespace {

constexpr std::array kinds{BlobKind::Wyvill, BlobKind::Metaball, BlobKind::Blinn};
constexpr int side = tile_size;
constexpr Tile tile{.col = 0, .row = 0, .cols = side, .rows = side};
constexpr StopCriterion usual_stop{.rule = StopRule::DStop, .value = 14};

/// A tile of a scene.
struct Seen {
    Seen(const Scene& scene, const Camera& camera, Precision precision = Precision::Float)
        : view(camera),
          frame(trace_frame(scene, scene.surfaces.front(), view, {.width = side, .height = side},
                            usual_stop)) {
        frame.precision = precision;
        frame.whole_pixels = true;
        rays = std::make_unique<TileRays>(frame, tile);
    }

    [[nodiscard]] glm::dvec3 direction(double u, double v) const {
        return view.forward + u * view.right + v * view.up;
    }
    [[nodiscard]] glm::dvec3 place(double u, double v, double s) const {
        return rays->base() + rays->distance() * (u * view.right + v * view.up) +
               s * direction(u, v);
    }

    ViewFrame view;
    TraceFrame frame;
    std::unique_ptr<TileRays> rays;
};

/// f and its gradient by the frame's own kernel.
struct At {
    double f;
    glm::dvec3 gradient;
};
std::vector<At> field_at(const Kernel& kernel, const TraceFrame& frame,
                         const std::vector<glm::dvec3>& places) {
    PointBatch<double> batch(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        batch.set(i, places[i].x, places[i].y, places[i].z);
    batch.pad();
    batch.evaluate(kernel.in_double.value, frame.scene.uniforms.points<double>(),
                   [] { return false; });
    std::vector<At> all;
    for (std::size_t i = 0; i < places.size(); ++i)
        all.push_back(
            {.f = batch.f(i),
             .gradient = {batch.gradient(0, i), batch.gradient(1, i), batch.gradient(2, i)}});
    return all;
}

const Camera usual{{2.5, -2, 1.5}, {0, 0, 0}, {0, 0, 1}, 0.7};

Camera camera_of(Projection projection) {
    Camera camera = usual;
    camera.projection = projection;
    return camera;
}

class BlobKernel : public testing::TestWithParam<Projection> {
protected:
    /// Cells of one size, at random in a tile; samples of each are in its form.
    template <class Real>
    void expect_enclosed(const Seen& seen, double width, double length) {
        const UpwardRegisters upward;
        const auto kernel = blob_kernel(seen.frame, tile);
        ASSERT_TRUE(kernel);
        const TileRays& rays = *seen.rays;
        constexpr std::size_t count = 48;
        FormCells<Real, count> cells;
        FrustumOf<Real> frustum = rays.frustum<Real>(1);
        const double radius = 0.5 * width * rays.pixel();
        frustum.u_radius = frustum.v_radius = static_cast<Real>(radius);
        const DepthRange all = rays.depths(0.0, 0.0, 0.5, 0.5);
        const double middle = seen.view.parallel() ? 0.0 : 0.5 * all.enter_lo + 0.5 * all.exit_hi;
        const double half = seen.view.parallel() ? 1.0 : 0.4 * (all.exit_hi - all.enter_lo);
        for (std::size_t i = 0; i < count; ++i) {
            const double col = std::floor(random_.uniform(0, side));
            const double row = std::floor(random_.uniform(0, side));
            const double off = 0.5 - 0.5 * width;
            cells.u[i] = static_cast<Real>(rays.u(col + random_.uniform(-off, off)));
            cells.v[i] = static_cast<Real>(rays.v(row + random_.uniform(-off, off)));
            cells.s[i] = static_cast<Real>(middle + half * random_.uniform(-0.7, 0.7));
            cells.s_radius[i] = static_cast<Real>(length * random_.uniform(0.2, 1));
        }
        const Real* const uniforms = seen.frame.scene.uniforms.boxes<Real>();
        kernel->in<Real>().form(cells.batch(count, frustum, uniforms));
        for (std::size_t i = 0; i < count; ++i)
            expect_enclosed(seen, cells, i, radius);
    }

    template <class Real, std::size_t count>
    void expect_enclosed(const Seen& seen, const FormCells<Real, count>& cells, std::size_t i,
                         double radius) {
        struct Place {
            double u, v, s;
        };
        std::vector<Place> in_cell;
        std::vector<glm::dvec3> places;
        const auto number = [i](const auto& of) { return static_cast<double>(of[i]); };
        for (int n = 0; n < 60; ++n) {
            // Corners, edges and what is between them.
            const auto part = [&] { return std::clamp(random_.uniform(-1.5, 1.5), -1.0, 1.0); };
            const Place at{.u = part(), .v = part(), .s = part()};
            in_cell.push_back(at);
            places.push_back(seen.place(number(cells.u) + at.u * radius,
                                        number(cells.v) + at.v * radius,
                                        number(cells.s) + at.s * number(cells.s_radius)));
        }
        const std::vector<At> found = field_at(seen.frame.kernel, seen.frame, places);
        ++cells_;
        if (number(cells.e) < 0.1) ++fine_;
        for (std::size_t n = 0; n < places.size(); ++n) {
            const Place& at = in_cell[n];
            const double linear = number(cells.c) + number(cells.k[0]) * at.u +
                                  number(cells.k[1]) * at.v + number(cells.k[2]) * at.s;
            ASSERT_LE(std::abs(found[n].f - linear), number(cells.e) + 1e-9);
            const double slope = glm::dot(
                found[n].gradient,
                seen.direction(number(cells.u) + at.u * radius, number(cells.v) + at.v * radius));
            ASSERT_LE(-number(cells.slope_neg_lo), slope + 1e-8);
            ASSERT_GE(number(cells.slope_hi), slope - 1e-8);
        }
    }

    RandomNumbers random_{11};
    int cells_ = 0, fine_ = 0;
};

TEST_P(BlobKernel, EnclosesTheFieldInCells) {
    for (const BlobKind kind : kinds) {
        for (const double level : {0.8, -0.4}) {
            const Both both = both_of(kind, {.count = 300, .hollow = 0.3}, level);
            const Seen in_float(both.balls, camera_of(GetParam()));
            const Seen in_double(both.balls, camera_of(GetParam()), Precision::Double);
            for (const double width : {1.0, 0.25}) {
                for (const double length : {0.001, 0.02, 0.1, 0.6}) {
                    SCOPED_TRACE(std::string(blob_name(kind)) + ", cells of " +
                                 std::to_string(length));
                    ASSERT_NO_FATAL_FAILURE(expect_enclosed<float>(in_float, width, length));
                    ASSERT_NO_FATAL_FAILURE(expect_enclosed<double>(in_double, width, length));
                }
            }
        }
    }
    EXPECT_GT(fine_, cells_ / 3) << "the enclosures tell something";
}

TEST_P(BlobKernel, HasTheFieldsValues) {
    for (const BlobKind kind : kinds) {
        const Both both = both_of(kind, {.count = 300}, 0.8);
        const Seen seen(both.balls, camera_of(GetParam()));
        const UpwardRegisters upward;
        const auto kernel = blob_kernel(seen.frame, tile);
        ASSERT_TRUE(kernel);
        std::vector<glm::dvec3> places;
        for (int n = 0; n < 500; ++n)
            places.push_back(seen.place(seen.rays->u(random_.uniform(-0.5, side - 0.5)),
                                        seen.rays->v(random_.uniform(-0.5, side - 0.5)),
                                        random_.uniform(-0.8, 0.8)));
        const std::vector<At> wanted = field_at(seen.frame.kernel, seen.frame, places);
        // Places that are none, such as ends of empty stretches, take nothing from the others.
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t n = 0; n < places.size(); n += 3)
            places[n] = glm::dvec3(none);
        const std::vector<At> found = field_at(*kernel, seen.frame, places);
        for (std::size_t n = 0; n < places.size(); ++n) {
            if (n % 3 == 0) continue;
            ASSERT_NEAR(found[n].f, wanted[n].f, 1e-11);
            ASSERT_LE(glm::length(found[n].gradient - wanted[n].gradient), 1e-9);
        }
    }
}

/// Whether f has one sign on a ray of a pixel between two depths, as far as samples tell.
bool is_of_one_sign(const Seen& seen, double col, double row, double from, double to) {
    constexpr int samples = 100;
    std::vector<glm::dvec3> places;
    for (int n = 0; n <= samples; ++n)
        places.push_back(
            seen.place(seen.rays->u(col), seen.rays->v(row), from + (to - from) * n / samples));
    const std::vector<At> found = field_at(seen.frame.kernel, seen.frame, places);
    return std::ranges::all_of(found, [&](const At& at) { return at.f * found.front().f > 0; });
}

/// The answer of a PixelCover for one pixel.
struct Told {
    bool is_mixed, is_covered;
    double before;    ///< this there is no root
    double from, to;  ///< is_covered: there is one between them
};
Told told_of(const PixelCover& cover, int col, int row) {
    const auto at = static_cast<std::size_t>(row * tile_size + col);
    constexpr float none = std::numeric_limits<float>::infinity();
    const bool is_mixed = (cover.mixed_in_row(row) >> col & 1U) != 0;
    const bool is_covered = !is_mixed && cover.to[at] < none;
    const float before = is_mixed ? cover.other_from[at] : is_covered ? cover.from[at] : none;
    return {.is_mixed = is_mixed,
            .is_covered = is_covered,
            .before = static_cast<double>(before),
            .from = static_cast<double>(cover.from[at]),
            .to = static_cast<double>(cover.to[at])};
}

/// Whether samples on a ray agree with what is said of its pixel.
bool agrees(const Seen& seen, const Told& told, double col, double row) {
    const auto inside = seen.rays->stretch_inside(seen.rays->u(col), seen.rays->v(row));
    if (!(inside.from < inside.to)) return true;
    const double end = std::min(inside.to, told.before);
    if (inside.from < end && !is_of_one_sign(seen, col, row, inside.from, end)) return false;
    return !told.is_covered || !is_of_one_sign(seen, col, row, told.from, told.to);
}

TEST_P(BlobKernel, IsRightAboutWholePixels) {
    int covered = 0;
    int free = 0;
    int mixed = 0;
    const auto check = [&](const Seen& seen, const PixelCover& cover, int col, int row) {
        const Told told = told_of(cover, col, row);
        mixed += told.is_mixed ? 1 : 0;
        covered += told.is_covered ? 1 : 0;
        free += told.is_mixed || told.is_covered ? 0 : 1;
        for (int n = 0; n < 9; ++n)
            ASSERT_TRUE(agrees(seen, told, col + 0.49 * (n % 3 - 1), row + 0.49 * (n / 3 - 1)))
                << col << ", " << row;
    };
    for (const BlobKind kind : kinds) {
        SCOPED_TRACE(blob_name(kind));
        const Both both = both_of(kind, {.count = 9, .least = 0.3, .largest = 0.6}, 0.8);
        const Seen seen(both.balls, camera_of(GetParam()));
        TileHits hits;
        hits.clear();
        Counters counters;
        const UpwardRegisters upward;
        ASSERT_TRUE(BlobWay().trace_tile(seen.frame, tile, hits, counters));
        ASSERT_TRUE(hits.cover.known);
        for (int at = 0; at < side * side; at += 5)
            check(seen, hits.cover, at % side, at / side);
    }
    EXPECT_GT(covered, 250);
    EXPECT_GT(free, 200);
    EXPECT_LT(mixed, covered + free) << "most pixels are known";
}

INSTANTIATE_TEST_SUITE_P(Views, BlobKernel,
                         testing::Values(Projection::Perspective, Projection::Orthographic));

/// The part that a disc covers of a pixel of this width, from its left bottom corner on.
double disc_in(const glm::dvec2& corner, double pixel, const glm::dvec2& middle, double radius) {
    constexpr int slices = 2000;
    double sum = 0;
    for (int i = 0; i < slices; ++i) {
        const double x = corner.x + (i + 0.5) / slices * pixel - middle.x;
        const double half = std::sqrt(std::max(0.0, radius * radius - x * x));
        sum += std::max(
            0.0, std::min(middle.y + half, corner.y + pixel) - std::max(middle.y - half, corner.y));
    }
    return sum / slices / pixel;
}

TEST(BlobEdges, CoverWhatABallCoversOfEachPixel) {
    constexpr double pixel = 2.0 / side;
    const Camera from_above{
        {0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 2.0 * std::atan(0.5), Projection::Orthographic};
    RandomNumbers random(5);
    for (int n = 0; n < 12; ++n) {
        const glm::dvec2 middle(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
        const double radius = random.uniform(3, 20) * pixel;
        const BlobKind kind = kinds[static_cast<std::size_t>(n) % kinds.size()];
        const std::vector<Blob> ball{{.center = {middle.x, middle.y, 0.1}, .radius = radius}};
        // Each kind's ball alone has its radius where the field is 1.
        const Expr f = level_of(blobs_field(kind, ball, "alone"), 1);
        Scene scene{{{.kernel = kernel_with_level(f)}}, Box::cube(1.5), {}};
        scene.uniforms.set(0, 0.0);
        const Seen seen(scene, from_above);
        const UpwardRounding upward;
        const auto kernel = blob_kernel(seen.frame, tile);
        ASSERT_TRUE(kernel);
        std::vector<MixedPixel> pixels;
        for (int at = 0; at < side * side; ++at)
            pixels.push_back({.pixel = static_cast<std::uint16_t>(at),
                              .from = -std::numeric_limits<float>::infinity(),
                              .hit = std::numeric_limits<float>::infinity()});
        const std::vector<TraceFrame> frames{seen.frame.with(*kernel, {})};
        std::vector<CoverSample> samples;
        Counters counters;
        find_cover(frames, tile, pixels, samples, counters);
        std::vector<double> cover(std::size_t{side} * side, 0.0);
        for (const CoverSample& sample : samples)
            cover[sample.pixel] += static_cast<double>(sample.area);
        double errors = 0;
        int edges = 0;
        for (int row = 0; row < side; ++row) {
            for (int col = 0; col < side; ++col) {
                const glm::dvec2 corner((col - side / 2) * pixel, (side / 2 - row - 1) * pixel);
                const double found = cover[static_cast<std::size_t>(row * side + col)];
                const double exact = disc_in(corner, pixel, middle, radius);
                // By so much an edge may be off from the line that is drawn for it
                // (cover_rules.hpp).
                ASSERT_NEAR(found, exact, 1.0 / 68) << blob_name(kind) << " of " << radius / pixel
                                                    << " pixels at " << col << ", " << row;
                errors += std::abs(found - exact);
                edges += exact > 0 && exact < 1 ? 1 : 0;
            }
        }
        EXPECT_LT(errors, edges / 256.0) << blob_name(kind) << " of " << radius / pixel;
    }
}

/// The mean square of what two pictures differ by, in steps of 8 bits.
double difference_of(const Framebuffer& a, const Framebuffer& b) {
    double sum = 0;
    for (std::size_t at = 0; at < a.color.size(); ++at) {
        for (unsigned shift = 0; shift < 24; shift += 8) {
            const double off = static_cast<double>(a.color[at] >> shift & 255U) -
                               static_cast<double>(b.color[at] >> shift & 255U);
            sum += off * off;
        }
    }
    return sum / (3.0 * static_cast<double>(a.color.size()));
}

TEST(BlobEdges, AreAsNearToManyRaysAsThoseByTheWholeField) {
    for (const BlobKind kind : kinds) {
        Both both = both_of(kind, {.count = 60, .least = 0.1, .largest = 0.3}, 0.8);
        const auto picture = [&](const Scene& scene, Antialias antialias, int scale = 1) {
            Framebuffer frame(scale * 131, scale * 99);
            TraceSettings settings;
            settings.antialias = antialias;
            render_frame(scene, usual, settings, frame);
            return frame;
        };
        const Framebuffer many = averaged(picture(both.balls, Antialias::Rays16, 4), 4);
        const double plain = difference_of(picture(both.balls, Antialias::None), many);
        const double balls = difference_of(picture(both.balls, Antialias::Beams), many);
        const double beams = difference_of(picture(both.beams, Antialias::Beams), many);
        EXPECT_LT(balls, 0.006 * plain) << blob_name(kind);
        EXPECT_LT(balls, 1.2 * beams + 0.02) << blob_name(kind);

        // Rays beside a clip sphere have no stretch.
        both.balls.region.ball = Ball{.centre = {0.1, 0, 0}, .radius = 0.6};
        const Framebuffer cut = picture(both.balls, Antialias::Rays64);
        EXPECT_LT(difference_of(picture(both.balls, Antialias::Beams), cut),
                  0.04 * difference_of(picture(both.balls, Antialias::None), cut))
            << blob_name(kind);
    }
}

}  // namespace
}  // namespace zeroset::test::blob_kernel_test
