#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/scene/scene.hpp"
#include "engine/volume/volume.hpp"

#include <optional>

namespace zeroset {

/// A surface volume(x, y, z) = level.
struct Isosurface {
    const Volume* volume;
    double level;
    double level_error = 0.0;  ///< how far it may be off
};

/// The volume that the surface is a level of; nullptr: there is none.
const Volume* volume_of(const Kernel& surface);

/// Why a surface is no plain isosurface of one trilinear volume: a line to be translated that says
/// what to type instead; nullptr: it is one.
const char* no_isosurface(const Kernel& surface);

/// The surface for the uniforms of a scene, in upward rounding; nothing where it is none.
std::optional<Isosurface> isosurface(const Kernel& surface, const Scene& scene);
/// The surface as by isosurface(), whose volume may also be a spline.
std::optional<Isosurface> isosurface_or_spline(const Kernel& surface, const Scene& scene);

}  // namespace zeroset
