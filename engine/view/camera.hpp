#pragma once

#include "engine/view/box.hpp"
#include "engine/view/image_point.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

namespace zeroset {

/// Directions of the rays: all from the eye, or all along the view. Both show the same height at
/// the point looked at.
enum class Projection : std::uint8_t { Perspective, Orthographic };

/// A projection's name as it is typed: "perspective".
std::string_view name_of(Projection projection);
std::optional<Projection> projection_named(std::string_view name);

/// A point of view. Row 0 of its image is at the top, rays go through pixel centres.
///
/// What it shows may be drawn stretched along the axes: then eye, point looked at and up are in the
/// drawn world, where the point p is at stretch * p. Scenes are in the drawn world.
struct Camera {
    glm::dvec3 eye{0.0};
    glm::dvec3 look_at{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    /// Vertical field of view, in (0, pi). An orthographic camera shows as much at the point looked
    /// at as a perspective one with this angle does.
    double fov_rad = 0.0;
    Projection projection = Projection::Perspective;
    glm::dvec3 stretch{1.0};  ///< above 0

    bool operator==(const Camera&) const = default;
    /// The camera among points of the drawn world.
    [[nodiscard]] Camera in_drawn_world() const {
        Camera camera = *this;
        camera.stretch = glm::dvec3(1.0);
        return camera;
    }
};

/// A camera as an orthonormal frame, and its rays: the points origin + t * direction. Perspective
/// rays begin at the eye. Orthographic ones have no beginning; t = 0 is where they cross the plane
/// through the eye across the view. Distances are measured along the ray from t = 0, so those of an
/// orthographic view may be negative. All of it is in the drawn world (Camera), but for the points
/// that `point` returns and `homogeneous` and `distance_of` take.
struct ViewFrame {
    glm::dvec3 eye, right, up, forward;
    double look_distance = 1.0;  ///< from the eye to the point looked at, along forward
    double half_height = 1.0;    ///< tan(fov / 2)
    Projection projection = Projection::Perspective;
    glm::dvec3 stretch{1.0};

    explicit ViewFrame(const Camera& camera);
    /// The frame among points of the drawn world.
    [[nodiscard]] ViewFrame in_drawn_world() const {
        ViewFrame frame = *this;
        frame.stretch = glm::dvec3(1.0);
        return frame;
    }

    [[nodiscard]] bool parallel() const { return projection == Projection::Orthographic; }
    /// The point looked at.
    [[nodiscard]] glm::dvec3 look_at() const { return eye + look_distance * forward; }
    /// Width of a pixel where the rays are as far apart as at distance 1 in perspective.
    [[nodiscard]] double pixel_size(int height_px) const { return 2.0 * half_height / height_px; }
    /// Width of a pixel at the point looked at.
    [[nodiscard]] double pixel_at_look(int height_px) const {
        return pixel_size(height_px) * look_distance;
    }
    /// Width of a pixel at `distance` along a ray near the image's centre.
    [[nodiscard]] double pixel_width(int height_px, double distance) const {
        return parallel() ? pixel_at_look(height_px) : pixel_size(height_px) * distance;
    }
    /// A vector that points so far to the right, upwards and backwards, to the viewer, in world
    /// axes; and back.
    [[nodiscard]] glm::dvec3 from_view(const glm::dvec3& v) const {
        return v.x * right + v.y * up - v.z * forward;
    }
    [[nodiscard]] glm::dvec3 to_view(const glm::dvec3& v) const {
        return {glm::dot(v, right), glm::dot(v, up), -glm::dot(v, forward)};
    }
    /// Direction (not normalised, 1 along forward) of the ray through a point of the image.
    [[nodiscard]] glm::dvec3 direction(const PixelPoint& at, const ImageSize& image) const;
    /// The point of that ray at t = 0.
    [[nodiscard]] glm::dvec3 origin(const PixelPoint& at, const ImageSize& image) const;
    /// The point of that ray at `distance`.
    [[nodiscard]] glm::dvec3 point(const PixelPoint& at, const ImageSize& image,
                                   double distance) const;

    /// The place (u, v, c), affine in the point, at which it shows: u / c to the right of the
    /// image's centre and v / c above it, in half heights of the image; nowhere where c <= 0.
    [[nodiscard]] glm::dvec3 homogeneous(const glm::dvec3& point) const;
    /// Distance of the point along its ray, as in Framebuffer::depth.
    [[nodiscard]] double distance_of(const glm::dvec3& point) const;

private:
    /// The vector from the image's centre to a point of it, in the plane across the view at
    /// depth 1.
    [[nodiscard]] glm::dvec3 across(const PixelPoint& at, const ImageSize& image) const;
};

/// The world's axes for one who looks from the front: the columns point to the right, away from the
/// viewer and upwards; orthonormal, right-handed. (x, y, z) for `up` along z, (x, -z, y) along y,
/// (y, z, x) along x; for other directions, not 0, the nearest of these, turned.
glm::dmat3 front_axes(const glm::dvec3& up);

/// The direction from which the gallery and the benchmarks look, along front_axes; not normalised.
inline constexpr glm::dvec3 default_view_direction{1.0, -1.6, 0.9};
inline constexpr double default_fov_deg = 42.0;

/// A camera that looks at the box's centre from `default_view_direction`, far enough to show the
/// whole box, stretched, in an image of the given aspect (width / height).
Camera default_camera(const Box& box, double aspect = 1.0,
                      const glm::dvec3& up = glm::dvec3(0.0, 0.0, 1.0),
                      const glm::dvec3& stretch = glm::dvec3(1.0));
/// `camera` moved to look at the box's centre in its direction, as near as shows the whole box.
Camera framed(const Camera& camera, const Box& box, double aspect);

/// The benchmarks' camera for the cube [-half_edge, half_edge]^3: looks at the origin from
/// `default_view_direction` at 4 half edges, from where the surfaces fill the image.
Camera suite_camera(double half_edge);

/// The reason why the camera cannot see anything (eye at the point looked at, up along the view,
/// bad angle), or nullptr where it is usable.
const char* camera_defect(const Camera& camera);

// Interaction: each function returns the changed camera and keeps its other properties.

/// Turns the camera about the point looked at; angles in radians, yaw right-handed about `up`,
/// pitch upwards and kept off the poles.
Camera orbit(const Camera& camera, double yaw_rad, double pitch_rad);
/// Moves the eye and the point looked at in the image plane.
Camera pan(const Camera& camera, const ViewShift& by);
/// Scales the distances of eye and point looked at from `fixed`, a point in world units, by
/// `factor` (< 1 comes nearer): what is seen at that point stays where it is in the image. Keeps
/// the camera where it would come nearer than double can tell eye and point looked at apart.
Camera zoom(const Camera& camera, double factor, const glm::dvec3& fixed);
/// The point under the cursor at `distance` along its ray, by default in the plane through the
/// point looked at.
glm::dvec3 point_under(const Camera& camera, const ViewPoint& cursor,
                       std::optional<double> distance = std::nullopt);

}  // namespace zeroset
