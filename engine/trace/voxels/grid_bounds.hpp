#pragma once

#include "engine/trace/trace_frame.hpp"
#include "engine/trace/voxels/isosurface.hpp"
#include "engine/volume/spline.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace zeroset {

/// Bounds of the numbers of a volume and a level.
struct GridBounds {
    double size;         ///< of samples and level
    double level_error;  ///< how far the level may be off
    double indices = 0;  ///< of all terms of places in the grid

    GridBounds(const Isosurface& surface, const TraceFrame& frame)
        : size(std::abs(surface.level)), level_error(surface.level_error) {
        const VolumeData& data = surface.volume->data();
        const SampleRange range = numbers_of(*surface.volume);
        size += std::max(std::abs(range.lo), std::abs(range.hi));
        const Box& clip = frame.scene.clip;
        const glm::dvec3 eye = glm::abs(frame.view.eye);
        const glm::dvec3 box = glm::max(glm::abs(clip.lo), glm::abs(clip.hi));
        const double reach = std::max({eye.x, eye.y, eye.z}) + std::max({box.x, box.y, box.z}) +
                             frame.view.look_distance;
        for (std::size_t i = 0; i < 3; ++i) {
            double sum = std::abs(data.map().shift[i]);
            for (const double entry : data.map().index_from_world[i])
                sum += 4 * std::abs(entry) * reach;
            indices = std::max({indices, sum, static_cast<double>(data.samples().size[i])});
        }
    }
    /// The range of the samples, or of the spline's coefficients.
    static SampleRange numbers_of(const Volume& volume) {
        const SplineData* const spline = volume.spline();
        if (spline == nullptr) return volume.data().range();
        return spline->coefficients().type == SampleType::Float ? spline->pyramid<float>().range()
                                                                : spline->pyramid<double>().range();
    }
    /// A bound of the error of f: by rounded places, some ulp of their terms times f's steepest
    /// slope; by sums of samples, some ulp of these; and the error of the level.
    [[nodiscard]] double error() const { return 0x1p-44 * (indices + 16) * size + level_error; }
    /// Whether places are known well enough, and numbers small enough for sums of them in float.
    [[nodiscard]] bool usable() const { return indices < 0x1p30 && size < 0x1p120; }
};

}  // namespace zeroset
