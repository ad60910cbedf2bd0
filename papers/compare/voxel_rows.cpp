#include "papers/compare/voxel_rows.hpp"

#include "papers/compare/text_columns.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

/// The corners that are 1, as bits.
constexpr std::array<unsigned, 7> marching_cubes{0x01, 0x03, 0x09, 0x81, 0x07, 0x0f, 0x69};

/// A number from 0 to 1.
float share(std::mt19937& random) { return static_cast<float>(random() >> 8U) * 0x1p-24F; }

/// A point of a face of the unit cube: 0 and 1 are those across axis 0, and so on.
std::array<float, 3> face_point(unsigned face, std::mt19937& random) {
    std::array<float, 3> point{share(random), share(random), share(random)};
    point[face / 2] = static_cast<float>(face % 2);
    return point;
}

VoxelRay random_ray(unsigned corners, std::mt19937& random) {
    VoxelRay ray;
    for (unsigned i = 0; i < 8; ++i)
        ray.rho[i] = (corners >> i & 1U) != 0 ? 0.5F : -0.5F;
    const auto entry = static_cast<unsigned>(random() % 6);
    const auto exit = static_cast<unsigned>((entry + 1 + random() % 5) % 6);
    ray.a = face_point(entry, random);
    const auto end = face_point(exit, random);
    for (std::size_t i = 0; i < 3; ++i)
        ray.b[i] = end[i] - ray.a[i];
    ray.t_out = 1;
    return ray;
}

std::vector<TextColumn> columns_of(const VoxelTable& table) {
    std::vector<TextColumn> columns{{"scene", "/scene", -15},
                                    {"method", "/method", -10},
                                    {"min", "/millions_per_s/min", 8, 2},
                                    {"max", "/millions_per_s/max", 8, 2},
                                    {"avg", "/millions_per_s/avg", 8, 2}};
    for (const std::string& printed : table.columns)
        columns.emplace_back(printed, "/printed/" + printed, 9, 2);
    columns.insert(columns.end(), {{"voxels", "/voxels", 9},
                                   {"roots", "/roots", 9},
                                   {"missed", "/of_1000/missed", 8, 2},
                                   {"added", "/of_1000/added", 8, 2},
                                   {"moved", "/of_1000/moved", 8, 2}});
    return columns;
}

Json json_of(const VoxelTable& table, const VoxelRow& row) {
    const VoxelCounts& counts = row.counts;
    const auto of_1000 = [&](std::size_t part) {
        return 1000.0 * static_cast<double>(part) / static_cast<double>(counts.voxels);
    };
    Json printed;
    for (std::size_t i = 0; i < 3; ++i)
        printed[table.columns[i]] = row.printed->millions[i];
    return {{"scene", row.scene},
            {"method", name_of(row.printed->method)},
            {"millions_per_s", {{"min", row.least}, {"max", row.most}, {"avg", row.mean}}},
            {"printed", printed},
            {"voxels", counts.voxels},
            {"roots", counts.roots},
            {"unknown", counts.unknown},
            {"missed", counts.missed},
            {"added", counts.added},
            {"moved", counts.moved},
            {"of_1000",
             {{"missed", of_1000(counts.missed)},
              {"added", of_1000(counts.added)},
              {"moved", of_1000(counts.moved)}}}};
}

}  // namespace

void VoxelCounts::add(const VoxelRay& ray, const ProvedRoot& proved, double t) {
    ++voxels;
    const bool found = t < std::numeric_limits<double>::infinity();
    switch (proved.kind) {
        case ProvedRoot::Kind::Unknown: ++unknown; return;
        case ProvedRoot::Kind::None: added += found ? 1 : 0; return;
        case ProvedRoot::Kind::Root: break;
    }
    ++roots;
    const double speed = std::hypot(static_cast<double>(ray.b[0]), static_cast<double>(ray.b[1]),
                                    static_cast<double>(ray.b[2]));
    if (!found) {
        ++missed;
    } else if (std::abs(t - proved.t) * speed > moved_by) {
        ++moved;
    }
}

