#include "engine/tape/shape_memory.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {

ShapeMemory::Known& ShapeMemory::note(const Skeleton& skeleton) {
    std::string key = skeleton.key();
    const auto found = std::ranges::find(known_, key, &Known::key);
    if (found == known_.end()) {
        known_.push_front(
            {.key = std::move(key), .first = skeleton, .varying = VaryingPlaces(skeleton)});
    } else {
        known_.splice(known_.begin(), known_, found);
        known_.front().varying.add(known_.front().first, skeleton);
    }
    return known_.front();
}

std::vector<std::optional<ShapedGraph>> ShapeMemory::shape(std::span<const Expr> graphs) {
    struct Noted {
        Skeleton skeleton;
        const Known* known;
    };
    const std::scoped_lock lock(mutex_);
    std::vector<Noted> noted;
    for (const Expr& graph : graphs) {
        Skeleton skeleton = skeleton_of(graph);
        const Known& known = note(skeleton);
        noted.push_back({.skeleton = std::move(skeleton), .known = &known});
    }
    std::vector<std::optional<ShapedGraph>> shapes;
    for (const auto& [skeleton, known] : noted) {
        auto& shaped = shapes.emplace_back();
        if (!known->varying.any()) continue;
        ShapeMaker maker(known->first, known->varying);
        PartShape shape = maker.make();
        shaped = ShapedGraph{
            .shape = std::move(shape),
            .part = {.root = skeleton.root, .shape = 0, .uniforms = maker.uniforms_of(skeleton)}};
    }
    while (known_.size() > most_shapes)
        known_.pop_back();
    return shapes;
}

}  // namespace zeroset
