#pragma once

#include "engine/kernel/form_cells.hpp"
#include "engine/kernel/range_boxes.hpp"
#include "engine/num/interval.hpp"
#include "engine/real/scalar.hpp"
#include "engine/trace/ray_lines.hpp"
#include "engine/trace/tile_costs.hpp"
#include "papers/along_rays/ray_boxes.hpp"
#include "papers/along_rays/stretch.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace zeroset {

/// Tasks that are looked at together: a batch for the kernels.
inline constexpr std::size_t most_tasks = 256;

/// F, the natural interval extension of f, over stretches and at points of rays: over the boxes
/// about them [Mitchell90]. In upward rounding, as all here.
template <class Real>
class RangesOnRays {
public:
    static constexpr std::size_t capacity = 3 * most_tasks;

    void begin(const TraceFrame& frame, const RayLines& lines, Counters& counters) {
        frame_ = &frame;
        lines_ = &lines;
        counters_ = &counters;
        size_ = 0;
    }
    /// Goes on with another function.
    void look_at(const TraceFrame& frame) { frame_ = &frame; }
    void clear() { size_ = 0; }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Adds [from, to] of a pixel's ray; its index.
    std::size_t push(std::uint32_t pixel, double from, double to) {
        assert(size_ < capacity);
        const RayLine& line = lines_->of(pixel);
        pixels_[size_] = pixel;
        spans_.from[size_] = from;
        spans_.to[size_] = to;
        for (std::size_t k = 0; k < 3; ++k) {
            spans_.origin[k][size_] = line.origin[k];
            spans_.direction[k][size_] = line.direction[k];
        }
        return size_++;
    }
    std::size_t push(std::uint32_t pixel, double at) { return push(pixel, at, at); }
    /// Repeats the last one up to a multiple of batch_multiple.
    void evaluate() {
        if (size_ == 0) return;
        counters_->range += size_;
        for (std::size_t i = 0; counters_->costs != nullptr && i < size_; ++i)
            counters_->costs->add(pixels_[i]);
        auto& ends = boxes_.ends;
        make_ray_boxes({.from = spans_.from.data(),
                        .to = spans_.to.data(),
                        .origin = pointers(spans_.origin),
                        .direction = pointers(spans_.direction)},
                       size_,
                       std::array<Real*, 6>{ends[0], ends[1], ends[2], ends[3], ends[4], ends[5]});
        boxes_.pad(size_);
        frame_->kernel.template range<Real>(
            boxes_.batch(padded(size_), frame_->scene.uniforms.template boxes<Real>()));
    }

    /// Whether f is surely nowhere 0.
    [[nodiscard]] bool excludes_zero(std::size_t i) const { return boxes_.excludes_zero(i); }
    [[nodiscard]] bool continuous(std::size_t i) const { return boxes_.continuous[i] != 0; }
    [[nodiscard]] EndSign sign(std::size_t i) const {
        return static_cast<EndSign>(static_cast<int>(boxes_.f_neg_lo[i] < 0) -
                                    static_cast<int>(boxes_.f_hi[i] < 0));
    }
    /// Where f is continuous: its enclosure.
    [[nodiscard]] Interval<double> of(std::size_t i) const {
        return without_nan(Interval<double>{.neg_lo = static_cast<double>(boxes_.f_neg_lo[i]),
                                            .hi = static_cast<double>(boxes_.f_hi[i])});
    }

private:
    static std::array<const double*, 3> pointers(
        const std::array<std::array<double, capacity>, 3>& columns) {
        return {columns[0].data(), columns[1].data(), columns[2].data()};
    }

    const TraceFrame* frame_ = nullptr;
    const RayLines* lines_ = nullptr;
    Counters* counters_ = nullptr;
    std::size_t size_ = 0;
    std::array<std::uint32_t, capacity> pixels_;
    RaySpans<capacity> spans_;
    RangeBoxes<Real, capacity> boxes_;
};

/// Affine forms of f over stretches of rays, and enclosures F' of df/ds there: cells of beams
/// without width [Knoll09].
template <class Real>
class FormsOnRays {
public:
    static constexpr std::size_t capacity = most_tasks;

    void begin(const TraceFrame& frame, const TileRays& rays, Counters& counters) {
        frame_ = &frame;
        counters_ = &counters;
        size_ = 0;
        margin_ = rays.depth_error();
        frustum_ = rays.frustum<Real>(1);
        for (int i = 0; i < tile_size; ++i) {
            u_[static_cast<std::size_t>(i)] = static_cast<Real>(rays.u(i));
            v_[static_cast<std::size_t>(i)] = static_cast<Real>(rays.v(i));
        }
    }
    /// Goes on with another function.
    void look_at(const TraceFrame& frame) { frame_ = &frame; }
    void clear() { size_ = 0; }
    [[nodiscard]] std::size_t size() const { return size_; }
    std::size_t push(std::uint32_t pixel, const Stretch& stretch) {
        assert(size_ < capacity);
        const auto s = static_cast<Real>(stretch.middle());
        const auto middle = static_cast<double>(s);
        const double radius = std::max(stretch.to - middle, middle - stretch.from) + margin_;
        pixels_[size_] = pixel;
        cells_.u[size_] = u_[pixel % tile_size];
        cells_.v[size_] = v_[pixel / tile_size];
        cells_.s[size_] = s;
        cells_.s_radius[size_] = upper_end(Real{}, radius);
        return size_++;
    }
    void evaluate() {
        if (size_ == 0) return;
        counters_->form += size_;
        for (std::size_t i = 0; counters_->costs != nullptr && i < size_; ++i)
            counters_->costs->add(pixels_[i]);
        const std::size_t whole = padded(size_, frame_->kernel.lane_multiple);
        for (auto* const column : {&cells_.u, &cells_.v, &cells_.s, &cells_.s_radius})
            std::fill(column->begin() + size_, column->begin() + whole, (*column)[0]);
        frame_->kernel.template ray_form<Real>(
            cells_.batch(whole, frustum_, frame_->scene.uniforms.template boxes<Real>()));
    }

    /// Whether f is surely undefined in all of the stretch.
    [[nodiscard]] bool is_nowhere(std::size_t i) const { return cells_.nowhere[i] != 0; }
    /// Whether f is surely nowhere 0.
    [[nodiscard]] bool excludes_zero(std::size_t i) const {
        return cells_.nowhere[i] != 0 || std::abs(cells_.c[i]) > spread(i);
    }
    /// The most by which f can differ from the middle of its enclosure.
    [[nodiscard]] Real spread(std::size_t i) const {
        return std::abs(cells_.k[2][i]) + cells_.e[i];
    }
    [[nodiscard]] bool continuous(std::size_t i) const { return cells_.continuous[i] != 0; }
    /// F' over the stretch; the whole line where it is not known.
    [[nodiscard]] Interval<double> slope(std::size_t i) const {
        if (!continuous(i)) return whole_line(0.0);
        return without_nan(Interval<double>{.neg_lo = static_cast<double>(cells_.slope_neg_lo[i]),
                                            .hi = static_cast<double>(cells_.slope_hi[i])});
    }

private:
    const TraceFrame* frame_ = nullptr;
    Counters* counters_ = nullptr;
    std::size_t size_ = 0;
    double margin_ = 0.0;
    FrustumOf<Real> frustum_{};
    std::array<Real, tile_size> u_{}, v_{};
    std::array<std::uint32_t, capacity> pixels_;
    FormCells<Real, capacity> cells_;
};

}  // namespace zeroset
