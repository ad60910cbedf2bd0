#include "engine/draw/files/formats.hpp"

#include "engine/draw/files/encoders.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zeroset::test::formats_test {
namespace {

LineDrawing two_lines() {
    LineDrawing drawing{.size = {.width = 200.0, .height = 100.0}};
    drawing.paths.push_back({.kind = CurveKind::Silhouette,
                             .surface = 0,
                             .hidden = false,
                             .closed = false,
                             .pieces = {{glm::dvec2(0, 0), {10, 0}, {20, 0}, {30, 12.34567}}}});
    drawing.paths.push_back({.kind = CurveKind::Boundary,
                             .surface = 1,
                             .hidden = true,
                             .closed = true,
                             .pieces = {{glm::dvec2(5, 5), {10, 5}, {10, 9}, {5, 5}}}});
    return drawing;
}

std::string encoded(const char* name, HiddenLines hidden) {
    const DrawingStyle style{.hidden = hidden};
    return find_drawing_format(name)->encode(two_lines(), style).value();
}

TEST(DrawingFormats, AreFoundByTheEnding) {
    EXPECT_EQ(find_drawing_format("a.svg")->name, "SVG");
    EXPECT_EQ(find_drawing_format("folder.pdf/a.PDF")->name, "PDF");
    EXPECT_EQ(find_drawing_format("a.tex")->name, "TikZ");
    EXPECT_EQ(find_drawing_format("a.png"), nullptr);
    EXPECT_EQ(find_drawing_format(""), nullptr);
}

TEST(Svg, HasAGroupForEachKind) {
    const std::string text = encoded("a.svg", HiddenLines::Dash);
    EXPECT_NE(text.find("<g id=\"hidden-boundary\""), std::string::npos);
    EXPECT_NE(text.find("<g id=\"visible-silhouette\""), std::string::npos);
    EXPECT_EQ(text.find("visible-boundary"), std::string::npos);
    EXPECT_NE(text.find("stroke-dasharray=\"3 2.5\""), std::string::npos);
    EXPECT_NE(text.find("width=\"200pt\" height=\"100pt\" viewBox=\"0 0 200 100\""),
              std::string::npos);
    EXPECT_NE(text.find("<path class=\"surface-1\" d=\"M0 0C10 0 20 0 30 12.3457\"/>"),
              std::string::npos);
    EXPECT_NE(text.find("<path class=\"surface-2\" d=\"M5 5C10 5 10 9 5 5Z\"/>"),
              std::string::npos);
}

TEST(DrawingFormats, HaveABackgroundWhereOneIsChosen) {
    const auto encode = [](const char* name, std::optional<std::uint32_t> background) {
        return find_drawing_format(name)->encode(two_lines(), {.background = background}).value();
    };
    EXPECT_FALSE(encode("a.svg", std::nullopt).contains("<rect"));
    EXPECT_TRUE(encode("a.svg", 0x00A0FF)
                    .contains("<rect width=\"200\" height=\"100\" fill=\"#00A0FF\"/>\n<g "));
    EXPECT_FALSE(encode("a.tex", std::nullopt).contains("\\fill"));
    EXPECT_TRUE(encode("a.tex", 0xFFFFFF)
                    .contains("\\definecolor{background}{HTML}{FFFFFF}\n\\fill[background] (0,0) "
                              "rectangle (200,100);"));
    EXPECT_GT(encode("a.pdf", 0x102030).size(), encode("a.pdf", std::nullopt).size());
}

TEST(Svg, HiddenLinesAreRemovedOrWhole) {
    EXPECT_EQ(encoded("a.svg", HiddenLines::Remove).find("hidden"), std::string::npos);
    const std::string shown = encoded("a.svg", HiddenLines::Show);
    EXPECT_NE(shown.find("hidden-boundary"), std::string::npos);
    EXPECT_EQ(shown.find("dasharray"), std::string::npos);
}

TEST(Tikz, DrawsPathsInScopes) {
    const std::string text = encoded("a.tex", HiddenLines::Dash);
    EXPECT_NE(text.find("\\begin{tikzpicture}[x=1bp,y=-1bp"), std::string::npos);
    EXPECT_NE(text.find(".. controls (10,0) and (20,0) .. (30,12.3457);"), std::string::npos);
    EXPECT_NE(text.find(".. controls (10,5) and (10,9) .. cycle;"), std::string::npos);
    EXPECT_NE(text.find("dash pattern=on 3bp off 2.5bp"), std::string::npos);
    EXPECT_TRUE(text.ends_with("\\end{tikzpicture}\n"));
}

TEST(Pdf, IsOfOnePageAndTheSameEachTime) {
    for (const double width : {0.01, 1.0, 60.0}) {
        const DrawingStyle style{.hidden = HiddenLines::Dash, .width_pt = width};
        const auto text = find_drawing_format("a.pdf")->encode(two_lines(), style);
        ASSERT_TRUE(text) << text.error();
        EXPECT_TRUE(text->starts_with("%PDF-1."));
        EXPECT_NE(text->find("/MediaBox [ 0 0 200 100 ]"), std::string::npos);
        EXPECT_NE(text->find("startxref"), std::string::npos);
        EXPECT_EQ(find_drawing_format("a.pdf")->encode(two_lines(), style).value(), *text);
    }
}

TEST(Widths, AreThoseAskedForOrParts) {
    LineDrawing drawing = two_lines();
    DrawingStyle style{.hidden = HiddenLines::Dash, .width_pt = 2.0};
    const auto width_of = [&](CurveKind kind, bool hidden) {
        for (const LineGroup& group : line_groups(drawing, style)) {
            if (group.kind == kind && group.hidden == hidden) return group.width_pt;
        }
        return 0.0;
    };
    EXPECT_EQ(width_of(CurveKind::Silhouette, false), 2.0);
    EXPECT_EQ(width_of(CurveKind::Contour, false), 0.8);
    drawing.contour_width_pt = 0.7;
    EXPECT_EQ(width_of(CurveKind::Contour, false), 0.7);
    EXPECT_DOUBLE_EQ(width_of(CurveKind::Contour, true), 0.42);
    style.widths_pt[static_cast<std::size_t>(CurveKind::Contour)] = 0.25;
    EXPECT_EQ(width_of(CurveKind::Contour, false), 0.25);
    EXPECT_EQ(width_of(CurveKind::Crease, false), 1.6);
}

TEST(Widths, AreWrittenToTheDigitWhateverTheTolerance) {
    const DrawingStyle style{.width_pt = 0.0125, .tolerance_pt = 10.0};
    for (const char* const name : {"a.svg", "a.tex"}) {
        const std::string text = find_drawing_format(name)->encode(two_lines(), style).value();
        EXPECT_NE(text.find("0.0125"), std::string::npos) << text;
    }
}

TEST(FileNumber, IsShort) {
    EXPECT_EQ(file_number(1.0, 4), "1");
    EXPECT_EQ(file_number(-0.00001, 4), "0");
    EXPECT_EQ(file_number(1234.56789, 3), "1234.568");
    EXPECT_EQ(file_number(-2.50, 3), "-2.5");
    EXPECT_EQ(file_number(100.0, 0), "100");
}

}  // namespace
}  // namespace zeroset::test::formats_test
