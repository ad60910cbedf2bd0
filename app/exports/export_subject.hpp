#pragma once

#include "document/document.hpp"
#include "document/row_program.hpp"
#include "engine/scene/settings.hpp"
#include "pipeline/picture_request.hpp"

#include <memory>

namespace zeroset {

/// The source of everything that the window saves.
struct ExportSubject {
    Document document;  ///< with its camera
    std::shared_ptr<const Formula> formula;
    std::shared_ptr<const ColorFormulas> colors;
    TraceSettings settings;

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

}  // namespace zeroset
