#include "engine/expr/ray_functions.hpp"

#include "engine/expr/unowned.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace zeroset {
namespace {

/// So many pixels at a time.
constexpr std::size_t most_pixels = 64;
static_assert(most_pixels % batch_multiple == 0);

template <class Real>
using Column = std::array<Real, most_pixels>;

template <class Real>
struct Points {
    std::array<Column<Real>, 3> origin, direction, x, gradient;
    Column<Real> f;
};

/// The rays of `count` pixels. Fused: ray_roundings() counts on it.
template <class Real>
void place_rays(const Real* numbers, const float* col, const float* row, std::size_t count,
                Points<Real>& points) {
    const auto& rays = *reinterpret_cast<const RaysOf<Real>*>(numbers);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto c = static_cast<Real>(col[i]);
            const auto r = static_cast<Real>(row[i]);
            points.origin[k][i] = std::fma(r, rays.origin_by_row[k],
                                           std::fma(c, rays.origin_by_col[k], rays.origin[k]));
            points.direction[k][i] =
                std::fma(r, rays.direction_by_row[k],
                         std::fma(c, rays.direction_by_col[k], rays.direction[k]));
        }
    }
}

/// f and its gradient at the depths.
template <class Real>
void evaluate_at(const KernelFunction<ValueBatchOf<Real>>& value, const Real* uniforms,
                 const Real* s, std::size_t count, Points<Real>& points) {
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < count; ++i) {
            points.x[k][i] = std::fma(s[i], points.direction[k][i], points.origin[k][i]);
        }
    }
    value({count,
           {points.x[0].data(), points.x[1].data(), points.x[2].data()},
           uniforms,
           points.f.data(),
           {points.gradient[0].data(), points.gradient[1].data(), points.gradient[2].data()}});
}

/// One step of `count` pixels from `first` on; whether another is wanted.
template <class Real>
bool take_step(const NewtonBatchOf<Real>& batch, std::size_t first, std::size_t count,
               const Points<Real>& points) {
    bool again = false;
    for (std::size_t i = 0; i < count; ++i) {
        Real slope = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            slope += points.gradient[k][i] * points.direction[k][i];
            batch.gradient[k][first + i] = points.gradient[k][i];
        }
        Real& s = batch.s[first + i];
        const Real from = batch.from[first + i];
        const Real to = batch.to[first + i];
        const Real per_slope = 1 / slope;
        const Real newton = s - points.f[i] * per_slope;
        const Real next = std::min(newton > from ? newton : from, to);  // `from` where NaN
        again = again || (from <= to && std::abs(next - s) > batch.small_step);
        batch.per_slope[first + i] = per_slope;
        s = next;
    }
    return again;
}

template <class Real>
void newton_by_values(const void* code, const NewtonBatchOf<Real>* batch) {
    const auto& value = *static_cast<const KernelFunction<ValueBatchOf<Real>>*>(code);
    Points<Real> points;
    for (std::size_t first = 0; first < batch->size; first += most_pixels) {
        const std::size_t count = std::min(most_pixels, batch->size - first);
        place_rays(batch->rays, batch->col + first, batch->row + first, count, points);
        for (int step = 0; step <= batch->more_steps; ++step) {
            evaluate_at(value, batch->uniforms, batch->s + first, count, points);
            if (!take_step(*batch, first, count, points)) break;
        }
    }
}

void ray_values_by_values(const void* code, const RayValueBatch* batch) {
    const auto& value = *static_cast<const KernelFunction<ValueBatchOf<double>>*>(code);
    Points<double> points;
    for (std::size_t first = 0; first < batch->size; first += most_pixels) {
        const std::size_t count = std::min(most_pixels, batch->size - first);
        place_rays(batch->rays, batch->col + first, batch->row + first, count, points);
        for (int step = 0;; ++step) {
            evaluate_at(value, batch->uniforms, batch->s + first, count, points);
            if (step == batch->steps) break;
            for (std::size_t i = 0; i < count; ++i) {
                double& s = batch->s[first + i];
                const auto per_slope = static_cast<double>(batch->per_slope[first + i]);
                const double newton = s - points.f[i] * per_slope;
                s = std::min(newton > batch->lo ? newton : batch->lo, batch->hi);
            }
        }
        std::copy_n(points.f.begin(), count, batch->f + first);
    }
}

void set_ray_functions(
    Kernel& kernel, std::shared_ptr<const KernelFunction<ValueBatchOf<float>>> in_float,
    const std::shared_ptr<const KernelFunction<ValueBatchOf<double>>>& in_double) {
    kernel.newton_float = {newton_by_values<float>, std::move(in_float)};
    kernel.newton_double = {newton_by_values<double>, in_double};
    kernel.ray_value = {ray_values_by_values, in_double};
}

}  // namespace

void add_ray_functions(Kernel& kernel) {
    set_ray_functions(
        kernel, std::make_shared<const KernelFunction<ValueBatchOf<float>>>(kernel.value_float),
        std::make_shared<const KernelFunction<ValueBatchOf<double>>>(kernel.value_double));
}

void add_ray_functions_in_place(Kernel& kernel) {
    set_ray_functions(kernel, unowned(kernel.value_float), unowned(kernel.value_double));
}

}  // namespace zeroset
