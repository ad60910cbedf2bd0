#pragma once

#include "engine/image/framebuffer.hpp"

#include <glm/glm.hpp>

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

    /// UTF-8 in one line with its middle (of a digit's height) at a place of the picture, in
    /// pixels; what is beyond the picture is left out. `em` in pixels.
    void paint(Framebuffer& picture, const glm::dvec2& middle, std::string_view text, double em,
               std::uint32_t color) const;
    /// In pixels.
    [[nodiscard]] double width(std::string_view text, double em) const;

private:
    struct Face;
    explicit LabelFont(std::shared_ptr<const Face> face) : face_(std::move(face)) {}

    std::shared_ptr<const Face> face_;
};

}  // namespace zeroset
