#pragma once

#include "engine/draw/draw_scene.hpp"
#include "engine/draw/page_curve.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"
#include "engine/rewrite/traceable.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

// Drawings of texts, and their curves point by point.

namespace zeroset::test {

/// A scene of texts, a surface each.
struct TextScene {
    Scene scene;
    std::vector<Expr> surfaces;

    TextScene(const std::vector<std::string>& texts, const Box& clip) {
        scene.clip = clip;
        scene.uniforms.set(0, 0.0);
        for (const std::string& text : texts) {
            surfaces.push_back(traceable(parse(text).value()));
            scene.surfaces.push_back({.kernel = interpret(surfaces.back())});
        }
    }
    [[nodiscard]] DrawnScene input(const Camera& camera, const PageSize& page = {}) const {
        return {.scene = scene,
                .surfaces = surfaces,
                .camera = camera,
                .page = page,
                .make_kernel = [](const Expr& f) { return interpret(f); }};
    }
    [[nodiscard]] LineDrawing draw(const Camera& camera, const DrawOptions& options,
                                   const PageSize& page = {}) const {
        return draw_scene(input(camera, page), options);
    }
};

inline DrawOptions only(CurveKind kind) {
    DrawOptions options{.kinds = {}};
    options.kinds.at(static_cast<std::size_t>(kind)) = true;
    return options;
}

/// Calls `visit` with many points of a path.
inline void visit_points(const DrawnPath& path,
                         const std::function<void(const glm::dvec2&)>& visit) {
    constexpr int parts = 24;
    for (const Bezier& piece : path.pieces) {
        for (int i = 0; i <= parts; ++i)
            visit(point_of(piece, static_cast<double>(i) / parts));
    }
}

/// The ray of a place on the page.
struct PageRay {
    glm::dvec3 origin, direction;
};
inline PageRay page_ray(const Page& page, const glm::dvec2& place) {
    const ImageSize image{.width = static_cast<int>(page.size().width),
                          .height = static_cast<int>(page.size().height)};
    const PixelPoint at{.col = place.x, .row = place.y};
    return {.origin = page.view().origin(at, image),
            .direction = glm::normalize(page.view().direction(at, image))};
}

inline std::size_t count_closed(const LineDrawing& drawing) {
    std::size_t closed = 0;
    for (const DrawnPath& path : drawing.paths)
        closed += path.closed ? 1U : 0U;
    return closed;
}

inline double length_of(const DrawnPath& path) {
    double length = 0.0;
    glm::dvec2 last = path.pieces.front()[0];
    visit_points(path, [&](const glm::dvec2& at) {
        length += glm::distance(last, at);
        last = at;
    });
    return length;
}

}  // namespace zeroset::test
