#pragma once

#include "document/document.hpp"
#include "document/shown_point.hpp"
#include "engine/annotate/label_font.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/scene/coloring.hpp"
#include "engine/view/camera.hpp"

#include <array>
#include <expected>
#include <memory>
#include <string>
#include <vector>

namespace zeroset {

inline const std::optional<SectionValues> no_section_values;
inline const std::vector<ShownPoint> no_points;

/// The things that axes, markers and legend are made from, beside the frame itself.
struct FrameSubject {
    const Document& document;
    const Camera& camera;      ///< the camera that the frame was drawn with
    const Coloring& coloring;  ///< the frame's colouring, with the range of its values
    const Uniforms& uniforms;  ///< the frame's, of what contour lines are of
    const std::optional<SectionValues>& section_values = no_section_values;  ///< the frame's
    bool legend = true;  ///< draw a legend, if the colours stand for something
    const std::vector<ShownPoint>& points = no_points;  ///< whose names are drawn beside them
    std::array<bool, 3> of_pi{};  ///< axes whose numbers are multiples of pi, see periodic_axes
    /// Marks are painted for what is behind the picture shining through: what is painted has no
    /// background, and its pixels their alpha.
    bool transparent = false;
};

/// Whether there are axes, a clip box, a grid, markers or a legend to be drawn over the frame.
bool has_marks(const FrameSubject& subject);

/// The document's axes, clip box, grid and markers and the legend of the colours, for a picture
/// that is painted band by band.
class PictureMarks {
public:
    /// `shown`: the picture in any resolution, which tells what surfaces hide. Returns one line
    /// that says why the marks cannot be drawn.
    static std::expected<PictureMarks, std::string> make(const Framebuffer& shown,
                                                         const ImageSize& size,
                                                         const FrameSubject& subject);
    /// Paints what lies over a band of the picture whose first row is `row`.
    void paint(Framebuffer& band, int row) const;

private:
    PictureMarks(LabelFont font, Shapes shapes, int height, bool transparent);

    LabelFont font_;
    Shapes shapes_;
    int height_;  ///< of the picture
    bool transparent_;
};

/// Draws the document's marks over the frame. Returns the frame itself if there is none of them, or
/// one line that says why they cannot be drawn.
std::expected<std::shared_ptr<const Framebuffer>, std::string> finish_picture(
    std::shared_ptr<const Framebuffer> frame, const FrameSubject& subject);

}  // namespace zeroset
