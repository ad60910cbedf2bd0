#include "tests/oracle/ray_audit.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Checks each tracer's claims about single rays against the oracles, on the gallery and on random
// surfaces. `ray_checks` does the same at any size.

namespace zeroset::test::tracer_oracle_test {
namespace {

/// Returns a fifth of the surfaces, others for each tracer, so that all are met; all of them for
/// the usual tracer, and in a long run.
std::vector<AuditSurface> part_for(const std::string& tracer, std::vector<AuditSurface> surfaces) {
    const std::vector<std::string> names = tracer_names();
    const auto nth = std::ranges::find(names, tracer) - names.begin();
    if (nth == 0 || is_long_run()) return surfaces;
    std::vector<AuditSurface> part;
    for (auto i = static_cast<std::size_t>(nth % 5); i < surfaces.size(); i += 5)
        part.push_back(std::move(surfaces[i]));
    return part;
}

class TracerAgainstOracles : public ::testing::TestWithParam<std::string> {
protected:
    static AuditReport checked(const std::vector<AuditSurface>& surfaces) {
        AuditReport total;
        for (const AuditSurface& surface : surfaces)
            total += audit(surface, {.tracer = GetParam(), .rays = 10, .interpreted = true});
        for (const std::string& failure : total.failures)
            ADD_FAILURE() << failure;
        std::printf("%s\n", total.text().c_str());
        return total;
    }
};

TEST_P(TracerAgainstOracles, OnTheGallery) {
    const std::vector<AuditSurface> surfaces = gallery_surfaces();
    EXPECT_GE(surfaces.size(), 50U);
    const AuditReport report = checked(part_for(GetParam(), surfaces));
    EXPECT_GT(report.hit, report.rays / 4);
    EXPECT_GT(report.empty, report.rays / 4);
    EXPECT_LT(report.unknown, report.rays / 20);
    EXPECT_GT(report.hit_certified, report.hit * 8 / 10);
}

TEST_P(TracerAgainstOracles, OnRandomSurfaces) {
    const std::vector<AuditSurface> surfaces = random_surfaces(is_long_run() ? 200 : 25, 2);
    const AuditReport report = checked(surfaces);
    EXPECT_GT(report.hit, report.rays / 4);
    EXPECT_GT(report.empty, report.rays / 4);
    EXPECT_LT(report.unknown, report.rays / 10);
    EXPECT_GT(report.hit_certified, report.hit * 8 / 10);
}

TEST_P(TracerAgainstOracles, OnSurfacesCutOpenAndParallelRays) {
    const AuditReport report = checked(cut_open(random_surfaces(is_long_run() ? 150 : 40, 3), 5));
    EXPECT_GT(report.hit, report.rays / 10);
    EXPECT_GT(report.empty, report.rays / 4);
    EXPECT_LT(report.unknown, report.rays / 10);
    EXPECT_GT(report.hit_certified, report.hit * 8 / 10);
}

/// Changes a true picture of the sphere into false ones, which the audit must find.
TEST_P(TracerAgainstOracles, FalsePicturesAreFound) {
    const AuditSurface sphere{"sphere", "x^2 + y^2 + z^2 - 1", Box::cube(1.5), 0.0,
                              suite_camera(1.5)};
    const AuditSettings settings{.tracer = GetParam()};
    const Framebuffer picture = drawn(sphere, settings);
    const AuditReport truth = audit(sphere, settings, picture);
    EXPECT_EQ(truth.failures.size(), 0U);
    ASSERT_GT(truth.hit, 50U);

    Framebuffer all_empty = picture;
    std::ranges::fill(all_empty.certificate, Certificate::Miss);
    std::ranges::fill(all_empty.depth, std::numeric_limits<float>::infinity());
    EXPECT_EQ(audit(sphere, settings, all_empty).failures.size(), truth.hit + truth.touched);

    Framebuffer all_certified = picture;
    std::ranges::fill(all_certified.certificate, Certificate::Certified);
    EXPECT_GE(audit(sphere, settings, all_certified).failures.size(), truth.empty);

    Framebuffer moved = picture;  // by ten cells
    for (float& depth : moved.depth)
        depth += 10 * 3.0F * 0x1p-14F;
    EXPECT_EQ(audit(sphere, settings, moved).failures.size(), truth.hit_certified);
}

INSTANTIATE_TEST_SUITE_P(AllTracers, TracerAgainstOracles, ::testing::ValuesIn(tracer_names()),
                         [](const auto& tracer) { return test_name(tracer.param); });

}  // namespace
}  // namespace zeroset::test::tracer_oracle_test
