#pragma once

#include "engine/annotate/shapes.hpp"
#include "engine/image/framebuffer.hpp"

#include <glm/ext/vector_double2.hpp>

#include <cstdint>
#include <expected>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace zeroset {

/// DejaVu Sans, for labels in pictures. Cheap to copy; any number of threads.
class LabelFont {
public:
    /// From ZEROSET_FONT_DIR (set by CMake); or one line that says what is missing.
    static std::expected<LabelFont, std::string> load();

    /// Paints the text; what is beyond the picture is left out. Nothing but colours changes.
    void paint(Framebuffer& picture, const Text& text) const;
    /// Width of one line of UTF-8, as a TextWidth.
    [[nodiscard]] double width(std::string_view text, double em) const;

private:
    struct Face;
    /// Paints letters from a place of their baseline on.
    void paint_letters(Framebuffer& picture, const glm::dvec2& start, std::string_view words,
                       double em, std::uint32_t color) const;
    explicit LabelFont(std::shared_ptr<const Face> face) : face_(std::move(face)) {}

    std::shared_ptr<const Face> face_;
};

}  // namespace zeroset
