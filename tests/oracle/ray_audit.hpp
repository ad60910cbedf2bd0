#pragma once

#include "engine/image/framebuffer.hpp"
#include "engine/scene/region.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/volume_source.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// Checks a tracer's claims about the rays of a picture against the oracles.

namespace zeroset::test {

struct AuditSurface {
    std::string name;
    std::string equation;
    Box clip;
    double w = 0.0;
    Camera camera;
    Region region = {};  ///< sections are without caps, as no oracle knows of solids
    std::shared_ptr<const FieldSource> files = volume_source({});  ///< that the equation may name
};

/// The items of the gallery that are one surface.
std::vector<AuditSurface> gallery_surfaces();
/// `count` random surfaces of all families in turn, equal for equal seeds.
std::vector<AuditSurface> random_surfaces(std::size_t count, std::uint64_t seed);

/// The surfaces cut by random regions, every second one in an orthographic view.
std::vector<AuditSurface> cut_open(std::vector<AuditSurface> surfaces, std::uint64_t seed);

struct AuditSettings {
    std::string tracer;
    int size_px = 24;  ///< width and height of the picture
    double d_stop = 14;
    std::size_t rays = 0;  ///< number of random pixels that are checked; 0: all
    /// Number of further random pixels among those that differ from a neighbour: silhouettes,
    /// edges, places that are hard to decide.
    std::size_t edge_rays = 0;
    /// 0: certified depths may be off the first root as far as TileHits allows. Else: by at most
    /// 2^-bits of the clip box's longest edge, plus the rounding of depths to float.
    double depth_bits = 0;
    /// Draws with the interpreter; for small pictures, for which machine code takes longer to make.
    bool interpreted = false;
    /// Tells tracers of volumes and balls, as pictures do, so that these are traced voxel by voxel,
    /// or by the balls that are near. With `interpreted`.
    bool knows_fields = false;
};

/// The command line that draws the surface with these settings and writes depth.pfm and
/// certificate.png.
std::string command_line(const AuditSurface& surface, const AuditSettings& settings);

struct AuditReport {
    std::size_t rays = 0;
    std::size_t hit = 0;      ///< f surely changes its sign at a known first root
    std::size_t touched = 0;  ///< the known first root is a touch
    std::size_t empty = 0;    ///< surely no root
    std::size_t unknown = 0;  ///< not decided by the oracles
    std::size_t hit_certified = 0;
    std::size_t hit_not_drawn = 0;  ///< undecided, and nothing is shown
    std::size_t hit_behind = 0;     ///< undecided, and a later place is shown
    std::size_t empty_drawn = 0;    ///< undecided, and something is shown
    /// Each failure with its pixel and the command line that repeats it.
    std::vector<std::string> failures;

    AuditReport& operator+=(const AuditReport& other);
    /// The report in one line.
    [[nodiscard]] std::string text() const;
};

/// The picture that the tracer draws.
Framebuffer drawn(const AuditSurface& surface, const AuditSettings& settings);

/// Checks pixels of a picture by the oracles. It is a failure if a ray that surely holds a root is
/// reported as empty, if one that surely holds none is certified, or if a certified depth is
/// farther from the first root than TileHits allows.
AuditReport audit(const AuditSurface& surface, const AuditSettings& settings,
                  const Framebuffer& frame);
inline AuditReport audit(const AuditSurface& surface, const AuditSettings& settings) {
    return audit(surface, settings, drawn(surface, settings));
}

}  // namespace zeroset::test
