#include "engine/trace/blobs/blob_kernel.hpp"

#include "engine/kernel/point_batch.hpp"
#include "engine/trace/blobs/ball_bins.hpp"
#include "engine/trace/blobs/ball_sums.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace zeroset {
namespace {

/// The data of the functions of a tile's kernel.
struct TileCode {
    BallBins& bins;
    BallForms forms;
    double sign;  ///< 1 or -1: f is this times the balls less the level
};

/// Items of a batch by their bins. Keeps its memory.
class ByBin {
public:
    void begin(std::size_t items) { next_.resize(std::max(next_.size(), items)); }
    void add(std::size_t bin, std::size_t item) {
        const auto at = static_cast<std::uint32_t>(item);
        if (heads_[bin] == none) {
            heads_[bin] = at;
            bins_[count_++] = static_cast<std::uint32_t>(bin);
        } else {
            next_[last_[bin]] = at;
        }
        last_[bin] = at;
        next_[item] = none;
    }
    /// Calls visit(bin, items) for up to most_ball_lanes items of one bin; then there are none.
    void take_groups(const auto& visit) {
        std::array<std::size_t, most_ball_lanes> group{};
        for (std::size_t i = 0; i < count_; ++i) {
            const std::size_t bin = bins_[i];
            std::uint32_t item = heads_[bin];
            heads_[bin] = none;
            while (item != none) {
                std::size_t some = 0;
                for (; item != none && some < group.size(); item = next_[item])
                    group[some++] = item;
                visit(bin, std::span<const std::size_t>(group).first(some));
            }
        }
        count_ = 0;
    }

private:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    static constexpr std::size_t bins = BallBins::across * BallBins::across;
    static constexpr auto no_heads = [] {
        std::array<std::uint32_t, bins> all{};
        all.fill(none);
        return all;
    }();

    std::array<std::uint32_t, bins> heads_ = no_heads;
    std::array<std::uint32_t, bins> last_{}, bins_{};
    std::size_t count_ = 0;
    std::vector<std::uint32_t> next_;
};

ByBin& thread_items(std::size_t count) {
    thread_local ByBin items;
    items.begin(count);
    return items;
}

/// 1 where f is the balls less the level, -1 where it is the negative of that, as f away from all
/// balls tells; 0: it cannot be told.
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
    double size = std::abs(form.c);
    for (const double k : form.along)
        size += std::abs(k);
    // Add what rounding to Real makes.
    const double error = form.error + 2 * unit * size;
    constexpr double most = std::numeric_limits<Real>::max();
    const bool known = size + error < most;
    batch.c[i] = known ? static_cast<Real>(sign * form.c) : Real{0};
    for (std::size_t k = 0; k < 3; ++k)
        batch.k[k][i] = known ? static_cast<Real>(sign * form.along[k]) : Real{0};
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
void forms_of(const void* of, const FormBatchOf<Real>* batch) {
    const auto& code = *static_cast<const TileCode*>(of);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): its first member (FormBatchOf)
    const auto& frustum = *reinterpret_cast<const FrustumOf<Real>*>(batch->frustum);
    BallBins& bins = code.bins;
    const auto is_again = [&](std::size_t i) {
        return i > 0 && batch->u[i] == batch->u[i - 1] && batch->v[i] == batch->v[i - 1] &&
               batch->s[i] == batch->s[i - 1] && batch->s_radius[i] == batch->s_radius[i - 1];
    };
    const double radius =
        std::max(static_cast<double>(frustum.u_radius), static_cast<double>(frustum.v_radius)) /
        bins.rays().pixel();
    const auto is_listed = [&](double col, double row, double from, double to) {
        return BallBins::holds(col, row, radius) && from >= bins.from() && to <= bins.to();
    };
    ByBin& items = thread_items(batch->size);
    for (std::size_t i = 0; i < batch->size; ++i) {
        if (is_again(i)) continue;
        const double col = bins.col(static_cast<double>(batch->u[i]));
        const double row = bins.row(static_cast<double>(batch->v[i]));
        const auto s = static_cast<double>(batch->s[i]);
        const auto way = static_cast<double>(batch->s_radius[i]);
        if (is_listed(col, row, s - way, s + way)) {
            items.add(BallBins::index_of(col, row), i);
        } else {
            write_form(*batch, i, {.error = std::numeric_limits<double>::infinity()}, code.sign);
        }
    }
    // Enclose the balls of each bin on its cells.
    BallCells cells;
    cells.u_radius = static_cast<double>(frustum.u_radius);
    cells.v_radius = static_cast<double>(frustum.v_radius);
    items.take_groups([&](std::size_t index, std::span<const std::size_t> group) {
        cells.count = group.size();
        double until = bins.from();
        for (std::size_t i = 0; i < group.size(); ++i) {
            cells.u[i] = static_cast<double>(batch->u[group[i]]);
            cells.v[i] = static_cast<double>(batch->v[group[i]]);
            cells.s[i] = static_cast<double>(batch->s[group[i]]);
            cells.s_radius[i] = static_cast<double>(batch->s_radius[group[i]]);
            until = std::max(until, cells.s[i] + cells.s_radius[i]);
        }
        std::array<BallForm, most_ball_lanes> forms;
        find_forms<Real>(code.forms, bins.bin(index, until), cells, forms.data());
        for (std::size_t i = 0; i < group.size(); ++i)
            write_form(*batch, group[i], forms[i], code.sign);
    });
    // Copy the forms of repeated cells: batches are filled up with their last one.
    for (std::size_t i = 0; i < batch->size; ++i) {
        if (is_again(i)) copy_form(*batch, i - 1, i);
    }
}

