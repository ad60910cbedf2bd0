#include "engine/trace/voxels/isosurface.hpp"

#include "engine/base/translation.hpp"
#include "engine/kernel/surface_facts.hpp"

#include <cmath>

namespace zeroset {

const Volume* volume_of(const Kernel& surface) {
    return dynamic_cast<const Volume*>(surface_facts(surface).field.field.get());
}

namespace {

/// The largest relative error of a level; beyond it beams tell more than rays at one level would.
constexpr double most_unknown_of_level = 0x1p-30;

Outside outside_of(const Volume& volume) { return volume.options().outside; }

std::optional<Isosurface> surface_of(const Kernel& surface, const Scene& scene) {
    const auto level = surface_facts(surface).field.at(scene.uniforms);
    if (!(level.error <= most_unknown_of_level * std::abs(level.middle))) return std::nullopt;
    return Isosurface{
        .volume = volume_of(surface), .level = level.middle, .level_error = level.error};
}

}  // namespace

const char* no_isosurface(const Kernel& surface) {
    const Volume* const volume = volume_of(surface);
    if (volume == nullptr) {
        return marked(
            "it draws only plain isosurfaces of a volume, such as scan(x, y, z) = 400 without cuts "
            "in the formula; choose another tracer, such as beams or k-bisection, for all "
            "formulas");
    }
    if (volume->spline() != nullptr) {
        return marked(
            "it draws only volumes that are trilinear between their samples; leave out cubic or "
            "smooth, or choose another tracer, such as beams");
    }
    if (outside_of(*volume) != Outside::Undefined) {
        return marked(
            "it draws volumes only within their samples; leave out what is typed for beyond them, "
            "such as edge, or choose another tracer, such as beams");
    }
    return nullptr;
}

std::optional<Isosurface> isosurface(const Kernel& surface, const Scene& scene) {
    return no_isosurface(surface) != nullptr ? std::nullopt : surface_of(surface, scene);
}

std::optional<Isosurface> isosurface_or_spline(const Kernel& surface, const Scene& scene) {
    const Volume* const volume = volume_of(surface);
    if (volume == nullptr || outside_of(*volume) != Outside::Undefined) return std::nullopt;
    return surface_of(surface, scene);
}

}  // namespace zeroset
