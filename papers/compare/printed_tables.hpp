#pragma once

#include "papers/voxels/voxel_tracers.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// A scene of a paper that is not in the gallery, in the box [-domain, domain]^3.
struct PrintedScene {
    std::string name, formula;
    double domain = 0.0;
};

/// A column of a table: how its pictures are drawn.
struct PrintedColumn {
    std::string tracer;  ///< its name here, of `tracers()`
    int d_stop = 0;      ///< beyond max_d_stop: levels of an octree; other tracers go to max_d_stop
    int reflections = 0;  ///< how often rays are mirrored
};

/// A row of a table.
struct PrintedRow {
    std::string surface;         ///< its name here: of the gallery, or of the table's scenes
    std::vector<double> values;  ///< for each column; 0: none is printed
};

enum class PrintedUnit : std::uint8_t { FramesPerSecond, Seconds };

/// A table of a paper.
struct PrintedTable {
    std::string name;    ///< as it is typed
    std::string source;  ///< author, year, table
    std::string machine;
    std::string note;  ///< where its rows are not those that are measured here, and why
    PrintedUnit unit = PrintedUnit::Seconds;
    int size_px = 0;  ///< width and height of the pictures
    std::vector<PrintedColumn> columns;
    std::vector<PrintedRow> rows;
    std::vector<PrintedScene> scenes;  ///< surfaces that are not in the gallery

    /// The time that a frame took, if that is printed.
    [[nodiscard]] std::optional<double> printed_ms(std::string_view surface,
                                                   std::string_view tracer, int d_stop,
                                                   int reflections = 0) const;
    /// Whether the table is of this surface by this tracer.
    [[nodiscard]] bool names(std::string_view surface, std::string_view tracer) const;
};

/// An animation of a paper that is drawn with one grid for n frames [Florez08, sec. 6.5].
struct PrintedAnimation {
    std::string name;  ///< as it is typed: a table of `zeroset dev compare`
    std::string source;
    std::string note;             ///< what of the scene is not printed
    std::string formula;          ///< w is the time
    double domain = 0.0;          ///< the clip box is [-domain, domain]^3
    double from = 0.0, to = 0.0;  ///< of w
    int n = 0;
    /// How much less time a frame takes by a grid for `n` frames than by one for each: least and
    /// most.
    std::array<double, 2> printed_percent{};
};

/// Shadow beams and single shadow rays [Florez08, sec. 5.4.4], and what is printed of them.
struct ShadowTable {
    std::string name, source, note;
    int size_px = 0;
    double printed_rays_min = 0.0, printed_boxes_min = 0.0;  ///< minutes of the whole picture
    std::vector<PrintedScene> scenes;
};

/// Millions of intersections of rays with voxels a second, as they were printed for a method.
struct PrintedVoxels {
    VoxelMethod method = VoxelMethod::Midpoint;
    std::array<double, 3> millions{};
};

/// The name of the method's tracer.
std::string name_of(VoxelMethod method);

/// A table of [Marmitt04].
struct VoxelTable {
    std::string name;  ///< as it is typed
    std::string source, machine;
    std::string note;  ///< where what is measured here is not what was measured there
    RaysAtOnce rays = RaysAtOnce::One;
    bool synthetic = false;  ///< voxels of marching cubes; else those of scenes
    std::array<std::string, 3> columns;
    std::vector<PrintedVoxels> rows;
};

/// All that papers printed and that is measured here beside it.
struct PrintedTables {
    std::vector<PrintedTable> tables;  ///< the usual one first
    std::vector<PrintedAnimation> animations;
    ShadowTable shadows;
    std::vector<VoxelTable> voxel_tables;
    std::vector<PrintedScene> voxel_scenes;  ///< in place of those of the paper
};

/// Read once from papers/compare/printed_tables.json, which is in the program. Any thread.
const PrintedTables& printed_tables();

/// nullptr when there is none of the name.
template <class Item>
const Item* find_named(const std::vector<Item>& items, std::string_view name) {
    const auto found = std::ranges::find(items, name, &Item::name);
    return found == items.end() ? nullptr : &*found;
}

}  // namespace zeroset
