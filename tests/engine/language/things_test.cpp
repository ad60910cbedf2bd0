#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/language/parse.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

// Rows that are made of points, points with names, and boxes of rows.

namespace zeroset::test::things_test {
namespace {

using Point = std::array<double, 3>;

Program program_of(const std::string& text, std::span<const CutText> cuts = {}) {
    auto program = read_program(text, nullptr, cuts);
    if (!program) {
        ADD_FAILURE() << text << ": " << program.error().reason;
        return {};
    }
    return std::move(*program);
}

std::string error_of(const std::string& text) {
    const auto program = read_program(text);
    return program ? "" : program.error().reason + ": " + program.error().hint;
}

void expect_says(const std::string& text, const std::string& words) {
    EXPECT_NE(error_of(text).find(words), std::string::npos) << text << ": " << error_of(text);
}

/// The point of a straight row at x.
Point at(const Program& program, double x, std::span<const double> parameters = {}) {
    const auto patch = patch_of(program.surfaces.at(0));
    Point point{};
    for (std::size_t k = 0; k < 3; ++k)
        point.at(k) = value_at(patch.value().point.at(k), {x, 0.7, 0.0, 0.0}, parameters).value;
    return point;
}

/// f at a point; nothing where the row is not drawn.
std::optional<double> value(const Program& program, const Point& p,
                            std::span<const double> parameters = {}) {
    const double f = value_at(program.surfaces.at(0), {p[0], p[1], p[2], 0.0}, parameters).value;
    return std::isnan(f) ? std::nullopt : std::optional(f);
}

bool is_in(const Program& program, const Point& p, std::span<const double> parameters = {}) {
    return value(program, p, parameters).has_value();
}

TEST(Things, SegmentsAndVectorsRunFromEndToEnd) {
    const Program segment = program_of("P = (1, 0, a); segment(P, (3, 4, 0))");
    ASSERT_EQ(segment.surfaces.size(), 2U);
    EXPECT_EQ(patch_of(segment.surfaces[0])->kind, PatchKind::Point);
    const Program alone = program_of("segment((1, 0, a), (3, 4, 0))");
    EXPECT_EQ(patch_of(alone.surfaces[0])->kind, PatchKind::Segment);
    const std::array<double, 1> a{-2.0};
    EXPECT_EQ(at(alone, 0.0, a), (Point{1.0, 0.0, -2.0}));
    EXPECT_EQ(at(alone, 0.5, a), (Point{2.0, 2.0, -1.0}));
    EXPECT_EQ(at(alone, 1.0, a), (Point{3.0, 4.0, 0.0}));
    const Program vector = program_of("v = (0, 0, 2); vector((1, 1, 1), v - (1, 0, 0))");
    EXPECT_EQ(patch_of(vector.surfaces[0])->kind, PatchKind::Arrow);
    EXPECT_EQ(at(vector, 1.0), (Point{0.0, 1.0, 3.0}));
}

TEST(Things, ReadingsCanBeTypedAgain) {
    for (const char* const text : {"segment((1, 0, a), (3, 4, 0))", "vector((0, 0, 0), (a, 1, 1))",
                                   "polygon((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))"}) {
        const Program once = program_of(text);
        EXPECT_EQ(once.readings.at(0).text, text);
        EXPECT_EQ(once.surfaces.at(0).key(),
                  program_of(once.readings[0].text).surfaces.at(0).key());
    }
}

TEST(Things, TrianglesArePartsOfTheirPlane) {
    const Program triangle = program_of("polygon((0, 0, 1), (2, 0, 1), (0, 2, 1))");
    ASSERT_EQ(triangle.surfaces.size(), 1U);
    EXPECT_TRUE(triangle.sheets.at(0));
    EXPECT_EQ(value(triangle, {0.5, 0.5, 1.0}), 0.0);
    EXPECT_NE(value(triangle, {0.5, 0.5, 1.5}), 0.0);
    EXPECT_TRUE(is_in(triangle, {0.9, 0.9, 1.0}));
    EXPECT_FALSE(is_in(triangle, {1.1, 1.1, 1.0}));
    EXPECT_FALSE(is_in(triangle, {-0.1, 0.5, 1.0}));
    EXPECT_FALSE(is_in(triangle, {0.5, -0.1, 1.0}));
}

/// Whether a point of the plane is within a polygon, by the sum of the angles that its edges are
/// seen at: a multiple of the full turn, which is even outside of the polygons here.
bool winds_oddly(const std::vector<std::array<double, 2>>& corners, double x, double y) {
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& a = corners[i];
        const auto& b = corners[(i + 1) % corners.size()];
        const double ax = a[0] - x;
        const double ay = a[1] - y;
        const double bx = b[0] - x;
        const double by = b[1] - y;
        sum += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return std::lround(sum / (2.0 * std::acos(-1.0))) % 2 != 0;
}

/// A polygon in the plane z = x + 2 y, with corners above these.
std::string lifted(const std::vector<std::array<double, 2>>& corners) {
    std::string text = "polygon(";
    for (std::size_t i = 0; i < corners.size(); ++i) {
        text += (i > 0 ? ", (" : "(") + std::to_string(corners[i][0]) + ", " +
                std::to_string(corners[i][1]) + ", " +
                std::to_string(corners[i][0] + 2.0 * corners[i][1]) + ")";
    }
    return text + ")";
}

void expect_inside(const std::vector<std::array<double, 2>>& corners) {
    const Program program = program_of(lifted(corners));
    ASSERT_EQ(program.surfaces.size(), 1U);
    int inside = 0;
    for (double x = -2.93; x < 3.0; x += 0.13) {
        for (double y = -2.91; y < 3.0; y += 0.17) {
            const bool expected = winds_oddly(corners, x, y);
            EXPECT_EQ(is_in(program, {x, y, x + 2.0 * y}), expected) << x << " " << y;
            inside += expected ? 1 : 0;
        }
    }
    EXPECT_GT(inside, 100);
}

TEST(Things, PolygonsOfAnyFormAreWhatTheirEdgesEnclose) {
    expect_inside({{-1, -1}, {2, -1}, {2, 1.5}, {-1, 2}});                // convex
    expect_inside({{-1, 2}, {2, 1.5}, {2, -1}, {-1, -1}});                // the other way
    expect_inside({{-2, -2}, {2, -2}, {2, 0}, {0, 0}, {0, 2}, {-2, 2}});  // an L
    expect_inside({{-2, -2}, {2, -2}, {2, 2}, {0, -1}, {-2, 2}});         // a notch
    // A five-pointed star, whose middle is wound about twice.
    std::vector<std::array<double, 2>> star;
    for (int i = 0; i < 5; ++i) {
        const double angle = 0.3 + 2.0 * i * 2.0 * std::acos(-1.0) / 5.0;
        star.push_back({2.5 * std::cos(angle), 2.5 * std::sin(angle)});
    }
    expect_inside(star);
}

TEST(Things, PolygonsFollowSliders) {
    const Program program =
        program_of("polygon((0, 0, a), (1, 0, a), (1, 1, a), (0.5, 0.4, a), (0, 1, a))");
    for (const double a : {-1.0, 0.25}) {
        const std::array<double, 1> parameters{a};
        EXPECT_NEAR(value(program, {0.2, 0.3, a}, parameters).value_or(1.0), 0.0, 1e-12);
        EXPECT_TRUE(is_in(program, {0.1, 0.7, a}, parameters));
        EXPECT_FALSE(is_in(program, {0.5, 0.7, a}, parameters));
    }
    EXPECT_FALSE(program.readings.at(0).notes.empty()) << "corners might leave the plane";
}

TEST(Things, PlanesAreDistances) {
    const Program program = program_of("plane((1, 2, 3), (0, 3, 4)) = 0.5");
    EXPECT_NEAR(value(program, {7.0, 2.0, 3.0}).value(), -0.5, 1e-12);
    EXPECT_NEAR(value(program, {0.0, 5.0, 7.0}).value(), 4.5, 1e-12);
    EXPECT_NEAR(value(program_of("plane((0, 0, 1), (0, 0, 2))"), {3.0, 3.0, 2.0}).value(), 1.0,
                1e-12);
}

TEST(Things, SaysWhatIsWrong) {
    expect_says("segment((1, 2), (3, 4, 5))", "vector of 2 numbers");
    expect_says("segment((1, 2, 3), 4)", "a number");
    expect_says("segment((1, 2, 3))", "2 arguments, not 1");
    expect_says("segment((x, 0, 0), (1, 1, 1))", "not of x, y and z");
    expect_says("segment((1, 2, 3), (1, 2, 3))", "the same point");
    expect_says("vector((1, 2, 3), (0, 0, 0))", "no length");
    expect_says("vector((1, 2, 3), (1, 0, 0)), z < 1", "nothing stands behind vector(P, v)");
    expect_says("segment((1, 2, 3), (1, 0, 0)) = 1", "is no value");
    expect_says("2 segment((1, 2, 3), (1, 0, 0))", "is no value");
    expect_says("polygon((0, 0, 0), (1, 0, 0))", "3 or more arguments, not 2");
    expect_says("polygon((0, 0, 0), (1, 1, 1), (2, 2, 2))", "on a line");
    expect_says("polygon((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.1))", "corner 4 is not in");
    expect_says("segment(P, (1, 2, 3))", "is a number");
}

TEST(Things, GiveWayToWhatATextDefines) {
    EXPECT_TRUE(read_program("segment(u, v) = u + v; segment(x, y) = 1"));
    EXPECT_TRUE(read_program("vector = 3; z = vector x"));
}

TEST(Things, PointsHaveTheirNames) {
    const Program program = program_of("P = (1, 2, a); (0, 0, 0); Qa = (1, 1, 1); z = x");
    EXPECT_EQ(program.names, (std::vector<std::string>{"P", "", "Qa", ""}));
}

TEST(RowBoxes, CutEquationsAsRestrictionsDo) {
    const std::string first = "x^2 + y^2 + z^2 = 4";
    const std::vector<CutText> cuts{
        {.begin = 0, .end = first.size() + 1, .box = {-1, 1, -3, 3, 0, 3}}};
    const Program program = program_of(first + "; z = x", cuts);
    EXPECT_TRUE(is_in(program, {0.5, 0.0, 1.0}));
    EXPECT_FALSE(is_in(program, {1.5, 0.0, 1.0}));
    EXPECT_FALSE(is_in(program, {0.5, 0.0, -0.1}));
    EXPECT_FALSE(std::isnan(value_at(program.surfaces.at(1), {5.0, 0.0, -1.0, 0.0}).value));
    EXPECT_EQ(program.readings.at(0).text, program_of(first).readings.at(0).text);
    const Program restricted =
        program_of("x^2 + y^2 = 1, z > 1",
                   std::vector<CutText>{{.begin = 0, .end = 100, .box = {-2, 2, -2, 2, -2, 1.5}}});
    EXPECT_TRUE(is_in(restricted, {1.0, 0.0, 1.2}));
    EXPECT_FALSE(is_in(restricted, {1.0, 0.0, 0.8}));
    EXPECT_FALSE(is_in(restricted, {1.0, 0.0, 1.7}));
}

TEST(RowBoxes, TravelWithPoints) {
    const RowBox box{-1, 1, -1, 1, 0, 0.5};
    const std::vector<CutText> cuts{{.begin = 0, .end = 100, .box = box}};
    const std::string text = "(u, v, u v), 0 < u < 1, 0 < v < 1";
    const auto cut = patch_of(program_of(text, cuts).surfaces.at(0));
    EXPECT_EQ(cut.value().box, box);
    const auto key = [](const Program& program) { return program.surfaces.at(0).key(); };
    EXPECT_EQ(key(program_of(text, cuts)), key(program_of(text, cuts)));
    EXPECT_NE(key(program_of(text, cuts)), key(program_of(text)));
    const auto meeting = patch_of(program_of("z = x and z = y", cuts).surfaces.at(0));
    EXPECT_EQ(meeting.value().kind, PatchKind::Meeting);
    EXPECT_EQ(value_at(meeting->point[2], {0, 0, 0.25, 0}).value, 1.0);
    EXPECT_EQ(value_at(meeting->point[2], {0, 0, 0.75, 0}).value, 0.0);
}

}  // namespace
}  // namespace zeroset::test::things_test
