#pragma once

#include "app/cli/commands.hpp"
#include "pipeline/plans/film_files.hpp"
#include "pipeline/plans/film_plan.hpp"
#include "pipeline/plans/frame_ranges.hpp"

namespace zeroset {

/// The frames to be drawn, counted from 0, both ends included.
struct FrameRange {
    int first = 0;
    int last = 0;
};

/// Reads what changes in the film. `document`: whose parameters are swept.
OrInputError<FilmPlan> read_film_plan(const FilmCommand& command, const InputDocument& document);

/// Reads which of the plan's frames are drawn.
OrInputError<FrameRange> read_frame_range(const FilmCommand& command, const FilmPlan& plan);

/// Reads how many frames share what is proved empty.
OrInputError<FrameRangeChoice> read_frame_range_choice(const FilmCommand& command);

/// Reads where the frames go.
OrInputError<FilmTarget> read_film_target(const FilmCommand& command, const Size& size,
                                          const FilmPlan& plan);

}  // namespace zeroset
