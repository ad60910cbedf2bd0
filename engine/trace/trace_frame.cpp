#include "engine/trace/trace_frame.hpp"

#include "engine/kernel/kernel.hpp"

#include <algorithm>

namespace zeroset {

Precision frame_precision(const Scene& scene, const ViewFrame& view, const StopCriterion& stop) {
    const bool has_double = std::ranges::all_of(
        scene.surfaces, [](const Surface& surface) { return surface.kernel.has_double; });
    return has_double ? wanted_precision(scene, view, stop) : Precision::Float;
}

TraceFrame trace_frame(const Scene& scene, const Surface& surface, const ViewFrame& view,
                       const ImageSize& image, const StopCriterion& stop) {
    return {.scene = scene,
            .kernel = surface.kernel,
            .view = view.in_drawn_world(),
            .image = image,
            .stop = stop,
            .depth = search_depth(scene.clip, view, stop),
            .precision = frame_precision(scene, view, stop)};
}

double place_error(const TraceFrame& frame) {
    const glm::dvec3 eye = glm::abs(frame.view.eye);
    const Box& clip = frame.scene.clip;
    const glm::dvec3 box = glm::max(glm::abs(clip.lo), glm::abs(clip.hi));
    double sizes = std::max({eye.x, eye.y, eye.z}) + std::max({box.x, box.y, box.z}) +
                   frame.view.look_distance;
    if (frame.view.parallel())
        sizes +=
            frame.view.pixel_at_look(frame.image.height) * (frame.image.width + frame.image.height);
    return 0x1p-46 * sizes;
}

}  // namespace zeroset
