#include "app/cli/options/view_options.hpp"
#include "document/camera_text.hpp"
#include "document/framing.hpp"
#include "document/views.hpp"
#include "engine/base/text.hpp"
#include "pipeline/input_error.hpp"

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace zeroset {
namespace {

OrInputError<glm::dvec3> read_vector(const std::string& option, const std::string& text) {
    const auto numbers = read_numbers(option, text, 3);
    if (!numbers) return std::unexpected(numbers.error());
    return glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

OrInputError<Projection> read_projection(const std::string& text) {
    if (const auto projection = projection_named(text)) return *projection;
    return wrong_input("--projection " + text + ": type perspective or orthographic");
}

/// The camera that the options for parts of it change; nothing: the document's stays as it is.
OrInputError<std::optional<Camera>> first_camera(const ViewText& view, const Document& document) {
    const Camera camera = camera_of(document);
    if (view.saved_view) return saved_camera("--view", *view.saved_view, document);
    if (view.camera) return read_camera("--camera", *view.camera, camera);
    if (!chooses_camera(view)) return std::nullopt;
    return camera;
}

}  // namespace

bool chooses_camera(const ViewText& view) {
    return view.saved_view || view.camera || view.eye || view.look_at || view.up || view.fov ||
           view.projection;
}

OrInputError<Camera> read_camera(const std::string& option, const std::string& text,
                                 const Camera& base) {
    auto camera = read_camera_text(text, base);
    if (!camera) return wrong_input(option + " " + text + ": " + camera.error());
    return *camera;
}

OrInputError<Camera> saved_camera(const std::string& option, const std::string& name,
                                  const Document& document) {
    const std::string wanted(trimmed(name));
    if (const SavedView* const view = find_view(document.views, wanted)) return view->camera;
    return wrong_input(option + " " + wanted + ": there is no such view; " +
                       (document.views.empty() ? "the document has no saved ones"
                                               : "there are: " + view_names(document.views)));
}

void fit_camera(const ViewText& view, bool stored, double aspect, Document& document) {
    if (chooses_camera(view) || !document.camera) return;
    document.camera = !stored && draws_box(document)
                          ? whole_view(*document.camera, document, aspect)
                          : fitting(*document.camera, aspect);
}

bool has_free_view(const InputDocument& input, const ViewText& view) {
    const bool chooses = view.box || view.fit || view.sphere || !view.sections.empty();
    return input.typed && !chooses && !chooses_camera(view) && input.document.clip == Box();
}

std::string fitted_note(const std::string& note) {
    return "zeroset: note: " + note + "; --box 2 keeps the usual clip box\n";
}

std::optional<InputError> take_camera(const ViewText& view, Document& document) {
    const auto first = first_camera(view, document);
    if (!first) return first.error();
    if (!*first) return std::nullopt;
    Camera camera = **first;
    const auto take = [](const std::optional<std::string>& text, const char* option,
                         glm::dvec3& value, const glm::dvec3& scale) -> std::optional<InputError> {
        if (!text) return std::nullopt;
        const auto vector = read_vector(option, *text);
        if (!vector) return vector.error();
        value = scale * *vector;
        return std::nullopt;
    };
    const glm::dvec3& stretch = camera.stretch;
    if (auto error = take(view.eye, "--eye", camera.eye, stretch)) return error;
    if (auto error = take(view.look_at, "--look-at", camera.look_at, stretch)) return error;
    if (auto error = take(view.up, "--up", camera.up, glm::dvec3(1.0))) return error;
    if (view.up) document.up = camera.up;
    if (view.fov) {
        const auto degrees = read_number("--fov", *view.fov);
        if (!degrees) return degrees.error();
        if (!(*degrees >= least_fov_deg && *degrees <= most_fov_deg)) {
            return InputError{.reason = "--fov " + *view.fov +
                                        ": type an angle from 0.01 to 170 degrees"};
        }
        camera.fov_rad = glm::radians(*degrees);
    }
    if (view.projection) {
        const auto projection = read_projection(*view.projection);
        if (!projection) return projection.error();
        camera.projection = *projection;
    }
    if (const char* defect = camera_defect(camera)) return InputError{.reason = defect};
    document.camera = camera;
    return std::nullopt;
}

}  // namespace zeroset
