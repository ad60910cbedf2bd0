#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace zeroset {

/// How a pixel's colour is made of more than its own ray. Its depth and certificate are of that.
enum class Antialias : std::uint8_t {
    None,
    Beams,  ///< of the pixel's parts, as beams find them [Florez08, sec. 5.5.2]
    Rays4,  ///< of so many rays, evenly spread
    Rays9,
    Rays16,
    Rays64,
};

/// The way of pictures whose edges are smooth, or not.
constexpr Antialias smooth_edges(bool on) { return on ? Antialias::Beams : Antialias::None; }

/// none, iaa, 4, 9, 16 or 64; 1 is none, too.
std::string_view name_of(Antialias antialias);
std::optional<Antialias> antialias_named(std::string_view name);

/// Rays of a pixel across and down of which its colour is made.
int rays_across(Antialias antialias);

/// When the search along a ray stops [Knoll07, sec. 5.5].
enum class StopRule : std::uint8_t {
    DStop,    ///< at cells of the clip box's longest edge times 2^-value
    Epsilon,  ///< at boxes whose diagonal is below value, world units (eq. 6 and 7)
    Delta,    ///< where the enclosure of f is narrower than value
};

struct StopCriterion {
    StopRule rule = StopRule::DStop;
    double value = 22.0;

    bool operator==(const StopCriterion&) const = default;
};

/// The finest d_stop: the cells are then 2^-22 of the domain, about an ulp of float there.
inline constexpr int max_d_stop = 22;

struct TraceSettings {
    std::string tracer = "beams";
    StopCriterion stop;
    int threads = 0;  ///< 0: all cores
    bool shadows = false;
    Antialias antialias = Antialias::None;
    int reflections = 0;     ///< surfaces that a ray is mirrored at, 0 to max_reflections
    bool soft_light = true;  ///< broad lights throw soft shadows, hollows of some looks are dark
    bool costs = false;      ///< Framebuffer::cost is wanted

    bool operator==(const TraceSettings&) const = default;
};

class TileCosts;

/// Evaluations of each kernel, in points or boxes (not batches), and how wide the widest bracket of
/// a Coarse hit is, world units along its ray.
struct Counters {
    std::uint64_t range = 0;
    std::uint64_t value = 0;
    std::uint64_t form = 0;
    double coarse_width = 0.0;
    /// Pixels of tiles that a time limit ended: those that are undecided, those without shadows or
    /// smooth edges.
    std::uint64_t cut_pixels = 0, rough_pixels = 0;
    /// Pixels, once for each light, of which it is not proved whether the light reaches them.
    std::uint64_t unproved_shadows = 0;
    /// Told by tracers for which pixels they evaluated (engine/trace/tile_costs.hpp); nullptr:
    /// nobody wants to know. Not added up.
    TileCosts* costs = nullptr;

    [[nodiscard]] bool is_cut() const { return cut_pixels + rough_pixels > 0; }

    Counters& operator+=(const Counters& other) {
        range += other.range;
        value += other.value;
        form += other.form;
        coarse_width = std::max(coarse_width, other.coarse_width);
        cut_pixels += other.cut_pixels;
        rough_pixels += other.rough_pixels;
        unproved_shadows += other.unproved_shadows;
        return *this;
    }
};

}  // namespace zeroset
