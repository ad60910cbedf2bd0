#include "engine/trace/shade.hpp"

#include "engine/trace/palette.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/trace/shade.cpp"
#include <hwy/foreach_target.h>
// Highway includes this file again for each instruction set.
#include <hwy/highway.h>

#include <algorithm>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace zeroset::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
constexpr D d;

struct V3 {
    V x, y, z;
};

HWY_INLINE V3 splat(const glm::dvec3& v) {
    return {hn::Set(d, static_cast<float>(v.x)), hn::Set(d, static_cast<float>(v.y)),
            hn::Set(d, static_cast<float>(v.z))};
}

HWY_INLINE V dot(const V3& a, const V3& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

HWY_INLINE V3 scaled(const V3& a, V s) {
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}

/// a / |a|, or `otherwise` where a is 0, too large or not a number.
HWY_INLINE V3 normalized(const V3& a, const V3& otherwise) {
    // Scaled by the largest component first, so that squares neither overflow nor vanish.
    const V size = hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
    const auto usable = hn::And(hn::Gt(size, hn::Set(d, 1e-37F)), hn::Lt(size, hn::Set(d, 1e37F)));
    const V3 b = scaled(a, hn::Div(hn::Set(d, 1.0F), size));
    const V3 n = scaled(b, hn::Div(hn::Set(d, 1.0F), hn::Sqrt(dot(b, b))));
    const auto valid = hn::And(usable, hn::Eq(dot(n, n), dot(n, n)));
    return {hn::IfThenElse(valid, n.x, otherwise.x), hn::IfThenElse(valid, n.y, otherwise.y),
            hn::IfThenElse(valid, n.z, otherwise.z)};
}

/// Directions to the lights; they move with the camera.
struct Lights {
    glm::dvec3 key, fill;

    explicit Lights(const ViewFrame& view)
        : key(glm::normalize(-0.45 * view.right + 0.65 * view.up - 0.75 * view.forward)),
          fill(glm::normalize(0.8 * view.right - 0.1 * view.up - 0.45 * view.forward)) {}
};

/// A channel of the picture, 0 to 255, from linear light; gamma 2.
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> encoded(V light) {
    const hn::RebindToSigned<D> di;
    const hn::RebindToUnsigned<D> du;
    const V value = hn::Sqrt(hn::Min(light, hn::Set(d, 1.0F)));
    const V scaled_value = hn::MulAdd(value, hn::Set(d, 255.0F), hn::Set(d, 0.5F));
    return hn::BitCast(du, hn::ConvertTo(di, scaled_value));
}

/// a - b, in float.
void narrow_differences(const double* a, double b, std::size_t size, float* out) {
    const hn::Repartition<double, D> d64;
    const hn::Rebind<float, decltype(d64)> narrow;
    const auto origin = hn::Set(d64, b);
    for (std::size_t i = 0; i < size; i += hn::Lanes(d64))
        hn::StoreU(hn::DemoteTo(narrow, hn::Sub(hn::LoadU(d64, a + i), origin)), narrow, out + i);
}

/// Colours of the first `size` hits, from points, in coordinates where the eye is at
/// `eye_at`, and gradients; `size` may be rounded up.
void shade_hits(const ViewFrame& view, const glm::dvec3& eye_at, const SurfaceColors& colors,
                std::size_t size, ShadeBuffers& buffers) {
    const hn::RebindToUnsigned<D> du;
    const Lights lights(view);
    const V3 key = splat(lights.key);
    const V3 fill = splat(lights.fill);
    const V3 up = splat(view.up);
    const V3 eye = splat(eye_at);
    const V3 forward = splat(view.forward);
    const V zero = hn::Zero(d);
    const V half = hn::Set(d, 0.5F);
    for (std::size_t i = 0; i < size; i += hn::Lanes(d)) {
        const V3 point{hn::LoadU(d, &buffers.point[0][i]), hn::LoadU(d, &buffers.point[1][i]),
                       hn::LoadU(d, &buffers.point[2][i])};
        const V3 ray = normalized(
            {hn::Sub(point.x, eye.x), hn::Sub(point.y, eye.y), hn::Sub(point.z, eye.z)}, forward);
        const V3 to_viewer{hn::Neg(ray.x), hn::Neg(ray.y), hn::Neg(ray.z)};
        const V3 outward = normalized(
            {hn::LoadU(d, &buffers.gradient[0][i]), hn::LoadU(d, &buffers.gradient[1][i]),
             hn::LoadU(d, &buffers.gradient[2][i])},
            to_viewer);
        const V facing = dot(outward, to_viewer);
        const auto front = hn::Ge(facing, zero);
        const V3 normal = scaled(outward, hn::CopySign(hn::Set(d, 1.0F), facing));
        const V key_light = hn::Max(dot(normal, key), zero);
        const V fill_light = hn::Max(dot(normal, fill), zero);
        const V sky = hn::MulAdd(dot(normal, up), half, half);
        const V diffuse =
            hn::MulAdd(key_light, hn::Set(d, 0.85F),
                       hn::MulAdd(fill_light, hn::Set(d, 0.26F),
                                  hn::MulAdd(sky, hn::Set(d, 0.16F), hn::Set(d, 0.10F))));
        const V3 halfway = normalized(
            {hn::Add(key.x, to_viewer.x), hn::Add(key.y, to_viewer.y), hn::Add(key.z, to_viewer.z)},
            to_viewer);
        V gloss = hn::Max(dot(normal, halfway), zero);
        for (int doubling = 0; doubling < 5; ++doubling)
            gloss = hn::Mul(gloss, gloss);
        const V specular = hn::Mul(gloss, hn::Set(d, 0.22F));
        auto color = hn::Set(du, 0xFF000000U);
        for (int channel = 0; channel < 3; ++channel) {
            const V albedo = hn::IfThenElse(front, hn::Set(d, colors.front[channel]),
                                            hn::Set(d, colors.back[channel]));
            const auto value = encoded(hn::MulAdd(albedo, diffuse, specular));
            color = hn::Or(color, hn::ShiftLeftSame(value, 8 * channel));
        }
        hn::StoreU(color, du, &buffers.color[i]);
    }
}

template <class Tag, class T = hn::TFromD<Tag>>
HWY_INLINE void fill(Tag tag, T value, std::size_t count, T* out) {
    std::size_t i = 0;
    for (; i + hn::Lanes(tag) <= count; i += hn::Lanes(tag))
        hn::StoreU(hn::Set(tag, value), tag, out + i);
    std::fill(out + i, out + count, value);
}

void clear_pixels(const Tile& tile, Framebuffer& out) {
    const auto count = static_cast<std::size_t>(tile.cols);
    for (int row = tile.row; row < tile.row + tile.rows; ++row) {
        const std::size_t begin = out.index(tile.col, row);
        fill(hn::RebindToUnsigned<D>(), background_color(row, out.height), count,
             &out.color[begin]);
        fill(d, std::numeric_limits<float>::infinity(), count, &out.depth[begin]);
        std::memset(&out.certificate[begin], static_cast<int>(Certificate::Miss), count);
        std::memset(&out.surface[begin], no_surface, count);
    }
}

}  // namespace zeroset::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zeroset {
namespace {

HWY_EXPORT(clear_pixels);
HWY_EXPORT(narrow_differences);
HWY_EXPORT(shade_hits);

std::size_t padded(std::size_t size) {
    return (size + batch_multiple - 1) / batch_multiple * batch_multiple;
}

/// Points and gradients of the hits, `size` with the padding, by code in float. Returns the eye in
/// the points' coordinates.
glm::dvec3 look_up(const TraceFrame& frame, const TileHits& hits, std::size_t size,
                   ShadeBuffers& buffers) {
    const auto narrow = HWY_DYNAMIC_DISPATCH(narrow_differences);
    for (std::size_t axis = 0; axis < 3; ++axis)
        narrow(hits.position[axis].data(), 0.0, size, buffers.point[axis].data());
    frame.kernel.value(
        {size,
         {buffers.point[0].data(), buffers.point[1].data(), buffers.point[2].data()},
         frame.scene.uniforms.points<float>(),
         buffers.f.data(),
         {buffers.gradient[0].data(), buffers.gradient[1].data(), buffers.gradient[2].data()}});
    return frame.view.eye;
}

/// The same by code in double.
glm::dvec3 look_up_in_double(const TraceFrame& frame, const TileHits& hits, std::size_t size,
                             ShadeBuffers& buffers) {
    const auto narrow = HWY_DYNAMIC_DISPATCH(narrow_differences);
    auto& gradient = buffers.gradient_double;
    buffers.f_double.resize(buffers.f.size());
    for (std::vector<double>& axis : gradient)
        axis.resize(buffers.f.size());
    frame.kernel.value(ValueBatchOf<double>{
        size,
        {hits.position[0].data(), hits.position[1].data(), hits.position[2].data()},
        frame.scene.uniforms.points<double>(),
        buffers.f_double.data(),
        {gradient[0].data(), gradient[1].data(), gradient[2].data()}});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double eye = frame.view.eye[static_cast<int>(axis)];
        narrow(hits.position[axis].data(), eye, size, buffers.point[axis].data());
        narrow(gradient[axis].data(), 0.0, size, buffers.gradient[axis].data());
    }
    return glm::dvec3(0.0);
}

}  // namespace

