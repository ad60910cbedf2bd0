#pragma once

#include "engine/base/clock.hpp"
#include "engine/view/camera.hpp"

#include <glm/ext/vector_double3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The camera's turn about the point looked at.
struct CameraTurn {
    glm::dvec3 axis{0.0, 0.0, 1.0};  ///< not 0; right-handed
    double degrees = 360.0;

    bool operator==(const CameraTurn&) const = default;
};

/// A number that changes with the film: w or a parameter.
struct Sweep {
    std::string name;
    double from = 0.0;
    double to = 1.0;

    bool operator==(const Sweep&) const = default;
};

/// How a film begins again.
enum class FilmEnd : std::uint8_t {
    Stop,    ///< the last frame shows the end
    Loop,    ///< after the last frame comes the first
    Bounce,  ///< from the end it goes back to the beginning
};

/// How a change begins and ends.
enum class Easing : std::uint8_t { Linear, Smooth };

/// The frames of a film and what changes in them.
struct FilmPlan {
    int frames = 180;
    FrameRate rate;
    std::optional<CameraTurn> turn;
    std::vector<Sweep> sweeps;
    std::vector<Camera> path;  ///< cameras that it goes through at constant speed; two or none
    FilmEnd end = FilmEnd::Loop;
    Easing easing = Easing::Linear;
    /// Pictures that are mixed for a frame, over this part of the time that it is shown.
    int blur = 1;
    double shutter = 0.5;

    bool operator==(const FilmPlan&) const = default;
};

}  // namespace zeroset
