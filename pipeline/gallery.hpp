#pragma once

#include "engine/view/camera.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/prepare.hpp"

#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// A surface of resources/gallery with a view that shows it well.
struct GalleryItem {
    std::string group;
    std::string name;
    std::string title;
    std::string equation;
    std::string about;   ///< one sentence of explanation
    std::string source;  ///< the source of the surface
    Box clip;
    double w = 0.0;
    std::optional<Camera> camera;                       ///< default_camera(clip) when absent
    LightChoice light = {};                             ///< the look that suits it
    std::optional<Thickness> thickness = std::nullopt;  ///< of its curve
};

/// The group of surfaces from papers, which the benchmark times.
inline constexpr std::string_view suite_group = "From the papers";

/// All items, in the order of the files, which are compiled into the program.
const std::vector<GalleryItem>& gallery();

/// Returns the item as a document with the item's view and light. Some items name volumes, which
/// the program makes. `files`: what its rows may name once they are edited (Document::files).
ReadDocument read_document(const GalleryItem& item,
                           const std::shared_ptr<const FieldSource>& files = nullptr);

/// Returns the item as a document that takes the place of `last`: with the settings that a person
/// made there for all surfaces. A light of one's own stays; the usual one and those that the
/// gallery brings give way to the item's.
Document taken_over(const GalleryItem& item, const Document& last,
                    const std::shared_ptr<const FieldSource>& files = nullptr);

/// Returns the item called `name` (without "@"), or an error that names the nearest one.
std::expected<GalleryItem, InputError> gallery_item(std::string_view name);

}  // namespace zeroset
