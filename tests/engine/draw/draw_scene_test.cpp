#include "engine/draw/draw_scene.hpp"

#include "tests/engine/draw/drawings.hpp"

#include <cmath>
#include <numbers>

// Drawings against closed forms: circles, lines, hidden arcs.

namespace zeroset::test::draw_scene_test {
namespace {

constexpr double pi = std::numbers::pi;

Camera camera_from(const glm::dvec3& eye, const glm::dvec3& look_at, double fov_deg = 40.0) {
    return {.eye = eye, .look_at = look_at, .up = {0, 0, 1}, .fov_rad = glm::radians(fov_deg)};
}

/// How far a ray passes from a point.
double distance_from(const PageRay& ray, const glm::dvec3& point) {
    const glm::dvec3 to = point - ray.origin;
    return glm::length(to - glm::dot(to, ray.direction) * ray.direction);
}

TEST(DrawScene, SilhouetteOfASphereIsWhereRaysTouchIt) {
    const TextScene of({"x^2 + y^2 + z^2 = 1"}, Box::cube(2));
    for (const Camera& camera :
         {camera_from({3, -4, 2}, {0.4, 0.3, -0.2}), default_camera(Box::cube(2)),
          camera_from({0, 0.01, 6}, {0, 0, 0}, 25.0)}) {
        const LineDrawing drawing = of.draw(camera, only(CurveKind::Silhouette));
        ASSERT_EQ(drawing.paths.size(), 1U);
        EXPECT_TRUE(drawing.paths[0].closed);
        EXPECT_FALSE(drawing.paths[0].hidden);
        EXPECT_EQ(drawing.report.open, 0U);
        const Page page(camera, drawing.size);
        visit_points(drawing.paths[0], [&](const glm::dvec2& at) {
            const PageRay ray = page_ray(page, at);
            const double off = std::abs(distance_from(ray, {0, 0, 0}) - 1.0);
            EXPECT_LT(off * page.scale(ray.origin + glm::length(camera.eye) * ray.direction), 0.06);
        });
    }
}

TEST(DrawScene, ToleranceIsKept) {
    const TextScene of({"x^2 + y^2 + z^2 = 1"}, Box::cube(2));
    Camera camera = camera_from({5, 0, 0}, {0, 0, 0});
    camera.projection = Projection::Orthographic;
    std::size_t last = 0;
    for (const double tolerance : {1.0, 0.1, 0.01, 0.001}) {
        DrawOptions options = only(CurveKind::Silhouette);
        options.tolerance_pt = tolerance;
        const LineDrawing drawing = of.draw(camera, options);
        ASSERT_EQ(drawing.paths.size(), 1U);
        const double radius = 200.0 / (5.0 * std::tan(glm::radians(20.0)));
        visit_points(drawing.paths[0], [&](const glm::dvec2& at) {
            EXPECT_NEAR(glm::distance(at, {200, 200}), radius, 1.02 * tolerance);
        });
        EXPECT_GE(drawing.paths[0].pieces.size(), last);
        last = drawing.paths[0].pieces.size();
    }
}

TEST(DrawScene, SilhouettesOfATorusFromAboveAreTwoCircles) {
    const TextScene of({"(x^2+y^2+z^2+0.75)^2 = 4*(x^2+y^2)"}, Box::cube(2));
    Camera camera = camera_from({0, 0, 5}, {0, 0, 0});
    camera.up = {0, 1, 0};
    camera.projection = Projection::Orthographic;
    const LineDrawing drawing = of.draw(camera, only(CurveKind::Silhouette));
    ASSERT_EQ(drawing.paths.size(), 2U);
    EXPECT_EQ(count_closed(drawing), 2U);
    const double unit = 200.0 / (5.0 * std::tan(glm::radians(20.0)));
    double lengths = 0.0;
    for (const DrawnPath& path : drawing.paths) {
        lengths += length_of(path);
        visit_points(path, [&](const glm::dvec2& at) {
            const double radius = glm::distance(at, {200, 200}) / unit;
            EXPECT_LT(std::min(std::abs(radius - 1.5), std::abs(radius - 0.5)) * unit, 0.06);
        });
    }
    EXPECT_NEAR(lengths, 2.0 * pi * 2.0 * unit, 0.5);
}

TEST(DrawScene, SilhouettesOfACylinderAreTwoLines) {
    const TextScene of({"x^2 + y^2 = 1"}, Box::cube(1.5));
    const Camera camera = camera_from({4, 0, 1}, {0, 0, 0}, 60.0);
    const LineDrawing drawing = of.draw(camera, only(CurveKind::Silhouette));
    ASSERT_EQ(drawing.paths.size(), 2U);
    const Page page(camera, drawing.size);
    for (const DrawnPath& path : drawing.paths) {
        EXPECT_EQ(path.pieces.size(), 1U);
        // Tangents from (4, 0) touch the circle at (1/4, +- sqrt(15)/4), from z = -1.5 to 1.5.
        const glm::dvec2 middle = 0.5 * (path.pieces[0][0] + path.pieces[0][3]);
        const double side = middle.x > 200.0 ? 1.0 : -1.0;
        const glm::dvec2 top = page.place({0.25, side * std::sqrt(15.0) / 4.0, 1.5});
        const glm::dvec2 foot = page.place({0.25, side * std::sqrt(15.0) / 4.0, -1.5});
        const bool falls = path.pieces[0][0].y < path.pieces[0][3].y;
        EXPECT_LT(glm::distance(path.pieces[0][0], falls ? top : foot), 0.01);
        EXPECT_LT(glm::distance(path.pieces[0][3], falls ? foot : top), 0.01);
    }
}

TEST(DrawScene, SpheresMeetInACircle) {
    const TextScene of({"x^2 + y^2 + z^2 = 1", "(x-1)^2 + y^2 + z^2 = 1"}, Box::cube(2.5));
    const Camera camera = camera_from({6, 3, 2}, {0.5, 0, 0});
    const LineDrawing drawing = of.draw(camera, only(CurveKind::Intersection));
    const Page page(camera, drawing.size);
    double length = 0.0;
    for (const DrawnPath& path : drawing.paths) {
        length += length_of(path);
        visit_points(path, [&](const glm::dvec2& at) {
            // The circle x = 1/2, y^2 + z^2 = 3/4.
            const PageRay ray = page_ray(page, at);
            const glm::dvec3 point =
                ray.origin + (0.5 - ray.origin.x) / ray.direction.x * ray.direction;
            EXPECT_NEAR(std::hypot(point.y, point.z), std::sqrt(0.75), 2e-3);
        });
    }
    EXPECT_GT(length, 100.0);
    EXPECT_EQ(drawing.report.open, 0U);
}

TEST(DrawScene, ASphereHidesTheArcBehindIt) {
    const TextScene of({"(x-3)^2 + y^2 + z^2 = 0.25", "x^2 + (y-0.6)^2 + z^2 = 1"}, Box::cube(4));
    const Camera camera = camera_from({9, 0, 0}, {0, 0, 0});
    const LineDrawing drawing = of.draw(camera, only(CurveKind::Silhouette));
    const Page page(camera, drawing.size);
    double hidden_length = 0.0;
    double length = 0.0;
    for (const DrawnPath& path : drawing.paths) {
        if (path.surface == 0) {
            EXPECT_FALSE(path.hidden);
            continue;
        }
        length += length_of(path);
        hidden_length += path.hidden ? length_of(path) : 0.0;
        visit_points(path, [&](const glm::dvec2& at) {
            const double gap = distance_from(page_ray(page, at), {3, 0, 0}) - 0.5;
            if (std::abs(gap) > 1e-3) {
                EXPECT_EQ(path.hidden, gap < 0.0) << at.x << " " << at.y;
            }
        });
    }
    EXPECT_GT(hidden_length, 0.05 * length);
    EXPECT_LT(hidden_length, 0.5 * length);
}

TEST(DrawScene, ContoursOfASphereAreCirclesOfLatitude) {
    const TextScene of({"x^2 + y^2 + z^2 = 1"}, Box::cube(2));
    Camera camera = camera_from({0, 0, 5}, {0, 0, 0});
    camera.up = {0, 1, 0};
    camera.projection = Projection::Orthographic;
    DrawOptions options = only(CurveKind::Contour);
    options.contours = {{.axis = 2}};
    options.contour_step = 0.25;
    const LineDrawing drawing = of.draw(camera, options);
    // -0.75 to 0.75; the poles at -1 and 1 are points, no curves.
    ASSERT_EQ(drawing.paths.size(), 7U);
    const double unit = 200.0 / (5.0 * std::tan(glm::radians(20.0)));
    for (const DrawnPath& path : drawing.paths) {
        EXPECT_TRUE(path.closed);
        const double level = path.level.value();
        // The lower half of the sphere is hidden from above; the equator is its silhouette.
        if (level != 0.0) {
            EXPECT_EQ(path.hidden, level < 0.0) << level;
        }
        visit_points(path, [&](const glm::dvec2& at) {
            EXPECT_NEAR(glm::distance(at, {200, 200}), unit * std::sqrt(1 - level * level), 0.06);
        });
    }
}

TEST(DrawScene, ContoursOfAFormulaAreTheSameCircles) {
    const TextScene of({"x^2 + y^2 + z^2 = 1"}, Box::cube(2));
    const Camera camera = camera_from({3, -4, 2}, {0, 0, 0});
    DrawOptions options = only(CurveKind::Contour);
    options.contour_step = 0.25;
    options.contours = {{.axis = 2}};
    const LineDrawing flat = of.draw(camera, options);
    options.contours = {{.axis = std::nullopt, .formula = parse("z").value()}};
    const LineDrawing by_formula = of.draw(camera, options);
    double flat_length = 0.0;
    double length = 0.0;
    for (const DrawnPath& path : flat.paths)
        flat_length += length_of(path);
    for (const DrawnPath& path : by_formula.paths)
        length += length_of(path);
    EXPECT_GT(length, 1000.0);
    EXPECT_NEAR(length, flat_length, 1e-3 * length);
}

TEST(DrawScene, ACubeHasTwelveEdges) {
    const TextScene of({"max(max(abs(x), abs(y)), abs(z)) = 1"}, Box::cube(2));
    const Camera camera = camera_from({4, -5, 3}, {0, 0, 0});
    const LineDrawing drawing = of.draw(camera, {});
    const Page page(camera, drawing.size);
    int visible = 0;
    int hidden = 0;
    for (const DrawnPath& path : drawing.paths) {
        EXPECT_EQ(path.kind, CurveKind::Crease);
        ++(path.hidden ? hidden : visible);
        const glm::dvec2 a = path.pieces.front()[0];
        const glm::dvec2 b = path.pieces.back()[3];
        visit_points(path, [&](const glm::dvec2& at) {
            const glm::dvec2 off = at - a;
            const glm::dvec2 along = glm::normalize(b - a);
            EXPECT_LT(std::abs(off.x * along.y - off.y * along.x), 0.06);
        });
        for (const glm::dvec2& end : {a, b}) {
            double nearest = 1e9;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 at(corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1);
                nearest = std::min(nearest, glm::distance(end, page.place(at)));
            }
            EXPECT_LT(nearest, 0.2);
        }
    }
    EXPECT_EQ(visible, 9);
    EXPECT_EQ(hidden, 3);
}

TEST(DrawScene, LinesWithoutASurfaceAreLeftOut) {
    // Steiner's Roman surface: its equation holds on all of the axes, but sheets meet on them only
    // up to 1/2 from the origin.
    const TextScene of({"x^2 y^2 + y^2 z^2 + z^2 x^2 = x y z"}, Box::cube(1));
    const Camera camera = camera_from({2.5, -3, 2}, {0, 0, 0});
    const LineDrawing drawing = of.draw(camera, only(CurveKind::Crease));
    const Page page(camera, drawing.size);
    double length = 0.0;
    for (const DrawnPath& path : drawing.paths)
        length += length_of(path);
    double wanted = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 end(0.0);
        end[axis] = 0.5;
        wanted += glm::distance(page.place(end), page.place(-end));
    }
    EXPECT_NEAR(length, wanted, 1.0);
}

