#include "engine/base/translation.hpp"
#include "engine/draw/files/encoders.hpp"

#include <hpdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace zeroset {
namespace {

struct FreeDocument {
    void operator()(HPDF_Doc document) const { HPDF_Free(document); }
};
using Document = std::unique_ptr<std::remove_pointer_t<HPDF_Doc>, FreeDocument>;

/// The unit in which a page with dashes is drawn, in points. libharu's dashes are whole numbers up
/// to 100, so it is a small part of the longest; and its numbers have five digits after the point,
/// so it is 1, 2 or 5 x 10^n.
double unit_for(const std::vector<LineGroup>& groups) {
    constexpr double most = 100.0;
    double longest = 0.0;
    for (const LineGroup& group : groups)
        longest = std::max({longest, group.dash_pt, group.gap_pt});
    if (longest == 0.0) return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(longest / most)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power * most >= longest) return digit * power;
    }
    return 10.0 * power;
}

/// Calls HPDF_Page_SetDash, whose numbers are integers up to libharu 2.3 and floats since.
template <class Length, class Phase>
void set_dashes(HPDF_STATUS (*set)(HPDF_Page, const Length*, HPDF_UINT, Phase), HPDF_Page page,
                double dash, double gap) {
    const std::array<Length, 2> lengths{static_cast<Length>(std::round(dash)),
                                        static_cast<Length>(std::round(gap))};
    const bool is_dashed = dash > 0.0;
    set(page, is_dashed ? lengths.data() : nullptr, is_dashed ? 2 : 0, 0);
}

class PdfPage {
public:
    PdfPage(HPDF_Page page, const LineDrawing& drawing, double unit_pt)
        : page_(page), drawing_(drawing), units_(1.0 / unit_pt) {
        const auto scale = static_cast<HPDF_REAL>(unit_pt);
        const auto height = static_cast<HPDF_REAL>(drawing.size.height);
        HPDF_Page_SetWidth(page_, static_cast<HPDF_REAL>(drawing.size.width));
        HPDF_Page_SetHeight(page_, height);
        HPDF_Page_Concat(page_, scale, 0, 0, -scale, 0, height);
        HPDF_Page_SetLineCap(page_, HPDF_ROUND_END);
        HPDF_Page_SetLineJoin(page_, HPDF_ROUND_JOIN);
    }
    void fill(std::uint32_t color);
    void draw(const LineGroup& group);
    void draw(const DrawnLine& line, double width_pt);
    void draw(const DrawnText& text, HPDF_Font font);

private:
    [[nodiscard]] HPDF_REAL unit(double points) const {
        return static_cast<HPDF_REAL>(units_ * points);
    }
    void draw(const DrawnPath& path);

    HPDF_Page page_;
    const LineDrawing& drawing_;
    double units_;  ///< for a point
};

HPDF_REAL channel(std::uint32_t color, unsigned shift) {
    return static_cast<HPDF_REAL>(color >> shift & 0xFFU) / 255.0F;
}

void PdfPage::draw(const DrawnLine& line, double width_pt) {
    HPDF_Page_SetRGBStroke(page_, channel(line.color, 16), channel(line.color, 8),
                           channel(line.color, 0));
    HPDF_Page_SetLineWidth(page_, unit(width_pt));
    HPDF_Page_MoveTo(page_, unit(line.from.x), unit(line.from.y));
    HPDF_Page_LineTo(page_, unit(line.to.x), unit(line.to.y));
    HPDF_Page_Stroke(page_);
    HPDF_Page_SetRGBStroke(page_, 0.0F, 0.0F, 0.0F);
}

/// The page's y axis points downwards, letters upwards.
void PdfPage::draw(const DrawnText& text, HPDF_Font font) {
    HPDF_Page_SetRGBFill(page_, channel(text.color, 16), channel(text.color, 8),
                         channel(text.color, 0));
    HPDF_Page_BeginText(page_);
    HPDF_Page_SetFontAndSize(page_, font, unit(text.em_pt));
    const HPDF_REAL wide = HPDF_Page_TextWidth(page_, text.words.c_str());
    const HPDF_REAL x = unit(text.middle.x) - 0.5F * wide;
    const HPDF_REAL y = unit(text.middle.y + below_middle_em * text.em_pt);
    HPDF_Page_SetTextMatrix(page_, 1, 0, 0, -1, x, y);
    HPDF_Page_ShowText(page_, text.words.c_str());
    HPDF_Page_EndText(page_);
}

