#pragma once

#include "document/document.hpp"
#include "engine/export/codecs/film_encoder.hpp"
#include "engine/view/camera.hpp"

#include <glm/ext/vector_double3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace zeroset {

/// The camera's turn about the point looked at.
struct Turn {
    glm::dvec3 axis{0.0, 0.0, 1.0};  ///< not 0; right-handed
    double degrees = 360.0;
};

/// A number that changes with the film: w or a parameter.
struct Sweep {
    std::string name;
    double from = 0.0;
    double to = 1.0;
};

/// How a film begins again.
enum class FilmEnd : std::uint8_t {
    Stop,    ///< the last frame shows the end
    Loop,    ///< after the last frame comes the first
    Bounce,  ///< from the end it goes back to the beginning
};

/// How a change begins and ends.
enum class Easing : std::uint8_t { Linear, Smooth };

/// What changes in a film.
struct FilmPlan {
    int frames = 180;
    FrameRate rate;
    std::optional<Turn> turn;
    std::vector<Sweep> sweeps;
    std::vector<Camera> path;  ///< cameras that it goes through at constant speed; two or none
    FilmEnd end = FilmEnd::Loop;
    Easing easing = Easing::Linear;
    /// Pictures that are mixed for a frame, over this part of the time that it is shown.
    int blur = 1;
    double shutter = 0.5;
};

/// How far the changes are, 0 to 1, at a frame; between frames for parts of them.
double progress_at(const FilmPlan& plan, double frame);

/// The document as it is at a frame of the film. Its camera is set, for a picture of this aspect
/// (width / height): one that sees all of the clip box on the whole way round, unless the document
/// has one.
class FilmScript {
public:
    FilmScript(FilmPlan plan, Document document, double aspect);

    [[nodiscard]] Document document_at(double frame) const;
    [[nodiscard]] const FilmPlan& plan() const { return plan_; }

private:
    [[nodiscard]] Camera camera_at(double progress) const;

    FilmPlan plan_;
    Document document_;
    Camera first_;  ///< that turns begin with
    /// The way through `plan_.path` so far, at equal steps of its parameter.
    std::vector<double> way_;
};

}  // namespace zeroset
