#pragma once

#include "engine/real/rounding.hpp"
#include "engine/trace/tile_rays.hpp"
#include "tests/support/rays.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace zeroset::test {

/// A tile of its own with hits of the plane z = 0, at which the eye looks from (0, 0, 4).
class PlaneTile : public testing::Test {
protected:
    static constexpr int side = 16;
    static constexpr Tile tile{.col = 0, .row = 0, .cols = side, .rows = side};

    explicit PlaneTile(double fov_rad)
        : scene_(scene_of("z = 0", Box::cube(1))),
          view_(
              Camera{.eye = {0, 0, 4}, .look_at = {0, 0, 0}, .up = {0, 1, 0}, .fov_rad = fov_rad}),
          frame_(trace_frame(scene_, scene_.surfaces.front(), view_,
                             {.width = side, .height = side}, {})),
          rays_(frame_, tile),
          hits_(1) {
        hits_[0].any = true;
    }

    UpwardRounding upward_;
    Scene scene_;
    ViewFrame view_;
    TraceFrame frame_;
    TileRays rays_;
    std::vector<TileHits> hits_;
};

}  // namespace zeroset::test
