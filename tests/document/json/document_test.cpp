// Tests of the document as a value: rows, sliders, files; each kind of damage to a file is named.

#include "document/document.hpp"

#include "document/colors.hpp"
#include "document/json/document_json.hpp"
#include "document/row_program.hpp"
#include "engine/image/gamma.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace zeroset::test::document_test {
namespace {

std::vector<std::string> rows_in(std::string_view text) { return rows_of(text, nullptr); }

Document rich_document() {
    Document document;
    document.statements = {{1, "a = 2", true, {}},
                           {2, "x^2 + y^2 =\n a z", true, 0x3399FF},
                           {3, "\u03B1 + x \"quoted\" \\ = 0", false, 0x000000},
                           {4, "", true, {}}};
    document.parameters["b"] = {0.1, -1.0 / 3.0, 7.0, 0.25, 2.0, Repeat::Loop};
    document.parameters["\u03B1"] = {1e-30, -1e30, 1e30, 0.0, slowest, Repeat::Bounce};
    document.w = {0.3, -2.0, 2.5, 0.1, 4.0, Repeat::Loop};
    document.clip = {{-1.1, -2, -3}, {0.7, 5, 6}};
    document.aspect = {1, 0.25, 1.0 / 3.0};
    document.camera = Camera{{5, 0.1, 1}, {1, 2, 3}, {0, 1, 0}, 0.7330382858376184};
    document.camera->stretch = {1, 0.25, 1.0 / 3.0};
    document.home = Camera{{1, 2, 3.3}, {0, 0, 0}, {0, 0, 1}, 1.0, Projection::Orthographic};
    document.region = {Ball{{0.1, -2, 3}, 1.0 / 3.0},
                       {make_section({1, 2, 3}, 0.1), make_section({0, 0, -1}, 7, false)}};
    document.stop = {StopRule::Epsilon, 0.001};
    document.mark_undecided = true;
    document.shadows = true;
    document.axes = document.grid = document.trackball = true;
    document.axis_names = {"u", "", "h\u00F6he"};
    document.parameters["hidden"].presented = false;
    document.w.presented = false;
    document.up = {0, 1, 0.5};
    document.statements[0].solid = SolidSide::Above;
    document.statements[1].solid = SolidSide::Below;
    document.statements[1].opacity = 0.25;
    document.statements[1].look = Look::Porcelain;
    document.statements[0].thickness = Thickness{.width = 2.5, .in_pixels = true};
    document.statements[1].thickness = Thickness{.width = 0.125};
    document.statements[1].box = Box{.lo = {-1, -2, 0.5}, .hi = {1, 0.25, 3}};
    document.light = {.look = Look::Glass,
                      .lights = {{.towards = {1, 2, -3},
                                  .with_camera = false,
                                  .color = light_of_color(0xFFEECC),
                                  .power = 1.5,
                                  .radius_deg = 7.5},
                                 {}},
                      .reflections = 3,
                      .absorption = 0.75,
                      .tone = Tone::Filmic,
                      .background = Background{.top = 0xABCDEF, .bottom = 0x123456}};
    document.region.sections[1].values = true;
    document.section_values = {.map = ColorMap::Ember, .range = ValueRange{-1000, 400.25}};
    document.coloring.lines = {.contours = Contours::Expression,
                               .expression = "x y",
                               .step = 0.125,
                               .width = 2.5,
                               .intersections = true};
    document.views = {{"front", *document.home}, {"from the \u03B1 \"hole\"", *document.camera}};
    return document;
}

/// A view of a document's file.
std::string view_named(const std::string& name) {
    return R"({"name": ")" + name +
           R"(", "eye": [0, -3, 0], "look_at": [0, 0, 0], "up": [0, 0, 1], "fov_rad": 1})";
}

TEST(DocumentText, IsReadAsItWasWritten) {
    for (const Document& document : {rich_document(), empty_document()}) {
        const auto read = document_from(text_of(document));
        ASSERT_TRUE(read) << read.error();
        EXPECT_EQ(read->document, document);
        EXPECT_TRUE(read->unknown.empty());
    }
}

TEST(DocumentText, MayLeaveOutAllButTheStatements) {
    const auto read = document_from(R"({"zeroset": 1, "statements": [{"text": "x = 1"}]})");
    ASSERT_TRUE(read) << read.error();
    Document expected = empty_document();
    expected.antialias = Antialias::None;  // off, as all that is missing of the look
    EXPECT_EQ(document_from(R"({"zeroset": 1, "statements": []})")->document, expected);
    expected.statements[0].text = "x = 1";
    EXPECT_EQ(read->document, expected);
}