TEST(DrawScene, APlaneEndsAtTheBox) {
    const TextScene of({"z = 0.25 x"}, Box::cube(1));
    const Camera camera = camera_from({3, -5, 4}, {0, 0, 0});
    const LineDrawing drawing = of.draw(camera, {});
    ASSERT_EQ(drawing.paths.size(), 4U);
    double length = 0.0;
    for (const DrawnPath& path : drawing.paths) {
        EXPECT_EQ(path.kind, CurveKind::Boundary);
        EXPECT_FALSE(path.hidden);
        length += length_of(path);
    }
    const Page page(camera, drawing.size);
    const std::array<glm::dvec2, 4> corners{page.place({1, 1, 0.25}), page.place({1, -1, 0.25}),
                                            page.place({-1, -1, -0.25}),
                                            page.place({-1, 1, -0.25})};
    double around = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
        around += glm::distance(corners.at(i), corners.at((i + 1) % 4));
    EXPECT_NEAR(length, around, 0.1);
}

TEST(DrawScene, RestrictionsEndASurface) {
    const TextScene of({"x^2 + y^2 = 1, -0.5 < z < 0.75"}, Box::cube(2));
    const Camera camera = camera_from({5, 0, 2}, {0, 0, 0});
    const LineDrawing drawing = of.draw(camera, only(CurveKind::Boundary));
    const Page page(camera, drawing.size);
    double upper = 0.0;
    double lower = 0.0;
    for (const DrawnPath& path : drawing.paths) {
        visit_points(path, [&](const glm::dvec2& at) {
            const PageRay ray = page_ray(page, at);
            const auto radius_at = [&](double z) {
                const glm::dvec3 p =
                    ray.origin + (z - ray.origin.z) / ray.direction.z * ray.direction;
                return std::hypot(p.x, p.y);
            };
            const double off_upper = std::abs(radius_at(0.75) - 1.0);
            const double off_lower = std::abs(radius_at(-0.5) - 1.0);
            EXPECT_LT(std::min(off_upper, off_lower), 2e-3);
        });
        const double at = path.pieces.front()[0].y;
        (at < 200.0 ? upper : lower) += length_of(path);
    }
    EXPECT_GT(upper, 100.0);
    EXPECT_GT(lower, 100.0);
}

