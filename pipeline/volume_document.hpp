#pragma once

#include "document/document.hpp"
#include "engine/language/parse.hpp"
#include "engine/volume/volume.hpp"
#include "pipeline/file_access.hpp"
#include "pipeline/input_error.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace zeroset {

/// Makes the clip box that of the volumes in the program's surfaces, if there are any, and that
/// which a plotting command in its text draws, if there is one; shows all of it.
void fit_to_program(const Program& program, Document& document);

/// The volumes of which parameters choose a value, by the parameter's name: that of `scan(x, y, z)
/// = a` is the one called a.
std::map<std::string, std::shared_ptr<const Volume>> isovalues(const Program& program);

/// A slider over all values of a volume.
Slider isovalue_slider(const Volume& volume);

/// A document of two rows that shows a volume: the file as a function, and the surface where that
/// is a, whose slider goes over its samples' range; its solid is above the value. Allows the file
/// from now on.
OrInputError<Document> document_of_volume(
    const std::filesystem::path& file,
    const std::shared_ptr<FileAccess>& access = std::make_shared<FileAccess>());

}  // namespace zeroset
