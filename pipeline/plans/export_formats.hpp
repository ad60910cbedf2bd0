#pragma once

#include "engine/export/export_format.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace zeroset {

/// All kinds of files that are written, each kind of export's usual one first. The writers' own
/// tables, of pictures, films, meshes and drawings, are behind it.
std::span<const ExportFormat> export_formats();

/// The format of the path's ending, in any case; nullptr where this kind has none.
const ExportFormat* export_format_of(ExportKind kind, const std::filesystem::path& path);

/// The endings of a kind's files, as ".png, .jpg or .exr".
std::string export_endings(ExportKind kind);

/// Those of the formats that have this member, as &ExportFormat::alpha.
std::string export_endings(ExportKind kind, bool ExportFormat::* has);

/// What to type instead of a path of which this kind has no format: "type a name that ends in
/// ...", and the command for files with that ending, if there is one.
std::string other_name(ExportKind kind, const std::filesystem::path& path);

}  // namespace zeroset
