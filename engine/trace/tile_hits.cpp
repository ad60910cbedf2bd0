#include "engine/trace/tracer.hpp"

#include <algorithm>
#include <limits>

namespace zeroset {
namespace {

constexpr float none = std::numeric_limits<float>::infinity();

/// Gradients at the points, by kernels' code in this type.
template <class Real>
class PointGradients {
public:
    PointGradients(const TraceFrame& frame, std::span<const TileHits::Point> points)
        : frame_(frame), points_(points), columns_(columns()) {
        const std::size_t count = points.size();
        size_ = (count + batch_multiple - 1) / batch_multiple * batch_multiple;
        columns_.f.resize(size_);
        columns_.least.assign(count, std::numeric_limits<Real>::infinity());
        for (std::size_t k = 0; k < 3; ++k) {
            columns_.x[k].resize(size_);
            columns_.gradient[k].resize(size_);
            for (std::size_t i = 0; i < size_; ++i)
                columns_.x[k][i] = static_cast<Real>(points[std::min(i, count - 1)].position[k]);
        }
    }
    /// Those of this function, where it is no larger than those before.
    void take(const Kernel& kernel, TileHits& hits) {
        auto& [x, gradient, f, least] = columns_;
        kernel.value(
            ValueBatchOf<Real>{size_,
                               {x[0].data(), x[1].data(), x[2].data()},
                               frame_.scene.uniforms.points<Real>(),
                               f.data(),
                               {gradient[0].data(), gradient[1].data(), gradient[2].data()}});
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (f[i] > least[i]) continue;
            least[i] = f[i];
            for (std::size_t k = 0; k < 3; ++k)
                hits.gradient[k][points_[i].pixel] = static_cast<float>(gradient[k][i]);
        }
    }

private:
    struct Columns {
        std::array<std::vector<Real>, 3> x, gradient;
        std::vector<Real> f, least;
    };
    static Columns& columns() {
        thread_local Columns instance;
        return instance;
    }

    const TraceFrame& frame_;
    std::span<const TileHits::Point> points_;
    Columns& columns_;
    std::size_t size_;
};

template <class Real>
void find_gradients_in(const TraceFrame& frame, TileHits& hits) {
    PointGradients<Real> gradients(frame, hits.points);
    if (frame.parts.empty()) gradients.take(frame.kernel, hits);
    for (const PartInView& part : frame.parts)
        gradients.take(*part.kernel, hits);
}

}  // namespace

TileHits::TileHits() {
    constexpr std::size_t pixels = static_cast<std::size_t>(tile_size) * tile_size;
    depth.resize(pixels, none);
    certificate.resize(pixels);
    for (std::vector<float>& axis : gradient)
        axis.resize(pixels);
    unsettled.resize(pixels, none);
    lit.resize(pixels, 1.0F);
    cap.resize(pixels, 0);
}

void TileHits::light_all() {
    if (any_dark) std::ranges::fill(lit, 1.0F);
    any_dark = false;
}

void TileHits::clear() {
    if (any) std::ranges::fill(depth, none);
    if (any_unsettled) std::ranges::fill(unsettled, none);
    if (any_cap) std::ranges::fill(cap, std::uint8_t{0});
    any_cap = false;
    light_all();
    any = false;
    any_unsettled = false;
    points.clear();
}

void TileHits::push(Pixel at, const std::array<double, 3>& where, float distance,
                    Certificate known) {
    any = true;
    depth[at.index()] = distance;
    certificate[at.index()] = known;
    points.push_back({at.index(), where});
}

void TileHits::pass(Pixel at, float distance) {
    any_unsettled = true;
    unsettled[at.index()] = std::min(unsettled[at.index()], distance);
}

void TileHits::put_cap(Pixel at, float distance, Certificate known, const glm::dvec3& normal) {
    const std::size_t pixel = at.index();
    any = true;
    any_cap = true;
    cap[pixel] = 1;
    depth[pixel] = distance;
    certificate[pixel] = known;
    unsettled[pixel] = none;
    for (std::size_t k = 0; k < 3; ++k)
        gradient[k][pixel] = static_cast<float>(normal[static_cast<int>(k)]);
}

void find_gradients(const TraceFrame& frame, TileHits& hits, Counters& counters) {
    std::erase_if(hits.points,
                  [&](const TileHits::Point& point) { return hits.depth[point.pixel] == none; });
    if (hits.points.empty()) return;
    counters.value += hits.points.size();
    if (frame.precision == Precision::Double) {
        find_gradients_in<double>(frame, hits);
    } else {
        find_gradients_in<float>(frame, hits);
    }
    hits.points.clear();
}

}  // namespace zeroset
