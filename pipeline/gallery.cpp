#include "pipeline/gallery.hpp"

#include "engine/base/translation.hpp"
#include "engine/language/vocabulary/nearest_word.hpp"
#include "pipeline/gallery_files.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/volume_source.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace zeroset {
namespace {

using nlohmann::json;

glm::dvec3 vector_of(const json& array) {
    return {array.at(0).get<double>(), array.at(1).get<double>(), array.at(2).get<double>()};
}

/// Reads a box: either half the edge of a cube about the origin, or x0, x1, y0, y1, z0, z1.
Box box_of(const json& box) {
    if (box.is_number()) return Box::cube(box.get<double>());
    const auto at = [&](std::size_t i) { return box.at(i).get<double>(); };
    return {.lo = {at(0), at(2), at(4)}, .hi = {at(1), at(3), at(5)}};
}

Camera camera_of(const json& camera) {
    return {.eye = vector_of(camera.at("eye")),
            .look_at = vector_of(camera.at("look_at")),
            .up = vector_of(camera.at("up")),
            .fov_rad = glm::radians(camera.at("fov").get<double>())};
}

/// Reads the look, and how often it mirrors light.
LightChoice light_of(const json& item) {
    LightChoice light;
    if (item.contains("look")) light.look = look_named(item.at("look").get<std::string>()).value();
    light.reflections = item.value("reflections", 0);
    return light;
}

/// Reads an item. `group`: used for an item that names none.
GalleryItem item_of(const json& item, const std::string& group) {
    GalleryItem result;
    result.group = item.value("group", group);
    result.name = item.at("name");
    result.title = item.at("title");
    result.equation = item.at("equation");
    result.about = item.at("about");
    result.source = item.at("source");
    result.clip = box_of(item.at("box"));
    result.w = item.value("w", 0.0);
    result.light = light_of(item);
    if (item.contains("thickness"))
        result.thickness = Thickness{.width = item.at("thickness").get<double>()};
    if (item.contains("camera")) {
        result.camera = camera_of(item.at("camera"));
    } else if (item.at("box").is_number()) {
        result.camera = suite_camera(item.at("box").get<double>());
    }
    return result;
}

std::vector<GalleryItem> load() {
    std::vector<GalleryItem> items;
    for (const std::string_view text : gallery_files()) {
        const json file = json::parse(text);
        for (const json& item : file.at("items")) {
            items.push_back(item_of(item, file.at("group").get<std::string>()));
        }
    }
    return items;
}

}  // namespace

const std::vector<GalleryItem>& gallery() {
    static const std::vector<GalleryItem> items = load();
    return items;
}

ReadDocument read_document(const GalleryItem& item,
                           const std::shared_ptr<const FieldSource>& files) {
    // Equal texts get the same volumes, and so the same code.
    static const auto made_volumes = volume_source({});
    ReadDocument read = read_document_text(item.equation, files ? files : made_volumes);
    Document& document = read.document;
    document.clip = item.clip;
    document.camera = document.home = item.camera;
    document.light = item.light;
    set_value(document.w, item.w);
    for (Statement& row : document.statements)
        row.thickness = item.thickness;
    return read;
}

Document taken_over(const GalleryItem& item, const Document& last,
                    const std::shared_ptr<const FieldSource>& files) {
    Document document = read_document(item, files).document;
    keep_settings(document, last);
    document.coloring = last.coloring;
    document.coloring.range.reset();
    const bool is_of_gallery =
        std::ranges::find(gallery(), last.light, &GalleryItem::light) != gallery().end();
    if (is_of_gallery || last.light == LightChoice()) document.light = item.light;
    return document;
}

std::expected<GalleryItem, InputError> gallery_item(std::string_view name) {
    const auto found = std::ranges::find(gallery(), name, &GalleryItem::name);
    if (found != gallery().end()) return *found;
    std::vector<std::string_view> names;
    std::ranges::transform(gallery(), std::back_inserter(names), &GalleryItem::name);
    const std::optional<std::string_view> meant = meant_word(name, names);
    const std::string shown = "'@" + std::string(name) + "'";
    if (!meant)
        return wrong_input(
            filled(tr("the gallery has no {0} (zeroset gallery lists all)"), {shown}));
    return wrong_input(
        filled(tr("the gallery has no {0}; did you mean {1}? (zeroset gallery lists all)"),
               {shown, "@" + std::string(*meant)}));
}

}  // namespace zeroset
