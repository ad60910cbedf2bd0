#include "app/cli/compare/printed_tables.hpp"

#include "engine/render/tracers.hpp"
#include "pipeline/gallery.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

// The papers' tables: what they name is there, and their numbers are those that are printed.

namespace zeroset::test {
namespace {

TEST(PrintedTables, NameSurfacesAndTracersThatThereAre) {
    for (const PrintedTable& table : printed_tables()) {
        EXPECT_FALSE(table.values.empty()) << table.name;
        EXPECT_EQ(find_printed_table(table.name), &table);
        std::set<std::tuple<std::string_view, std::string_view, int>> seen;
        for (const PrintedValue& value : table.values) {
            EXPECT_NE(find_tracer(value.tracer), nullptr) << value.tracer;
            EXPECT_TRUE(std::ranges::any_of(gallery(), [&](const GalleryItem& item) {
                return item.name == value.surface && item.group == suite_group;
            })) << value.surface;
            EXPECT_GT(value.value, 0.0);
            EXPECT_TRUE(seen.insert({value.surface, value.tracer, value.d_stop}).second)
                << value.surface << " " << value.tracer;
        }
    }
    EXPECT_EQ(find_printed_table("knoll-table-7"), nullptr);
}

TEST(PrintedTables, GiveTimes) {
    const PrintedTable& frames = *find_printed_table("knoll-table-1");
    EXPECT_DOUBLE_EQ(frames.printed_ms("mitchell", "k-bisection", 22).value(), 1000.0 / 1.3);
    EXPECT_DOUBLE_EQ(frames.printed_ms("trilerp", "t-bisection", 22).value(), 1000.0 / 0.31);
    EXPECT_FALSE(frames.printed_ms("mitchell", "k-bisection", 21).has_value());
    EXPECT_FALSE(frames.printed_ms("mitchell", "beams", 22).has_value());
    const PrintedTable& seconds = *find_printed_table("florez-table-4.1");
    EXPECT_DOUBLE_EQ(seconds.printed_ms("chubs", "mrfro", 22).value(), 188'000.0);
    EXPECT_DOUBLE_EQ(seconds.printed_ms("kusner_schmitt", "alefeld-hansen", 22).value(), 86'000.0);
}

}  // namespace
}  // namespace zeroset::test
