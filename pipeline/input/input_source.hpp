#pragma once

#include "pipeline/volume_source.hpp"

#include <cstdint>
#include <string>

namespace zeroset {

/// The kind of thing that a text stands for, where the window or the command line takes an
/// equation.
enum class InputKind : std::uint8_t {
    Formula,
    Document,      ///< a session's file, or a picture that holds a session
    OtherProgram,  ///< a file, or a surface in it, of another program
    Volume,        ///< a file of samples, or a folder of slices
    Folder,
    Shared,         ///< a session as a line of text
    Gallery,        ///< @NAME
    OtherFile,      ///< a file of a kind that is not opened
    StandardInput,  ///< -
};

struct InputSource {
    InputKind kind = InputKind::Formula;
    /// Where its texts may name volumes: typed ones anywhere, a document or a shared session only
    /// beside it.
    VolumeFolder volumes;
};

/// Tells what a text stands for, by its form and by what files there are.
InputSource classify(const std::string& text);

/// The files that a document from a file may name: those beside it and below.
VolumeFolder volumes_beside(const std::filesystem::path& file);

}  // namespace zeroset
