#include "pipeline/sample_grid.hpp"

#include "engine/base/parallel.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/real/rounding.hpp"
#include "engine/rewrite/row_split.hpp"
#include "jit/compile.hpp"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>

namespace zeroset {
namespace {

/// So many operators at all points take the interpreter about as long as LLVM takes to be loaded
/// and to make code.
constexpr double operators_for_code = 1e9;

PointFunction code_of(const Expr& along, double points) {
    if (points * static_cast<double>(along.nodes().size()) >= operators_for_code) {
        if (auto code = jit::compile_points(along)) return std::move(*code);
    }
    return interpret_points(along);
}

/// f at points in upward rounding; the arrays are padded.
void evaluate(const PointFunction& function, const std::array<const double*, 3>& x,
              std::span<const double> uniforms, std::span<double> f) {
    function({.size = f.size(),
              .x = {x[0], x[1], x[2]},
              .uniforms = uniforms.data(),
              .f = f.data(),
              .gradient = {}});
}

void round_to_floats(std::span<const double> numbers, std::span<float> floats) {
    const NearestCall nearest;
    std::size_t i = 0;
    for (; i + 4 <= floats.size(); i += 4) {
        const __m128 low = _mm_cvtpd_ps(_mm_loadu_pd(&numbers[i]));
        const __m128 high = _mm_cvtpd_ps(_mm_loadu_pd(&numbers[i + 2]));
        _mm_storeu_ps(&floats[i], _mm_movelh_ps(low, high));
    }
    for (; i < floats.size(); ++i)
        floats[i] = static_cast<float>(numbers[i]);
}

/// Lets threads pass in the order of their numbers.
class InOrder {
public:
    /// Waits until all lower numbers are done, then calls `act`, which returns whether to go on.
    template <class Act>
    void pass(std::size_t number, const Act& act) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return next_ == number || ended_; });
        if (ended_) return;
        lock.unlock();
        const bool goes_on = act();
        lock.lock();
        ended_ = !goes_on;
        ++next_;
        changed_.notify_all();
    }
    [[nodiscard]] bool ended() {
        const std::scoped_lock lock(mutex_);
        return ended_;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t next_ = 0;
    bool ended_ = false;
};

}  // namespace

Geometry geometry_of(const GridPlan& plan) {
    Geometry geometry;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        geometry.origin[i] = plan.box.lo[axis];
        geometry.world_from_index[i] = {};
        geometry.world_from_index[i][i] =
            (plan.box.hi[axis] - plan.box.lo[axis]) / static_cast<double>(plan.size[i] - 1);
    }
    return geometry;
}

double sample_place(const Geometry& geometry, std::size_t axis, std::size_t index) {
    return geometry.origin[axis] +
           geometry.world_from_index[axis][axis] * static_cast<double>(index);
}

GridFunction::GridFunction(const Expr& f, const Uniforms& uniforms, const GridPlan& plan)
    : plan_(plan),
      geometry_(geometry_of(plan)),
      width_(plan.size[0]),
      rows_(plan.size[1] * plan.size[2]) {
    const auto numbers = uniforms.all_points<double>();
    uniforms_.assign(numbers.begin(), numbers.end());
    uniforms_.resize(1 + f.parameters().size());
    const RowSplit split = split_for_rows(f);
    function_ = code_of(split.along, static_cast<double>(width_) * static_cast<double>(rows_));
    const Column x = along(0);
    const UpwardRounding upward;
    for (const Expr& table : split.tables) {
        evaluate(interpret_points(table), {x.data(), x.data(), x.data()}, uniforms_,
                 tables_.emplace_back(x.size()));
    }
    tables_.resize(RowSplit::most_tables, x);
    for (const Expr& value : split.of_row)
        of_row_.push_back(interpret_points(value));
}

GridFunction::Column GridFunction::along(std::size_t axis) const {
    Column places(padded(plan_.size[axis]));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t index = std::min<std::size_t>(i, plan_.size[axis] - 1);
        places[i] = sample_place(geometry_, axis, index);
    }
    return places;
}

std::size_t GridFunction::rows_at_once() const {
    constexpr std::size_t samples_at_once = std::size_t{1} << 16U;
    return std::clamp<std::size_t>(samples_at_once / width_, 1, rows_);
}

std::vector<GridFunction::Column> GridFunction::row_values(std::size_t first_row,
                                                           std::size_t count) const {
    std::array<Column, 2> at{Column(padded(count)), Column(padded(count))};
    for (std::size_t i = 0; i < at[0].size(); ++i) {
        const std::size_t row = first_row + std::min(i, count - 1);
        const std::array index{row % plan_.size[1], row / plan_.size[1]};
        for (std::size_t k = 0; k < 2; ++k)
            at[k][i] = sample_place(geometry_, k + 1, index[k]);
    }
    std::vector<Column> values;
    for (const PointFunction& value : of_row_) {
        evaluate(value, {at[0].data(), at[0].data(), at[1].data()}, uniforms_,
                 values.emplace_back(at[0].size()));
    }
    return values;
}

void GridFunction::sample(std::size_t first_row, std::span<float> samples) const {
    const UpwardRounding upward;
    const std::size_t count = samples.size() / width_;
    const std::vector<Column> values = row_values(first_row, count);
    std::vector<double> uniforms = uniforms_;
    uniforms.resize(uniforms_.size() + values.size());
    Column f(tables_[0].size());
    for (std::size_t row = 0; row < count; ++row) {
        for (std::size_t k = 0; k < values.size(); ++k)
            uniforms[uniforms_.size() + k] = values[k][row];
        evaluate(function_, {tables_[0].data(), tables_[1].data(), tables_[2].data()}, uniforms, f);
        round_to_floats(f, samples.subspan(row * width_, width_));
    }
}

bool sample_in_order(const GridFunction& function,
                     const std::function<bool(std::span<const float>)>& take) {
    const std::size_t at_once = function.rows_at_once();
    const std::size_t count = (function.rows() + at_once - 1) / at_once;
    std::atomic<std::size_t> next = 0;
    InOrder order;
    const auto work = [&](std::size_t /*thread*/) {
        std::vector<float> samples(at_once * function.width());
        for (std::size_t i = next++; i < count && !order.ended(); i = next++) {
            const std::size_t first = i * at_once;
            const std::size_t rows = std::min(at_once, function.rows() - first);
            const std::span<float> part(samples.data(), rows * function.width());
            function.sample(first, part);
            order.pass(i, [&] { return take(part); });
        }
    };
    parallel_for(static_cast<std::size_t>(core_count()), 0, work);
    return !order.ended();
}

Samples sampled(const Expr& f, const Uniforms& uniforms, const GridPlan& plan) {
    const GridFunction function(f, uniforms, plan);
    const std::size_t width = function.width();
    const auto numbers = std::make_shared_for_overwrite<float[]>(width * function.rows());
    const std::size_t at_once = function.rows_at_once();
    parallel_for((function.rows() + at_once - 1) / at_once, 0, [&](std::size_t i) {
        const std::size_t first = i * at_once;
        const std::size_t rows = std::min(at_once, function.rows() - first);
        function.sample(first, {numbers.get() + first * width, rows * width});
    });
    return {.type = SampleType::Float, .size = plan.size, .data = numbers};
}

}  // namespace zeroset
