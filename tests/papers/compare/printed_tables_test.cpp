#include "papers/compare/printed_tables.hpp"

#include "engine/render/tracers.hpp"
#include "pipeline/gallery.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

// The papers' tables: what they name is there, and their numbers are those that are printed.

namespace zeroset::test::printed_tables_test {
namespace {

TEST(PrintedTables, NameSurfacesAndTracersThatThereAre) {
    for (const PrintedTable& table : printed_tables()) {
        EXPECT_FALSE(table.values.empty()) << table.name;
        EXPECT_EQ(find_printed_table(table.name), &table);
        std::set<std::tuple<std::string_view, std::string_view, int, int>> seen;
        for (const PrintedValue& value : table.values) {
            EXPECT_NE(find_tracer(value.tracer), nullptr) << value.tracer;
            const bool is_own = std::ranges::find(table.surfaces, value.surface,
                                                  &PrintedSurface::name) != table.surfaces.end();
            EXPECT_NE(is_own, std::ranges::any_of(gallery(),
                                                  [&](const GalleryItem& item) {
                                                      return item.name == value.surface &&
                                                             item.group == suite_group;
                                                  }))
                << value.surface;
            EXPECT_EQ(value.value > 0.0, table.name != "florez-figure-6.2");
            EXPECT_TRUE(table.names(value.surface, value.tracer));
            EXPECT_FALSE(table.names(value.surface, "beams"));
            EXPECT_TRUE(
                seen.insert({value.surface, value.tracer, value.d_stop, value.reflections}).second)
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
    const PrintedTable& without = *find_printed_table("florez-figure-6.2");
    EXPECT_FALSE(without.printed_ms("lens", "mrfro", 22).has_value());
    const PrintedTable& mirrors = *find_printed_table("stolte-table-1");
    EXPECT_DOUBLE_EQ(mirrors.printed_ms("holesrot", "octree", 30).value(), 37'937.0);
    EXPECT_DOUBLE_EQ(mirrors.printed_ms("holesrot", "octree", 30, 5).value(), 53'500.0);
}

/// The shares of pixels that the thesis's tables 5.2 and 5.3 come to, and that they are of one
/// picture.
TEST(PrintedTables, TellOfBoxes) {
    const PrintedTable& table = *find_printed_table("florez-table-5.1");
    for (const PrintedBoxes& boxes : table.boxes) {
        EXPECT_EQ(boxes.rejected_pixels + boxes.kept_pixels, 301 * 301) << boxes.surface;
        // Classic rays are those in both kinds of boxes together.
        EXPECT_NEAR(1000.0 * (boxes.rejected_s + boxes.kept_s),
                    table.printed_ms(boxes.surface, "mrfro", 22).value(), 20.0)
            << boxes.surface;
        EXPECT_NEAR(1000.0 * (boxes.trimming_s + boxes.kept_s),
                    table.printed_ms(boxes.surface, "florez-trimming", 22).value(), 20.0)
            << boxes.surface;
    }
    EXPECT_EQ(table.boxes_of("sphere")->rejected, 92);
    EXPECT_EQ(table.boxes_of("cube"), nullptr);
}

}  // namespace
}  // namespace zeroset::test::printed_tables_test
