#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/trace/time_limit.hpp"
#include "engine/view/camera.hpp"

#include <optional>
#include <span>
#include <vector>

namespace zeroset {

/// The range that shows most of the values well, its ends rounded outward: between the 2nd and the
/// 98th percentile, what is no number left out; symmetric about 0 where the sign matters (a signed
/// quantity, or the map Balance).
ValueRange fitting_range(std::vector<double> values, bool symmetric);

/// The range for a picture of the scene, from a coarse one of at most 96 pixels along a side;
/// of what was found of it within `limit`; nothing where it was cancelled before it was known.
std::optional<ValueRange> find_range(const Scene& scene, const Camera& camera,
                                     const TraceSettings& settings, int width_px, int height_px,
                                     const TimeLimit& limit = {});

/// Ranges of pictures that follow one another. A range stays as long as it fits about as well as a
/// new one would, so that colours are steady while the view changes.
class SteadyRange {
public:
    /// The last range for the scene, whatever the view is now; nothing for a scene of other
    /// surfaces, or coloured by something else.
    [[nodiscard]] std::optional<ValueRange> last(const Scene& scene) const;
    /// The range for the scene after `found` was found for it.
    ValueRange after(const Scene& scene, const ValueRange& found);

private:
    std::vector<Surface> surfaces_;
    Coloring coloring_;
    std::optional<ValueRange> range_;
};

}  // namespace zeroset
