#pragma once

#include "engine/volume/volume.hpp"

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace zeroset {

/// A volume that the program makes itself, so that there is one to look at without a file.
struct MadeVolume {
    std::string_view name;
    std::uint64_t usual_size;  ///< samples along each edge
    double half_edge;          ///< of its cube about the origin
    /// The samples of a cube of `size`^3, i running fastest.
    void (*fill)(std::span<float> samples, std::uint64_t size, double half_edge);
};

/// All of them.
std::span<const MadeVolume> made_volumes();

inline constexpr std::uint64_t largest_made_size = 1024;

/// The one called `name`, with `size` samples (2 to largest_made_size) along each edge or with the
/// usual number; while it lives, it is given again. An error is one line. Thread-safe.
std::expected<std::shared_ptr<const VolumeData>, std::string> made_volume(
    std::string_view name, std::optional<std::uint64_t> size);

}  // namespace zeroset
