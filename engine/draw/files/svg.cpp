#include "engine/draw/files/encoders.hpp"

namespace zeroset {
namespace {

/// Writes the parts of a file.
class SvgWriter {
public:
    SvgWriter(const LineDrawing& drawing, const DrawingStyle& style)
        : drawing_(drawing), style_(style), decimals_(decimals(style)) {}

    std::string run() {
        begin();
        write_lines();
        for (const LineGroup& group : line_groups(drawing_, style_))
            write_group(group);
        write_texts();
        return std::move(text_) + "</svg>\n";
    }

private:
    void begin();
    void write_lines();
    void write_texts();
    void write_group(const LineGroup& group);
    void write_path(const DrawnPath& path);
    [[nodiscard]] std::string number(double value) const { return file_number(value, decimals_); }
    [[nodiscard]] static std::string width(double value) {
        return file_number(value, width_decimals);
    }
    void write_point(const glm::dvec2& at) { text_ += number(at.x) + " " + number(at.y); }

    const LineDrawing& drawing_;
    const DrawingStyle& style_;
    int decimals_;
    std::string text_;
};

void SvgWriter::begin() {
    const std::string across = width(drawing_.size.width);
    const std::string down = width(drawing_.size.height);
    text_ =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"" +
        across + "pt\" height=\"" + down + "pt\" viewBox=\"0 0 " + across + " " + down + "\">\n";
    if (style_.background) {
        text_ += "<rect width=\"" + across + "\" height=\"" + down + "\" fill=\"#" +
                 hex_digits(*style_.background) + "\"/>\n";
    }
}

void SvgWriter::write_lines() {
    if (drawing_.marks.lines.empty()) return;
    text_ += R"(<g id="axes" stroke-linecap="round">)"
             "\n";
    for (const DrawnLine& line : drawing_.marks.lines) {
        const auto width_pt = shown_width(line, style_);
        if (!width_pt) continue;
        text_ += R"(<path fill="none" stroke="#)" + hex_digits(line.color) + R"(" stroke-width=")" +
                 width(*width_pt) + "\" d=\"M";
        write_point(line.from);
        text_ += "L";
        write_point(line.to);
        text_ += "\"/>\n";
    }
    text_ += "</g>\n";
}

/// The text with what XML would take for marks as entities.
std::string escaped(const std::string& words) {
    std::string text;
    for (const char letter : words) {
        switch (letter) {
            case '&': text += "&amp;"; break;
            case '<': text += "&lt;"; break;
            case '>': text += "&gt;"; break;
            default: text += letter;
        }
    }
    return text;
}

void SvgWriter::write_texts() {
    if (drawing_.marks.texts.empty()) return;
    text_ += R"(<g id="labels" font-family="DejaVu Sans, sans-serif" text-anchor="middle">)"
             "\n";
    for (const DrawnText& text : drawing_.marks.texts) {
        text_ += "<text x=\"" + number(text.middle.x) + "\" y=\"" +
                 number(text.middle.y + below_middle_em * text.em_pt) + "\" font-size=\"" +
                 width(text.em_pt) + "\" fill=\"#" + hex_digits(text.color) + "\">" +
                 escaped(text.words) + "</text>\n";
    }
    text_ += "</g>\n";
}

void SvgWriter::write_group(const LineGroup& group) {
    const std::size_t before = text_.size();
    text_ += std::string("<g id=\"") + (group.hidden ? "hidden-" : "visible-") +
             std::string(name_of(group.kind)) +
             "\" fill=\"none\" stroke=\"#000000\" stroke-linecap=\"round\" "
             "stroke-linejoin=\"round\" stroke-width=\"" +
             width(group.width_pt) + "\"";
    if (group.dash_pt > 0.0) {
        text_ += " stroke-dasharray=\"" + width(group.dash_pt) + " " + width(group.gap_pt) + "\"";
    }
    text_ += ">\n";
    const std::size_t empty = text_.size();
    for (const DrawnPath& path : drawing_.paths) {
        if (path.kind == group.kind && path.hidden == group.hidden) write_path(path);
    }
    if (text_.size() == empty) {
        text_.resize(before);
    } else {
        text_ += "</g>\n";
    }
}

void SvgWriter::write_path(const DrawnPath& path) {
    text_ += "<path class=\"surface-" + std::to_string(path.surface + 1) + "\" d=\"M";
    write_point(path.pieces.front()[0]);
    for (const Bezier& piece : path.pieces) {
        text_ += "C";
        for (const std::size_t i : {1UL, 2UL, 3UL}) {
            if (i > 1) text_ += " ";
            write_point(piece.at(i));
        }
    }
    text_ += path.closed ? "Z\"/>\n" : "\"/>\n";
}

}  // namespace

std::string svg_of(const LineDrawing& drawing, const DrawingStyle& style) {
    return SvgWriter(drawing, style).run();
}

}  // namespace zeroset
