#include "engine/base/parallel.hpp"
#include "engine/distance/near_surface.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/real/rounding.hpp"
#include "pipeline/mesh_solid.hpp"
#include "pipeline/sample_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The sample points of a plan.
class GridPoints {
public:
    explicit GridPoints(const GridPlan& plan) : geometry_(geometry_of(plan)), size_(plan.size) {}

    [[nodiscard]] std::size_t width() const { return size_[0]; }
    [[nodiscard]] std::size_t rows() const { return size_[1] * size_[2]; }
    [[nodiscard]] double step() const { return geometry_.world_from_index[0][0]; }
    [[nodiscard]] glm::dvec3 point(std::size_t row, std::size_t i) const {
        return {along(0, i), along(1, row % size_[1]), along(2, row / size_[1])};
    }

private:
    [[nodiscard]] double along(std::size_t axis, std::size_t index) const {
        return sample_place(geometry_, axis, index);
    }

    Geometry geometry_;
    GridSize size_;
};

/// How far it is from a point in a box to the box's nearest face.
double depth_in(const Box& box, const glm::dvec3& point) {
    const glm::dvec3 depth = glm::min(point - box.lo, box.hi - point);
    return std::max(0.0, std::min({depth.x, depth.y, depth.z}));
}

/// Calls visit(i, bounds) for the samples of a row; bounds of the distance to the zeros in the
/// surface's box.
void each_distance_in(const GridPoints& points, const NearSurface& surface, std::size_t row,
                      auto visit) {
    const NearestRounding nearest;
    double known = infinity;
    for (std::size_t i = 0; i < points.width(); ++i) {
        const DistanceBounds bounds = surface.distance(points.point(row, i), known);
        visit(i, bounds);
        // A neighbour is farther by at most the way to it.
        known = bounds.hi + points.step() * (1 + 0x1p-40);
    }
}

/// How far beyond the box a zero can be that is nearer to a sample than those in it.
double reach_beyond(const GridPlan& plan, const NearSurface& inside) {
    const GridPoints points(plan);
    std::vector<double> reach(points.rows());
    parallel_for(points.rows(), 0, [&](std::size_t row) {
        each_distance_in(points, inside, row, [&](std::size_t i, const DistanceBounds& bounds) {
            const double most = std::isfinite(bounds.hi) ? bounds.hi : bounds.lo;
            reach[row] = std::max(reach[row], most - depth_in(plan.box, points.point(row, i)));
        });
    });
    return *std::ranges::max_element(reach);
}

/// The sign of f that is proved at a point.
enum class PointSign : std::uint8_t { Below, Above, Unknown, Undefined };

class PointSigns {
public:
    explicit PointSigns(const SurfaceFunction& function) : function_(function) {
        boxes_.resize(batch_multiple);
    }

    /// Finds the signs at a row of samples. In upward rounding.
    void find(const GridPoints& points, std::size_t row) {
        const std::size_t count = points.width();
        boxes_.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 point = points.point(row, i);
            for (int axis = 0; axis < 3; ++axis) {
                boxes_.ends[static_cast<std::size_t>(axis)][i] = -point[axis];
                boxes_.ends[static_cast<std::size_t>(axis) + 3][i] = point[axis];
            }
        }
        function_.range(boxes_.batch(count, function_.uniforms.boxes<double>()));
    }
    [[nodiscard]] PointSign at(std::size_t i) const {
        const double lo = -boxes_.f_neg_lo[i];
        const double hi = boxes_.f_hi[i];
        if (lo == infinity && hi == -infinity) return PointSign::Undefined;
        if (lo > 0 && !(hi < lo)) return PointSign::Above;
        if (hi < 0 && !(hi < lo)) return PointSign::Below;
        return PointSign::Unknown;
    }
    /// A guess where the sign is unknown.
    [[nodiscard]] double guess(std::size_t i) const { return boxes_.f_hi[i] - boxes_.f_neg_lo[i]; }

