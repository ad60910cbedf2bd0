#pragma once

#include "document/document.hpp"
#include "document/framing.hpp"
#include "document/row_program.hpp"
#include "engine/scene/settings.hpp"
#include "pipeline/picture_request.hpp"

#include <glm/ext/vector_double2.hpp>

#include <memory>

namespace zeroset {

/// The source of everything that the window saves.
struct ExportSubject {
    Document document;  ///< with its camera
    std::shared_ptr<const Formula> formula;
    std::shared_ptr<const ColorFormulas> colors;
    TraceSettings settings;
    bool whole_box = false;  ///< the view is of the whole clip box

    /// The document's rows as they were read.
    [[nodiscard]] RowProgram rows() const { return *formula; }
    bool operator==(const ExportSubject&) const = default;
};

/// The subject, with smooth edges where they are wanted.
inline ExportSubject smoothed(ExportSubject subject, bool smooth) {
    if (smooth && subject.document.antialias == Antialias::None)
        subject.document.antialias = Antialias::Beams;
    if (!smooth) subject.document.antialias = Antialias::None;
    return subject;
}

/// The subject, with the camera for a picture of this size, in any unit: what the window shows is
/// in view whatever its shape.
inline ExportSubject framed_for(ExportSubject subject, const glm::dvec2& size) {
    Document& document = subject.document;
    const double aspect = size.x / size.y;
    document.camera = subject.whole_box ? whole_view(*document.camera, document, aspect)
                                        : fitting(*document.camera, aspect);
    return subject;
}

}  // namespace zeroset
