#include "papers/compare/printed_tables.hpp"

#include "papers/compare/printed_tables_file.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>

namespace zeroset {

NLOHMANN_JSON_SERIALIZE_ENUM(PrintedUnit, {{PrintedUnit::FramesPerSecond, "frames/s"},
                                           {PrintedUnit::Seconds, "s"}})
NLOHMANN_JSON_SERIALIZE_ENUM(RaysAtOnce, {{RaysAtOnce::One, "one"}, {RaysAtOnce::Packet, "packet"}})
NLOHMANN_JSON_SERIALIZE_ENUM(VoxelMethod, {{VoxelMethod::Midpoint, "midpoint"},
                                           {VoxelMethod::Linear, "linear"},
                                           {VoxelMethod::Neubauer, "neubauer"},
                                           {VoxelMethod::Schwarze, "schwarze"},
                                           {VoxelMethod::Marmitt, "marmitt"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PrintedScene, name, formula, domain)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PrintedRow, surface, values)
// NOLINTBEGIN(misc-const-correctness): variables of the macro
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(PrintedColumn, tracer, d_stop, reflections)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(PrintedTable, name, source, machine, note, unit,
                                                size_px, columns, rows, scenes)
// NOLINTEND(misc-const-correctness)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PrintedAnimation, name, source, note, formula, domain, from, to,
                                   n, printed_percent)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ShadowTable, name, source, note, size_px, printed_rays_min,
                                   printed_boxes_min, scenes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PrintedVoxels, method, millions)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(VoxelTable, name, source, machine, note, rays, synthetic,
                                   columns, rows)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PrintedTables, tables, animations, shadows, voxel_tables,
                                   voxel_scenes)

std::optional<double> PrintedTable::printed_ms(std::string_view surface, std::string_view tracer,
                                               int d_stop, int reflections) const {
    const auto row = std::ranges::find(rows, surface, &PrintedRow::surface);
    const auto column = std::ranges::find_if(columns, [&](const PrintedColumn& of) {
        return of.tracer == tracer && of.d_stop == d_stop && of.reflections == reflections;
    });
    if (row == rows.end() || column == columns.end()) return std::nullopt;
    const double value = row->values.at(static_cast<std::size_t>(column - columns.begin()));
    if (value == 0.0) return std::nullopt;
    return unit == PrintedUnit::Seconds ? 1000.0 * value : 1000.0 / value;
}

bool PrintedTable::names(std::string_view surface, std::string_view tracer) const {
    return std::ranges::count(rows, surface, &PrintedRow::surface) > 0 &&
           std::ranges::count(columns, tracer, &PrintedColumn::tracer) > 0;
}

std::string name_of(VoxelMethod method) { return nlohmann::json(method).get<std::string>(); }

const PrintedTables& printed_tables() {
    static const auto tables =
        nlohmann::json::parse(printed_tables_file().front()).get<PrintedTables>();
    return tables;
}

}  // namespace zeroset