TEST(DocumentText, MaySayWhatItWasShownOn) {
    const Background light{.top = 0xF0F4FA, .bottom = 0xD8DEE8};
    Document document = empty_document();
    EXPECT_EQ(document_from(text_of(document))->shown_on, std::nullopt);
    EXPECT_EQ(document_from(text_of(document, light))->shown_on, light);
    EXPECT_TRUE(document_from(text_of(document, light))->unknown.empty());
    document.light.background = Background{.top = 1, .bottom = 2};
    EXPECT_EQ(document_from(text_of(document, light))->shown_on, std::nullopt)
        << "it has a background of its own";
    const auto damaged =
        document_from(R"({"zeroset": 1, "shown_on": 3, "statements": [{"text": "y"}]})");
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error(),
              "it is damaged: shown_on is neither a color such as #3399FF nor a list of two");
}

TEST(DocumentText, TakesWhatIsUpFromTheCameraIfItDoesNotSay) {
    const auto read = document_from(
        R"({"zeroset": 1, "statements": [], "camera":
            {"eye": [0, 0, 1], "look_at": [0, 0, 0], "up": [0, 2, 0], "fov_rad": 1}})");
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read->document.up, glm::dvec3(0, 2, 0));
}

TEST(DocumentText, NamesFieldsThatItDoesNotKnow) {
    const auto read = document_from(
        R"({"zeroset": 1, "fog": 3, "statements": [{"text": "x", "bold": true}], "look": {"sky": 1}})");
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(std::set(read->unknown.begin(), read->unknown.end()),
              (std::set<std::string>{"fog", "statements[0].bold", "look.sky"}));
}

TEST(DocumentText, RefusesNewerFormatsAndOtherFiles) {
    const auto reason = [](const char* text) { return document_from(text).error(); };
    EXPECT_EQ(reason(R"({"zeroset": 2, "statements": 5})"),
              "it was written by a newer Zeroset (format 2; this one reads up to 1)");
    EXPECT_EQ(reason("{}"), "it is no Zeroset document");
    EXPECT_EQ(reason("[1, 2]"), "it is no Zeroset document");
    EXPECT_EQ(reason("\n\nhello"), "it is damaged: line 3 is no JSON");
    EXPECT_EQ(reason(""), "it is damaged: line 1 is no JSON");
    EXPECT_EQ(reason("[1e999]"), "it is damaged: a number in it is too large");
    EXPECT_EQ(reason(R"({"zeroset": "1"})"), "it is damaged: the format version is no number");
}

/// Returns the text of a document whose top-level `field` has the value `json`.
std::string with(const std::string& field, const std::string& json) {
    const std::string statements =
        field == "statements" ? "" : R"(, "statements": [{"text": "x"}])";
    return R"({"zeroset": 1, ")" + field + "\": " + json + statements + "}";
}