std::vector<VoxelRays> synthetic_voxels(std::size_t rays, std::size_t at_once) {
    std::mt19937 random(1);
    std::vector<VoxelRays> all;
    for (const unsigned corners : marching_cubes) {
        for (std::size_t i = 0; i < rays; ++i) {
            if (i % at_once == 0) all.emplace_back();
            all.back().add(random_ray(corners, random));
        }
    }
    for (VoxelRays& list : all)
        list.pad();
    return all;
}

std::vector<ProvedRoot> proved_roots(std::span<const VoxelRays> voxels) {
    std::vector<ProvedRoot> proved;
    for (const VoxelRays& list : voxels) {
        for (std::size_t i = 0; i < list.count(); ++i)
            proved.push_back(proved_first_root(list.ray(i)));
    }
    return proved;
}

VoxelRow measured_voxels(const VoxelTable& table, const PrintedVoxels& printed,
                         std::span<const VoxelRays> voxels, std::span<const ProvedRoot> proved) {
    constexpr int times = 40;
    VoxelRow row;
    row.printed = &printed;
    row.least = std::numeric_limits<double>::max();
    double seconds = 0;
    std::vector<float> t;
    for (const VoxelRays& list : voxels) {
        t.resize(list.size());
        find_first_hits(printed.method, table.rays, list, t);
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < times; ++i)
            find_first_hits(printed.method, table.rays, list, t);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        const double millions = 1e-6 * times * static_cast<double>(list.count()) / taken.count();
        row.least = std::min(row.least, millions);
        row.most = std::max(row.most, millions);
        seconds += taken.count();
        for (std::size_t i = 0; i < list.count(); ++i) {
            row.counts.add(list.ray(i), proved[row.counts.voxels], static_cast<double>(t[i]));
        }
    }
    row.mean = 1e-6 * times * static_cast<double>(row.counts.voxels) / seconds;
    return row;
}

std::string voxel_heading_text(const VoxelTable& table) {
    return table.source + " (" + table.machine + "): " + table.note +
           ".\nMillions of intersections a second, here and as printed; voxels with a proved first "
           "root, and of those missed\nand moved (farther from it than a hundredth of a voxel's "
           "edge); added: a root where none is, in 1000 voxels each.\n\n" +
           title_line(columns_of(table));
}

std::string voxel_row_text(const VoxelTable& table, const VoxelRow& row) {
    return row_line(columns_of(table), json_of(table, row));
}

std::string voxel_frames_text(const std::vector<ComparedRow>& frames) {
    const std::array<TextColumn, 7> columns{{{"scene", "/surface", -15},
                                             {"tracer", "/tracer", -17},
                                             {"ms", "/frame_ms/median", 9, 2},
                                             {"missed", "/missed", 8},
                                             {"added", "/added", 8},
                                             {"moved", "/moved", 8},
                                             {"certified", "/certified", 9}}};
    std::string text = title_line(columns);
    for (const ComparedRow& frame : frames)
        text += row_line(columns, json_of(frame));
    return text;
}

Json json_of(const VoxelTable& table, const std::vector<VoxelRow>& rows,
             const std::vector<ComparedRow>& frames) {
    Json json_rows = Json::array();
    for (const VoxelRow& row : rows)
        json_rows.push_back(json_of(table, row));
    Json json_frames = Json::array();
    for (const ComparedRow& frame : frames)
        json_frames.push_back({{"scene", frame.surface},
                               {"tracer", frame.tracer},
                               {"frame_ms", frame.median_ms},
                               {"missed", frame.wrong.missed},
                               {"added", frame.wrong.added},
                               {"moved", frame.wrong.moved}});
    return {{"table", table.name}, {"source", table.source}, {"machine", table.machine},
            {"note", table.note},  {"rows", json_rows},      {"frames", json_frames}};
}

}  // namespace zeroset
