#pragma once

#include "engine/level_sets/level_set_file.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"

#include <cstddef>
#include <optional>

namespace zeroset {

/// The surfaces that the request shows as level sets, each the side that sections fill, in the clip
/// box, whose longest edge gets `size_mm`. `surface`: only that of this number, from 1 on. Says in
/// one line what cannot be one. Thread-safe.
OrInputError<LevelSetFile> level_sets_of(const PictureRequest& request, double size_mm,
                                         std::optional<std::size_t> surface = std::nullopt);

/// The bytes of a file of them, or one line on the first thing that it cannot say. Thread-safe.
OrInputError<EncodedLevelSets> encoded_level_sets_of(
    const PictureRequest& request, double size_mm,
    std::optional<std::size_t> surface = std::nullopt);

}  // namespace zeroset
