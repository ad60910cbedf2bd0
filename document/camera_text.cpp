#include "document/camera_text.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/view/navigation.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

constexpr std::array<std::pair<std::string_view, glm::dvec3 Camera::*>, 3> points{
    {{"eye", &Camera::eye}, {"look-at", &Camera::look_at}, {"up", &Camera::up}}};

/// Documents hold no larger numbers.
constexpr double farthest = 1e30;

std::string text_of(const glm::dvec3& point) {
    return digits_of(point.x) + "," + digits_of(point.y) + "," + digits_of(point.z);
}

std::optional<double> finite_number(std::string_view text) {
    const auto number = number_from<double>(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

/// Reads X,Y,Z, or says what is wrong.
std::expected<glm::dvec3, std::string> point_of(std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() != 3)
        return std::unexpected(filled(tr("3 numbers separated by commas are needed, not {0}"),
                                      {std::to_string(parts.size())}));
    glm::dvec3 point(0.0);
    for (int i = 0; i < 3; ++i) {
        const std::string_view part = parts[static_cast<std::size_t>(i)];
        const auto number = finite_number(part);
        if (!number)
            return std::unexpected(
                filled(tr("{0} is not a finite number"), {"'" + std::string(part) + "'"}));
        if (std::abs(*number) > farthest) return std::unexpected(tr("stay between -1e30 and 1e30"));
        point[i] = *number;
    }
    return point;
}

/// A camera as it is read part by part.
struct CameraReading {
    Camera camera;
    bool has_eye = false;
    std::optional<double> height = std::nullopt;

    /// Reads "WORD VALUE"; says what is wrong.
    std::optional<std::string> take(std::string_view word, std::string_view value);
};

std::optional<std::string> CameraReading::take(std::string_view word, std::string_view value) {
    for (const auto& [name, member] : points) {
        if (word != name) continue;
        const auto point = point_of(value);
        if (!point) return point.error();
        camera.*member = *point;
        has_eye = has_eye || name == "eye";
        return std::nullopt;
    }
    const auto number = finite_number(value);
    if (word == "fov") {
        if (!number || !(*number >= least_fov_deg && *number <= most_fov_deg))
            return tr("type an angle from 0.01 to 170 degrees");
        camera.fov_rad = glm::radians(*number);
        camera.projection = Projection::Perspective;
        height.reset();
        return std::nullopt;
    }
    if (word == "height") {
        if (!number || !(*number > 0.0)) return tr("type a height above 0");
        height = number;
        camera.projection = Projection::Orthographic;
        return std::nullopt;
    }
    return tr("type eye X,Y,Z, then look-at, up, fov or height after a ;");
}

}  // namespace

std::string camera_text(const Camera& camera) {
    std::string text;
    for (const auto& [name, member] : points)
        text += std::string(name) + " " + text_of(camera.*member) + "; ";
    if (camera.projection == Projection::Orthographic)
        return text + "height " + digits_of(shown_height(camera));
    return text + "fov " + digits_of(glm::degrees(camera.fov_rad));
}

bool looks_like_camera(std::string_view text) {
    const std::string_view start = trimmed(text);
    const std::size_t end = start.find_first_of(" =");
    if (end == std::string_view::npos) return false;
    const std::string_view word = start.substr(0, end);
    return word == "fov" || word == "height" ||
           std::ranges::find(points, word, [](const auto& point) { return point.first; }) !=
               points.end();
}

std::expected<Camera, std::string> read_camera_text(std::string_view text, const Camera& base) {
    CameraReading reading{.camera = base};
    for (const std::string_view part : split(text, ';')) {
        const std::size_t end = part.find_first_of(" =");
        const std::string_view value =
            end == std::string_view::npos ? std::string_view() : trimmed(part.substr(end + 1));
        if (const auto wrong = reading.take(part.substr(0, end), value))
            return std::unexpected(*wrong);
    }
    if (!reading.has_eye) return std::unexpected(tr("it says no eye X,Y,Z"));
    const Camera camera =
        reading.height ? with_shown_height(reading.camera, *reading.height) : reading.camera;
    if (const char* const defect = camera_defect(camera)) return std::unexpected(defect);
    return camera;
}

}  // namespace zeroset
