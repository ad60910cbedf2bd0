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

/// The endings of a kind's files that this program can write, as ".png, .jpg or .exr"; may be
/// empty.
std::string export_endings(ExportKind kind);

/// The endings of this kind's formats that have this member, as &ExportFormat::alpha.
std::string export_endings(ExportKind kind, bool ExportFormat::* has);

/// "; it is for .jpg or .webp", of an option that the formats with this member have; empty where
/// there is none.
std::string export_use(ExportKind kind, bool ExportFormat::* has);

/// The endings of a kind's files that this program cannot write, with the reason: "no .gif: this
/// Zeroset was built without FFmpeg"; empty where it can write all.
std::string missing_endings(ExportKind kind);

/// A hint on what to type instead of a path of which this kind has no format: "type a name that
/// ends in ...", and the command for files with that ending, if there is one. For films
/// "name####.png", which stands for numbered pictures, is one of the names.
std::string other_name(ExportKind kind, const std::filesystem::path& path);

}  // namespace zeroset