TEST(DocumentText, SaysWhatIsDamaged) {
    const std::vector<std::pair<std::string, std::string>> damages{
        {with("statements", "3"), "statements is no list"},
        {with("statements", "[3]"), "statements[0] is no object"},
        {with("statements", R"([{"text": "x"}, {}])"), "statements[1].text is missing"},
        {with("statements", R"([{"text": 1}])"), "statements[0].text is no text"},
        {with("statements", R"([{"text": "x", "visible": 1}])"),
         "statements[0].visible is neither true nor false"},
        {with("statements", R"([{"text": "x", "color": "#12345"}])"),
         "statements[0].color is no color such as #3399FF"},
        {with("statements", R"([{"text": "x", "color": "#12345G"}])"),
         "statements[0].color is no color such as #3399FF"},
        {with("statements", R"([{"text": "x", "solid": "in"}])"),
         "statements[0].solid is neither f<0 nor f>0"},
        {with("parameters", "[]"), "parameters is no object"},
        {with("parameters", R"({"a": {"value": 1}})"), "parameters.a.range is missing"},
        {with("parameters", R"({"a": {"value": "1", "range": [0, 1]}})"),
         "parameters.a.value is no number"},
        {with("parameters", R"({"a": {"value": 1e31, "range": [0, 1]}})"),
         "parameters.a.value is too large a number"},
        {with("w", R"({"value": 1, "range": [1, 1]})"), "w.range is empty"},
        {with("w", R"({"value": 1, "range": [1]})"), "w.range is no list of 2 numbers"},
        {with("w", R"({"value": 1, "range": [0, 1], "step": -1})"), "w.step is below 0"},
        {with("w", R"({"value": 1, "range": [0, 1], "speed": 0})"),
         "w.speed is not between 1/64 and 64"},
        {with("w", R"({"value": 1, "range": [0, 1], "repeat": "once"})"),
         "w.repeat is neither loop nor bounce"},
        {with("box", "[0, 1, 0, 1, 1, 1]"), "box is empty"},
        {with("box", "[0, 1]"), "box is no list of 6 numbers"},
        {with("camera", R"({"eye": [0, 0, 1], "look_at": [0, 0, 0], "up": [0, 0, 1]})"),
         "camera.fov_rad is missing"},
        {with("region", R"({"sphere": {"radius": 0}})"), "region.sphere.radius is not above 0"},
        {with("region", R"({"sections": [{"normal": [0, 0, 0], "offset": 1}]})"),
         "region.sections[0].normal has no direction"},
        {with("region", R"({"sections": [{"normal": [0, 0, 1]}]})"),
         "region.sections[0].offset is missing"},
        {with("region", R"({"sections": [1, 2, 3, 4, 5, 6, 7]})"),
         "region.sections has more than 6 items"},
        {with("camera",
              R"({"eye": [0, 1, 1], "look_at": [0, 0, 0], "up": [0, 0, 1], "fov_rad": 1,
                  "projection": "fisheye"})"),
         "camera.projection is neither perspective nor orthographic"},
        {with("up", "[0, 0, 0]"), "up is zero"},
        {with("views", "{}"), "views is no list"},
        {with("views", "[3]"), "views[0] is no object"},
        {with("views", "[" + view_named("a") + ", " + view_named("a") + "]"),
         "there are two views called a"},
        {with("views", "[" + view_named("") + "]"), "views[0].name: it is empty"},
        {with("views", "[" + view_named("a\\nb") + "]"), "views[0].name: it is more than a line"},
        {with("views", R"([{"eye": [0, 0, 1]}])"), "views[0].name is missing"},
        {with("views", R"([{"name": "a", "look_at": [0, 0, 0]}])"), "views[0].eye is missing"},
        {with("views", R"([{"name": "a", "eye": [0, 0, 0], "look_at": [0, 0, 0],
                            "up": [0, 0, 1], "fov_rad": 1}])"),
         "views[0]: the eye is at the point looked at; move one of them"},
        {with("stop", R"({"rule": "d_stop", "value": 23})"), "stop.value is out of range"},
        {with("stop", R"({"rule": "d_stop", "value": 2.5})"), "stop.value is out of range"},
        {with("stop", R"({"rule": "luck", "value": 2})"),
         "stop.rule is none of d_stop, epsilon and delta"},
        {with("look", R"({"mark_undecided": "yes"})"),
         "look.mark_undecided is neither true nor false"},
        {with("look", R"({"antialias": 1})"),
         "look.antialias is neither true nor false, nor 4, 9, 16 or 64"},
        {with("look", R"({"antialias": "none"})"),
         "look.antialias is neither true nor false, nor 4, 9, 16 or 64"},
        {with("look", R"({"axis_names": ["x", "y"]})"), "look.axis_names is no list of 3 names"},
        {with("look", R"({"axis_names": ["x", "y", 3]})"), "look.axis_names is no text"},
        {with("look", R"({"axis_names": ["x", "y", ")" + std::string(81, 'z') + "\"]}"),
         "look.axis_names is longer than 80 bytes"},
        {with("w", R"({"value": 1, "range": [0, 1], "presented": 1})"),
         "w.presented is neither true nor false"},
        {with("markers", R"([{"number": 1, "at": [0, 0, 0], "label": 1}])"),
         "markers[0].label is no text"},
        {with("light", R"({"look": "gold"})"), "light.look is no look"},
        {with("light", R"({"tone": "loud"})"), "light.tone is neither plain nor filmic"},
        {with("light", R"({"reflections": 1.5})"),
         "light.reflections is no whole number from 0 to 5"},
        {with("light", R"({"absorption": -1})"), "light.absorption is not between 0 and 1e+06"},
        {with("light", R"({"background": [1]})"),
         "light.background is neither a color such as #3399FF nor a list of two"},
        {with("light", R"({"lights": [{"towards": [0, 0, 0]}]})"),
         "light.lights[0].towards is zero"},
        {with("light", R"({"lights": [{"towards": [1, 0, 0], "with": "me"}]})"),
         "light.lights[0].with is neither camera nor world"},
        {with("light", R"({"lights": [{"towards": [1, 0, 0], "power": 101}]})"),
         "light.lights[0].power is not between 0 and 100"},
        {with("color", R"({"by": "plain", "lines": {"contours": "all"}})"),
         "color.lines.contours is none of none, height, xyz, expression"},
        {with("color", R"({"by": "plain", "lines": {"step": 0}})"),
         "color.lines.step is not above 0"},
        {with("statements", R"([{"text": "x = 1", "opacity": 2}])"),
         "statements[0].opacity is not between 0 and 1"},
        {with("statements", R"([{"text": "x = 1", "look": "gold"}])"),
         "statements[0].look is no look"},
        {with("statements", R"([{"text": "x = 1", "thickness": 0}])"),
         "statements[0].thickness is neither a width above 0 nor a text such as \"3 px\""},
        {with("statements", R"([{"text": "x = 1", "thickness": "3 cm"}])"),
         "statements[0].thickness is neither a width above 0 nor a text such as \"3 px\""},
        {with("statements", R"([{"text": "x = 1", "box": [0, 1, 2, 2, 0, 1]}])"),
         "statements[0].box is empty"},
        {R"({"zeroset": 1})", "statements is missing"}};
    for (const auto& [text, reason] : damages) {
        const auto read = document_from(text);
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error(), "it is damaged: " + reason);
    }
    const auto blind = document_from(with(
        "camera", R"({"eye": [0, 0, 0], "look_at": [0, 0, 0], "up": [0, 0, 1], "fov_rad": 1})"));
    ASSERT_FALSE(blind);
    EXPECT_TRUE(blind.error().starts_with("it is damaged: camera: ")) << blind.error();
}

