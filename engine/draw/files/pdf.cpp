#include "engine/draw/files/pdf.hpp"

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

/// Draws in a unit that is smaller than a point, as libharu's dashes are whole numbers up to 100.
class PdfPage {
public:
    PdfPage(HPDF_Page page, const LineDrawing& drawing, const DrawingStyle& style)
        : page_(page), drawing_(drawing), units_(most / (dash_share * style.width_pt)) {
        const auto scale = static_cast<HPDF_REAL>(1.0 / units_);
        const auto height = static_cast<HPDF_REAL>(drawing.size.height);
        HPDF_Page_SetWidth(page_, static_cast<HPDF_REAL>(drawing.size.width));
        HPDF_Page_SetHeight(page_, height);
        HPDF_Page_Concat(page_, scale, 0, 0, -scale, 0, height);
        HPDF_Page_SetLineCap(page_, HPDF_ROUND_END);
        HPDF_Page_SetLineJoin(page_, HPDF_ROUND_JOIN);
    }
    void draw(const LineGroup& group);

private:
    static constexpr double most = 96.0;
    static constexpr double dash_share = 3.0;  ///< the longest dash, in widths

    [[nodiscard]] HPDF_REAL unit(double points) const {
        return static_cast<HPDF_REAL>(units_ * points);
    }
    [[nodiscard]] HPDF_UINT16 whole_unit(double points) const {
        return static_cast<HPDF_UINT16>(std::lround(units_ * points));
    }
    void draw(const DrawnPath& path);

    HPDF_Page page_;
    const LineDrawing& drawing_;
    double units_;  ///< for a point
};

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
    const std::array<HPDF_UINT16, 2> dashes{whole_unit(group.dash_pt), whole_unit(group.gap_pt)};
    const bool is_dashed = group.dash_pt > 0.0;
    HPDF_Page_SetDash(page_, is_dashed ? dashes.data() : nullptr, is_dashed ? 2 : 0, 0);
    for (const DrawnPath& path : drawing_.paths) {
        if (path.kind == group.kind && path.hidden == group.hidden) draw(path);
    }
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
    if (!document) return std::unexpected("there is no memory for a PDF");
    HPDF_SetCompressionMode(document.get(), HPDF_COMP_ALL);
    PdfPage page(HPDF_AddPage(document.get()), drawing, style);
    for (const LineGroup& group : line_groups(style))
        page.draw(group);
    std::string bytes = bytes_of(document.get());
    const HPDF_STATUS error = HPDF_GetError(document.get());
    if (error != HPDF_OK || bytes.empty()) {
        return std::unexpected("the PDF library gave error " + std::to_string(error));
    }
    return bytes;
}

}  // namespace zeroset
