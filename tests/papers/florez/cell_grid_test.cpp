#include "papers/florez/cell_grid.hpp"

#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

// Grids hold all of a surface, for all values of w that they are made for, and are kept.

namespace zeroset::test::cell_grid_test {
namespace {

std::shared_ptr<const CellGrid> grid_of(const Scene& scene) {
    const TraceFrame frame =
        trace_frame(scene, scene.surfaces[0], ViewFrame(default_camera(scene.clip)),
                    {.width = 40, .height = 40}, StopCriterion());
    return std::static_pointer_cast<const CellGrid>(prepare_cell_grid(frame, 2));
}

/// The number of the cell of a 4 wide box that holds a place.
int cell_at(double place) { return static_cast<int>(std::floor((place + 2.0) * 8.0)); }

void expect_holds_sphere(const CellGrid& grid, double radius) {
    for (int i = 0; i < 40; ++i) {
        for (int k = 0; k < 20; ++k) {
            const double phi = 0.1571 * i + 0.01;
            const double theta = 0.1571 * k + 0.01;
            EXPECT_TRUE(grid.is_crossed(cell_at(radius * std::sin(theta) * std::cos(phi)),
                                        cell_at(radius * std::sin(theta) * std::sin(phi)),
                                        cell_at(radius * std::cos(theta))))
                << phi << " " << theta;
        }
    }
}

TEST(CellGrid, HoldsASphereAndLittleElse) {
    const Scene scene = scene_of("x^2 + y^2 + z^2 = 1", Box::cube(2));
    const auto grid = grid_of(scene);
    expect_holds_sphere(*grid, 1.0);
    EXPECT_FALSE(grid->is_crossed(0, 0, 0));
    EXPECT_FALSE(grid->is_crossed(15, 16, 15));
    EXPECT_LT(grid->crossed_cells(), 3000U);  // of 32768
    EXPECT_EQ(grid->plane(0, 0), -2.0);
    EXPECT_EQ(grid->plane(2, 16), 0.0);
    EXPECT_EQ(grid->plane(1, CellGrid::side), 2.0);
}

TEST(CellGrid, IsThatOfAllFramesInAnInterval) {
    Scene scene = scene_of("x^2 + y^2 + z^2 = (1 + w)^2", Box::cube(2));
    scene.uniforms.set(0, 0.0, 0.25);
    const auto all = grid_of(scene);
    expect_holds_sphere(*all, 1.0);
    expect_holds_sphere(*all, 1.1);
    expect_holds_sphere(*all, 1.25);
    for (const double w : {0.0, 0.1, 0.25}) {
        scene.uniforms.set(0, w);
        EXPECT_EQ(grid_of(scene), all) << w;
    }
    scene.uniforms.set(0, 0.26);
    const auto other = grid_of(scene);
    EXPECT_NE(other, all);
    EXPECT_LT(other->crossed_cells(), all->crossed_cells());
    EXPECT_EQ(grid_of(scene), other);
    scene.clip = Box::cube(1.9);
    EXPECT_NE(grid_of(scene), other);
}

/// Frames by a grid for several of them show what beams prove.
TEST(RegularGrid, DrawsFramesByTheGridOfAllOfThem) {
    Scene scene =
        scene_of("min((x - w)^2 + y^2 + z^2, (x + w)^2 + y^2 + (z - 0.3)^2) = 0.4", Box::cube(2));
    scene.uniforms.set(0, 0.2, 0.9);
    const auto all = grid_of(scene);
    for (const double w : {0.2, 0.5, 0.9}) {
        scene.uniforms.set(0, w);
        Framebuffer beams(60, 50);
        Framebuffer found(60, 50);
        const Camera camera = default_camera(scene.clip);
        render_frame(scene, camera, settings_at("beams", 18), beams);
        render_frame(scene, camera, settings_at("regular-grid", 18), found);
        EXPECT_EQ(grid_of(scene), all);
        int hits = 0;
        for (std::size_t i = 0; i < beams.depth.size(); ++i) {
            if (!is_proved(beams.certificate[i])) continue;
            EXPECT_NEAR(found.depth[i], beams.depth[i], 1e-3F) << w << " " << i;
            ++hits;
        }
        EXPECT_GT(hits, 50);
    }
}

/// A way through the grid that is kept from frame to frame is that of the view that is drawn.
TEST(RegularGrid, WalksAnewWhereTheViewHasChanged) {
    Scene scene = scene_of("x^2 + (y - w)^2 + z^2 = 0.4", Box::cube(2));
    scene.uniforms.set(0, -0.9, 0.9);
    const auto all = grid_of(scene);
    EXPECT_TRUE(all->of_frames());
    Camera aside = default_camera(scene.clip);
    aside.eye = {0.5, -6.0, 1.0};
    Camera parallel = aside;
    parallel.projection = Projection::Orthographic;
    const auto drawn = [&](const Camera& camera, int size) {
        Framebuffer frame(size, size);
        render_frame(scene, camera, settings_at("regular-grid", 18), frame);
        return frame.depth;
    };
    for (const double w : {-0.8, 0.7}) {
        for (const Camera& camera : {default_camera(scene.clip), aside, parallel}) {
            for (const int size : {70, 90}) {
                scene.uniforms.set(0, w);
                const auto kept = drawn(camera, size);
                EXPECT_EQ(grid_of(scene), all);
                Scene fresh = scene;
                fresh.surfaces[0].kernel.memory = std::make_shared<KernelMemory>();
                std::swap(scene, fresh);
                EXPECT_FALSE(grid_of(scene)->of_frames());
                const auto alone = drawn(camera, size);
                std::swap(scene, fresh);
                int hits = 0;
                for (std::size_t i = 0; i < kept.size(); ++i) {
                    if (!std::isfinite(alone[i])) continue;
                    EXPECT_NEAR(kept[i], alone[i], 1e-3F) << w << " " << i;
                    ++hits;
                }
                EXPECT_GT(hits, 80);
            }
        }
    }
}

}  // namespace
}  // namespace zeroset::test::cell_grid_test
