#include "engine/trace/blobs/blob_kernel.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/trace/blobs/ball_bins.hpp"
#include "engine/trace/blobs/ball_sums.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace zeroset {
namespace {

/// What the functions of a tile's kernel know.
struct TileCode {
    BallBins& bins;
    BallForms forms;
    double sign;  ///< f is so often the balls less the level
};

/// Whether f is the balls less the level, or the negative of that: as f is where no ball is.
/// 0: it cannot be told.
double sign_of(const TraceFrame& frame, const BlobSurface& surface) {
    const BlobSet::Node& all = surface.blobs->set().nodes().front();
    const auto beside = [&](std::size_t i) { return 2 * all.hi[i] - all.lo[i]; };
    PointBatch<double> point(1);
    point.set(0, beside(0), beside(1), beside(2));
    point.pad();
    auto batch = point.batch(frame.scene.uniforms.points<double>());
    frame.kernel.in_double.value(batch);
    const double f = batch.f[0] * surface.level;
    return f < 0 ? 1 : f > 0 ? -1 : 0;
}

template <class Real>
void write_form(const FormBatchOf<Real>& batch, std::size_t i, const BallForm& form, double sign) {
    constexpr double unit = std::numeric_limits<Real>::epsilon();
    const double along[3] = {form.along_u, form.along_v, form.along_s};
    double size = std::abs(form.c);
    for (const double k : along)
        size += std::abs(k);
    // Rounded once more.
    const double error = form.error + 2 * unit * size;
    constexpr double most = std::numeric_limits<Real>::max();
    const bool known = size + error < most;
    batch.c[i] = known ? static_cast<Real>(sign * form.c) : Real{0};
    for (std::size_t k = 0; k < 3; ++k)
        batch.k[k][i] = known ? static_cast<Real>(sign * along[k]) : Real{0};
    batch.e[i] = known ? static_cast<Real>(error) : std::numeric_limits<Real>::infinity();
    batch.r[i] = static_cast<Real>(error / unit);
    const double lo = sign > 0 ? form.slope_lo : -form.slope_hi;
    const double hi = sign > 0 ? form.slope_hi : -form.slope_lo;
    const bool sloped = known && std::abs(lo) < most && std::abs(hi) < most;
    batch.slope_neg_lo[i] = sloped ? static_cast<Real>(-lo) : std::numeric_limits<Real>::infinity();
    batch.slope_hi[i] = sloped ? static_cast<Real>(hi) : std::numeric_limits<Real>::infinity();
    batch.continuous[i] = ~ContinuityMask<Real>{0};
    batch.nowhere[i] = 0;
}

template <class Real>
void copy_form(const FormBatchOf<Real>& batch, std::size_t from, std::size_t to) {
    for (Real* const column : {batch.c, batch.k[0], batch.k[1], batch.k[2], batch.e, batch.r,
                               batch.slope_neg_lo, batch.slope_hi})
        column[to] = column[from];
    batch.continuous[to] = batch.continuous[from];
    batch.nowhere[to] = batch.nowhere[from];
}

template <class Real>
BallForm form_of(const TileCode& code, const BallCell& cell) {
    BallBins& bins = code.bins;
    const double col = bins.col(cell.u);
    const double row = bins.row(cell.v);
    const double radius = std::max(std::abs(cell.u_radius), std::abs(cell.v_radius)) /
                          bins.rays().pixel();
    const bool listed = BallBins::holds(col, row, radius) &&
                        cell.s - cell.s_radius >= bins.from() &&
                        cell.s + cell.s_radius <= bins.to();
    if (!listed) return {.error = std::numeric_limits<double>::infinity()};
    const BallBin& bin = bins.bin(col, row, cell.s + cell.s_radius);
    if constexpr (sizeof(Real) == sizeof(float)) {
        return form_by_floats(code.forms, bin, cell);
    } else {
        return form_by_doubles(code.forms, bin, cell);
    }
}

template <class Real>
void forms_of(const void* of, const FormBatchOf<Real>* batch) {
    const auto& code = *static_cast<const TileCode*>(of);
    const auto& frustum = *static_cast<const FrustumOf<Real>*>(
        static_cast<const void*>(batch->frustum));
    const auto is_again = [&](std::size_t i) {
        return batch->u[i] == batch->u[i - 1] && batch->v[i] == batch->v[i - 1] &&
               batch->s[i] == batch->s[i - 1] && batch->s_radius[i] == batch->s_radius[i - 1];
    };
    for (std::size_t i = 0; i < batch->size; ++i) {
        // Batches are filled up by the last one.
        if (i > 0 && is_again(i)) {
            copy_form(*batch, i - 1, i);
            continue;
        }
        const BallCell cell{.u = batch->u[i],
                            .v = batch->v[i],
                            .u_radius = frustum.u_radius,
                            .v_radius = frustum.v_radius,
                            .s = batch->s[i],
                            .s_radius = batch->s_radius[i]};
        write_form(*batch, i, form_of<Real>(code, cell), code.sign);
    }
}

template <class Real>
void ray_forms_of(const void* of, const FormBatchOf<Real>* batch) {
    FrustumOf<Real> ray{};
    FormBatchOf<Real> along = *batch;
    along.frustum = ray.base;
    forms_of<Real>(of, &along);
}

void values_of(const void* of, const ValueBatchOf<double>* batch) {
    const auto& code = *static_cast<const TileCode*>(of);
    BallBins& bins = code.bins;
    const TileRays& rays = bins.rays();
    const ViewFrame& view = rays.axes();
    for (std::size_t i = 0; i < batch->size; ++i) {
        const glm::dvec3 point =
            glm::dvec3(batch->x[0][i], batch->x[1][i], batch->x[2][i]) - rays.base();
        const double x = glm::dot(point, view.right);
        const double y = glm::dot(point, view.up);
        const double z = glm::dot(point, view.forward);
        const double per_distance = 1 / (rays.distance() + z);
        const BallBin& bin = bins.bin(bins.col(x * per_distance), bins.row(y * per_distance), z);
        const BallValue found = value_of(code.forms, bin, x, y, z);
        batch->f[i] = code.sign * found.value;
        const glm::dvec3 slope = code.sign * (found.slope[0] * view.right +
                                              found.slope[1] * view.up +
                                              found.slope[2] * view.forward);
        for (int k = 0; k < 3; ++k)
            batch->gradient[k][i] = slope[k];
    }
}

}  // namespace

