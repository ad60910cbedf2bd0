#pragma once

#include "app/exports/exports.hpp"
#include "engine/image/rgba_image.hpp"

#include <memory>
#include <optional>

namespace zeroset {

/// The source of a preview: equal requests give equal previews.
struct PreviewRequest {
    ExportSubject subject;
    ui::ExportWish wish;
    double at = 0.0;         ///< the film's frame
    Camera camera = {};      ///< that meshes are looked at with
    glm::ivec2 space_px{0};  ///< for the picture
    /// True if both are of the same file, at whatever frame, from wherever and in
    /// whatever size it is looked at.
    [[nodiscard]] bool same_file(const PreviewRequest& other) const {
        return subject == other.subject && wish == other.wish;
    }
    bool operator==(const PreviewRequest&) const = default;
};

/// A preview of a file that is not yet made. The texture and `doing` of `shown` are empty.
struct Preview {
    PreviewRequest request;
    ui::ExportPreview shown;
    std::optional<RgbaImage> image;
    std::shared_ptr<const DocumentMeshes> meshes;
    std::shared_ptr<const LineDrawing> drawing;
};

/// Makes a preview; may take long. `last`: one that was made before, whose meshes are used again if
/// they are of the same file. The news tell how far it is.
Preview make_preview(const PreviewRequest& request, const std::optional<Preview>& last,
                     ExportNews& news);

}  // namespace zeroset
