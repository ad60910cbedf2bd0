#include "papers/compare/printed_tables.hpp"

#include "engine/render/tracers.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/prepare.hpp"
#include "pipeline/volume_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

// The papers' tables: what they name is there, and their numbers are those that are printed.

namespace zeroset::test::printed_tables_test {
namespace {

const PrintedTable& table_of(std::string_view name) {
    return *find_named(printed_tables().tables, name);
}

TEST(PrintedTables, NameSurfacesAndTracersThatThereAre) {
    for (const PrintedTable& table : printed_tables().tables) {
        SCOPED_TRACE(table.name);
        EXPECT_EQ(find_named(printed_tables().tables, table.name), &table);
        for (const std::string* const text : {&table.source, &table.machine, &table.note})
            EXPECT_FALSE(text->empty());
        EXPECT_GT(table.size_px, 0);
        EXPECT_FALSE(table.rows.empty());
        std::set<std::tuple<std::string_view, int, int>> columns;
        for (const PrintedColumn& column : table.columns) {
            EXPECT_NE(find_tracer(column.tracer), nullptr) << column.tracer;
            EXPECT_TRUE(columns.insert({column.tracer, column.d_stop, column.reflections}).second);
        }
        std::set<std::string_view> surfaces;
        for (const PrintedRow& row : table.rows) {
            EXPECT_TRUE(surfaces.insert(row.surface).second) << row.surface;
            const bool is_own = find_named(table.scenes, row.surface) != nullptr;
            EXPECT_NE(is_own, std::ranges::any_of(gallery(),
                                                  [&](const GalleryItem& item) {
                                                      return item.name == row.surface &&
                                                             item.group == suite_group;
                                                  }))
                << row.surface;
            ASSERT_EQ(row.values.size(), table.columns.size()) << row.surface;
            for (const double value : row.values)
                EXPECT_EQ(value > 0.0, table.name != "florez-figure-6.2");
            EXPECT_TRUE(table.names(row.surface, table.columns.front().tracer));
            EXPECT_FALSE(table.names(row.surface, "beams"));
        }
    }
    EXPECT_EQ(find_named(printed_tables().tables, "knoll-table-7"), nullptr);
}

TEST(PrintedTables, HaveScenesThatAreRead) {
    std::vector<PrintedScene> scenes = printed_tables().voxel_scenes;
    const auto add = [&](const std::vector<PrintedScene>& more) {
        scenes.insert(scenes.end(), more.begin(), more.end());
    };
    add(printed_tables().shadows.scenes);
    for (const PrintedTable& table : printed_tables().tables)
        add(table.scenes);
    for (const PrintedAnimation& animation : printed_tables().animations) {
        EXPECT_LT(animation.from, animation.to);
        EXPECT_GT(animation.n, 1);
        scenes.push_back({animation.name, animation.formula, animation.domain});
    }
    EXPECT_EQ(scenes.size(), 4U + 4U + 7U + 3U);
    for (const PrintedScene& scene : scenes) {
        EXPECT_GT(scene.domain, 0.0) << scene.name;
        EXPECT_TRUE(read_document_text(scene.formula, volume_source({})).rows) << scene.name;
    }
}

TEST(PrintedTables, GiveTimes) {
    const PrintedTable& frames = table_of("knoll-table-1");
    EXPECT_DOUBLE_EQ(frames.printed_ms("mitchell", "k-bisection", 22).value(), 1000.0 / 1.3);
    EXPECT_DOUBLE_EQ(frames.printed_ms("trilerp", "t-bisection", 22).value(), 1000.0 / 0.31);
    EXPECT_FALSE(frames.printed_ms("mitchell", "k-bisection", 21).has_value());
    EXPECT_FALSE(frames.printed_ms("mitchell", "beams", 22).has_value());
    const PrintedTable& seconds = table_of("florez-table-4.1");
    EXPECT_DOUBLE_EQ(seconds.printed_ms("chubs", "mrfro", 22).value(), 188'000.0);
    EXPECT_DOUBLE_EQ(seconds.printed_ms("kusner_schmitt", "alefeld-hansen", 22).value(), 86'000.0);
    const PrintedTable& without = table_of("florez-figure-6.2");
    EXPECT_FALSE(without.printed_ms("lens", "mrfro", 22).has_value());
    const PrintedTable& mirrors = table_of("stolte-table-1");
    EXPECT_DOUBLE_EQ(mirrors.printed_ms("holesrot", "octree", 30).value(), 37'937.0);
    EXPECT_DOUBLE_EQ(mirrors.printed_ms("holesrot", "octree", 30, 5).value(), 53'500.0);
}

}  // namespace
}  // namespace zeroset::test::printed_tables_test
