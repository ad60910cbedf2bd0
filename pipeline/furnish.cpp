#include "pipeline/furnish.hpp"

#include "engine/annotate/furnished.hpp"
#include "engine/annotate/furniture.hpp"
#include "engine/annotate/furniture_colors.hpp"
#include "engine/annotate/label_font.hpp"

namespace zeroset {

std::expected<Framebuffer, std::string> furnished(const Framebuffer& picture,
                                                  const Document& document, const Camera& camera) {
    const FurnitureChoice choice{document.axes, document.clip_box, document.grid};
    if (!choice.any()) return picture;
    const auto font = LabelFont::load();
    if (!font) return std::unexpected(font.error());
    const double em = label_em(picture.width, picture.height);
    const FurnitureView view{document.clip, camera, document.up, picture.width, picture.height, em};
    Framebuffer painted = picture;
    paint_furniture(painted, make_furniture(view, choice, picture), furniture_on_dark, *font, em);
    return painted;
}

}  // namespace zeroset
