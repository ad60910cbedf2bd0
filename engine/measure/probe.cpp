#include "engine/measure/probe.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"
#include "engine/trace/ways/surface_ways.hpp"
#include "engine/view/pixel_ray.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace zeroset {
namespace {

constexpr std::size_t lanes = batch_multiple;
using LaneValues = std::array<double, lanes>;
using Columns = std::array<LaneValues, 3>;

/// f and its gradient at a point.
struct Sample {
    double f = std::numeric_limits<double>::quiet_NaN();
    glm::dvec3 gradient{0.0};
};

/// f on a ray, in double.
class RayFormula {
public:
    RayFormula(const Kernel& kernel, const Uniforms& uniforms, const PixelRay& ray)
        : kernel_(kernel), uniforms_(uniforms), ray_(ray) {}

    [[nodiscard]] Sample at(double t) const;
    /// The least of the widths for which f is proved to change its sign, continuously, on the ray's
    /// stretch from t - width to t + width, by that of its points in double.
    [[nodiscard]] std::optional<double> proved_width(double t, const LaneValues& widths) const;

private:
    using Ranges = RangeBoxes<double, lanes>;
    /// f over the boxes with these corners.
    [[nodiscard]] Ranges ranges(const Columns& a, const Columns& b) const;

    const Kernel& kernel_;
    const Uniforms& uniforms_;
    PixelRay ray_;
};

Sample RayFormula::at(double t) const {
    const glm::dvec3 point = ray_.at(t);
    PointBatch<double> batch(1);
    batch.set(0, point.x, point.y, point.z);
    batch.pad();
    const UpwardRounding upward;
    kernel_.value(batch.batch(uniforms_.points<double>()));
    return {.f = batch.f(0),
            .gradient = {batch.gradient(0, 0), batch.gradient(1, 0), batch.gradient(2, 0)}};
}

RayFormula::Ranges RayFormula::ranges(const Columns& a, const Columns& b) const {
    Ranges ranges;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < lanes; ++i) {
            ranges.ends[k][i] = -std::min(a[k][i], b[k][i]);
            ranges.ends[k + 3][i] = std::max(a[k][i], b[k][i]);
        }
    }
    const UpwardRounding upward;
    kernel_.range(ranges.batch(lanes, uniforms_.boxes<double>()));
    return ranges;
}

std::optional<double> RayFormula::proved_width(double t, const LaneValues& widths) const {
    Columns before;
    Columns behind;
    for (std::size_t i = 0; i < lanes; ++i) {
        const glm::dvec3 a = ray_.at(t - widths[i]);
        const glm::dvec3 b = ray_.at(t + widths[i]);
        for (int k = 0; k < 3; ++k) {
            before.at(static_cast<std::size_t>(k))[i] = a[k];
            behind.at(static_cast<std::size_t>(k))[i] = b[k];
        }
    }
    const Ranges near = ranges(before, before);
    const Ranges far = ranges(behind, behind);
    const Ranges all = ranges(before, behind);
    const auto below = [](const Ranges& f, std::size_t i) { return f.f_hi[i] < 0.0; };
    const auto above = [](const Ranges& f, std::size_t i) { return f.f_neg_lo[i] < 0.0; };
    std::optional<double> least;
    for (std::size_t i = 0; i < lanes; ++i) {
        const bool changes = (below(near, i) && above(far, i)) || (above(near, i) && below(far, i));
        if (!changes || all.continuous[i] == 0) continue;
        least = std::min(least.value_or(widths[i]), widths[i]);
    }
    return least;
}

/// The distance to the root that Newton's method finds within the tolerance of `start`; `start`
/// where it finds none.
double polished(const RayFormula& formula, const PixelRay& ray, double start, double tolerance) {
    constexpr int most_steps = 8;
    double t = start;
    double least = std::numeric_limits<double>::infinity();
    double best = start;
    for (int step = 0; step < most_steps; ++step) {
        const Sample sample = formula.at(t);
        if (!(std::abs(sample.f) < least)) break;
        least = std::abs(sample.f);
        best = t;
        t -= sample.f / glm::dot(sample.gradient, ray.direction);
        if (!(std::abs(t - start) <= tolerance)) break;
    }
    return best;
}

/// Powers of ten from the point's last digit in double on.
LaneValues widths_at(const PixelRay& ray, double t) {
    const glm::dvec3 point = ray.at(t);
    const double reach = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z), t,
                                   std::numeric_limits<double>::min()});
    LaneValues widths;
    double width = std::ldexp(1.0, std::ilogb(reach) - 51);
    for (double& item : widths) {
        item = width;
        width *= 8.0;
    }
    return widths;
}

/// Finds the place near a distance on the ray of a surface that is no level set.
void probe_by_way(const ProbedPicture& picture, const PixelRay& ray, double depth, double tolerance,
                  PointFacts& facts) {
    const UpwardRounding upward;
    const Kernel& surface = picture.formulas[facts.surface];
    const double finest = 0x1p-38 * (std::abs(depth) + glm::length(ray.at(depth)));
    const RayHit hit = way_of(surface)
                           .hit_on(surface, picture.uniforms,
                                   {.origin = ray.at(0.0),
                                    .direction = ray.direction,
                                    .from = depth - tolerance,
                                    .to = depth + tolerance},
                                   finest)
                           .value_or(RayHit());
    facts.f = 0.0;
    facts.proved = hit.certificate == Certificate::Certified;
    facts.distance = hit.is_hit() ? hit.t : depth;
    facts.point = ray.at(facts.distance);
    facts.within = facts.proved ? hit.error : tolerance;
    const double length = glm::length(hit.gradient);
    if (length > 0.0 && std::isfinite(length)) facts.normal = hit.gradient / length;
}

}  // namespace

std::optional<PointFacts> probe(const ProbedPicture& picture, int col, int row) {
    const Framebuffer& frame = picture.frame;
    if (col < 0 || row < 0 || col >= frame.width || row >= frame.height) return std::nullopt;
    const std::size_t pixel = frame.index(col, row);
    const auto depth = static_cast<double>(frame.depth[pixel]);
    const std::uint8_t surface = frame.surface[pixel];
    if (!std::isfinite(depth) || surface >= picture.formulas.size()) return std::nullopt;

    const ViewFrame view(picture.camera);
    const PixelRay ray =
        pixel_ray(view, pixel_centre(col, row), {.width = frame.width, .height = frame.height});
    const RayFormula formula(picture.formulas[surface], picture.uniforms, ray);
    // A depth is a float; a surface seen at a slant is farther off along the ray than it is.
    const double rounding = 0x1p-20 * (std::abs(depth) + glm::length(view.eye));
    const double tolerance = 4.0 * picture.tolerance + rounding;
    PointFacts facts;
    facts.surface = surface;
    facts.certificate = frame.certificate[pixel];
    if (!way_of(picture.formulas[surface]).is_level_set()) {
        probe_by_way(picture, ray, depth, tolerance, facts);
        return facts;
    }
    facts.distance = polished(formula, ray, depth, tolerance);
    facts.point = ray.at(facts.distance);
    const auto proved = formula.proved_width(facts.distance, widths_at(ray, facts.distance));
    facts.proved = proved.has_value();
    facts.within = proved.value_or(tolerance);
    const Sample sample = formula.at(facts.distance);
    facts.f = sample.f;
    const double length = glm::length(sample.gradient);
    const bool along_normal = facts.certificate != Certificate::Jump;
    if (along_normal && length > 0.0 && std::isfinite(length))
        facts.normal = sample.gradient / length;
    return facts;
}

}  // namespace zeroset
