#include "engine/draw/files/encoders.hpp"

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
        for (const LineGroup& group : line_groups(drawing_, style_))
            write_group(group);
        return std::move(text_) + "\\end{tikzpicture}\n";
    }

private:
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
