#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace zeroset {

/// The kinds of files that are made of a session, for use elsewhere.
enum class ExportKind : std::uint8_t { Picture, Film, Mesh, Drawing };

/// A kind of file, and what can be chosen of it.
struct ExportFormat {
    ExportKind kind = ExportKind::Picture;
    std::string_view name;      ///< "PNG"
    std::string_view ending;    ///< ".png"
    std::string_view about;     ///< what it is good for
    std::array<int, 2> bits{};  ///< of a colour channel, the usual number first; 0: none to choose
    bool deep = false;          ///< there are two numbers of bits
    bool alpha = false;         ///< can be transparent
    bool quality = false;       ///< loses detail where less quality is wanted
    bool density = false;       ///< tells printers the dots per inch
    bool numbered = false;      ///< a file for each frame of a film
    bool even = false;          ///< both sides are even numbers of pixels
    std::string missing = {};   ///< why this program cannot write it; empty where it can
};

}  // namespace zeroset
