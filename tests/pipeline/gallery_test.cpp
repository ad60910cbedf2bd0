#include "pipeline/gallery.hpp"

#include "engine/interpret/interpret.hpp"
#include "tests/support/formulas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

// Tests of the gallery's files, which are compiled into the program.

namespace zeroset::test::gallery_test {
namespace {

TEST(Gallery, HasTheSuiteAndADozenMore) {
    const auto in_suite = [](const GalleryItem& item) { return item.group == suite_group; };
    EXPECT_EQ(std::ranges::count_if(gallery(), in_suite), 29);
    EXPECT_GE(gallery().size(), 29U + 12U);
}

TEST(Gallery, NamesAreUniqueAndEasyToType) {
    std::set<std::string> names;
    for (const GalleryItem& item : gallery()) {
        EXPECT_TRUE(names.insert(item.name).second) << item.name;
        EXPECT_FALSE(item.name.empty());
        EXPECT_EQ(item.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
                  std::string::npos)
            << item.name;
    }
}

TEST(Gallery, EveryItemIsExplained) {
    for (const GalleryItem& item : gallery()) {
        EXPECT_FALSE(item.title.empty()) << item.name;
        EXPECT_FALSE(item.group.empty()) << item.name;
        EXPECT_GT(item.about.size(), 20U) << item.name;
        EXPECT_TRUE(item.about.ends_with('.') || item.about.ends_with('!')) << item.about;
        EXPECT_GT(item.source.size(), 3U) << item.name;
    }
}

TEST(Gallery, EveryEquationIsRead) {
    for (const GalleryItem& item : gallery()) {
        const auto program = read_formula(item.equation);
        ASSERT_TRUE(program) << item.name << ": " << program.error().reason;
        ASSERT_EQ(program->surfaces.size(), 1) << item.name;
        EXPECT_TRUE(program->parameters.empty()) << item.name;
        const Expr& expr = program->surfaces.front();
        EXPECT_TRUE(interpret(expr).uses_w || item.w == 0.0) << item.name;
    }
}

/// True if a corner of the box is in front of the eye and inside a square image.
bool sees_a_corner(const Camera& camera, const Box& box) {
    const ViewFrame view(camera);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point((corner & 1) != 0 ? box.hi.x : box.lo.x,
                               (corner & 2) != 0 ? box.hi.y : box.lo.y,
                               (corner & 4) != 0 ? box.hi.z : box.lo.z);
        const glm::dvec3 to = point - view.eye;
        const double depth = glm::dot(to, view.forward);
        const double reach = view.half_height * depth;
        if (depth > 0 && std::abs(glm::dot(to, view.right)) <= reach &&
            std::abs(glm::dot(to, view.up)) <= reach) {
            return true;
        }
    }
    return false;
}

TEST(Gallery, BoxesAndCamerasAreUsable) {
    for (const GalleryItem& item : gallery()) {
        for (int i = 0; i < 3; ++i)
            EXPECT_LT(item.clip.lo[i], item.clip.hi[i]) << item.name;
        const Camera camera = item.camera.value_or(default_camera(item.clip));
        EXPECT_EQ(camera_defect(camera), nullptr) << item.name;
        EXPECT_TRUE(sees_a_corner(camera, item.clip)) << item.name;
    }
}

TEST(Gallery, BringsItsLookUnlessThereIsALightOfOnesOwn) {
    const GalleryItem metal = *gallery_item("tiger");
    const GalleryItem glass = *gallery_item("catenoid");
    ASSERT_EQ(metal.light.look, Look::Metal);
    ASSERT_EQ(glass.light.look, Look::Glass);
    EXPECT_EQ(read_document(metal).document.light, metal.light);
    Document last = empty_document();
    EXPECT_EQ(taken_over(metal, last).light, metal.light) << "over the usual light";
    last = taken_over(metal, last);
    EXPECT_EQ(taken_over(glass, last).light, glass.light) << "over one that the gallery brought";
    last.light.tone = Tone::Filmic;
    last.shadows = true;
    const Document next = taken_over(glass, last);
    EXPECT_EQ(next.light, last.light);
    EXPECT_TRUE(next.shadows);
    EXPECT_EQ(next.clip, glass.clip);
}

TEST(GalleryItem, IsFoundByItsName) {
    for (const GalleryItem& item : gallery()) {
        const auto found = gallery_item(item.name);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->equation, item.equation);
    }
}

TEST(GalleryItem, NamesTheNearestOfAnUnknownName) {
    const auto nothing = gallery_item("linked_torus");
    ASSERT_FALSE(nothing);
    EXPECT_NE(nothing.error().reason.find("@linked_tori"), std::string::npos)
        << nothing.error().reason;
    EXPECT_FALSE(gallery_item(""));
}

}  // namespace
}  // namespace zeroset::test::gallery_test