private:
    const SurfaceFunction& function_;
    RangeBoxList<double> boxes_;
};

/// A distance to write.
struct Answer {
    double value;
    double error;  ///< bounds how far it is off
};

/// The errors of the samples of a row that are not proved.
struct RowErrors {
    std::uint64_t count = 0;
    double worst = 0;

    void add(double error) {
        ++count;
        worst = std::max(worst, error);
    }
};

/// From bounds of the distance without its sign.
Answer answer_of(const DistanceBounds& bounds, PointSign sign, double guess) {
    if (sign == PointSign::Undefined)
        return {.value = std::numeric_limits<double>::quiet_NaN(), .error = 0};
    const bool negative = sign == PointSign::Below || (sign == PointSign::Unknown && guess < 0);
    Answer answer{.value = 0.5 * (bounds.lo + bounds.hi), .error = 0.5 * bounds.gap()};
    if (!std::isfinite(bounds.hi)) answer = {.value = bounds.lo, .error = infinity};
    // A distance whose sign is not known is off by twice its size.
    if (sign == PointSign::Unknown) answer.error = 2 * bounds.hi;
    if (negative) answer.value = -answer.value;
    return answer;
}

InputError too_fine(double tolerance) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", tolerance);
    return {.reason = "the surface takes too many cells to enclose to " + std::string(text) +
                      ", as where it touches 0 without crossing it: type a larger --tolerance"};
}

DistanceGrid distances(const SurfaceFunction& function, const GridPlan& plan,
                       const NearSurface& surface, const Box& region, double tolerance) {
    const GridPoints points(plan);
    const auto numbers = std::make_shared<std::vector<float>>(points.rows() * points.width());
    std::vector<RowErrors> errors(points.rows());
    parallel_for(points.rows(), 0, [&](std::size_t row) {
        PointSigns signs(function);
        {
            const UpwardRounding upward;
            signs.find(points, row);
        }
        each_distance_in(points, surface, row, [&](std::size_t i, DistanceBounds bounds) {
            // The surface beyond the region was not looked at.
            bounds.lo = std::min(bounds.lo, depth_in(region, points.point(row, i)));
            const Answer answer = answer_of(bounds, signs.at(i), signs.guess(i));
            (*numbers)[row * points.width() + i] = static_cast<float>(answer.value);
            if (answer.error > tolerance) errors[row].add(answer.error);
        });
    });
    DistanceGrid grid{.samples = {.type = SampleType::Float,
                                  .size = plan.size,
                                  .data = std::shared_ptr<const void>(numbers, numbers->data())}};
    for (const RowErrors& row : errors) {
        grid.unproved += row.count;
        grid.worst = std::max(grid.worst, row.worst);
    }
    return grid;
}

}  // namespace

OrInputError<DistanceGrid> sampled_distance(const Expr& f, const Uniforms& uniforms,
                                            const GridPlan& plan, double tolerance) {
    const SolidPart part = solid_part(f, plan.box);
    const SurfaceFunction function{
        .range = part.range, .gradient = part.gradient, .uniforms = uniforms};
    const SlabLimits limits{.half_width = tolerance / 6, .smallest = tolerance / 2};
    auto surface = NearSurface::make(function, plan.box, limits);
    if (!surface) return std::unexpected(too_fine(tolerance));
    if (surface->pieces().empty()) {
        return wrong_input("the surface surely has no point in the box: type another --box");
    }
    Box region = plan.box;
    if (const double reach = reach_beyond(plan, *surface); reach > 0) {
        region.lo -= reach * (1 + 0x1p-20);
        region.hi += reach * (1 + 0x1p-20);
        surface = NearSurface::make(function, region, limits);
        if (!surface) return std::unexpected(too_fine(tolerance));
    }
    return distances(function, plan, *surface, region, tolerance);
}

}  // namespace zeroset
