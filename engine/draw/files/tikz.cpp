#include "engine/draw/files/encoders.hpp"

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace zeroset {
namespace {

/// Writes the parts of a file. Lengths are in bp, TeX's name of 1/72 inch.
class TikzWriter {
public:
    TikzWriter(const LineDrawing& drawing, const DrawingStyle& style)
        : drawing_(drawing), style_(style), decimals_(decimals(style)) {}

    std::string run() {
        text_ =
            "% \\input in a document with \\usepackage{tikz}\n"
            "\\begin{tikzpicture}[x=1bp,y=-1bp,line cap=round,line join=round]\n"
            "\\clip (0,0) rectangle " +
            place({drawing_.size.width, drawing_.size.height}) + ";\n";
        if (style_.background) {
            text_ += "\\definecolor{background}{HTML}{" + hex_digits(*style_.background) +
                     "}\n\\fill[background] (0,0) rectangle " +
                     place({drawing_.size.width, drawing_.size.height}) + ";\n";
        }
        write_lines();
        for (const LineGroup& group : line_groups(drawing_, style_))
            write_group(group);
        write_texts();
        return std::move(text_) + "\\end{tikzpicture}\n";
    }

private:
    void write_lines();
    void write_texts();
    void write_group(const LineGroup& group);
    void write_path(const DrawnPath& path);
    [[nodiscard]] std::string number(double value) const { return file_number(value, decimals_); }
    [[nodiscard]] static std::string width(double value) {
        return file_number(value, width_decimals);
    }
    [[nodiscard]] std::string place(const glm::dvec2& at) const {
        return "(" + number(at.x) + "," + number(at.y) + ")";
    }

    const LineDrawing& drawing_;
    const DrawingStyle& style_;
    int decimals_;
    std::string text_;
};

/// The option of TikZ for a colour 0xRRGGBB.
std::string color_of(std::uint32_t color) {
    return "color={rgb,255:red," + std::to_string(color >> 16U & 255U) + ";green," +
           std::to_string(color >> 8U & 255U) + ";blue," + std::to_string(color & 255U) + "}";
}

void TikzWriter::write_lines() {
    for (const DrawnLine& line : drawing_.marks.lines) {
        const auto width_pt = shown_width(line, style_);
        if (!width_pt) continue;
        text_ += "\\draw[" + color_of(line.color) + ",line width=" + width(*width_pt) + "bp] " +
                 place(line.from) + " -- " + place(line.to) + ";\n";
    }
}

/// The words as TeX has to read them: numbers and single letters as formulas, pi and the minus by
/// their names.
std::string tex_of(const std::string& words) {
    const auto replace = [](std::string text, std::string_view from, std::string_view to) {
        for (std::size_t at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
        return text;
    };
    std::string text;
    for (const char letter : words) {
        if (letter == '\\') {
            text += "\\textbackslash{}";
        } else if (letter == '^' || letter == '~') {
            text += std::string("\\") + letter + "{}";
        } else {
            if (std::string_view("&%$#_{}").contains(letter)) text += '\\';
            text += letter;
        }
    }
    const bool is_number =
        words.find_first_not_of("0123456789.,/e+-\u2212\u03C0") == std::string::npos;
    const bool is_letter =
        words.size() == 1 && std::isalpha(static_cast<unsigned char>(words[0])) != 0;
    if (!is_number && !is_letter) return text;
    text = replace(replace(text, "\u2212", "-"), "\u03C0", "\\pi ");
    return "$" + replace(text, ",", "{,}") + "$";
}

void TikzWriter::write_texts() {
    for (const DrawnText& text : drawing_.marks.texts) {
        text_ += "\\node[" + color_of(text.color) + ",inner sep=0,font=\\fontsize{" +
                 width(text.em_pt) + "}{" + width(1.2 * text.em_pt) + "}\\selectfont] at " +
                 place(text.middle) + " {" + tex_of(text.words) + "};\n";
    }
}

void TikzWriter::write_group(const LineGroup& group) {
    const std::size_t before = text_.size();
    text_ += std::string(group.hidden ? "% hidden " : "% visible ") +
             std::string(name_of(group.kind)) +
             "\n\\begin{scope}[line width=" + width(group.width_pt) + "bp";
    if (group.dash_pt > 0.0) {
        text_ +=
            ",dash pattern=on " + width(group.dash_pt) + "bp off " + width(group.gap_pt) + "bp";
    }
    text_ += "]\n";
    const std::size_t empty = text_.size();
    for (const DrawnPath& path : drawing_.paths) {
        if (path.kind == group.kind && path.hidden == group.hidden) write_path(path);
    }
    if (text_.size() == empty) {
        text_.resize(before);
    } else {
        text_ += "\\end{scope}\n";
    }
}

void TikzWriter::write_path(const DrawnPath& path) {
    text_ += "\\draw " + place(path.pieces.front()[0]);
    for (std::size_t i = 0; i < path.pieces.size(); ++i) {
        const Bezier& c = path.pieces[i];
        const bool closes = path.closed && i + 1 == path.pieces.size();
        text_ += "\n  .. controls " + place(c[1]) + " and " + place(c[2]) + " .. " +
                 (closes ? "cycle" : place(c[3]));
    }
    text_ += ";\n";
}

}  // namespace

std::string tikz_of(const LineDrawing& drawing, const DrawingStyle& style) {
    return TikzWriter(drawing, style).run();
}

}  // namespace zeroset
