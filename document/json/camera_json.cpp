#include "document/json/document_fields.hpp"
#include "engine/base/translation.hpp"

namespace zeroset {
namespace {

Projection projection_of(const Json& json, const std::string& place) {
    if (const auto projection = projection_named(string_of(json, place))) return *projection;
    throw Damage{filled(tr("{0} is neither perspective nor orthographic"), {place})};
}

/// The camera in an object that may have other fields.
Camera camera_in(Fields& fields, const std::string& place) {
    Camera camera;
    camera.eye = vector_of(fields.get("eye"), fields.at("eye"));
    camera.look_at = vector_of(fields.get("look_at"), fields.at("look_at"));
    camera.up = vector_of(fields.get("up"), fields.at("up"));
    camera.fov_rad = number_of(fields.get("fov_rad"), fields.at("fov_rad"));
    if (const Json* projection = fields.find("projection")) {
        camera.projection = projection_of(*projection, fields.at("projection"));
    }
    if (const Json* stretch = fields.find("stretch"))
        camera.stretch = stretch_of(*stretch, fields.at("stretch"));
    if (const char* defect = camera_defect(camera)) throw Damage{place + ": " + defect};
    return camera;
}

}  // namespace

glm::dvec3 stretch_of(const Json& json, const std::string& place) {
    const glm::dvec3 stretch = vector_of(json, place);
    if (!glm::all(glm::greaterThan(stretch, glm::dvec3(0.0))))
        throw Damage{filled(tr("{0} is not above 0"), {place})};
    return stretch;
}

Json json_of(const Camera& camera) {
    Json json{{"eye", array_of(camera.eye)},
              {"look_at", array_of(camera.look_at)},
              {"up", array_of(camera.up)},
              {"fov_rad", camera.fov_rad}};
    if (camera.projection != Projection::Perspective)
        json["projection"] = name_of(camera.projection);
    if (camera.stretch != Camera().stretch) json["stretch"] = array_of(camera.stretch);
    return json;
}

Camera camera_of(const Json& json, const std::string& place, std::vector<std::string>& unknown) {
    Fields fields(json, place, unknown);
    return camera_in(fields, place);
}

Json json_of(const std::vector<SavedView>& views) {
    Json list = Json::array();
    for (const SavedView& view : views) {
        Json json{{"name", view.name}};
        json.update(json_of(view.camera));
        list.push_back(std::move(json));
    }
    return list;
}

std::vector<SavedView> views_of(const Json& json, std::vector<std::string>& unknown) {
    if (!json.is_array()) throw Damage{filled(tr("{0} is no list"), {"views"})};
    if (json.size() > most_views) throw Damage{tr("there are more than 1000 views")};
    std::vector<SavedView> views;
    for (const Json& item : json) {
        const std::string place = "views[" + std::to_string(views.size()) + "]";
        Fields fields(item, place, unknown);
        SavedView view{.name = string_of(fields.get("name"), fields.at("name")), .camera = {}};
        if (const char* const defect = name_defect(view.name))
            throw Damage{fields.at("name") + ": " + defect};
        if (find_view(views, view.name) != nullptr)
            throw Damage{filled(tr("there are two views called {0}"), {view.name})};
        view.camera = camera_in(fields, place);
        views.push_back(std::move(view));
    }
    return views;
}

}  // namespace zeroset
