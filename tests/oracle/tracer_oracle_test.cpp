#include "engine/trace/tracer.hpp"
#include "tests/oracle/ray_audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

// What each tracer says of single rays against the oracles, on the gallery and on random surfaces.
// `ray_checks` does the same at any size.

namespace zeroset::test {
namespace {

class TracerAgainstOracles : public ::testing::TestWithParam<std::string> {
protected:
    static AuditReport checked(const std::vector<AuditSurface>& surfaces) {
        AuditReport total;
        for (const AuditSurface& surface : surfaces)
            total += audit(surface, {.tracer = GetParam(), .rays = 14});
        for (const std::string& failure : total.failures)
            ADD_FAILURE() << failure;
        std::printf("%s\n", total.text().c_str());
        return total;
    }
};

TEST_P(TracerAgainstOracles, OnTheGallery) {
    const std::vector<AuditSurface> surfaces = gallery_surfaces();
    EXPECT_GE(surfaces.size(), 50U);
    const AuditReport report = checked(surfaces);
    EXPECT_GT(report.hit, report.rays / 4);
    EXPECT_GT(report.empty, report.rays / 4);
    EXPECT_LT(report.unknown, report.rays / 20);
    EXPECT_GT(report.hit_certified, report.hit * 8 / 10);
}

TEST_P(TracerAgainstOracles, OnRandomSurfaces) {
    const AuditReport report = checked(random_surfaces(200, 1));
    EXPECT_GT(report.hit, report.rays / 4);
    EXPECT_GT(report.empty, report.rays / 4);
    EXPECT_LT(report.unknown, report.rays / 10);
    EXPECT_GT(report.hit_certified, report.hit * 8 / 10);
}

std::vector<std::string> tracer_names() {
    std::vector<std::string> names;
    for (const Tracer& tracer : tracers())
        names.emplace_back(tracer.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(AllTracers, TracerAgainstOracles, ::testing::ValuesIn(tracer_names()),
                         [](const auto& tracer) {
                             std::string name = tracer.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace zeroset::test