template <class Real>
void ray_forms_of(const void* of, const FormBatchOf<Real>* batch) {
    const FrustumOf<Real> ray{};
    FormBatchOf<Real> along = *batch;
    along.frustum = ray.base;
    forms_of<Real>(of, &along);
}

void values_of(const void* of, const ValueBatchOf<double>* batch) {
    const auto& code = *static_cast<const TileCode*>(of);
    BallBins& bins = code.bins;
    const TileRays& rays = bins.rays();
    const ViewFrame& view = rays.axes();
    ByBin& items = thread_items(batch->size);
    thread_local std::vector<glm::dvec3> places;
    places.resize(batch->size);
    // Place the points in the view, and sort them by bins.
    for (std::size_t i = 0; i < batch->size; ++i) {
        const glm::dvec3 point =
            glm::dvec3(batch->x[0][i], batch->x[1][i], batch->x[2][i]) - rays.base();
        glm::dvec3& at = places[i];
        at = {glm::dot(point, view.right), glm::dot(point, view.up), glm::dot(point, view.forward)};
        const double per_distance = 1 / (rays.distance() + at.z);
        items.add(BallBins::index_of(bins.col(at.x * per_distance), bins.row(at.y * per_distance)),
                  i);
    }
    // Evaluate each bin's balls at its points; turn the slopes into the world.
    items.take_groups([&](std::size_t index, std::span<const std::size_t> group) {
        BallPoints points;
        points.count = group.size();
        double until = bins.from();
        for (std::size_t i = 0; i < most_ball_lanes; ++i) {
            const glm::dvec3& at = places[group[std::min(i, group.size() - 1)]];
            points.x[i] = at.x;
            points.y[i] = at.y;
            points.z[i] = at.z;
            until = std::max(until, at.z);
        }
        find_values(code.forms, bins.bin(index, until), points);
        for (std::size_t i = 0; i < group.size(); ++i) {
            batch->f[group[i]] = code.sign * points.value[i];
            const glm::dvec3 slope =
                code.sign * (points.slope[0][i] * view.right + points.slope[1][i] * view.up +
                             points.slope[2][i] * view.forward);
            for (int k = 0; k < 3; ++k)
                batch->gradient[k][group[i]] = slope[k];
        }
    });
}

}  // namespace

std::optional<Kernel> blob_kernel(const TraceFrame& frame, const Tile& tile) {
    const auto surface = blob_surface(frame);
    if (!surface) return std::nullopt;
    const double sign = sign_of(frame, *surface);
    if (sign == 0) return std::nullopt;
    BallBins& bins = thread_ball_bins();
    bins.begin(frame, tile, *surface);
    const auto code = std::make_shared<TileCode>(
        TileCode{.bins = bins, .forms = ball_forms(bins, *surface), .sign = sign});
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
