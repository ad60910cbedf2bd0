#pragma once

#include "document/sheet.hpp"
#include "document/shown_point.hpp"
#include "engine/annotate/legend.hpp"
#include "engine/annotate/shapes.hpp"
#include "engine/image/framebuffer.hpp"
#include "engine/language/help.hpp"
#include "engine/measure/probe.hpp"
#include "engine/scene/lighting.hpp"
#include "engine/scene/precision.hpp"
#include "engine/view/camera.hpp"
#include "engine/volume/histogram.hpp"
#include "ui/model/export_page.hpp"
#include "ui/model/inspection.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace zeroset::ui {

/// A surface of the gallery, or of a folder or file that is looked through like it.
struct GalleryEntry {
    std::string title;
    std::string equation;
    std::string about;  ///< one sentence
    std::string group = {};
    std::string source = {};
    std::string path =
        {};  ///< of a document that is not the gallery's; its texts are not translated
};

/// How the rows were read.
struct ReadingFacts {
    std::map<int, RowReport> reports;     ///< how each row was read, by its id
    std::vector<int> surface_rows;        ///< the row of each surface
    std::vector<int> thick_rows;          ///< the rows that are curves or points
    std::vector<std::string> parameters;  ///< that have a slider
    /// The histograms of the volumes of which sliders choose a value, by the slider's name.
    std::map<std::string, std::shared_ptr<const Histogram>> histograms;
    bool uses_w = false;
    bool calls_w_t = false;     ///< the rows say t for w
    std::string color_error;    ///< what is wrong with the expression of the colours; or empty
    std::string contour_error;  ///< what is wrong with that of the contour lines; or empty
};

/// The document as a file with a history.
struct DocumentStatus {
    std::string name;
    bool unsaved = false;
    bool can_undo = false;
    bool can_redo = false;
    std::vector<std::string> recent;  ///< paths of recent documents, the newest first
};

/// Texts that the window shows, over the picture for some seconds and in the status line; each may
/// be empty.
struct StatusTexts {
    std::string note;    ///< what is not as it should be
    std::string done;    ///< what was just done, over the picture
    std::string framed;  ///< what framing has found, over the picture
    std::string saved;   ///< path of the file that `done` tells of; empty: of none
    std::string doing;   ///< what is going on with the text
};

/// The picture on the screen, fine or coarse; no frame before the first.
struct ShownPicture {
    std::shared_ptr<const Framebuffer> frame;
    Camera camera;                                        ///< that the frame was taken with
    std::optional<Legend> legend;                         ///< of its colours
    std::optional<Legend> section_legend = std::nullopt;  ///< of the values that sections show
    std::optional<ValueRange> usual_section_range = std::nullopt;  ///< of most of these
    Shapes contour_labels = {};                                    ///< in pixels of the canvas
    std::optional<double> contour_step = std::nullopt;             ///< of its contour lines
    std::array<bool, 3> of_pi{};  ///< axes whose numbers are multiples of pi
    bool tracing = false;         ///< a finer picture is on its way
    /// The picture is of another text than the rows', and so little of it is seen: 0 (all) to 1.
    float dimmed = 0.0F;
};

/// Figures of the last full picture.
struct PictureFigures {
    int width_px = 0;  ///< 0: no full picture yet
    int height_px = 0;
    double frame_ms = 0.0;
    CertificateCounts counts;
    Precision precision = Precision::Float;
    bool hidden = false;  ///< they are of another text than the rows'
};

/// Facts of the point under the pointer.
struct PointedFacts {
    PointFacts facts;
    int row = 0;              ///< of the list, whose surface it is
    double pixel_size = 0.0;  ///< how far apart neighbouring pixels are there, world units
};

/// A small picture of what a camera sees.
struct ViewPicture {
    Camera camera;
    unsigned int texture = 0;  ///< OpenGL's name
};

/// Everything the owner tells; panels only read it.
struct Shown {
    std::vector<GalleryEntry> gallery;
    std::map<std::size_t, unsigned int> thumbnails;  ///< OpenGL's names of the gallery's pictures
    std::map<Look, unsigned int> look_pictures;      ///< of what is drawn, in each look
    std::vector<ViewPicture> view_pictures;          ///< of saved views
    std::vector<HelpSection> language_help;
    ReadingFacts reading;
    DocumentStatus document;
    StatusTexts status;
    ShownPicture picture;
    PictureFigures figures;
    std::optional<PointedFacts> pointed;
    std::vector<ShownPoint> points;     ///< of the rows, in the document's present state
    std::vector<TracerChoice> tracers;  ///< the usual one first
    OtherPicture other;
    /// Each kind's usual one first; empty until the page of exports is open.
    std::vector<ExportFormat> export_formats;
    ExportPreview export_preview;
    ExportProgress export_progress;
    /// The file that the export page saves without asking; none has its name. Empty: it asks.
    std::string export_target;
};

}  // namespace zeroset::ui
