#include "engine/volume/made_volumes.hpp"

#include "engine/base/parallel.hpp"
#include "engine/real/rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// Fills the cube with value(x, y, z), on all cores.
void fill_with(std::span<float> samples, std::uint64_t size, double half_edge, auto value) {
    const double step = 2 * half_edge / static_cast<double>(size - 1);
    const auto at = [&](std::uint64_t i) { return static_cast<double>(i) * step - half_edge; };
    parallel_for(size, 0, [&](std::size_t k) {
        const NearestRounding nearest;
        for (std::uint64_t j = 0; j < size; ++j) {
            for (std::uint64_t i = 0; i < size; ++i) {
                samples[(k * size + j) * size + i] = static_cast<float>(value(at(i), at(j), at(k)));
            }
        }
    });
}

/// The test signal of [MarLob94], with their frequency 6 and amplitude 1/4.
void fill_marschner_lobb(std::span<float> samples, std::uint64_t size, double half_edge) {
    constexpr double pi = std::numbers::pi;
    fill_with(samples, size, half_edge, [](double x, double y, double z) {
        const double r = std::sqrt(x * x + y * y);
        const double ripple = std::cos(2 * pi * 6 * std::cos(pi * r / 2));
        return (1 - std::sin(pi * z / 2) + 0.25 * (1 + ripple)) / (2 * (1 + 0.25));
    });
}

/// A number from 0 to 1 for each point of a lattice.
double lattice_number(std::int64_t i, std::int64_t j, std::int64_t k) {
    auto bits = static_cast<std::uint64_t>(i * 73856093) ^
                static_cast<std::uint64_t>(j * 19349663) ^ static_cast<std::uint64_t>(k * 83492791);
    bits = (bits ^ (bits >> 31U)) * 0x7fb5d329728ea185ULL;
    bits = (bits ^ (bits >> 27U)) * 0x81dadef4bc2dd44dULL;
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// Smooth noise between the points of the lattice of whole numbers.
double noise(double x, double y, double z) {
    const std::array from{std::floor(x), std::floor(y), std::floor(z)};
    const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
    const std::array t{smooth(x - from[0]), smooth(y - from[1]), smooth(z - from[2])};
    double sum = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::array<std::int64_t, 3> index{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const unsigned next = corner >> axis & 1U;
            index[axis] = static_cast<std::int64_t>(from[axis]) + next;
            weight *= next == 1 ? t[axis] : 1 - t[axis];
        }
        sum += weight * lattice_number(index[0], index[1], index[2]);
    }
    return sum;
}

/// Spongy bone with a firm shell, as a scanner shows it: 0 is air, 1 bone.
void fill_bone(std::span<float> samples, std::uint64_t size, double half_edge) {
    fill_with(samples, size, half_edge, [](double x, double y, double z) {
        // A shaft that is wider at both ends
        const double width = 0.42 + 0.3 * z * z + 0.05 * noise(3 * x + 7, 3 * y, 3 * z);
        const double depth = width - std::sqrt(x * x + 1.3 * y * y);
        const double ends = 0.93 - std::abs(z);
        const double inside = std::min(depth, ends);
        const double shell = std::exp(-900 * (inside - 0.05) * (inside - 0.05));
        const double turn = 15 + 2 * noise(2 * x, 2 * y, 2 * z + 5);
        const double web =
            std::sin(turn * x + 3 * noise(5 * x, 5 * y, 5 * z)) * std::cos(turn * y) +
            std::sin(turn * y) * std::cos(turn * z + 2) + std::sin(turn * z) * std::cos(turn * x);
        const double sponge = 1 / (1 + std::exp(18 * (std::abs(web) - 0.28)));
        const double within = 1 / (1 + std::exp(-60 * (inside - 0.04)));
        const double grain = 0.06 * (noise(60 * x, 60 * y, 60 * z) - 0.5);
        return std::max(shell, 0.85 * sponge * within) + grain;
    });
}

/// The wave function of a hydrogen atom for n = 4, l = 3, m = 2 (real form), in Bohr radii, scaled.
void fill_orbital(std::span<float> samples, std::uint64_t size, double half_edge) {
    fill_with(samples, size, half_edge, [](double x, double y, double z) {
        const double r = std::sqrt(x * x + y * y + z * z);
        return z * (x * x - y * y) * std::exp(-r / 4) / 35;
    });
}

