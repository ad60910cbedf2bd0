// Tests of opening a saved session in place of an equation.

#include "app/cli/options/options.hpp"
#include "app/cli/window_command.hpp"
#include "app/desktop/desktop.hpp"
#include "document/colors.hpp"
#include "document/json/document_file.hpp"
#include "pipeline/picture_request.hpp"
#include "tests/support/formulas.hpp"
#include "tests/support/test_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace zeroset::test::desktop_options_test {
namespace {

namespace fs = std::filesystem;

class SavedSession : public testing::Test {
protected:
    void SetUp() override {
        document_.statements = {{1, "x^2 + y^2 = a", true, 0x3399FF},
                                {2, "b = 2", true, {}},
                                {3, "z = b", false, palette_fronts()[3]},
                                {4, "y = 0", true, palette_fronts()[2]}};
        document_.parameters["a"] = {.value = 3.0};
        document_.parameters["unused"] = {.value = 2.0};
        document_.clip = Box::cube(3);
        document_.w.value = 0.25;
        document_.stop.value = 11;
        document_.shadows = true;
        ASSERT_TRUE(save_document(path_, document_));
    }

    TestFolder folder_;
    fs::path path_ = folder_ / "a.zeroset.json";
    Document document_;
};

TEST_F(SavedSession, OpensInTheWindow) {
    const auto options = read_desktop_options(path_.string(), {}, {});
    ASSERT_TRUE(options);
    EXPECT_NE(options->document.files, nullptr) << "its texts may name files beside it";
    document_.files = options->document.files;
    EXPECT_EQ(options->document, document_);
    EXPECT_EQ(options->path, path_.string());
}

TEST_F(SavedSession, IsNotNew) {
    EXPECT_FALSE(read_desktop_options(path_.string(), {}, {})->is_new);
    EXPECT_TRUE(read_desktop_options("x = 1", {}, {})->is_new);
    EXPECT_TRUE(read_desktop_options("", {}, {})->is_new) << "the gallery's first";
    TraceText trace;
    trace.axes = false;
    EXPECT_FALSE(read_desktop_options("x = 1", {}, trace)->is_new) << "as the command line says";
    EXPECT_TRUE(read_desktop_options("x = 1", {}, trace)->has_new_edges);
    EXPECT_FALSE(read_desktop_options(path_.string(), {}, {})->has_new_edges);
    trace.aa = "none";
    EXPECT_FALSE(read_desktop_options("x = 1", {}, trace)->has_new_edges);
}

TEST_F(SavedSession, GivesWayToTheCommandLine) {
    ViewText view;
    view.box = "5";
    view.w = "-0.5";
    view.set = {"a=7"};
    TraceText trace;
    trace.d_stop = "9";
    trace.shadows = false;
    trace.antialias = true;
    trace.jumps = true;
    const auto options = read_desktop_options(path_.string(), view, trace);
    ASSERT_TRUE(options);
    EXPECT_EQ(options->document.clip, Box::cube(5));
    EXPECT_EQ(options->document.w.value, -0.5);
    EXPECT_EQ(options->document.parameters.at("a").value, 7.0);
    EXPECT_EQ(options->document.stop.value, 9.0);
    EXPECT_FALSE(options->document.shadows);
    EXPECT_EQ(options->document.antialias, Antialias::Beams);
    EXPECT_TRUE(options->document.jumps);
}

TEST_F(SavedSession, DrawsItsVisibleRowsInTheirColors) {
    const auto input = read_document(path_.string(), {});
    ASSERT_TRUE(input);
    ASSERT_TRUE(input->rows);
    EXPECT_EQ(input->rows->surface_rows, (std::vector{1, 3, 4}));
    const auto prepared = prepare(input->document, *input->rows, Preparation::Interpreted);
    ASSERT_TRUE(prepared);
    const Scene scene = scene_of(
        picture_request(prepared->formula, prepared->colors, input->document, {}, {64, 64}));
    ASSERT_EQ(scene.surfaces.size(), 2U);
    EXPECT_EQ(scene.surfaces[0].colors->back[0], surface_colors(0x3399FF).back[0]);
    EXPECT_EQ(scene.surfaces[1].colors->front[1], colors_of(2).front[1]);
    EXPECT_EQ(scene.uniforms.middle_double.at(1), 3.0);
}

TEST_F(SavedSession, IsRefusedWhenItIsMissing) {
    const auto input = read_document("no_such_file.zeroset.json", {});
    ASSERT_FALSE(input);
    EXPECT_EQ(input.error().reason,
              "cannot open 'no_such_file.zeroset.json': there is no such file");
}

TEST(DocumentOfAText, HasARowForEachStatement) {
    ViewText view;
    view.box = "1";
    view.w = "3";
    view.eye = "4,5,6";
    view.set = {"c=9"};
    const auto input = read_document("a = 2; x^2 = a c", view);
    ASSERT_TRUE(input);
    const Document& document = input->document;
    ASSERT_EQ(document.statements.size(), 2U);
    EXPECT_EQ(document.statements[1].text, "x^2 = a c");
    EXPECT_EQ(document.w, (Slider{.value = 3.0, .lo = -2.0, .hi = 3.0}));
    EXPECT_EQ(document.parameters.at("c"), (Slider{.value = 9.0, .hi = 9.0}));
    ASSERT_TRUE(document.camera);
    EXPECT_EQ(document.camera->eye, glm::dvec3(4, 5, 6));
    EXPECT_EQ(document.home, document.camera);
}

TEST(DocumentOfAText, RefusesParametersSolidsAndColorsThatItDoesNotHave) {
    const auto reason = [](const ViewText& view) {
        const auto input = read_document("x = a", view);
        return input ? "" : input.error().reason;
    };
    ViewText view;
    view.set = {"b=1"};
    EXPECT_TRUE(reason(view).starts_with("--set b:")) << reason(view);
    view = {};
    view.surfaces.solids = {"2:f<0"};
    EXPECT_TRUE(reason(view).starts_with("--solid 2:")) << reason(view);
    view = {};
    view.look.color_by = "x + q(";
    EXPECT_TRUE(reason(view).starts_with("--color-by:")) << reason(view);
}

}  // namespace
}  // namespace zeroset::test::desktop_options_test
