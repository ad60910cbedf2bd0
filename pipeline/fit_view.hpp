#pragma once

#include "document/document.hpp"
#include "engine/language/parse.hpp"
#include "engine/trace/time_limit.hpp"
#include "engine/view/box.hpp"
#include "pipeline/picture_request.hpp"

#include <atomic>
#include <optional>
#include <string>

namespace zeroset {

/// The clip box that plotting commands in a program's text ask for: their ranges, and where a graph
/// z = f(x, y) has none for z the heights that it reaches over them, without a few far ones and at
/// most twice its width. Axes that nothing is known of are those of the usual box. Nothing where no
/// command gives a range.
std::optional<Box> asked_box(const Program& program);

/// The clip box that suits the document's surfaces if they are all graphs z = f(x, y): the usual
/// one, as high as they are, as asked_box has it, and at least a quarter as high as wide.
std::optional<Box> graph_box(const Program& program, const Document& document);

/// One line that says what graph_box chose.
std::string graph_note(const Box& box);

/// Fits clip box and view to surfaces whose clip box nobody has chosen: to graphs by graph_box, to
/// others by frame_by_itself. Returns one line on what was done, or nothing where the usual box
/// suits them or `limit` was over before that was known.
std::string fit_by_itself(Document& document, const PictureRequest& request, double aspect,
                          const TimeLimit& limit);

/// The part of `limit` that fit_by_itself may take of a command that was not asked to fit anything.
TimeLimit own_fitting_limit(TimeLimit limit);

/// Makes the document's camera look at all of its surfaces, in a picture of this aspect (width /
/// height); `fits_box`: and fits the clip box to them. `request`: for a picture of the document.
/// Returns one line on why it cannot, or that surfaces go on beyond what is shown; else nothing.
std::string fit_view(Document& document, const PictureRequest& request, double aspect,
                     bool fits_box, const TimeLimit& limit);

}  // namespace zeroset
