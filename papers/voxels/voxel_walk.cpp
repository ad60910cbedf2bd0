#include "papers/voxels/voxel_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace zeroset {
namespace {

/// The walk through samples of one type.
template <class Sample>
class WalkOf final : public VoxelWalk {
public:
    WalkOf(const VolumeData& data, const Sample* samples, double level)
        : VoxelWalk(data, data.pyramid<Sample>().levels()),
          pyramid_(data.pyramid<Sample>()),
          samples_(samples),
          row_(data.samples().size[0]),
          slice_(row_ * data.samples().size[1]),
          level_(level) {}

    bool next(WalkingRay& ray, VoxelRay& voxel) const override {
        while (ray.s < ray.end) {
            ++ray.looks;
            if (ray.level < 0) {
                if (enters_voxel(ray, voxel)) return true;
            } else if (holds_level(ray)) {
                --ray.level;
            } else {
                const int shift = Pyramid<Sample>::lowest_shift + ray.level;
                climb(ray, leave(ray, shift), shift);
            }
        }
        return false;
    }

private:
    [[nodiscard]] bool holds_level(const WalkingRay& ray) const {
        const int shift = Pyramid<Sample>::lowest_shift + ray.level;
        const auto& brick =
            pyramid_.brick(ray.level, ray.at[0] >> shift, ray.at[1] >> shift, ray.at[2] >> shift);
        return static_cast<double>(brick.lo) <= level_ && level_ <= static_cast<double>(brick.hi);
    }
    /// Looks at a larger brick where the ray has left one.
    void climb(WalkingRay& ray, std::int32_t face, int shift) const {
        if ((face & ((std::int32_t{2} << shift) - 1)) == 0 && ray.level < top_level()) ++ray.level;
    }
    /// Passes the ray's voxel; whether the level is in it.
    bool enters_voxel(WalkingRay& ray, VoxelRay& voxel) const {
        const std::array<std::int32_t, 3> at = ray.at;
        const double from = ray.s;
        const std::int32_t face = leave(ray, 0);
        if ((face & ((1 << Pyramid<Sample>::lowest_shift) - 1)) == 0) ray.level = 0;
        if (!set_corners(at, voxel)) return false;
        ray.voxel_from = from;
        for (std::size_t i = 0; i < 3; ++i) {
            const double place = ray.origin[i] + from * ray.direction[i] - at[i];
            voxel.a[i] = static_cast<float>(std::clamp(place, 0.0, 1.0));
            voxel.b[i] = static_cast<float>(ray.direction[i]);
        }
        voxel.t_out = static_cast<float>(std::min(ray.s, ray.end) - from);
        return true;
    }
    bool set_corners(const std::array<std::int32_t, 3>& at, VoxelRay& voxel) const {
        const Sample* const base = samples_ + static_cast<std::size_t>(at[2]) * slice_ +
                                   static_cast<std::size_t>(at[1]) * row_ +
                                   static_cast<std::size_t>(at[0]);
        const std::array<Sample, 8> corners{
            base[0],      base[1],          base[row_],          base[row_ + 1],
            base[slice_], base[slice_ + 1], base[slice_ + row_], base[slice_ + row_ + 1]};
        Sample lo = corners[0];
        Sample hi = corners[0];
        for (const Sample corner : corners) {
            lo = corner < lo ? corner : lo;
            hi = corner > hi ? corner : hi;
        }
        if (!(static_cast<double>(lo) <= level_ && level_ <= static_cast<double>(hi))) return false;
        for (std::size_t i = 0; i < 8; ++i) {
            if constexpr (std::is_floating_point_v<Sample>) {
                if (!std::isfinite(corners[i])) return false;
            }
            voxel.rho[i] = static_cast<float>(static_cast<double>(corners[i]) - level_);
        }
        return true;
    }

    const Pyramid<Sample>& pyramid_;
    const Sample* samples_;
    std::size_t row_, slice_;
    double level_;
};

}  // namespace

VoxelWalk::VoxelWalk(const VolumeData& data, int levels) : map_(data.map()), levels_(levels) {
    for (std::size_t i = 0; i < 3; ++i)
        last_cell_[i] = static_cast<std::int32_t>(data.samples().size[i]) - 2;
}

std::unique_ptr<const VoxelWalk> VoxelWalk::make(const Isosurface& surface) {
    const VolumeData& data = surface.volume->data();
    return visit_samples(
        data.samples(), [&](const auto* samples) -> std::unique_ptr<const VoxelWalk> {
            using Sample = std::remove_cvref_t<decltype(*samples)>;
            return std::make_unique<const WalkOf<Sample>>(data, samples, surface.level);
        });
}

bool VoxelWalk::begin(const RayLine& line, WalkingRay& ray) const {
    ray.s = line.from;
    ray.end = line.to;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& row = map_.index_from_world[i];
        ray.origin[i] = map_.shift[i];
        ray.direction[i] = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            ray.origin[i] += row[c] * line.origin[c];
            ray.direction[i] += row[c] * line.direction[c];
        }
        ray.per_direction[i] = 1 / ray.direction[i];
        const double last = last_cell_[i] + 1.0;
        if (ray.direction[i] == 0) {
            if (!(ray.origin[i] >= 0 && ray.origin[i] <= last)) return false;
            continue;
        }
        const double first_face = -ray.origin[i] * ray.per_direction[i];
        const double last_face = (last - ray.origin[i]) * ray.per_direction[i];
        ray.s = std::max(ray.s, std::min(first_face, last_face));
        ray.end = std::min(ray.end, std::max(first_face, last_face));
    }
    if (!(ray.s < ray.end)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        const double place = std::floor(ray.origin[i] + ray.s * ray.direction[i]);
        ray.at[i] =
            static_cast<std::int32_t>(std::clamp(place, 0.0, static_cast<double>(last_cell_[i])));
    }
    ray.level = top_level();
    return true;
}

std::int32_t VoxelWalk::leave(WalkingRay& ray, int shift) const {
    std::array<std::int32_t, 3> faces{};
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t axis = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (ray.direction[i] == 0) continue;
        faces[i] = ((ray.at[i] >> shift) + (ray.direction[i] > 0 ? 1 : 0)) << shift;
        const double s = (faces[i] - ray.origin[i]) * ray.per_direction[i];
        if (!(s < nearest)) continue;
        nearest = s;
        axis = i;
    }
    ray.s = std::max(ray.s, nearest);
    // The other axes stay within the brick, whatever was rounded.
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == axis) continue;
        const std::int32_t first = ray.at[i] >> shift << shift;
        const std::int32_t last = std::min(first + (1 << shift) - 1, last_cell_[i]);
        const auto place = static_cast<std::int32_t>(ray.origin[i] + ray.s * ray.direction[i]);
        ray.at[i] = std::clamp(place, first, last);
    }
    const std::int32_t face = faces[axis];
    ray.at[axis] = ray.direction[axis] > 0 ? face : face - 1;
    if (ray.at[axis] < 0 || ray.at[axis] > last_cell_[axis]) {
        ray.at[axis] = std::clamp(ray.at[axis], 0, last_cell_[axis]);
        ray.end = std::min(ray.end, ray.s);
    }
    return face;
}

}  // namespace zeroset
