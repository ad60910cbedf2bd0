#include "papers/compare/voxel_rows.hpp"

#include "engine/render/tracers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>
#include <vector>

// The tables of rays in voxels: their data, what is counted, and what is made of it.

namespace zeroset::test::voxel_rows_test {
namespace {

constexpr double nothing = std::numeric_limits<double>::infinity();

TEST(VoxelTables, AreOfTracersThatThereAre) {
    const std::vector<VoxelTable>& tables = printed_tables().voxel_tables;
    ASSERT_EQ(tables.size(), 4U);
    for (const VoxelTable& table : tables) {
        std::set<VoxelMethod> methods;
        for (const PrintedVoxels& row : table.rows) {
            methods.insert(row.method);
            EXPECT_NE(find_tracer(name_of(row.method)), nullptr);
        }
        EXPECT_EQ(methods.size(), 5U);
    }
    EXPECT_EQ(tables[1].rays, RaysAtOnce::Packet);
    EXPECT_EQ(tables[1].rows[4].method, VoxelMethod::Marmitt);
    EXPECT_EQ(tables[1].rows[4].millions, (std::array{0.85, 4.80, 4.35}));
}

TEST(VoxelCounts, TellWhatIsMissedAddedAndMoved) {
    VoxelRay ray;
    ray.b = {0, 2, 0};
    ray.t_out = 1;
    const ProvedRoot root{.kind = ProvedRoot::Kind::Root, .t = 0.5};
    const ProvedRoot none{.kind = ProvedRoot::Kind::None};
    const ProvedRoot unknown{.kind = ProvedRoot::Kind::Unknown};
    VoxelCounts counts;
    counts.add(ray, root, 0.504);
    counts.add(ray, root, 0.506);  // two edges a unit of t: 0.012 of an edge away
    counts.add(ray, root, nothing);
    counts.add(ray, none, 0.5);
    counts.add(ray, none, nothing);
    counts.add(ray, unknown, 0.5);
    EXPECT_EQ(counts.voxels, 6U);
    EXPECT_EQ(counts.roots, 3U);
    EXPECT_EQ(counts.unknown, 1U);
    EXPECT_EQ(counts.missed, 1U);
    EXPECT_EQ(counts.moved, 1U);
    EXPECT_EQ(counts.added, 1U);
}

TEST(SyntheticVoxels, HoldTheLevelAndRaysThatCrossThem) {
    const auto lists = synthetic_voxels(300, 256);
    ASSERT_EQ(lists.size(), 14U);
    for (const VoxelRays& list : lists) {
        EXPECT_EQ(list.size() % 16, 0U);
        for (std::size_t i = 0; i < list.count(); ++i) {
            const VoxelRay ray = list.ray(i);
            EXPECT_EQ(std::ranges::min(ray.rho), -0.5F);
            EXPECT_EQ(std::ranges::max(ray.rho), 0.5F);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                EXPECT_GE(ray.a[axis], 0);
                EXPECT_LE(ray.a[axis] + ray.b[axis], 1.0001F);
            }
        }
    }
}

TEST(MeasuredVoxels, CountAll) {
    const auto lists = synthetic_voxels(512, 256);
    const auto proved = proved_roots(lists);
    const VoxelTable& table = *find_named(printed_tables().voxel_tables, "marmitt-table-2");
    std::vector<VoxelRow> rows;
    for (const PrintedVoxels& printed : table.rows) {
        rows.push_back(measured_voxels(table, printed, lists, proved));
        const VoxelRow& row = rows.back();
        EXPECT_EQ(row.counts.voxels, 7U * 512);
        EXPECT_GT(row.counts.roots, 1000U);
        EXPECT_LE(row.least, row.mean);
        EXPECT_LE(row.mean, row.most);
    }
    EXPECT_EQ(rows[0].counts.missed, 0U);  // the midpoint is always found
    EXPECT_GT(rows[0].counts.added, 100U);
    EXPECT_GT(rows[1].counts.missed, 10U);
    EXPECT_EQ(rows[1].counts.missed, rows[2].counts.missed);
    EXPECT_LT(rows[4].counts.missed + rows[4].counts.added, 4U);
    const std::string heading = voxel_heading_text(table);
    EXPECT_EQ(voxel_row_text(table, rows[2]).size(),
              heading.size() - heading.rfind('\n', heading.size() - 2) - 1);
    EXPECT_TRUE(voxel_row_text(table, rows[2]).contains("neubauer"));
}

}  // namespace
}  // namespace zeroset::test::voxel_rows_test