TEST(DocumentText, SaysThatItIsNestedTooDeep) {
    for (const std::size_t depth : {std::size_t{33}, std::size_t{1'000'000}}) {
        for (const std::string& begin : {std::string("["), std::string(R"({"a":)")}) {
            std::string deep;
            for (std::size_t i = 0; i < depth; ++i)
                deep += begin;
            deep += "1" + std::string(depth, begin == "[" ? ']' : '}');
            // Behind it are fields enough for the object to be moved in memory.
            const auto read = document_from(R"({"w": )" + deep +
                                            R"(, "b": 1, "c": 1, "d": 1, "e": 1, "zeroset": 1})");
            ASSERT_FALSE(read);
            EXPECT_EQ(read.error(), "it is damaged: it is nested more than 32 deep");
        }
    }
    const auto read = document_from(R"({"w": )" + std::string(31, '[') + "1" +
                                    std::string(31, ']') + R"(, "zeroset": 1})");
    ASSERT_FALSE(read);
    EXPECT_FALSE(read.error().contains("nested")) << read.error();
}

/// A file that is cut anywhere, or has any byte changed, is read or refused without a crash.
TEST(DocumentText, SurvivesEveryCutAndManyChanges) {
    const std::string whole = text_of(rich_document());
    for (std::size_t size = 0; size + 2 < whole.size(); ++size)
        EXPECT_FALSE(document_from(whole.substr(0, size))) << size;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (const char byte : {'\0', '"', '9', '{', '\xFF'}) {
            std::string changed = whole;
            changed[at] = byte;
            if (const auto read = document_from(changed)) {
                EXPECT_EQ(document_from(text_of(read->document))->document, read->document);
            }
        }
    }
}

TEST(DocumentText, IsToldFromAFormula) {
    EXPECT_TRUE(looks_like_document(text_of(empty_document())));
    EXPECT_FALSE(looks_like_document("{x < 0: -x, x} = y"));
    EXPECT_FALSE(looks_like_document(""));
}

TEST(Rows, AreAStatementEach) {
    EXPECT_EQ(rows_in("a = 2; x^2 + y^2 = a z, z < 1\n\nx + y =\n z ; "),
              (std::vector<std::string>{"a = 2", "x^2 + y^2 = a z, z < 1", "x + y =\n z"}));
    EXPECT_EQ(rows_in("  x = 1\r\n"), (std::vector<std::string>{"x = 1"}));
    EXPECT_EQ(rows_in("# a ball\nx^2 + y^2 + z^2 = 1"),
              (std::vector<std::string>{"# a ball", "x^2 + y^2 + z^2 = 1"}));
    EXPECT_EQ(rows_in("\\left(x+1\\right)^2 = z"),
              (std::vector<std::string>{"\\left(x+1\\right)^2 = z"}));
    EXPECT_EQ(rows_in("a = 2\n\\displaystyle \\left(x+a\\right)^2 = z"),
              (std::vector<std::string>{"a = 2", "\\displaystyle \\left(x+a\\right)^2 = z"}));
    EXPECT_EQ(rows_in("$$\\big(x+y\\big) = 1$$"),
              (std::vector<std::string>{"$$\\big(x+y\\big) = 1$$"}));
    EXPECT_EQ(rows_in("z = x \\pi\n(y+1)^2 = z"),
              (std::vector<std::string>{"z = x \\pi", "(y+1)^2 = z"}));
    EXPECT_TRUE(rows_in(" \n;; ").empty());
}

