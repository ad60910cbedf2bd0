#include "papers/compare/compared_row.hpp"

#include "papers/compare/plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

// Results made of measured rows: ratios, means, what boxes save, and plots.

namespace zeroset::test::compared_row_test {
namespace {

ComparedRow row_of(const std::string& surface, const std::string& tracer, double ms,
                   std::optional<double> printed_ms = std::nullopt) {
    ComparedRow row;
    row.surface = surface;
    row.tracer = tracer;
    row.wanted_d_stop = 22;
    row.d_stop = 22;
    row.median_ms = ms;
    row.printed_ms = printed_ms;
    row.of_table = printed_ms.has_value();
    return row;
}

const PrintedTable& table() { return *find_printed_table("florez-table-5.4"); }

Comparison comparison() {
    return {.table = &table(), .width = 300, .height = 300, .threads = 1, .repeats = 3};
}

TEST(ComparedRows, AreTimesTheFirstPrintedOneOfTheirCase) {
    std::vector<ComparedRow> rows{row_of("a", "beams", 1), row_of("a", "mrf", 8, 100),
                                  row_of("a", "mrfro", 16, 300), row_of("b", "mrf", 2, 10),
                                  row_of("a", "mrf", 80, 900)};
    rows[4].reflections = 5;
    set_times(rows);
    EXPECT_DOUBLE_EQ(rows[0].times.value(), 0.125);
    EXPECT_FALSE(rows[0].printed_times.has_value());
    EXPECT_DOUBLE_EQ(rows[2].times.value(), 2.0);
    EXPECT_DOUBLE_EQ(rows[2].printed_times.value(), 3.0);
    EXPECT_DOUBLE_EQ(rows[3].times.value(), 1.0);
    EXPECT_DOUBLE_EQ(rows[4].times.value(), 1.0);
    rows[4].of_table = false;
    rows[0].printed_ms.reset();
    rows[0].of_table = true;
    set_times(rows);
    EXPECT_DOUBLE_EQ(rows[2].times.value(), 16.0);
    EXPECT_DOUBLE_EQ(rows[1].times.value(), 8.0);
    EXPECT_DOUBLE_EQ(rows[3].times.value(), 1.0);
    const auto means = means_of(rows);
    ASSERT_EQ(means.size(), 4U);
    const auto mrf = std::ranges::find_if(
        means, [](const auto& mean) { return mean.tracer == "mrf" && mean.reflections == 0; });
    EXPECT_DOUBLE_EQ(mrf->ms, 4.0);
}

std::vector<ComparedRow> rows_with_boxes() {
    std::vector<ComparedRow> rows{row_of("orthocircle", "mrfro", 100, 1'266'000),
                                  row_of("orthocircle", "florez-boxes", 50, 528'000)};
    rows[1].boxes = {.rejected = {.boxes = 10, .pixels = 45'000, .ms = 0},
                     .included = {.boxes = 20, .pixels = 36'000, .ms = 20},
                     .undefined = {.boxes = 30, .pixels = 9'000, .ms = 10},
                     .ms = 5};
    return rows;
}

TEST(BoxSavings, CountOneRayInsideAndNineAtEdges) {
    const std::vector<ComparedRow> rows = rows_with_boxes();
    const auto savings = box_savings(rows);
    ASSERT_EQ(savings.size(), 1U);
    EXPECT_EQ(savings[0].classic, rows.data());
    EXPECT_DOUBLE_EQ(savings[0].rejected_ms, 70.0);
    EXPECT_DOUBLE_EQ(savings[0].kept_ms, 30.0);
    EXPECT_DOUBLE_EQ(savings[0].rays, 36'000.0 + 81'000.0);
    EXPECT_DOUBLE_EQ(savings[0].rays_ms, 5.0 + 20.0 + 90.0);
    EXPECT_TRUE(box_savings({rows[1]}).empty());  // without single rays
    const std::string text = boxes_text(comparison(), rows);
    for (const char* part : {"orthocircle", "117000", "115.0", "683", "68631", "140", "50.0"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    EXPECT_TRUE(boxes_text(comparison(), {rows[0]}).empty());
}

double digits_width(std::string_view words, double em) {
    return 0.6 * em * static_cast<double>(words.size());
}

TEST(ComparisonPlot, HasADotAndARingForEachRowOnALogarithmicAxis) {
    std::vector<ComparedRow> rows{row_of("a", "mrf", 10, 1000), row_of("a", "mrfro", 100, 10'000),
                                  row_of("b", "mrf", 1000, 10)};
    set_times(rows);
    rows[1].wrong.missed = 7;
    const ComparisonPlot plot = comparison_plot(comparison(), rows, digits_width);
    std::vector<Circle> dots, rings;
    std::vector<std::string> words;
    for (const Shape& shape : plot.shapes) {
        if (const auto* const circle = std::get_if<Circle>(&shape)) {
            EXPECT_GT(circle->middle.x, 0.0);
            EXPECT_LT(circle->middle.x, plot.size.x);
            EXPECT_LT(circle->middle.y, plot.size.y);
            if (circle->middle.y > 60.0) (circle->line > 0 ? rings : dots).push_back(*circle);
        } else if (const auto* const text = std::get_if<Text>(&shape)) {
            EXPECT_LT(text->at.y, plot.size.y);
            words.push_back(text->words);
        }
    }
    ASSERT_EQ(dots.size(), 3U);
    ASSERT_EQ(rings.size(), 3U);
    const double decade = dots[1].middle.x - dots[0].middle.x;
    EXPECT_GT(decade, 50.0);
    EXPECT_NEAR(dots[2].middle.x - dots[1].middle.x, decade, 1e-9);
    EXPECT_NEAR(rings[0].middle.x, dots[2].middle.x, 1e-9);
    EXPECT_NEAR(rings[2].middle.x, dots[0].middle.x, 1e-9);
    EXPECT_LT(dots[0].middle.y, dots[1].middle.y);
    for (const char* word :
         {"a", "b", "mrfro", "10 ms  \u00d71", "10 s  \u00d710", "7 pixels wrong"})
        EXPECT_NE(std::ranges::find(words, word), words.end()) << word;
}

TEST(PlotFormat, IsThatOfTheName) {
    EXPECT_EQ(plot_format("a.svg"), PlotFormat::Svg);
    EXPECT_EQ(plot_format("dir/a.png"), PlotFormat::Png);
    EXPECT_FALSE(plot_format("a.gif").has_value());
    EXPECT_FALSE(plot_format(".svg").has_value());
    EXPECT_FALSE(plot_format("svg").has_value());
}

}  // namespace
}  // namespace zeroset::test::compared_row_test
