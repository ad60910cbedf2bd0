#include "engine/trace/tracer.hpp"

#include <algorithm>
#include <limits>

namespace zeroset {
namespace {

constexpr float none = std::numeric_limits<float>::infinity();

/// Gradients at the points, by the kernel's code in this type.
template <class Real>
void find_gradients_in(const TraceFrame& frame, TileHits& hits) {
    struct Columns {
        std::array<std::vector<Real>, 3> x, gradient;
        std::vector<Real> f;
    };
    thread_local Columns columns;
    const std::size_t count = hits.points.size();
    const std::size_t size = (count + batch_multiple - 1) / batch_multiple * batch_multiple;
    columns.f.resize(size);
    for (std::size_t k = 0; k < 3; ++k) {
        columns.x[k].resize(size);
        columns.gradient[k].resize(size);
        for (std::size_t i = 0; i < size; ++i)
            columns.x[k][i] = static_cast<Real>(hits.points[std::min(i, count - 1)].position[k]);
    }
    frame.kernel.value(ValueBatchOf<Real>{
        size,
        {columns.x[0].data(), columns.x[1].data(), columns.x[2].data()},
        frame.scene.uniforms.points<Real>(),
        columns.f.data(),
        {columns.gradient[0].data(), columns.gradient[1].data(), columns.gradient[2].data()}});
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < count; ++i)
            hits.gradient[k][hits.points[i].pixel] = static_cast<float>(columns.gradient[k][i]);
    }
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
