// Formulas to 3MF's implicit functions and back: the reader was written after the specification,
// for files of others.

#include "pipeline/level_set_document.hpp"

#include "document/import/import.hpp"
#include "document/row_program.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/surface_functions.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/prepare.hpp"
#include "tests/support/random_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <string>

namespace zeroset::test::level_set_document_test {
namespace {

PictureRequest request_of(const std::string& text, double half,
                          const std::function<void(Document&)>& change = {}) {
    ReadDocument read = read_document_text(text);
    if (!read.rows) ADD_FAILURE() << text << ": " << read.rows.error().reason;
    read.document.clip = Box::cube(half);
    if (change) change(read.document);
    const auto prepared = prepare(read.document, *read.rows, Preparation::Interpreted);
    EXPECT_TRUE(prepared);
    return picture_request(prepared->formula, prepared->colors, read.document, {}, {64, 64});
}

/// The solids of a file's bytes, read again.
ImportedDocument read_again(const EncodedLevelSets& encoded) {
    const std::string bytes(reinterpret_cast<const char*>(encoded.bytes.data()),
                            encoded.bytes.size());
    auto imported = read_import("a.3mf", bytes);
    if (!imported || imported->documents.size() != 1) {
        ADD_FAILURE() << (imported ? "no document" : imported.error());
        return {};
    }
    return std::move(imported->documents[0]);
}

/// The function that is not above 0 in a solid of the file, without the box: NaN where undefined.
double expected_value(const LevelSetFile& file, const LevelSet& surface, const glm::dvec3& at) {
    const std::span values = file.values;
    const std::array<double, 4> point{at.x, at.y, at.z, values.empty() ? 0.0 : values[0]};
    const auto parameters = values.empty() ? values : values.subspan(1);
    double value = surface.side * value_at(surface.function, point, parameters).value;
    for (const Expr& bound : surface.bounds) {
        const double other = value_at(bound, point, parameters).value;
        value = std::isnan(other) ? other : std::max(value, other);
    }
    for (const LevelSetPlane& plane : file.planes)
        value = std::max(value, glm::dot(plane.normal, at) - plane.offset);
    for (const LevelSetBall& ball : file.balls)
        value = std::max(value, glm::distance(at, ball.centre) - ball.radius);
    return value;
}

/// Compares the file's solids with the surfaces at points of the box, away from its walls.
void expect_same(const LevelSetFile& file, const ImportedDocument& again, const std::string& name) {
    EXPECT_EQ(again.refusal, "") << name;
    const auto rows = read_rows(again.document);
    ASSERT_TRUE(rows) << name << ": " << rows.error().reason;
    ASSERT_EQ(rows->program->surfaces.size(), file.surfaces.size()) << name;
    RandomNumbers random(11);
    for (int round = 0; round < 300; ++round) {
        const glm::dvec3 place(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        const glm::dvec3 at = glm::mix(file.lo, file.hi, place);
        const glm::dvec3 mm = file.mm_per_unit * at;
        const glm::dvec3 beyond =
            glm::max(file.mm_per_unit * file.lo - mm, mm - file.mm_per_unit * file.hi);
        const double wall = std::max({beyond.x, beyond.y, beyond.z});
        for (std::size_t i = 0; i < file.surfaces.size(); ++i) {
            const double inside = expected_value(file, file.surfaces[i], at);
            const double value = value_at(rows->program->surfaces[i], {mm.x, mm.y, mm.z, 0}).value;
            if (std::isnan(inside) || !(std::abs(inside) < 1e12)) continue;
            const double expected = std::max(inside, wall);
            ASSERT_NEAR(value, expected, 1e-8 * std::max(1.0, std::abs(expected)))
                << name << " at " << at.x << ", " << at.y << ", " << at.z;
        }
    }
}

void expect_same_again(const PictureRequest& request, const std::string& name) {
    const auto file = level_sets_of(request, 100.0);
    ASSERT_TRUE(file) << name << ": " << file.error().reason;
    const auto encoded = encode_level_sets(*file);
    ASSERT_TRUE(encoded) << name << ": " << encoded.error();
    expect_same(*file, read_again(*encoded), name);
}

TEST(LevelSets, EveryOperatorComesBack) {
    for (const std::string text :
         {"x^5 - 3x^2 + y^-3 + 7", "x^(1/3) + y^(1/5) - z^(2/3)", "sqrt(abs(x)) + cot(y) - sign(z)",
          "floor(3x) + ceil(3y) + round(3z) + 1/2", "mod(x, 0.3) + mod(-y, 0.7) - z",
          "min(x, y, z) - max(x, y^2) + 0.1", "exp(x) + ln(y + 3) - log10(z + 3) + log2(x + 9)",
          "sin(3x) + cos(5y) - tan(z)", "asin(x/3) - acos(y/3) + atan(z)", "atan2(y, x) - z",
          "sinh(x) - cosh(y) + tanh(z) + asinh(x - y) - acosh(z + 4) + atanh(y/3)",
          "if(x < y, x^2 + y - 1, if(z <= x and not y < 0.2 or x == z, z, y - x))",
          "sin(3 atan2(y, x)) - z", "if(x, y, z) - 0.2", "2.5e-7 x + 1.25e9 y - pi z"}) {
        expect_same_again(request_of(text, 2.0), text);
    }
}

TEST(LevelSets, WhatEndsASurfaceEndsItThere) {
    const auto change = [](Document& document) {
        document.region.sections.push_back(make_section({1.0, 2.0, -1.0}, 0.25));
        document.region.ball = Ball{.centre = {0.1, 0.0, 0.0}, .radius = 1.2};
    };
    expect_same_again(request_of("x^2 + y^2 + z^2 = 1, x < y, z > -0.5 or y < 0", 1.5, change),
                      "bounds");
    // A solid of conditions, two surfaces, parameters with values and w.
    expect_same_again(request_of("x^2 + y^2 < 1 and z < x\nx + a y + w z = b", 1.5), "solid");
}

TEST(LevelSets, TheGalleryComesBack) {
    std::size_t written = 0;
    for (const GalleryItem& item : gallery()) {
        const std::string name(item.name);
        const ReadDocument read = read_document(item);
        const auto prepared = prepare(read.document, *read.rows, Preparation::Interpreted);
        ASSERT_TRUE(prepared) << name;
        const PictureRequest request =
            picture_request(prepared->formula, prepared->colors, read.document, {}, {64, 64});
        const auto file = level_sets_of(request, 100.0);
        if (!file) continue;  // curves, points, parametric surfaces
        const auto encoded = encode_level_sets(*file);
        if (!encoded) {
            EXPECT_FALSE(encoded.error().contains('\n'));
            continue;
        }
        ++written;
        expect_same(*file, read_again(*encoded), name);
    }
    EXPECT_GT(written, 80U);
}

TEST(LevelSets, SurfacesKeepTheirColors) {
    const auto change = [](Document& document) { document.statements[0].color = 0x12AB05; };
    const auto file = level_sets_of(request_of("x = y", 1.0, change), 50.0);
    ASSERT_TRUE(file);
    const auto encoded = encode_level_sets(*file);
    ASSERT_TRUE(encoded);
    const ImportedDocument again = read_again(*encoded);
    EXPECT_EQ(again.document.statements.back().color, 0x12AB05U);
    EXPECT_NEAR(again.document.clip.hi.x, 25.0 * 1.02, 1e-9);
}

TEST(LevelSets, WhatTheyCannotSayIsRefusedInOneLine) {
    const auto refusal = [](const std::string& text) {
        const auto file = level_sets_of(request_of(text, 2.0), 100.0);
        if (!file) return file.error().reason;
        const auto encoded = encode_level_sets(*file);
        return encoded ? std::string("written") : encoded.error();
    };
    EXPECT_TRUE(refusal("noise(x, y, z) = 0").contains("noise"));
    EXPECT_TRUE(refusal("(u cos v, u sin v, v), 0 < u < 1, 0 < v < 6").contains("parametric"));
    EXPECT_TRUE(refusal("x + sin(where(y, y > 0)) = 0").contains("undefined"));
    EXPECT_EQ(refusal("x = y"), "written");
    const auto hidden = encoded_level_sets_of(
        request_of("x = y", 2, [](Document& document) { document.statements[0].visible = false; }),
        100);
    ASSERT_FALSE(hidden);
    EXPECT_TRUE(hidden.error().reason.contains("no surface that is shown"));
    const auto both = encoded_level_sets_of(request_of("x = y\nx^2 + y^2 = z", 2), 100);
    ASSERT_TRUE(both);
    EXPECT_EQ(both->surfaces, 2U);
}

}  // namespace
}  // namespace zeroset::test::level_set_document_test
