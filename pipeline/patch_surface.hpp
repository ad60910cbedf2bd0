#pragma once

#include "engine/kernel/kernel.hpp"
#include "engine/language/parse.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace zeroset {

/// Whether a surface of a program is a parametric one.
bool is_patch(const Program& program, std::size_t surface);

/// The code of a parametric surface: interpreted until it has been used for long enough.
Kernel patch_code(const PatchGraphs& graphs);
/// The same, always interpreted.
Kernel interpreted_patch(const PatchGraphs& graphs);

/// Why something cannot be made of what a picture shows: one of its surfaces is a parametric one.
/// `what`: the beginning of the line, translated. Nothing: there is none.
std::optional<InputError> patch_refusal(const PictureRequest& request, const std::string& what);

}  // namespace zeroset