void clear_tile(const Tile& tile, Framebuffer& out) {
    HWY_DYNAMIC_DISPATCH(clear_pixels)(tile, out);
}

ShadeBuffers::ShadeBuffers() {
    constexpr std::size_t capacity = static_cast<std::size_t>(tile_size) * tile_size;
    f.resize(capacity);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        point[axis].resize(capacity);
        gradient[axis].resize(capacity);
    }
    color.resize(capacity);
}

std::uint32_t background_color(int row, int height) {
    const double t = (row + 0.5) / height;
    const auto mixed = [t](double top, double bottom) {
        return static_cast<std::uint32_t>(top + t * (bottom - top));
    };
    return 0xFF000000U | mixed(58, 24) << 16U | mixed(50, 20) << 8U | mixed(44, 18);
}

void shade_tile(const TraceFrame& frame, std::uint8_t surface, const Tile& tile, TileHits& hits,
                ShadeBuffers& buffers, Framebuffer& out, Counters& counters) {
    for (const auto& [at, depth] : hits.unsettled) {
        Certificate& certificate = out.certificate[out.index(tile.col + at.col, tile.row + at.row)];
        if (certificate == Certificate::Miss) certificate = Certificate::Undecided;
    }
    if (hits.size == 0) return;
    const std::size_t size = padded(hits.size);
    for (std::vector<double>& axis : hits.position) {
        std::fill(axis.begin() + static_cast<std::ptrdiff_t>(hits.size),
                  axis.begin() + static_cast<std::ptrdiff_t>(size), axis.front());
    }
    const bool in_double = frame.precision == Precision::Double;
    const glm::dvec3 eye = in_double ? look_up_in_double(frame, hits, size, buffers)
                                     : look_up(frame, hits, size, buffers);
    counters.value += hits.size;
    HWY_DYNAMIC_DISPATCH(shade_hits)(frame.view, eye, colors_of(surface), size, buffers);
    for (std::size_t i = 0; i < hits.size; ++i) {
        const std::size_t pixel =
            out.index(tile.col + hits.pixel[i].col, tile.row + hits.pixel[i].row);
        out.color[pixel] = buffers.color[i];
        out.depth[pixel] = hits.depth[i];
        out.certificate[pixel] = hits.certificate[i];
        out.surface[pixel] = surface;
    }
}

}  // namespace zeroset

#endif
