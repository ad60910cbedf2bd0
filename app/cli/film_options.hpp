#pragma once

#include "app/cli/commands.hpp"
#include "engine/export/films/film_formats.hpp"
#include "engine/export/films/frame_names.hpp"
#include "engine/export/pictures/picture_formats.hpp"
#include "pipeline/plans/film_plan.hpp"

#include <optional>

namespace zeroset {

/// The file, or files, that frames go into.
struct FilmTarget {
    const FilmFormat* film = nullptr;  ///< nullptr: numbered pictures
    FilmSettings settings;
    std::optional<FrameNames> names;
    const PictureFormat* picture = nullptr;
    PictureOptions picture_options;
};

/// The frames to be drawn, counted from 0, both ends included.
struct FrameRange {
    int first = 0;
    int last = 0;
};

/// Reads what changes in the film. `document`: whose parameters are swept.
OrInputError<FilmPlan> read_film_plan(const FilmCommand& command, const InputDocument& document);

/// Reads which of the plan's frames are drawn.
OrInputError<FrameRange> read_frame_range(const FilmCommand& command, const FilmPlan& plan);

/// Reads where the frames go.
OrInputError<FilmTarget> read_film_target(const FilmCommand& command, const Size& size,
                                          const FilmPlan& plan);

}  // namespace zeroset