void PdfPage::fill(std::uint32_t color) {
    HPDF_Page_SetRGBFill(page_, channel(color, 16), channel(color, 8), channel(color, 0));
    HPDF_Page_Rectangle(page_, 0, 0, unit(drawing_.size.width), unit(drawing_.size.height));
    HPDF_Page_Fill(page_);
}

void PdfPage::draw(const DrawnPath& path) {
    const glm::dvec2& first = path.pieces.front()[0];
    HPDF_Page_MoveTo(page_, unit(first.x), unit(first.y));
    for (const Bezier& c : path.pieces)
        HPDF_Page_CurveTo(page_, unit(c[1].x), unit(c[1].y), unit(c[2].x), unit(c[2].y),
                          unit(c[3].x), unit(c[3].y));
    path.closed ? HPDF_Page_ClosePathStroke(page_) : HPDF_Page_Stroke(page_);
}

void PdfPage::draw(const LineGroup& group) {
    HPDF_Page_SetLineWidth(page_, unit(group.width_pt));
    set_dashes(HPDF_Page_SetDash, page_, units_ * group.dash_pt, units_ * group.gap_pt);
    for (const DrawnPath& path : drawing_.paths) {
        if (path.kind == group.kind && path.hidden == group.hidden) draw(path);
    }
}

/// DejaVu Sans, of which the file gets the letters that it needs.
HPDF_Font letters(HPDF_Doc document) {
    HPDF_UseUTFEncodings(document);
    const char* const name =
        HPDF_LoadTTFontFromFile(document, ZEROSET_FONT_DIR "/DejaVuSans.ttf", HPDF_TRUE);
    return HPDF_GetFont(document, name, "UTF-8");
}

/// The file's bytes; empty where an error occurred.
std::string bytes_of(HPDF_Doc document) {
    HPDF_SaveToStream(document);
    HPDF_ResetStream(document);
    std::string bytes;
    std::array<HPDF_BYTE, 4096> part{};
    for (HPDF_UINT32 left = HPDF_GetStreamSize(document); left > 0;) {
        HPDF_UINT32 size = std::min(left, static_cast<HPDF_UINT32>(part.size()));
        HPDF_ReadFromStream(document, part.data(), &size);
        if (size == 0) return {};
        bytes.append(part.begin(), part.begin() + size);
        left -= size;
    }
    return bytes;
}

}  // namespace

std::expected<std::string, std::string> pdf_of(const LineDrawing& drawing,
                                               const DrawingStyle& style) {
    const Document document(HPDF_New(nullptr, nullptr));
    if (!document) return std::unexpected(tr("there is no memory for a PDF"));
    HPDF_SetCompressionMode(document.get(), HPDF_COMP_ALL);
    const std::vector<LineGroup> groups = line_groups(drawing, style);
    PdfPage page(HPDF_AddPage(document.get()), drawing, unit_for(groups));
    if (style.background) page.fill(*style.background);
    for (const DrawnLine& line : drawing.marks.lines) {
        if (const auto width_pt = shown_width(line, style)) page.draw(line, *width_pt);
    }
    for (const LineGroup& group : groups)
        page.draw(group);
    const HPDF_Font font = drawing.marks.texts.empty() ? nullptr : letters(document.get());
    for (const DrawnText& text : drawing.marks.texts)
        page.draw(text, font);
    std::string bytes = bytes_of(document.get());
    const HPDF_STATUS error = HPDF_GetError(document.get());
    if (error != HPDF_OK || bytes.empty()) {
        return std::unexpected(
            filled(tr("the PDF library gave error {0}"), {std::to_string(error)}));
    }
    return bytes;
}

}  // namespace zeroset