/// The 60 corners of a truncated icosahedron, at a distance of 3.55 from the origin.
std::vector<std::array<double, 3>> carbon_places() {
    constexpr double g = std::numbers::phi;
    const std::array<std::array<double, 3>, 3> kinds{
        {{0, 1, 3 * g}, {1, 2 + g, 2 * g}, {2, 1 + 2 * g, g}}};
    std::vector<std::array<double, 3>> places;
    for (const auto& kind : kinds) {
        for (std::size_t turn = 0; turn < 3; ++turn) {
            for (unsigned signs = 0; signs < 8; ++signs) {
                if (kind[0] == 0 && (signs & 1U) != 0) continue;
                std::array<double, 3> place{};
                for (std::size_t i = 0; i < 3; ++i) {
                    const double size = kind[i] * 3.55 / std::sqrt(9 * g + 10);
                    place[(i + turn) % 3] = (signs >> i & 1U) != 0 ? -size : size;
                }
                places.push_back(place);
            }
        }
    }
    return places;
}

/// The density of electrons about the atoms of C60, in Angstrom, as a sum of bells.
void fill_atoms(std::span<float> samples, std::uint64_t size, double half_edge) {
    const double step = 2 * half_edge / static_cast<double>(size - 1);
    std::vector<std::array<std::vector<double>, 3>> bells;
    for (const auto& place : carbon_places()) {
        auto& bell = bells.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::uint64_t i = 0; i < size; ++i) {
                const double x = static_cast<double>(i) * step - half_edge - place[axis];
                bell[axis].push_back(std::exp(-2.2 * x * x));
            }
        }
    }
    parallel_for(size, 0, [&](std::size_t k) {
        std::vector<double> row(size);
        for (std::uint64_t j = 0; j < size; ++j) {
            std::ranges::fill(row, 0.0);
            for (const auto& [x, y, z] : bells) {
                const double factor = y[j] * z[k];
                if (factor < 1e-12) continue;
                for (std::uint64_t i = 0; i < size; ++i)
                    row[i] += factor * x[i];
            }
            for (std::uint64_t i = 0; i < size; ++i)
                samples[(k * size + j) * size + i] = static_cast<float>(row[i]);
        }
    });
}

constexpr std::array all_made{
    MadeVolume{
        .name = "marschner_lobb", .usual_size = 64, .half_edge = 1, .fill = fill_marschner_lobb},
    MadeVolume{.name = "bone", .usual_size = 128, .half_edge = 1, .fill = fill_bone},
    MadeVolume{.name = "orbital", .usual_size = 96, .half_edge = 28, .fill = fill_orbital},
    MadeVolume{.name = "atoms", .usual_size = 96, .half_edge = 5, .fill = fill_atoms}};

std::expected<std::shared_ptr<const VolumeData>, std::string> made(const MadeVolume& volume,
                                                                   std::uint64_t size) {
    const auto numbers = std::make_shared<std::vector<float>>(size * size * size);
    volume.fill(*numbers, size, volume.half_edge);
    Geometry place;
    for (std::size_t i = 0; i < 3; ++i) {
        place.world_from_index[i][i] = 2 * volume.half_edge / static_cast<double>(size - 1);
        place.origin[i] = -volume.half_edge;
    }
    return VolumeData::make({.type = SampleType::Float,
                             .size = {size, size, size},
                             .data = std::shared_ptr<const void>(numbers, numbers->data())},
                            place);
}

}  // namespace

std::span<const MadeVolume> made_volumes() { return all_made; }

std::expected<std::shared_ptr<const VolumeData>, std::string> made_volume(
    std::string_view name, std::optional<std::uint64_t> size) {
    static std::mutex mutex;
    static std::map<std::pair<std::string_view, std::uint64_t>, std::weak_ptr<const VolumeData>>
        known;
    const auto* const found = std::ranges::find(all_made, name, &MadeVolume::name);
    if (found == all_made.end()) {
        std::string names;
        for (const MadeVolume& volume : all_made)
            names += (names.empty() ? "@" : ", @") + std::string(volume.name);
        return std::unexpected("there is no such volume; the program makes " + names);
    }
    const std::uint64_t edge = size.value_or(found->usual_size);
    if (edge < 2 || edge > largest_made_size) {
        return std::unexpected("its size is from 2 to " + std::to_string(largest_made_size) +
                               " samples along each edge");
    }
    const std::scoped_lock lock(mutex);
    auto& kept = known[{found->name, edge}];
    if (auto data = kept.lock()) return data;
    auto data = made(*found, edge);
    if (data) kept = *data;
    return data;
}

}  // namespace zeroset