TEST(Rows, AreAStatementEachHoweverWritten) {
    EXPECT_EQ(rows_in("a = 2\n-x + y\n+z\n-w x"),
              (std::vector<std::string>{"a = 2", "-x + y\n+z", "-w x"}));
    EXPECT_EQ(rows_in("const float a = 1., b = 2.;\nfloat c = 3.;\na x + b y + c z"),
              (std::vector<std::string>{"const float a = 1.", "b = 2.", "float c = 3.",
                                        "a x + b y + c z"}));
    EXPECT_EQ(
        rows_in("float f(float u) {\n  float v = u;\n  return v;\n}\nf(x)"),
        (std::vector<std::string>{"float f(float u) {\n  float v = u;\n  return v;\n}", "f(x)"}));
    EXPECT_EQ(rows_in("x - 1 :\ny - 1 :"), (std::vector<std::string>{"x - 1", "y - 1"}));
    EXPECT_EQ(rows_in("e1: x = 1\ne2: y = 1"),
              (std::vector<std::string>{"e1: x = 1", "e2: y = 1"}));
    EXPECT_EQ(rows_in("a var-x\nb neg a"), (std::vector<std::string>{"a var-x\nb neg a"}));
}

TEST(Rows, AreLinesWhereTheTextCannotBeRead) {
    EXPECT_EQ(rows_in("x + * = 2\ny = ("), (std::vector<std::string>{"x + * = 2", "y = ("}));
    EXPECT_EQ(rows_in("x^2 +"), (std::vector<std::string>{"x^2 +"}));
}

TEST(Rows, FindTheRowOfAByte) {
    const JoinedRows joined({"ab", "", "cd"});
    EXPECT_EQ(joined.text.substr(joined.begins[2]), "cd");
    EXPECT_EQ(joined.row_at(0), 0U);
    EXPECT_EQ(joined.row_at(2), 0U);
    EXPECT_EQ(joined.row_at(joined.begins[1]), 1U);
    EXPECT_EQ(joined.row_at(joined.text.size()), 2U);
}

TEST(Rows, KeepTheirLengthWhereLinesAreJoined) {
    const JoinedRows joined({"x\n + y\n\n- z\nw = 1", "a\n\n"});
    EXPECT_EQ(joined.text, "x\v + y\n\v- z\nw = 1\n;\na\n\n");
}

TEST(SameWork, IsAllButTheCamera) {
    const Document document = rich_document();
    Document other = document;
    other.camera->eye.x += 1;
    EXPECT_TRUE(same_work(document, other));
    other.camera.reset();
    EXPECT_TRUE(same_work(document, other));
    other.w.value += 1;
    EXPECT_FALSE(same_work(document, other));
}

TEST(Colors, AreOfThePaletteAndEachOnce) {
    Document document;
    document.statements = {
        {1, "", true, {}}, {2, "", true, palette_fronts()[0]}, {3, "", true, {}}};
    EXPECT_TRUE(choose_colors(document, {1, 2, 3}));
    EXPECT_EQ(document.statements[0].color, palette_fronts()[1]);
    EXPECT_EQ(document.statements[1].color, palette_fronts()[0]);
    EXPECT_EQ(document.statements[2].color, palette_fronts()[2]);
    EXPECT_FALSE(choose_colors(document, {1, 2, 3}));
}

TEST(Colors, StartAgainWhenAllAreTaken) {
    Document document;
    std::vector<int> rows;
    for (int id = 1; id <= 20; ++id) {
        document.statements.push_back({id, "", true, {}});
        rows.push_back(id);
    }
    choose_colors(document, rows);
    for (const Statement& statement : document.statements) {
        ASSERT_TRUE(statement.color);
        EXPECT_NE(std::ranges::find(palette_fronts(), *statement.color), palette_fronts().end());
    }
}

TEST(Colors, HaveABackThatDiffers) {
    for (const std::uint32_t front : {0x000000U, 0xFFFFFFU, 0x3399FFU, palette_fronts()[2]}) {
        const SurfaceColors colors = surface_colors(front);
        float apart = 0;
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(std::sqrt(colors.front[i]) * 255,
                        static_cast<double>(front >> (16 - 8 * i) & 0xFFU), 0.6);
            apart += std::abs(colors.front[i] - colors.back[i]);
        }
        EXPECT_GT(apart, 0.3F);
    }
}

}  // namespace
}  // namespace zeroset::test::document_test
