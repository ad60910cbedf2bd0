#include "document/import/import.hpp"
#include "tests/document/import/imported_values.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

// Scenes of POV-Ray with what lies beside them, and as editors write them.

namespace zeroset::test::pov_include_test {
namespace {

constexpr const char* ball =
    "isosurface { function { x*x + y*y + z*z - R*R } contained_by { box { -9, 9 } } }\n";

class PovFiles : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        const auto file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }
    [[nodiscard]] ImportedDocument opened(const std::string& scene) const {
        const auto imported = load_import(write("scenes/a.pov", scene));
        EXPECT_TRUE(imported) << imported.error();
        return imported ? imported->documents[0] : ImportedDocument{.name = {}};
    }
    [[nodiscard]] std::string why_not(const std::string& scene) const {
        const auto imported = load_import(write("scenes/a.pov", scene));
        return imported ? "" : imported.error();
    }

    TestFolder folder_;
};

TEST_F(PovFiles, IncludedFilesAreRead) {
    write("scenes/sizes.inc", "#declare R = 2;\n#macro Large(N) " + std::string(ball) + "#end\n");
    write("scenes/parts/all.inc", "#include \"sizes.inc\"\n#declare R = R + 1;\n");
    const ImportedDocument scene = opened("#include \"parts\\\\all.inc\"\nLarge(1)\n");
    EXPECT_NEAR(value(scene, 0, 3.0, 0.0, 0.0), 0.0, 1e-12);
    EXPECT_FALSE(has_note(scene, "#include"));
    // In a loop each time
    write("scenes/more.inc", "#declare R = R + 1;\n");
    const ImportedDocument looped =
        opened("#declare R = 1; #for (I, 1, 4)\n#include \"more.inc\"\n#end\n" + std::string(ball));
    EXPECT_NEAR(value(looped, 0, 5.0, 0.0, 0.0), 0.0, 1e-12);
}

TEST_F(PovFiles, NothingElsewhereIsRead) {
    write("sizes.inc", "#declare R = 2;\n");
    write("scenes/here.inc", "#declare R = 2;\n");
    std::filesystem::create_symlink(folder_ / "sizes.inc", folder_ / "scenes/link.inc");
    const std::string reason = "it is not read; files beside the scene, and in folders below, are";
    for (const std::string& name :
         {std::string("../sizes.inc"), (folder_ / "sizes.inc").string(), std::string("link.inc"),
          std::string("none.inc"), std::string("."), std::string("")}) {
        const ImportedDocument scene =
            opened("#declare R = 1;\n#include \"" + name + "\"\n" + std::string(ball));
        EXPECT_NEAR(value(scene, 0, 1.0, 0.0, 0.0), 0.0, 1e-12);
        ASSERT_FALSE(scene.notes.empty());
        EXPECT_EQ(scene.notes.front().line, 2U);
        EXPECT_EQ(scene.notes.front().reason, reason);
    }
    EXPECT_TRUE(why_not("\n#include \"none.inc\"\nBall()\n")
                    .ends_with("of scenes of POV-Ray; #include none.inc: " + reason));
    // A text without a place has nothing beside it.
    EXPECT_TRUE(has_note(
        read("a.pov", "#include \"here.inc\"\n#declare R = 1;" + std::string(ball)).documents[0],
        "#include here.inc"));
}

TEST_F(PovFiles, ThatIncludeThemselvesEnd) {
    write("scenes/again.inc", "#include \"again.inc\"\n#declare R = 2;\n");
    const ImportedDocument scene = opened("#include \"again.inc\"\n" + std::string(ball));
    EXPECT_NEAR(value(scene, 0, 2.0, 0.0, 0.0), 0.0, 1e-12);
}

TEST_F(PovFiles, NotesTellOfWhichFileTheyAre) {
    write("scenes/deep.inc", "\n\nlight_source { 0 }\n");
    write("scenes/parts.inc", "\n#include \"deep.inc\"\n#version 3.7;\nfog { }\n");
    const ImportedDocument scene =
        opened("#declare R = 1;\n\n\n#include \"parts.inc\"\n" + std::string(ball));
    const auto at = [&](const std::string& entry) {
        const auto found = std::ranges::find(scene.notes, entry, &ImportNote::entry);
        return found == scene.notes.end() ? 0 : found->line;
    };
    EXPECT_EQ(at("deep.inc:3: light_source"), 4U);
    EXPECT_EQ(at("parts.inc:4: fog"), 4U);
}

TEST_F(PovFiles, MayHaveAnyEncodingAndLineEnds) {
    const std::string text =
        "// a ball\r#declare R = 4; // its size\rcamera { location -20*z look_at 0 }\r" +
        std::string(ball);
    std::string wide = "\xff\xfe";
    for (const char c : text)
        wide += std::string{c, '\0'};
    write("scenes/r.inc", wide);
    for (const std::string& scene : {text, wide, std::string("#include \"r.inc\"")})
        EXPECT_NEAR(value(opened(scene), 0, 4.0, 0.0, 0.0), 0.0, 1e-12);
}

/// `angle` is that across the picture, whose sides are 4:3 unless `right` says otherwise.
TEST_F(PovFiles, AnglesAreAcrossThePicture) {
    const auto seen = [&](const std::string& camera) {
        const auto scene = opened("#declare R = 1; camera { location -10*z look_at 0 " + camera +
                                  " } " + std::string(ball));
        return scene.document.camera ? std::tan(scene.document.camera->fov_rad / 2) : 0.0;
    };
    const double half = std::tan(20 * std::numbers::pi / 180);
    EXPECT_NEAR(seen("angle 40"), half * 3 / 4, 1e-12);
    EXPECT_NEAR(seen("right x*image_width/image_height angle 40"), half * 3 / 4, 1e-12);
    EXPECT_NEAR(seen("right -x*(image_width/image_height) angle 40"), half * 3 / 4, 1e-12);
    EXPECT_NEAR(seen("right 2*x angle 40"), half / 2, 1e-12);
    EXPECT_NEAR(seen("up y*image_height/image_width right x angle 40"), half * 3 / 4, 1e-12);
}

}  // namespace
}  // namespace zeroset::test::pov_include_test
