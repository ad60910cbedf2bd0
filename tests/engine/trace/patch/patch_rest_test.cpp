#include "engine/kernel/patch_code.hpp"
#include "engine/kernel/surface_facts.hpp"
#include "engine/real/rounding.hpp"
#include "engine/trace/patch/patch_tile.hpp"
#include "engine/trace/patch/patch_tree.hpp"
#include "engine/trace/tile_rays.hpp"
#include "engine/trace/trace_frame.hpp"
#include "tests/support/patch_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

// The parts that are kept for the end of a tile stay few, whatever is not known of a patch.

namespace zeroset::test::patch_rest_test {
namespace {

/// The rays of the whole tile, on which all is wanted.
TileQuest quest_for(const TileRays& rays) {
    TileQuest quest;
    for (int i = 0; i < tile_size; ++i) {
        quest.u.push_back(rays.u(i));
        quest.v.push_back(rays.v(i));
    }
    return quest;
}

/// Ends the work on a tile once the forms of so many boxes have been asked for.
struct Stop {
    std::size_t boxes_left;
    std::atomic<bool> cancel = false;
};

/// Does what `forms` does, and counts.
struct CountedForms {
    KernelFunction<FormBatchOf<double>> forms;
    Stop* stop;

    static void call(const void* code, const FormBatchOf<double>* batch) {
        const auto& self = *static_cast<const CountedForms*>(code);
        self.forms(*batch);
        if (self.stop->boxes_left < batch->size) self.stop->cancel = true;
        self.stop->boxes_left -= std::min(self.stop->boxes_left, batch->size);
    }
};

TEST(PatchRest, StaysSmallWhereAPatchIsUndefinedEverywhere) {
    const UpwardRounding upward;
    const std::string nowhere = "x + ln(x - x)*(y - y)";
    Scene scene = patch_scene({nowhere, nowhere, nowhere}, Way::WithoutModels, Box::cube(2));
    Kernel& surface = scene.surfaces.front().kernel;
    Stop stop{.boxes_left = 300'000};
    std::array<Kernel, 3> point = surface_facts(surface).patch->point;
    auto& forms = point.front().in_double.form;
    forms = {CountedForms::call, std::make_shared<const CountedForms>(forms, &stop)};
    surface = patch_kernel(std::move(point));
    const ViewFrame view(default_camera(scene.clip));
    TraceFrame frame = trace_frame(scene, scene.surfaces.front(), view,
                                   {.width = tile_size, .height = tile_size}, {})
                           .with(surface, {.cancel = &stop.cancel});
    const auto tree = patch_tree(surface, scene.uniforms);
    frame.prepared = tree.get();
    const Tile tile{.col = 0, .row = 0, .cols = tile_size, .rows = tile_size};
    const TileRays rays(frame, tile);
    const TileQuest quest = quest_for(rays);
    TileAnswer answer;
    Counters counters;
    PatchTile search(frame, rays, quest, answer, counters);
    search.run();
    EXPECT_EQ(stop.boxes_left, 0U);
    EXPECT_GT(search.most_kept(), 10'000U);
    EXPECT_LE(search.most_kept(), 300'000U);
}

}  // namespace
}  // namespace zeroset::test::patch_rest_test
