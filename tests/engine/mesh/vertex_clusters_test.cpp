#include "engine/mesh/vertex_clusters.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace zeroset::test::vertex_clusters_test {
namespace {

// An octahedron: 0 and 1 at the ends of x, 2 and 3 of y, 4 and 5 of z.
constexpr std::array<Triangle, 8> octahedron{
    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};

std::vector<std::uint32_t> defects_of(const std::vector<std::uint64_t>& labels) {
    VertexClusters clusters(octahedron, labels.size());
    const VertexClusters::Set all(labels.size(), 1);
    clusters.join(labels, all);
    return clusters.defects(all);
}

constexpr std::uint64_t alone = VertexClusters::alone;

TEST(VertexClusters, KeepAClosedPiece) {
    EXPECT_TRUE(defects_of({alone, alone, alone, alone, alone, alone}).empty());
    // Two neighbours that are one leave a tetrahedron with a pole.
    EXPECT_TRUE(defects_of({0, alone, 0, alone, alone, alone}).empty());
}

TEST(VertexClusters, TellGroupsOfWhichNothingWouldBeLeft) {
    EXPECT_FALSE(defects_of({0, 0, 0, 0, 0, 0}).empty()) << "all of it";
    EXPECT_EQ(defects_of({0, 1, 0, 1, 0, 1}).size(), 2U) << "two halves";
    EXPECT_FALSE(defects_of({0, 1, 0, 1, 2, 2}).empty()) << "two ends that are no neighbours";
}

}  // namespace
}  // namespace zeroset::test::vertex_clusters_test
