#pragma once

#include "engine/antialias/half_square.hpp"
#include "engine/antialias/ray_stretches.hpp"
#include "engine/antialias/square_rays.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace zeroset {

/// The part of a square that has a root, as stretches of its rays tell it.
struct EdgeSamples {
    std::array<double, square_ray_count> height{};  ///< at most 0: the ray has a root
    bool known = false;  ///< whether `height` may go smoothly with the place
    /// Whether roots are before the far ends; else before the places of the least f.
    std::array<bool, square_ray_count> before_end{};

    [[nodiscard]] std::size_t roots() const;
    /// The bracket of ray i's root, or of where f comes nearest to 0.
    [[nodiscard]] RayRoot bracket(SquareStretches stretches, std::size_t i) const;
    /// The rays that have no root.
    [[nodiscard]] SquareRayFlags misses() const;
    /// The ray of the least height.
    [[nodiscard]] std::size_t deepest() const;
    /// The ray with a root that is nearest to a place; `deepest` where none has one.
    [[nodiscard]] std::size_t nearest_hit(const SquareRay& place) const;
};
EdgeSamples edge_samples(SquareStretches stretches);
/// Samples of f at one end of the stretches, where f surely keeps its sign at the other end all
/// over the square: roots are where f has the other sign at this end. Nothing where that holds of
/// neither end, or where f has a root, or is least, within a stretch.
std::optional<EdgeSamples> one_end_samples(SquareStretches stretches);
/// Whether the rays' stretches begin in a plane, and end in one: in one wall of the clip region, or
/// at one depth. They may be empty, where a wall is beyond the other end.
bool are_ends_even(SquareStretches stretches, CornerStretches corners);
/// The end of stretches at which a wall is: f there, and at the other end.
struct WallEnd {
    double RayStretch::* f;
    double RayStretch::* other_f;
};
inline constexpr WallEnd entry_wall{.f = &RayStretch::near, .other_f = &RayStretch::far};
inline constexpr WallEnd exit_wall{.f = &RayStretch::far, .other_f = &RayStretch::near};
/// Samples of f in a wall, where f surely keeps its sign at the other ends all over the square:
/// roots are where f has the other sign in the wall. Nothing where rays may have more of them.
std::optional<EdgeSamples> wall_samples(SquareStretches stretches, const WallEnd& wall);
/// The stretch of a ray beside the square's own, as deep as planes through their ends are there.
RayStretch stretch_at(SquareStretches stretches, const SquareRay& place);

/// Samples of the sign of f where the rays enter: above 0 where it is not that of the middle ray,
/// as a wall has cut the root away.
EdgeSamples entry_samples(SquareStretches stretches);

/// Whether the heights, all above 0, come so near to it that a thread may pass between the rays, to
/// some of which it is nearer, by the slopes at them.
bool is_touched(const EdgeSamples& samples, SquareStretches stretches);

/// Whether f changes from ray to ray in nearly the same way at all rays: where it may have kinks
/// elsewhere on them, these leave the edge alone.
bool is_one_slope(SquareStretches stretches);

/// Whether f comes to 0 on all rays, and on none goes through it.
bool is_touched_everywhere(const EdgeSamples& samples, SquareStretches stretches);

/// Whether f is 0, but for rounding, at the same end of all stretches, and the rays at the corners
/// are within the clip region, too: where stretches end at a wall of it, the surface lies in that.
bool is_flush(SquareStretches stretches, CornerStretches corners);

/// Whether all of the square has a root, as far as the heights tell.
bool is_all_below(const EdgeSamples& samples);

/// Whether f keeps its sign on all rays of a square, or changes it on all, as far as f at the ends
/// of their stretches tells; empty ones count, too.
enum class Signs : std::uint8_t { Unknown, Kept, Changed };
Signs signs_of(SquareStretches stretches);

/// The linear function through the heights, if it is one to within `error` of its slope; with
/// `flat_too` also where it is far from 0 all over the square.
std::optional<LinearOnSquare> fit_edge(const EdgeSamples& samples, double error, bool flat_too);

/// The sheets that cover a square: one, or two that meet in a line.
struct Creased {
    /// The part of each sheet, and the ray that stands for it; of share 0: there is none.
    std::array<SquarePart, 2> parts;
    std::array<std::size_t, 2> rays;
    bool grazed = false;  ///< a ray grazes a sheet, which may end nearby
    bool bent = false;    ///< one sheet, whose normals differ: all rays should stand for it
};

/// The sheets through the first roots of a square's rays, if they are such. `half_side`: of the
/// square, in pixels.
std::optional<Creased> fit_crease(SquareRoots roots, double half_side);

/// A straight thread across a square. All in halves of the square's side.
struct Thread {
    SquareRay normal;   ///< of length 1, across the thread
    double offset;      ///< of its middle along the normal, from the square's middle
    double half_width;  ///< 0: f comes to 0 on its middle, as far as samples tell, not through it
    bool empty;         ///< there would be one, but f stays away from 0

    /// The share of the square that a thread of such a width covers.
    [[nodiscard]] double share(double with_half_width) const;
    /// A place on the thread, in the square where it can be.
    [[nodiscard]] SquareRay middle() const;
};

/// The thread along which f is nearest to 0, if there f goes with the square of the distance from
/// it; `half_side`: of the square, in pixels; `thinnest`: half the width from which on a thread is
/// told from none.
std::optional<Thread> fit_thread(SquareStretches stretches, double half_side, double thinnest);

}  // namespace zeroset
