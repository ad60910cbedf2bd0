#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace zeroset {

/// A figure that a paper printed for a surface, a tracer and a tolerance.
struct PrintedValue {
    std::string_view surface, tracer;  ///< their names here: of the gallery, of `tracers()`
    int d_stop;
    double value;
};

enum class PrintedUnit : std::uint8_t { FramesPerSecond, Seconds };

/// A table of a paper, as data.
struct PrintedTable {
    std::string_view name;    ///< as it is typed
    std::string_view source;  ///< author, year, table
    std::string_view machine;
    std::string_view note;  ///< where its rows are not those that are measured here, and why
    PrintedUnit unit;
    int size_px;  ///< width and height of the pictures
    std::span<const PrintedValue> values;

    /// The time that a frame took, if that is printed.
    [[nodiscard]] std::optional<double> printed_ms(std::string_view surface,
                                                   std::string_view tracer, int d_stop) const;
};

/// All of them, the usual one first.
std::span<const PrintedTable> printed_tables();
/// nullptr when there is none of the name.
const PrintedTable* find_printed_table(std::string_view name);

}  // namespace zeroset
