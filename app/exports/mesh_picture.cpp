#include "app/exports/previews.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace zeroset {
namespace {

/// Samples of a pixel along each side.
constexpr int samples = 2;
/// Samples from an edge within which it is seen, and the mean area from which edges are drawn.
constexpr double edge_width = 0.9;
constexpr double least_area = 120.0;
constexpr double edge_shade = 0.45;

/// A corner of a triangle in the picture, in samples.
struct Corner {
    double x = 0.0, y = 0.0;
    double nearness = 0.0;  ///< affine in the picture; more is nearer
    bool shown = false;     ///< before the eye
};

/// The picture with as many samples as it takes to be smooth.
class MeshPainter {
public:
    MeshPainter(const Camera& camera, const glm::ivec2& size_px)
        : view_(camera),
          width_(samples * size_px.x),
          height_(samples * size_px.y),
          colors_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)),
          nearness_(colors_.size(), -std::numeric_limits<double>::infinity()) {}

    void draw(const MeshObject& object);
    [[nodiscard]] RgbaImage image() const;

private:
    [[nodiscard]] Corner corner_of(const glm::dvec3& point) const;
    void draw(const std::array<Corner, 3>& corners, const glm::dvec3& color, bool has_edges);
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    ViewFrame view_;
    int width_, height_;
    std::vector<std::uint32_t> colors_;  ///< as in RgbaImage; 0: nothing
    std::vector<double> nearness_;
};

Corner MeshPainter::corner_of(const glm::dvec3& point) const {
    const glm::dvec3 place = view_.homogeneous(point);
    if (!(place.z > 0.0)) return {};
    const double along = glm::dot(point - view_.eye, view_.forward);
    const double half = 0.5 * height_;
    return {.x = 0.5 * width_ + half * place.x / place.z,
            .y = half - half * place.y / place.z,
            .nearness = view_.parallel() ? -along : 1.0 / along,
            .shown = true};
}

std::uint32_t packed(const glm::dvec3& color) {
    std::uint32_t bits = 0xFF000000U;
    for (int i = 0; i < 3; ++i) {
        const double shown = std::clamp(color[i], 0.0, 1.0) * 255.0 + 0.5;
        bits |= static_cast<std::uint32_t>(shown) << static_cast<unsigned>(8 * i);
    }
    return bits;
}

/// Twice the area of the triangle in the picture, with its sign.
double area_of(const Corner& a, const Corner& b, const Corner& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void MeshPainter::draw(const std::array<Corner, 3>& corners, const glm::dvec3& color,
                       bool has_edges) {
    const auto& [a, b, c] = corners;
    if (!(a.shown && b.shown && c.shown)) return;
    const double area = area_of(a, b, c);
    if (!(std::abs(area) > 0.0)) return;
    const std::array<double, 3> lengths{std::hypot(c.x - b.x, c.y - b.y),
                                        std::hypot(a.x - c.x, a.y - c.y),
                                        std::hypot(b.x - a.x, b.y - a.y)};
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    const int x_end = static_cast<int>(std::min(std::ceil(right), static_cast<double>(width_)));
    const int y_end = static_cast<int>(std::min(std::ceil(bottom), static_cast<double>(height_)));
    const std::uint32_t inside = packed(color);
    const std::uint32_t edge = packed(edge_shade * color);
    for (int y = static_cast<int>(std::max(top, 0.0)); y < y_end; ++y) {
        for (int x = static_cast<int>(std::max(left, 0.0)); x < x_end; ++x) {
            const double px = x + 0.5;
            const double py = y + 0.5;
            const double of_a = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) / area;
            const double of_b = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) / area;
            const double of_c = 1.0 - of_a - of_b;
            if (of_a < 0.0 || of_b < 0.0 || of_c < 0.0) continue;
            const double nearness = of_a * a.nearness + of_b * b.nearness + of_c * c.nearness;
            const std::size_t at = index(x, y);
            if (!(nearness > nearness_[at])) continue;
            nearness_[at] = nearness;
            const double from_edge =
                std::min({of_a / lengths[0], of_b / lengths[1], of_c / lengths[2]}) *
                std::abs(area);
            colors_[at] = has_edges && from_edge < edge_width ? edge : inside;
        }
    }
}

void MeshPainter::draw(const MeshObject& object) {
    const TriangleMesh& mesh = object.mesh;
    std::vector<Corner> corners(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        corners[i] = corner_of(mesh.vertices[i].point);
    double area = 0.0;
    for (const auto& [i, j, k] : mesh.triangles)
        area += 0.5 * std::abs(area_of(corners[i], corners[j], corners[k]));
    const bool has_edges = area > least_area * static_cast<double>(mesh.triangles.size());
    const glm::dvec3 light = glm::normalize(view_.from_view({-0.4, 0.7, 0.9}));
    for (const auto& [i, j, k] : mesh.triangles) {
        const glm::dvec3 across = glm::cross(mesh.vertices[j].point - mesh.vertices[i].point,
                                             mesh.vertices[k].point - mesh.vertices[i].point);
        const double length = glm::length(across);
        if (!(length > 0.0)) continue;
        // Open surfaces are seen from both sides.
        const double shade = 0.3 + 0.7 * std::abs(glm::dot(across, light)) / length;
        const MeshColor& own = object.colors.empty() ? object.color : object.colors[i];
        const glm::dvec3 color(own[0] / 255.0, own[1] / 255.0, own[2] / 255.0);
        draw({corners[i], corners[j], corners[k]}, shade * color, has_edges);
    }
}

RgbaImage MeshPainter::image() const {
    RgbaImage image{.width = width_ / samples, .height = height_ / samples, .pixels = {}};
    image.pixels.reserve(colors_.size() / (samples * samples));
    for (int y = 0; y < height_; y += samples) {
        for (int x = 0; x < width_; x += samples) {
            std::array<unsigned, 4> sum{};
            for (int i = 0; i < samples * samples; ++i) {
                const std::uint32_t color = colors_[index(x + i % samples, y + i / samples)];
                if (color == 0) continue;
                for (unsigned channel = 0; channel < 4; ++channel)
                    sum.at(channel) += color >> (8 * channel) & 0xFFU;
            }
            const unsigned hits = sum[3] / 255U;
            std::uint32_t mean = sum[3] / (samples * samples) << 24U;
            for (unsigned channel = 0; hits > 0 && channel < 3; ++channel)
                mean |= sum.at(channel) / hits << (8 * channel);
            image.pixels.push_back(mean);
        }
    }
    return image;
}

/// The smallest box that holds all vertices; of any place where there are none.
Box bounds_of(const MeshFile& file) {
    Box box{.lo = glm::dvec3(std::numeric_limits<double>::max()),
            .hi = glm::dvec3(std::numeric_limits<double>::lowest())};
    for (const MeshObject& object : file.objects) {
        for (const MeshVertex& vertex : object.mesh.vertices) {
            box.lo = glm::min(box.lo, vertex.point);
            box.hi = glm::max(box.hi, vertex.point);
        }
    }
    return box.lo.x <= box.hi.x ? box : Box{.lo = glm::dvec3(-1.0), .hi = glm::dvec3(1.0)};
}

}  // namespace

RgbaImage mesh_picture(const MeshFile& file, const Camera& camera, const glm::ivec2& size_px) {
    const double aspect = static_cast<double>(size_px.x) / size_px.y;
    MeshPainter painter(framed(camera, bounds_of(file), aspect), size_px);
    for (const MeshObject& object : file.objects)
        painter.draw(object);
    return painter.image();
}

}  // namespace zeroset
