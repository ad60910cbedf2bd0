#pragma once

#include "engine/view/camera.hpp"

#include <vector>

namespace zeroset {

/// A smooth way of a camera through others at constant speed: of what moves most, the eye with the
/// point looked at, or what is seen by rolling or zooming. Between two of them the point looked
/// at goes along a curve by Catmull and Rom, and so do the logarithm of the distance and the angles
/// of the view about what is up, so that the camera goes around what it looks at. Where the cameras
/// differ in what is up, their orientations are interpolated as quaternions [Shoemake87].
class CameraPath {
public:
    CameraPath() = default;
    /// `through`: two or more that see something; or none. `closed`: after the last comes the
    /// first.
    CameraPath(std::vector<Camera> through, bool closed);

    [[nodiscard]] bool empty() const { return through_.empty(); }
    /// The camera where `part`, 0 to 1, of the way is behind; the path is not empty.
    [[nodiscard]] Camera at(double part) const;

private:
    /// The camera at a parameter: whole numbers are those that it goes through.
    [[nodiscard]] Camera between(double parameter) const;
    [[nodiscard]] const Camera& camera(int index) const;

    std::vector<Camera> through_;
    bool closed_ = false;
    bool upright_ = false;     ///< all have the same direction up
    std::vector<double> way_;  ///< that is behind, at equal steps of the parameter
};

}  // namespace zeroset
