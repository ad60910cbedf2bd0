#pragma once

#include "document/document.hpp"
#include "document/film_plan.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/plans/camera_path.hpp"

#include <vector>

namespace zeroset {

/// How far the changes are, 0 to 1, at a frame; between frames for parts of them.
double progress_at(const FilmPlan& plan, double frame);

/// The moments that a frame mixes; without blur its own alone.
std::vector<double> moments_of(const FilmPlan& plan, int frame);

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
    Camera first_;     ///< that turns begin with
    CameraPath path_;  ///< through `plan_.path`
};

}  // namespace zeroset
