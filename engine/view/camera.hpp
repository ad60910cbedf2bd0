#pragma once

#include "engine/view/box.hpp"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace zeroset {

/// How rays leave the image: from the eye, or all along the view. Both show the same height at the
/// point looked at.
enum class Projection : std::uint8_t { Perspective, Orthographic };

/// Image row 0 is at the top, rays go through pixel centres.
struct Camera {
    glm::dvec3 eye{0.0};
    glm::dvec3 look_at{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    /// Vertical, in (0, pi). Of an orthographic view, that of the perspective one which shows as
    /// much at the point looked at.
    double fov_rad = 0.0;
    Projection projection = Projection::Perspective;

    bool operator==(const Camera&) const = default;
};

/// The camera as an orthonormal frame, and its rays: the points origin + t * direction. In
/// perspective they begin at the eye; orthographic ones begin anywhere and go through the plane
/// across the view through the eye at t = 0. Distances are measured from there, along the ray:
/// those of an orthographic view may be below 0.
struct ViewFrame {
    glm::dvec3 eye, right, up, forward;
    double look_distance = 1.0;  ///< from the eye to the point looked at, along forward
    double half_height = 1.0;    ///< tan(fov / 2)
    Projection projection = Projection::Perspective;

    explicit ViewFrame(const Camera& camera);

    [[nodiscard]] bool parallel() const { return projection == Projection::Orthographic; }
    /// Width of a pixel where rays are as far apart as in perspective at distance 1.
    [[nodiscard]] double pixel_size(int height_px) const { return 2.0 * half_height / height_px; }
    /// The width of a pixel at the point looked at.
    [[nodiscard]] double pixel_at_look(int height_px) const {
        return pixel_size(height_px) * look_distance;
    }
    /// The same at a distance along a ray near the image's centre.
    [[nodiscard]] double pixel_width(int height_px, double distance) const {
        return parallel() ? pixel_at_look(height_px) : pixel_size(height_px) * distance;
    }
    /// Direction (not normalised, 1 along forward) of the ray through the point (col, row) of the
    /// image in pixels; a pixel's centre is at (i + 0.5, j + 0.5).
    [[nodiscard]] glm::dvec3 direction(double col, double row, int width_px, int height_px) const;
    /// Where that ray has t = 0.
    [[nodiscard]] glm::dvec3 origin(double col, double row, int width_px, int height_px) const;
    /// The ray's point at a distance.
    [[nodiscard]] glm::dvec3 point(double col, double row, int width_px, int height_px,
                                   double distance) const;

    /// Where a point shows: (u, v, c), affine in the point, which lies u / c to the right and v / c
    /// upwards of the image's centre, in half heights of the image; not at all where c <= 0.
    [[nodiscard]] glm::dvec3 homogeneous(const glm::dvec3& point) const;
    /// As Framebuffer::depth of a pixel that shows the point.
    [[nodiscard]] double distance_of(const glm::dvec3& point) const;

private:
    /// From the image's centre, in widths of a pixel times right and up.
    [[nodiscard]] glm::dvec3 across(double col, double row, int width_px, int height_px) const;
};

/// How the world stands to one who looks from the front: columns are what lies to the right, behind
/// and above; orthonormal, right-handed. (x, y, z) where z is up, (x, -z, y) for y, (y, z, x) for
/// x, and the nearest of these turned for other directions `up`, which is not 0.
glm::dmat3 front_axes(const glm::dvec3& up);

/// The direction from which the gallery and the benchmarks look, along front_axes; not normalised.
inline constexpr glm::dvec3 default_view_direction{1.0, -1.6, 0.9};
inline constexpr double default_fov_deg = 42.0;

/// Looks at the box's centre from `default_view_direction`, far enough to show the whole box in
/// an image of the given aspect (width / height).
Camera default_camera(const Box& box, double aspect = 1.0,
                      const glm::dvec3& up = glm::dvec3(0.0, 0.0, 1.0));
/// Looks at the box's centre along the same direction, as near as shows the whole box.
Camera framed(const Camera& camera, const Box& box, double aspect);

/// The benchmarks' camera for the cube [-half_edge, half_edge]^3: looks at the origin from
/// `default_view_direction` at 4 half edges, from where the surfaces fill the image.
Camera suite_camera(double half_edge);

/// Why the camera cannot see anything (eye at the point looked at, up along the view, bad angle),
/// or nullptr when it is usable.
const char* camera_defect(const Camera& camera);

// Interaction: each returns the changed camera and keeps the other properties.

/// Turns about the point looked at; angles in radians, yaw right-handed about `up`, pitch upwards
/// and kept off the poles.
Camera orbit(const Camera& camera, double yaw_rad, double pitch_rad);
/// Moves eye and point looked at in the image plane; (dx, dy) in heights of the image,
/// positive to the right and upwards.
Camera pan(const Camera& camera, double dx, double dy);
/// Scales the distances of eye and point looked at from `fixed`, a point in world units, by
/// `factor` (< 1 comes nearer): what is seen at that point stays where it is in the image. Keeps
/// the camera where it would come nearer than double can tell eye and point looked at apart.
Camera zoom(const Camera& camera, double factor, const glm::dvec3& fixed);
/// The point under the cursor at `distance` from the eye, or, without one, in the plane through the
/// point looked at. (u, v) in half heights of the image from its centre.
glm::dvec3 point_under(const Camera& camera, double u, double v,
                       std::optional<double> distance = std::nullopt);

}  // namespace zeroset
