#include "engine/draw/files/formats.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/draw/files/encoders.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

using Encoded = std::expected<std::string, std::string>;

Encoded encode_svg(const LineDrawing& drawing, const DrawingStyle& style) {
    return svg_of(drawing, style);
}

Encoded encode_tikz(const LineDrawing& drawing, const DrawingStyle& style) {
    return tikz_of(drawing, style);
}

constexpr std::array formats{
    DrawingFormat{.ending = ".svg",
                  .name = "SVG",
                  .about = marked("for the web and to be edited"),
                  .encode = encode_svg},
    DrawingFormat{.ending = ".pdf",
                  .name = "PDF",
                  .about = marked("for papers: \\includegraphics"),
                  .encode = pdf_of},
    DrawingFormat{.ending = ".tex",
                  .name = "TikZ",
                  .about = marked("for papers: lines as text of LaTeX"),
                  .encode = encode_tikz},
};

}  // namespace

std::span<const DrawingFormat> drawing_formats() { return formats; }

const DrawingFormat* find_drawing_format(std::string_view path) {
    const std::string name = lower_case(path);
    const auto* const found = std::ranges::find_if(
        formats, [&](const DrawingFormat& format) { return name.ends_with(format.ending); });
    return found == formats.end() ? nullptr : found;
}

}  // namespace zeroset
