#include "papers/compare/compared_row.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// Results made of measured rows: ratios, and lines of text.

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
}

TEST(ComparedRows, AreLinesInTheColumnsOfTheirHeading) {
    ComparedRow row = row_of("orthocircle", "florez-boxes", 50, 528'000);
    row.wrong.missed = 7;
    row.printed_times = 0.417;
    const std::string line = row_text(row);
    std::istringstream words(line);
    const std::vector<std::string> found{std::istream_iterator<std::string>(words), {}};
    EXPECT_EQ(found,
              (std::vector<std::string>{"orthocircle", "22", "0", "florez-boxes", "50.00", "0.00",
                                        "0.00", "7", "0", "0", "0", "-", "528000", "0.42"}));
    const Comparison comparison{.table = find_named(printed_tables().tables, "florez-table-5.4"),
                                .width = 300,
                                .height = 300,
                                .threads = 1,
                                .repeats = 3};
    const std::string heading = heading_text(comparison);
    EXPECT_TRUE(heading.starts_with("Florez 2008, table 5.4 (Pentium 4 2.4 GHz): Drop is"));
    EXPECT_EQ(line.size(), heading.size() - heading.rfind('\n', heading.size() - 2) - 1);
    row.counters.cut_pixels = 1;
    EXPECT_TRUE(row_text(row).ends_with("0.42  (cut by --budget)\n"));
}

}  // namespace
}  // namespace zeroset::test::compared_row_test
