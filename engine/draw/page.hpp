#pragma once

#include "engine/view/box.hpp"
#include "engine/view/camera.hpp"

#include <glm/glm.hpp>

namespace zeroset {

/// Width and height of a drawing in points, 1/72 inch.
struct PageSize {
    double width = 400.0;
    double height = 400.0;

    bool operator==(const PageSize&) const = default;
};

/// The page of a drawing: places on it are in points, from its upper left corner to the right and
/// downwards. It shows what a picture of the same aspect shows.
class Page {
public:
    Page(const Camera& camera, const PageSize& size);

    [[nodiscard]] const PageSize& size() const { return size_; }
    [[nodiscard]] const ViewFrame& view() const { return view_; }

    /// Whether the point is in front of the eye, not too near, and on the page or beside it by no
    /// more than a margin.
    [[nodiscard]] bool shows(const glm::dvec3& point) const;
    /// False where nothing of the box is shown.
    [[nodiscard]] bool may_show(const Box& box) const;
    /// Where a shown point is.
    [[nodiscard]] glm::dvec2 place(const glm::dvec3& point) const;
    /// How the place of a shown point changes as it moves along a vector, per length of that.
    [[nodiscard]] glm::dvec2 motion(const glm::dvec3& point, const glm::dvec3& along) const;
    /// Points on the page for a unit of length across the view at a shown point.
    [[nodiscard]] double scale(const glm::dvec3& point) const;
    /// A bound of the box's diameter on the page, in points.
    [[nodiscard]] double diameter(const Box& box) const;
    /// The unit vector along the ray that goes through the point, away from the eye.
    [[nodiscard]] glm::dvec3 ray_direction(const glm::dvec3& point) const;

private:
    [[nodiscard]] double half_height() const { return 0.5 * size_.height; }

    ViewFrame view_;
    PageSize size_;
    double nearest_;    ///< the least third coordinate of homogeneous places that are shown
    glm::dvec2 reach_;  ///< the largest places that are shown, in half heights from the middle
};

}  // namespace zeroset
