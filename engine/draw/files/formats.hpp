#pragma once

#include "engine/draw/files/drawing_style.hpp"

#include <expected>
#include <span>
#include <string>
#include <string_view>

namespace zeroset {

/// A kind of file that a drawing can be written to.
struct DrawingFormat {
    std::string_view ending;  ///< of file names, with the point
    std::string_view name;    ///< as a dialog lists it
    std::string_view about;   ///< what it is good for
    /// The bytes of the file, or the reason why they cannot be made.
    std::expected<std::string, std::string> (*encode)(const LineDrawing& drawing,
                                                      const DrawingStyle& style);
};

/// All formats: the dialog, the command line and the help read this table.
std::span<const DrawingFormat> drawing_formats();
/// The format of a file name's ending, in capitals, too; nullptr where there is none.
const DrawingFormat* find_drawing_format(std::string_view path);

}  // namespace zeroset
