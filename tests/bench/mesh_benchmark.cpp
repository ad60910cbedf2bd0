#include "engine/base/clock.hpp"
#include "engine/mesh/make_mesh.hpp"
#include "engine/mesh/mesh_facts.hpp"
#include "engine/mesh/mesh_steps.hpp"
#include "engine/real/rounding.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/mesh_solid.hpp"
#include "pipeline/prepare.hpp"
#include "tests/bench/marching_cubes.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

// Our meshes against plain marching cubes whose distance from the surface, measured alike, is no
// greater: mesh_benchmark [TOLERANCE [NAME...]], names of the gallery.

namespace zeroset::test {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int most_cells = 400;

double farthest(const MeshSolid& solid, const TriangleMesh& mesh) {
    const std::vector<float> far = deviations(solid, mesh, {});
    return far.empty() ? 0.0 : double{*std::ranges::max_element(far)};
}

/// Milliseconds of each stage, one after the other.
class StageTimes {
public:
    void enter(MeshStage stage) {
        end();
        now_ = static_cast<std::size_t>(stage);
    }
    void end() {
        ms_.at(now_) += ms_since(since_);
        since_ = Clock::now();
    }
    [[nodiscard]] double of(MeshStage stage) const {
        return ms_.at(static_cast<std::size_t>(stage));
    }

private:
    std::array<double, 4> ms_{};
    std::size_t now_ = 0;
    Clock::time_point since_ = Clock::now();
};

/// The coarsest grid of 1, 1.25, 1.5, ... times a power of 2 cells that is good enough.
void print_cubes(const MeshSolid& solid, double error) {
    for (int cells = 16; cells <= most_cells; cells += std::max(4, cells / 4)) {
        const auto start = Clock::now();
        const TriangleMesh mesh = marching_cubes(solid, cells);
        const double ms = ms_since(start);
        const double far = farthest(solid, mesh);
        if (far > error) continue;
        std::printf(" | cubes %4d^3 %9zu %8.0f ms %.2e chi %lld\n", cells, mesh.triangles.size(),
                    ms, far, facts_of(mesh).euler());
        return;
    }
    std::printf(" | cubes: not by %d^3\n", most_cells);
}

void compare(const std::string& name, double relative) {
    const auto item = gallery_item(name);
    if (!item) return;
    const ReadDocument read = read_document(*item);
    const auto prepared = prepare(read.document, *read.rows, Preparation::Interpreted);
    const auto solids = surface_solids(
        picture_request(prepared->formula, prepared->colors, read.document, {}, {64, 64}));
    if (!solids || solids->empty()) return;
    const MeshSolid& solid = solids->front().solid;
    const double tolerance = relative * solid.box.size();
    const auto start = Clock::now();
    StageTimes times;
    const MadeMesh made =
        make_mesh(solid, {.tolerance = tolerance,
                          .limit = {.until = until_after(start, 30.0)},
                          .on_stage = [&](MeshStage stage) { times.enter(stage); }});
    times.end();
    const double ms = ms_since(start);
    std::printf(
        "%-14s tol %.1e | ours %8zu (of %zu, %zu cells) %8.0f ms %.2e chi %lld %s; ms of "
        "cells %.0f, proof %.0f, triangles %.0f, thinning %.0f",
        name.c_str(), tolerance, made.mesh.triangles.size(), made.report.thinned_from,
        made.report.cells, ms, made.report.deviation, facts_of(made.mesh).euler(),
        made.report.isotopic ? "proved" : "not proved", times.of(MeshStage::Dividing),
        times.of(MeshStage::Proving), times.of(MeshStage::Contouring),
        times.of(MeshStage::Thinning));
    const UpwardRegisters upward;
    print_cubes(solid, std::max(tolerance, made.report.deviation));
    std::fflush(stdout);
}

}  // namespace
}  // namespace zeroset::test

int main(int argc, char** argv) {
    const double tolerance = argc > 1 ? std::stod(argv[1]) : 1e-3;
    std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
    if (names.empty()) names = {"sphere", "torus", "tangle", "orthocircle", "steinmetz", "tiger"};
    for (const std::string& name : names)
        zeroset::test::compare(name, tolerance);
}