std::optional<Kernel> blob_kernel(const TraceFrame& frame, const Tile& tile) {
    const auto surface = blob_surface(frame);
    if (!surface) return std::nullopt;
    const double sign = sign_of(frame, *surface);
    if (sign == 0) return std::nullopt;
    BallBins& bins = thread_ball_bins();
    bins.begin(frame, tile, *surface);
    const TileRays& rays = bins.rays();
    const Blobs& blobs = *surface->blobs;
    const double u_most = std::max(std::abs(rays.u(-1)), std::abs(rays.u(tile_size)));
    const double v_most = std::max(std::abs(rays.v(-1)), std::abs(rays.v(tile_size)));
    const auto code = std::make_shared<TileCode>(
        TileCode{.bins = bins,
                 .forms = {.kind = blobs.kind(),
                           .level = surface->level,
                           .tail = surface->tail(),
                           .slope_tail = (1 + u_most + v_most) * blob_facts(blobs.kind()).tail *
                                         blobs.set().total().per_radius,
                           .distance = rays.distance(),
                           .place_error = 16 * rays.depth_error()},
                 .sign = sign});
    Kernel kernel;
    kernel.in_float.form = {.call = forms_of<float>, .code = code};
    kernel.in_float.ray_form = {.call = ray_forms_of<float>, .code = code};
    kernel.in_double.form = {.call = forms_of<double>, .code = code};
    kernel.in_double.ray_form = {.call = ray_forms_of<double>, .code = code};
    kernel.in_double.value = {.call = values_of, .code = code};
    kernel.has_double = frame.kernel.has_double;
    return kernel;
}

}  // namespace zeroset
