#include "app/cli/options/options.hpp"

#include "document/camera_text.hpp"
#include "document/json/share_text.hpp"
#include "engine/render/tracers.hpp"
#include "pipeline/input_error.hpp"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Tests of the command line's option texts: their meaning, and that every wrong one is refused with
// a line that names the option.

namespace zeroset::test::options_test {
namespace {

/// Option texts as pairs: the option's member and the text typed for it.
template <class Texts>
using Typed = std::initializer_list<std::pair<std::optional<std::string> Texts::*, const char*>>;

template <class Texts>
Texts texts_of(Typed<Texts> typed) {
    Texts texts;
    for (const auto& [option, text] : typed)
        texts.*option = text;
    return texts;
}

OrInputError<TraceSettings> settings_of(Typed<TraceText> typed) {
    return read_trace_settings(texts_of<TraceText>(typed));
}

OrInputError<InputDocument> document_of(Typed<ViewText> typed) {
    return read_document("x^2 + y^2 + z^2 = 1", texts_of<ViewText>(typed));
}

template <class Value>
void expect_refused(const OrInputError<Value>& result, const std::string& word) {
    ASSERT_FALSE(result) << "expected an error about " << word;
    EXPECT_NE(result.error().reason.find(word), std::string::npos) << result.error().reason;
    EXPECT_EQ(result.error().reason.find('\n'), std::string::npos) << result.error().reason;
    EXPECT_FALSE(result.error().column);
}

void expect_box(const char* text, const glm::dvec3& lo, const glm::dvec3& hi) {
    const auto surface = document_of({{&ViewText::box, text}});
    ASSERT_TRUE(surface) << surface.error().reason;
    EXPECT_EQ(surface->document.clip.lo, lo) << text;
    EXPECT_EQ(surface->document.clip.hi, hi) << text;
}

TEST(ReadBox, TakesAHalfEdgeOrSixBounds) {
    expect_box("1.5", glm::dvec3(-1.5), glm::dvec3(1.5));
    expect_box(" -1,2, -3,4,-5.5,+6e0", {-1, -3, -5.5}, {2, 4, 6});
    expect_box("1e9", glm::dvec3(-1e9), glm::dvec3(1e9));
}

TEST(ReadBox, RefusesWhatIsNoBox) {
    for (const char* text :
         {"", "0", "-1", "nan", "inf", "1e10", "1,2", "1,2,3,4,5", "1,2,3,4,5,6,7", "2,1,0,1,0,1",
          "0,1,0,1,1,1", "0,1,nan,1,0,1", "0,1,0,1,0,x", "0,1,0,1,0,", "1 2", "0x1p3"}) {
        expect_refused(document_of({{&ViewText::box, text}}), "--box");
    }
}

TEST(ReadBox, RefusesBoxesTooSmallForFloatsThere) {
    expect_refused(document_of({{&ViewText::box, "1,1.0000000000000009,0,1e-16,0,1e-16"}}),
                   "too small");
    const auto deep =
        document_of({{&ViewText::box, "1,1.000000001,-1,-0.999999999,2,2.000000001"}});
    ASSERT_TRUE(deep) << deep.error().reason;
    EXPECT_NEAR(deep->document.clip.size(), 1e-9, 1e-15);
    expect_refused(document_of({{&ViewText::box, "1e-31"}}), "too small");
    EXPECT_TRUE(document_of({{&ViewText::box, "100,101,0,1,0,1"}}));
    EXPECT_TRUE(document_of({{&ViewText::box, "1e-20"}}));
}

TEST(ReadSize, TakesAPairOrASquare) {
    const auto pair = read_size("--size", "640x480");
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->width, 640);
    EXPECT_EQ(pair->height, 480);
    const auto square = read_size("--size", "33");
    ASSERT_TRUE(square);
    EXPECT_EQ(square->width, 33);
    EXPECT_EQ(square->height, 33);
    EXPECT_TRUE(read_size("--size", "16384x1"));
    EXPECT_TRUE(read_size("--size", "10000x10000"));
}

TEST(ReadSize, RefusesWhatIsNoSize) {
    for (const char* text : {"", "x", "0", "0x0", "5x0", "-5x5", "5x", "x5", "5x5x5", "5.5", "axb",
                             "16385x1", "100000x100000", "16384x16384", "99999999999x1"}) {
        expect_refused(read_size("--size", text), "--size");
    }
}

TEST(ReadNumbers, TakesAsManyAsAsked) {
    const auto numbers = read_numbers("--eye", " 1, -2.5 ,+3e-2", 3);
    ASSERT_TRUE(numbers);
    EXPECT_EQ(*numbers, (std::vector{1.0, -2.5, 0.03}));
    EXPECT_EQ(read_number("--w", "0.25").value(), 0.25);
}

TEST(ReadNumbers, RefusesOtherCountsAndWhatIsNotFinite) {
    for (const char* text : {"", "1", "1,2", "1,2,3,4", "1,,3", "1,2,nan", "1,inf,3", "1e999,2,3",
                             "1,2,3;", "1,2,0x3", "a,b,c", "--1,2,3"}) {
        expect_refused(read_numbers("--eye", text, 3), "--eye");
    }
}

TEST(ReadInteger, KeepsToItsRange) {
    EXPECT_EQ(read_integer("--repeat", "7", 1, 9).value(), 7);
    EXPECT_EQ(read_integer("--repeat", " 9 ", 1, 9).value(), 9);
    for (const char* text : {"", "0", "10", "-1", "1.5", "1e0", "99999999999999999999", "two"}) {
        expect_refused(read_integer("--repeat", text, 1, 9), "--repeat");
    }
}

TEST(ReadDocument, SaysWhatIsNoParameter) {
    ViewText text;
    text.set = {"s=2"};
    expect_refused(read_document("s = 3; z = s*x", text), "s is a constant of the formula");
    expect_refused(read_document("s = 1/2; z = s*x", text), "s is a constant of the formula");
    for (const char* other : {"s = u; (u, v, s), 0 < u < 1, 0 < v < 1", "s = x*y; z = s"})
        expect_refused(read_document(other, text), "there is no such parameter");
}

TEST(ReadTraceSettings, HasDefaults) {
    const auto settings = read_trace_settings({});
    ASSERT_TRUE(settings);
    EXPECT_NE(find_tracer(settings->tracer), nullptr);
    EXPECT_EQ(settings->stop.rule, StopRule::DStop);
    EXPECT_EQ(settings->stop.value, max_d_stop);
    EXPECT_EQ(settings->threads, 0);
}

TEST(ReadTraceSettings, TakesEachRule) {
    const auto by_depth = settings_of({{&TraceText::d_stop, "10"}, {&TraceText::threads, "3"}});
    ASSERT_TRUE(by_depth);
    EXPECT_EQ(by_depth->stop.rule, StopRule::DStop);
    EXPECT_EQ(by_depth->stop.value, 10.0);
    EXPECT_EQ(by_depth->threads, 3);
    const auto by_size = settings_of({{&TraceText::epsilon, "0.5"}});
    ASSERT_TRUE(by_size);
    EXPECT_EQ(by_size->stop.rule, StopRule::Epsilon);
    EXPECT_EQ(by_size->stop.value, 0.5);
    const auto by_range = settings_of({{&TraceText::delta, "1e-3"}});
    ASSERT_TRUE(by_range);
    EXPECT_EQ(by_range->stop.rule, StopRule::Delta);
    EXPECT_EQ(by_range->stop.value, 1e-3);
}

TEST(ReadTraceSettings, RefusesWhatIsWrong) {
    expect_refused(settings_of({{&TraceText::tracer, "magic"}}), "--tracer");
    expect_refused(settings_of({{&TraceText::tracer, "magic"}}), "k-bisection");
    for (const char* text : {"0", "23", "-3", "1.5", "ten", ""}) {
        expect_refused(settings_of({{&TraceText::d_stop, text}}), "--dstop");
    }
    for (const char* text : {"0", "-1", "nan", "inf", "", "1,2"}) {
        expect_refused(settings_of({{&TraceText::epsilon, text}}), "--epsilon");
        expect_refused(settings_of({{&TraceText::delta, text}}), "--delta");
    }
    for (const char* text : {"0", "-1", "1025", "x"}) {
        expect_refused(settings_of({{&TraceText::threads, text}}), "--threads");
    }
}

TEST(ReadTraceSettings, TakesLevelsOfOctrees) {
    for (const char* const tracer : {"octree", "octree-unrounded", "gargantini"}) {
        const auto settings =
            settings_of({{&TraceText::tracer, tracer}, {&TraceText::levels, "53"}});
        ASSERT_TRUE(settings);
        EXPECT_EQ(settings->stop, (StopCriterion{StopRule::DStop, 53.0}));
        for (const char* const text : {"9", "54", "-1", "30.5", "many", ""}) {
            expect_refused(settings_of({{&TraceText::tracer, tracer}, {&TraceText::levels, text}}),
                           "--levels");
        }
    }
    for (const char* const tracer : {"beams", "k-bisection"}) {
        expect_refused(settings_of({{&TraceText::tracer, tracer}, {&TraceText::levels, "30"}}),
                       "--tracer octree");
    }
}

TEST(TakeLook, SwitchesAllOfATextbooksLinesAtOnce) {
    Document document;
    TraceText text;
    text.textbook = true;
    ASSERT_FALSE(take_look(text, document));
    EXPECT_TRUE(document.axes && document.clip_box && document.grid);
    text.grid = false;
    ASSERT_FALSE(take_look(text, document));
    EXPECT_TRUE(document.axes && document.clip_box && !document.grid) << "one of them by itself";
    text = {};
    text.textbook = false;
    text.axes = true;
    ASSERT_FALSE(take_look(text, document));
    EXPECT_TRUE(document.axes && !document.clip_box && !document.grid);
}

TEST(TakeLook, NamesTheAxes) {
    Document document;
    TraceText text;
    text.axis_names = " u, v ,the height";
    ASSERT_FALSE(take_look(text, document));
    EXPECT_EQ(document.axis_names, (std::array<std::string, 3>{"u", "v", "the height"}));
    text.axis_names = ",,";
    ASSERT_FALSE(take_look(text, document));
    EXPECT_EQ(document.axis_names, (std::array<std::string, 3>{}));
    for (const std::string& wrong : {std::string(), std::string("x"), std::string("x,y"),
                                     std::string("x,y,z,w"), "x,y," + std::string(81, 'z')}) {
        text.axis_names = wrong;
        const auto error = take_look(text, document);
        ASSERT_TRUE(error) << wrong;
        EXPECT_TRUE(error->reason.starts_with("--axis-names " + wrong)) << error->reason;
    }
}

TEST(ReadSurface, TakesMarkersWithLabels) {
    ViewText view;
    view.look.marks = {"1,2,3", "0,0,1; label the pole", "0,0,2 ;label=P; 2"};
    const auto surface = read_document("x = 1", view);
    ASSERT_TRUE(surface) << surface.error().reason;
    EXPECT_EQ(
        surface->document.markers,
        (std::vector<Marker>{{1, {1, 2, 3}}, {2, {0, 0, 1}, "the pole"}, {3, {0, 0, 2}, "P; 2"}}));
    for (const std::string& wrong :
         {std::string("0,0,1;"), std::string("0,0,1; pole"), std::string("0,0,1; label"),
          std::string("0,0,1; label "), "0,0,1; label " + std::string(81, 'p')}) {
        view.look.marks = {wrong};
        expect_refused(read_document("x = 1", view), "label TEXT");
    }
}

TEST(ReadSurface, HasNoCameraOfItsOwnUnlessAsked) {
    const auto surface = document_of({});
    ASSERT_TRUE(surface);
    EXPECT_FALSE(surface->document.camera);
    EXPECT_EQ(surface->document.clip.lo, glm::dvec3(-2.0));
    EXPECT_EQ(surface->document.w.value, 0.0);
}

TEST(ReadSurface, TakesTheCamera) {
    const auto surface = document_of({{&ViewText::eye, "5,0,1"},
                                      {&ViewText::look_at, "1,2,3"},
                                      {&ViewText::up, "0,1,0"},
                                      {&ViewText::fov, "90"},
                                      {&ViewText::w, "-0.5"}});
    ASSERT_TRUE(surface) << surface.error().reason;
    ASSERT_TRUE(surface->document.camera);
    EXPECT_EQ(surface->document.camera->eye, glm::dvec3(5, 0, 1));
    EXPECT_EQ(surface->document.camera->look_at, glm::dvec3(1, 2, 3));
    EXPECT_EQ(surface->document.camera->up, glm::dvec3(0, 1, 0));
    EXPECT_DOUBLE_EQ(surface->document.camera->fov_rad, std::numbers::pi / 2);
    EXPECT_EQ(surface->document.w.value, -0.5);
}

TEST(AspectOption, ScalesTheAxesOfThePicture) {
    ViewText view;
    view.box = "-1,1,-1,1,-50,50";
    view.eye = "3,-4,100";
    view.look_at = "0,0,10";
    const Document chosen = read_document("z = 50 x y", view).value().document;
    EXPECT_FALSE(chosen.aspect);
    EXPECT_EQ(chosen.camera->stretch, glm::dvec3(64, 64, 1));
    EXPECT_EQ(chosen.camera->eye, glm::dvec3(192, -256, 100));
    view.aspect = "1:1:0.5";
    const Document typed = read_document("z = 50 x y", view).value().document;
    EXPECT_EQ(typed.aspect, glm::dvec3(1, 1, 0.5));
    EXPECT_EQ(typed.camera->look_at, glm::dvec3(0, 0, 5));
    for (const char* const wrong : {"1:1", "1:0:1", "1:-1:1", "flat"}) {
        view.aspect = wrong;
        expect_refused(read_document("z = 50 x y", view), "--aspect");
    }
    view.aspect = "1:1:0.5";
    view.sphere = "1";
    expect_refused(read_document("z = 50 x y", view), "--aspect");
}

TEST(ReadSurface, RefusesCamerasThatSeeNothing) {
    expect_refused(document_of({{&ViewText::eye, "1,1,1"}, {&ViewText::look_at, "1,1,1"}}), "eye");
    expect_refused(document_of({{&ViewText::up, "0,0,0"}}), "up");
    expect_refused(document_of({{&ViewText::eye, "0,0,5"}, {&ViewText::look_at, "0,0,0"}}), "up");
    for (const char* text : {"0", "-10", "180", "nan", "wide"}) {
        expect_refused(document_of({{&ViewText::fov, text}}), "--fov");
    }
    expect_refused(document_of({{&ViewText::w, "nan"}}), "--w");
}

TEST(ReadSurface, KnowsTheGallery) {
    const auto sphere = read_document("@sphere", {});
    ASSERT_TRUE(sphere);
    EXPECT_EQ(sphere->document.clip.hi, glm::dvec3(1.5));
    const auto view = texts_of<ViewText>({{&ViewText::box, "3"}});
    EXPECT_EQ(read_document("@sphere", view).value().document.clip.hi, glm::dvec3(3));
    expect_refused(read_document("@spher", {}), "@sphere");
    expect_refused(read_document("@barth_sextik", {}), "@barth_sextic");
    EXPECT_EQ(read_document("  x + y\n", {}).value().rows->text, "x + y");
}

TEST(ReadBudget, TakesSeconds) {
    EXPECT_EQ(read_budget(std::nullopt).value(), 30.0);
    EXPECT_EQ(read_budget("0.25").value(), 0.25);
    for (const char* const wrong : {"", "0", "-1", "nan", "1e7", "5 s"}) {
        const auto budget = read_budget(wrong);
        ASSERT_FALSE(budget) << wrong;
        EXPECT_NE(budget.error().reason.find("--budget"), std::string::npos);
    }
}

/// A document with the saved views "front" and "the hole", as EQUATION.
std::string session_with_views() {
    Document document = empty_document();
    document.statements[0].text = "x^2 + y^2 + z^2 = 1";
    document.views = {{"front", {{0, -3, 0}, {0, 0, 0}, {0, 0, 1}, 1.0}},
                      {"the hole", {{3, 0, 0}, {0, 0, 1}, {0, 0, 1}, 0.5}}};
    return share_text(document);
}

TEST(SavedViewOption, LooksFromTheView) {
    const auto read = read_document(session_with_views(),
                                    texts_of<ViewText>({{&ViewText::saved_view, " the hole"}}));
    ASSERT_TRUE(read) << read.error().reason;
    EXPECT_EQ(read->document.camera, read->document.views[1].camera);
    const auto changed = read_document(
        session_with_views(),
        texts_of<ViewText>({{&ViewText::saved_view, "front"}, {&ViewText::look_at, "0,0,0.5"}}));
    ASSERT_TRUE(changed) << changed.error().reason;
    EXPECT_EQ(changed->document.camera->eye, glm::dvec3(0, -3, 0));
    EXPECT_EQ(changed->document.camera->look_at, glm::dvec3(0, 0, 0.5));
}

TEST(SavedViewOption, SaysWhichViewsThereAre) {
    expect_refused(
        read_document(session_with_views(), texts_of<ViewText>({{&ViewText::saved_view, "Front"}})),
        "--view Front: there is no such view; there are: front, the hole");
    expect_refused(document_of({{&ViewText::saved_view, "front"}}),
                   "--view front: there is no such view; the document has no saved ones");
}

TEST(CameraOption, TakesTheTextOfACamera) {
    const auto read =
        document_of({{&ViewText::camera, "eye 0,-6,0; look-at 0,0,1; up 0,1,1; height 4"}});
    ASSERT_TRUE(read) << read.error().reason;
    EXPECT_EQ(read->document.camera->look_at, glm::dvec3(0, 0, 1));
    EXPECT_EQ(read->document.camera->projection, Projection::Orthographic);
    const auto again =
        document_of({{&ViewText::camera, camera_text(*read->document.camera).c_str()}});
    ASSERT_TRUE(again) << again.error().reason;
    EXPECT_EQ(again->document.camera->eye, read->document.camera->eye);
}

TEST(CameraOption, IsRefusedWithItsText) {
    expect_refused(document_of({{&ViewText::camera, "eye 1,2"}}),
                   "--camera eye 1,2: 3 numbers separated by commas are needed, not 2");
    expect_refused(document_of({{&ViewText::camera, "front"}}), "--camera front: type eye X,Y,Z");
    expect_refused(document_of({{&ViewText::camera, "eye 1,2,3; fov 0"}}), "0.01 to 170");
}

}  // namespace
}  // namespace zeroset::test::options_test