TEST(DrawScene, SectionsAndBallsBoundWhatIsDrawn) {
    TextScene of({"x^2 + y^2 + z^2 = 1"}, Box::cube(2));
    of.scene.region.sections = {make_section({0, 0, 1}, 0.5)};
    const Camera camera = camera_from({5, 0, 4}, {0, 0, 0});
    const LineDrawing drawing = of.draw(camera, {});
    const Page page(camera, drawing.size);
    double rim = 0.0;
    for (const DrawnPath& path : drawing.paths) {
        // The cap hides all that is seen through the rim, and nothing else is hidden.
        EXPECT_FALSE(path.hidden && path.kind == CurveKind::Boundary);
        if (path.kind != CurveKind::Boundary) continue;
        rim += length_of(path);
        visit_points(path, [&](const glm::dvec2& at) {
            const PageRay ray = page_ray(page, at);
            const glm::dvec3 p =
                ray.origin + (0.5 - ray.origin.z) / ray.direction.z * ray.direction;
            EXPECT_NEAR(std::hypot(p.x, p.y), std::sqrt(0.75), 2e-3);
        });
    }
    EXPECT_GT(rim, 100.0);
}

TEST(DrawScene, DoubleCurvesAreCreases) {
    // Two planes in one equation meet in the z axis.
    const TextScene of({"(x - y)*(x + y) = 0"}, Box::cube(1));
    const Camera camera = camera_from({5, 1, 3}, {0, 0, 0});
    const LineDrawing drawing = of.draw(camera, only(CurveKind::Crease));
    const Page page(camera, drawing.size);
    double length = 0.0;
    for (const DrawnPath& path : drawing.paths) {
        length += length_of(path);
        visit_points(path, [&](const glm::dvec2& at) {
            const glm::dvec2 top = page.place({0, 0, 1});
            const glm::dvec2 along = glm::normalize(page.place({0, 0, -1}) - top);
            EXPECT_LT(std::abs((at - top).x * along.y - (at - top).y * along.x), 0.06);
        });
    }
    EXPECT_NEAR(length, glm::distance(page.place({0, 0, 1}), page.place({0, 0, -1})), 0.2);
}

TEST(DrawScene, IsolatedSingularPointsAreNoCreases) {
    const TextScene of({"x^2 + y^2 = z^2"}, Box::cube(1));
    const LineDrawing drawing = of.draw(camera_from({5, 1, 3}, {0, 0, 0}), only(CurveKind::Crease));
    EXPECT_TRUE(drawing.paths.empty());
}

TEST(DrawScene, ABudgetEndsTheSearch) {
    const TextScene of({"sin(20 x y z) sin(30 x) sin(40 y) = 0.01"}, Box::cube(2));
    const LineDrawing drawing =
        draw_scene(of.input(default_camera(Box::cube(2))), {}, {.until = TimeLimit::Clock::now()});
    EXPECT_FALSE(drawing.in_time());
}

}  // namespace
}  // namespace zeroset::test::draw_scene_test
