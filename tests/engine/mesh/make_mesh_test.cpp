#include "engine/mesh/make_mesh.hpp"

#include "engine/mesh/mesh_facts.hpp"
#include "tests/support/mesh_checks.hpp"
#include "tests/support/solids.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

// Whatever ends the work, what comes out is closed or nothing.

namespace zeroset::test::make_mesh_test {
namespace {

TEST(MakeMesh, IsClosedAndSaysSoWhereThereIsNoTimeAtAll) {
    for (const char* text : {"x^2 + y^2 + z^2 - 1", "x^2 + y^2 - z^2", "max(x, y, z) - 0.5"}) {
        const MadeMesh made =
            make_mesh(solid_of({text}, Box::cube(2)),
                      {.tolerance = 1e-4, .limit = {.until = TimeLimit::Clock::time_point()}});
        EXPECT_EQ(defect_of(made.mesh), "") << text;
        EXPECT_FALSE(made.mesh.triangles.empty()) << text;
        EXPECT_LT(made.mesh.triangles.size(), 20'000U) << text;
        EXPECT_TRUE(made.report.cut) << text;
        EXPECT_FALSE(made.report.isotopic) << text;
        EXPECT_GT(made.report.unproved, 0U) << text;
    }
}

TEST(MakeMesh, IsClosedAndSmallWhereNothingCanBeProved) {
    // All gradients vanish at the surface.
    const MadeMesh made = make_mesh(solid_of({"(x^2 + y^2 + z^2 - 1)^3"}, Box::cube(2)),
                                    {.tolerance = 2e-3, .most_uncertain = 1'000});
    EXPECT_EQ(defect_of(made.mesh), "");
    EXPECT_EQ(facts_of(made.mesh).euler(), 2);
    EXPECT_TRUE(made.report.dense);
    EXPECT_FALSE(made.report.isotopic);
    EXPECT_LT(made.report.thinned_from, 100'000U);
}

/// An eight turned about its axis: two drops that meet at the origin.
TEST(MakeMesh, SaysWhereTheOnlyNodeIs) {
    const MadeMesh made =
        make_mesh(solid_of({"x^2 + y^2 - z^2*(1 - z^2)"}, Box::cube(1.2)), {.tolerance = 0.01});
    EXPECT_EQ(defect_of(made.mesh), "");
    ASSERT_EQ(made.report.places.size(), 1U);
    EXPECT_LT(glm::length(made.report.places[0].cell), 0.1);
    EXPECT_LT(made.report.places[0].reach, 0.1);
    EXPECT_EQ(made.report.rough, 0U);
    EXPECT_FALSE(made.report.cut || made.report.dense);
}

/// Wedges of 23 to 48 degrees, whose tips are thinner than cells.
TEST(MakeMesh, HasNoFalseHandlesAtSharpEdges) {
    for (const char* slope : {"0.2", "0.3", "0.45"}) {
        const std::string steep = std::string(slope) + "*x";
        const MadeMesh made =
            make_mesh(solid_of({"y - " + steep, "-y - " + steep, "x - 1", "z - 0.8", "-z - 0.8"},
                               Box::cube(2)),
                      {.tolerance = 0.04});
        EXPECT_EQ(defect_of(made.mesh), "") << slope;
        const MeshFacts facts = facts_of(made.mesh);
        EXPECT_EQ(facts.components, 1U) << slope;
        EXPECT_EQ(facts.genus(), 0) << slope;
        EXPECT_NEAR(facts.volume, 1.6 * std::stod(slope), 1e-3) << slope;
    }
}

TEST(MakeMesh, IsNothingWhereItIsCancelled) {
    const std::atomic<bool> cancelled = true;
    const MadeMesh made = make_mesh(unit_ball(), {.limit = {.cancel = &cancelled}});
    EXPECT_TRUE(made.mesh.triangles.empty());
    EXPECT_FALSE(made.report.isotopic);
    for (const MeshStage last : {MeshStage::Proving, MeshStage::Contouring, MeshStage::Thinning}) {
        std::atomic<bool> later = false;
        const MadeMesh ended =
            make_mesh(unit_ball(), {.limit = {.cancel = &later}, .on_stage = [&](MeshStage stage) {
                                        if (stage == last) later = true;
                                    }});
        EXPECT_TRUE(ended.mesh.triangles.empty());
    }
}

}  // namespace
}  // namespace zeroset::test::make_mesh_test
