#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace zeroset {

/// A row of a table: a surface, a tracer, a tolerance and the figure that a paper printed for them.
struct PrintedValue {
    std::string_view surface, tracer;  ///< their names here: of the gallery, of `tracers()`
    int d_stop;    ///< beyond max_d_stop: levels of an octree; other tracers go to max_d_stop
    double value;  ///< 0: none is printed
    int reflections = 0;  ///< how often rays are mirrored
};

/// A surface of a table that is not in the gallery, in the box [-domain, domain]^3.
struct PrintedSurface {
    std::string_view name, formula;
    double domain;
};

/// The numbers that Florez printed of the boxes of an image; 0: not printed.
struct PrintedBoxes {
    std::string_view surface;
    double trimming_s;  ///< of finding the boxes
    int rejected, rejected_pixels, kept, kept_pixels;
    double rejected_s, kept_s;  ///< single rays through them, without boxes
    int rays, all_rays;         ///< with boxes, and nine a pixel everywhere
};

enum class PrintedUnit : std::uint8_t {
    FramesPerSecond,
    Seconds,
    MillionsPerSecond  ///< of intersections: a time is that of a million
};

/// A table of a paper, as data.
struct PrintedTable {
    std::string_view name;    ///< as it is typed
    std::string_view source;  ///< author, year, table
    std::string_view machine;
    std::string_view note;  ///< where its rows are not those that are measured here, and why
    PrintedUnit unit;
    int size_px;  ///< width and height of the pictures
    std::span<const PrintedValue> values;
    std::span<const PrintedSurface> surfaces = {};
    std::span<const PrintedBoxes> boxes = {};

    /// The time that a frame took, if that is printed.
    [[nodiscard]] std::optional<double> printed_ms(std::string_view surface,
                                                   std::string_view tracer, int d_stop,
                                                   int reflections = 0) const;
    /// Whether the table is of this surface by this tracer.
    [[nodiscard]] bool names(std::string_view surface, std::string_view tracer) const;
    /// nullptr where nothing is printed.
    [[nodiscard]] const PrintedBoxes* boxes_of(std::string_view surface) const;
};

/// All of them, the usual one first.
std::span<const PrintedTable> printed_tables();
/// nullptr when there is none of the name.
const PrintedTable* find_printed_table(std::string_view name);

}  // namespace zeroset
