#include "engine/render/color_range.hpp"

#include "engine/image/framebuffer.hpp"
#include "engine/light/surface_values.hpp"
#include "engine/real/rounding.hpp"
#include "engine/render/render.hpp"
#include "engine/view/pixel_ray.hpp"

#include <algorithm>
#include <cmath>

namespace zeroset {
namespace {

constexpr int longest_side = 96;
constexpr double outliers = 0.02;  ///< of the values, at each end

/// The hits of each surface of a picture.
std::vector<std::vector<SurfacePoint>> points_of(const Framebuffer& frame, const Camera& camera,
                                                 std::size_t surfaces) {
    const ViewFrame view(camera);
    std::vector<std::vector<SurfacePoint>> points(surfaces);
    for (int row = 0; row < frame.height; ++row) {
        for (int col = 0; col < frame.width; ++col) {
            const std::size_t pixel = frame.index(col, row);
            const auto distance = static_cast<double>(frame.depth[pixel]);
            const std::uint8_t surface = frame.surface[pixel];
            if (surface >= surfaces || !std::isfinite(distance)) continue;
            const PixelRay ray = pixel_ray(view, pixel_centre(col, row),
                                           {.width = frame.width, .height = frame.height});
            points[surface].push_back({.at = ray.at(distance), .distance = distance});
        }
    }
    return points;
}

std::vector<double> values_in(const Framebuffer& frame, const Scene& scene, const Camera& camera) {
    const auto points = points_of(frame, camera, scene.surfaces.size());
    const UpwardRounding upward;
    std::vector<double> all;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::vector<double> values = values_at(scene, i, points[i]);
        all.insert(all.end(), values.begin(), values.end());
    }
    return all;
}

/// The range as a person would choose it: to a tenth of its power of ten, outward.
ValueRange rounded(const ValueRange& range) {
    const double step = std::pow(10.0, std::floor(std::log10(range.hi - range.lo)) - 1.0);
    const ValueRange wider{.lo = std::floor(range.lo / step) * step,
                           .hi = std::ceil(range.hi / step) * step};
    const bool usable = std::isfinite(wider.lo) && std::isfinite(wider.hi) && wider.lo < wider.hi;
    return usable ? wider : range;
}

/// Whether a range shows about as much as another would.
bool fits(const ValueRange& range, const ValueRange& found) {
    const double width = range.hi - range.lo;
    const double most = 0.35 * width;
    return std::abs(found.lo - range.lo) <= most && std::abs(found.hi - range.hi) <= most &&
           found.hi - found.lo >= 0.5 * width;
}

}  // namespace

ValueRange fitting_range(std::vector<double> values, bool symmetric) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return symmetric ? ValueRange{.lo = -1.0, .hi = 1.0} : ValueRange{};
    const auto at = [&values](double part) {
        const auto index =
            static_cast<std::ptrdiff_t>(std::lround(part * static_cast<double>(values.size() - 1)));
        std::ranges::nth_element(values, values.begin() + index);
        return values[static_cast<std::size_t>(index)];
    };
    ValueRange range{.lo = at(outliers), .hi = at(1.0 - outliers)};
    if (symmetric) {
        range.hi = std::max(std::abs(range.lo), std::abs(range.hi));
        range.lo = -range.hi;
    }
    // All values are the same, but for rounding.
    const double size = std::max(std::abs(range.lo), std::abs(range.hi));
    if (range.hi - range.lo <= 1e-6 * size || size == 0.0) {
        const double margin = size == 0.0 ? 1.0 : 0.5 * size;
        range = {.lo = range.lo - margin, .hi = range.hi + margin};
    }
    return rounded(range);
}

std::optional<ValueRange> find_range(const Scene& scene, const Camera& camera,
                                     const TraceSettings& settings, int width_px, int height_px,
                                     const TimeLimit& limit) {
    const double scale = std::min(1.0, static_cast<double>(longest_side) /
                                           static_cast<double>(std::max(width_px, height_px)));
    const auto scaled = [scale](int side) {
        return std::max(1, static_cast<int>(std::lround(scale * side)));
    };
    Scene plain = scene;
    plain.coloring = {};
    for (Section& section : plain.region.sections) {
        section.cap = section.cap && !section.values && !is_of_skin(scene.coloring.by);
        section.values = false;
    }
    TraceSettings quick = settings;
    quick.shadows = false;
    quick.antialias = Antialias::None;
    Framebuffer frame(scaled(width_px), scaled(height_px));
    render_frame(plain, camera, quick, frame, {.limit = limit});
    if (limit.cancelled()) return std::nullopt;
    const Coloring& coloring = scene.coloring;
    const bool symmetric = is_signed(coloring.by) || coloring.map == ColorMap::Balance;
    return fitting_range(values_in(frame, scene, camera), symmetric);
}

std::optional<ValueRange> SteadyRange::last(const Scene& scene) const {
    Coloring same = coloring_;
    same.range = scene.coloring.range;
    const bool same_values = same == scene.coloring && have_same_code(surfaces_, scene.surfaces);
    return same_values ? range_ : std::nullopt;
}

ValueRange SteadyRange::after(const Scene& scene, const ValueRange& found) {
    const std::optional<ValueRange> before = last(scene);
    coloring_ = scene.coloring;
    surfaces_ = scene.surfaces;
    range_ = before && fits(*before, found) ? *before : found;
    return *range_;
}

}  // namespace zeroset
