#pragma once

#include "document/film_plan.hpp"
#include "engine/export/export_format.hpp"

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_int2.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace zeroset::ui {

/// The settings of a picture that is to be saved.
struct PictureExport {
    glm::ivec2 size_px{1920, 1080};
    int bits = 8;
    bool alpha = false;     ///< the background is left transparent
    bool smooth = true;     ///< edges by the exact cover of pixels, whatever the window shows
    int dots_per_inch = 0;  ///< 0: not told
    int quality = 92;

    bool operator==(const PictureExport&) const = default;
};

/// The settings of a film that is to be saved.
struct FilmExport {
    glm::ivec2 size_px{1280, 720};
    double seconds = 6.0;
    bool turns = true;  ///< a turn of `degrees` about `axis`
    double degrees = 360.0;
    int axis = 0;                ///< 0: what is up; 1 to 3: x, y, z
    bool through_views = false;  ///< the way of `plan` leads through all saved views instead
    /// The other changes, with their rate, end and easing; frames and turn are made of the above.
    FilmPlan plan = {};
    bool alpha = false;
    bool smooth = true;
    int quality = 90;

    bool operator==(const FilmExport&) const = default;
    [[nodiscard]] int frames() const {
        const double count = std::round(seconds * plan.rate.frames / plan.rate.seconds);
        return count < 1.0 ? 1 : static_cast<int>(count);
    }
    void take_frames(int count) {
        seconds = static_cast<double>(count) * plan.rate.seconds / plan.rate.frames;
    }
};

/// The settings of meshes that are to be saved.
struct MeshExport {
    /// Formula: no triangles but the formula itself, which 3MF alone can hold.
    enum class Shape : std::uint8_t { Solid, Open, Wall, Formula };
    Shape shape = Shape::Solid;
    double size_mm = 100.0;      ///< the longest edge of all; of Shape::Formula: of the clip box
    double wall_mm = 2.0;        ///< of Shape::Wall
    double tolerance_mm = 0.05;  ///< where the clip box's longest edge is size_mm long
    int most_triangles = 0;      ///< of each surface; 0: as many as the tolerance wants

    bool operator==(const MeshExport&) const = default;
};

/// The settings of a drawing in lines that is to be saved.
struct DrawingExport {
    enum class Hidden : std::uint8_t { Remove, Dash, Show };
    glm::dvec2 size_mm{120.0, 90.0};
    std::array<bool, 5> kinds{true, true, true, true, true};  ///< in the order of CurveKind
    Hidden hidden = Hidden::Remove;
    double width_pt = 1.0;  ///< of silhouettes
    std::array<double, 5>
        widths_pt{};  ///< of the others, in the order of CurveKind; 0: a part of it
    double tolerance_pt = 0.05;

    bool operator==(const DrawingExport&) const = default;
};

/// Everything that is asked for of an export.
struct ExportWish {
    ExportKind kind = ExportKind::Picture;
    PictureExport picture;
    FilmExport film;
    MeshExport mesh;
    DrawingExport drawing;

    bool operator==(const ExportWish&) const = default;
};

/// The panel in which one says what is saved.
struct ExportPage {
    bool open = false;
    bool begins = true;  ///< the next frame chooses `wish.kind`
    ExportWish wish;
    /// The ending of the chosen format, by kind; "####.png" for numbered pictures.
    std::array<std::string, 4> endings;
    double at = 0.0;  ///< the film's frame that is shown
    bool plays = false;
    glm::ivec2 preview_px{0};  ///< room for the preview, set by the panel
};

/// The ending of the format that MeshExport::Shape::Formula is written in.
inline constexpr const char* formula_ending = ".3mf";

/// The ending that a format is chosen by.
inline std::string ending_of(const ExportFormat& format) {
    return (format.numbered ? "####" : "") + std::string(format.ending);
}

/// A line of a drawing's preview.
struct PreviewLine {
    std::vector<glm::dvec2> points;  ///< 0 to 1 across and down the page
    float width_pt = 1.0F;
    bool dashed = false;
};

/// A preview of the file that is wished for.
struct ExportPreview {
    unsigned int texture = 0;  ///< OpenGL's name of the picture; 0: none
    glm::ivec2 size_px{0};     ///< of the picture
    std::vector<PreviewLine> lines;
    std::string verdict;                ///< whether it can be printed, in one line; or empty
    bool is_good = true;                ///< the verdict is
    std::vector<std::string> facts;     ///< lines of text
    std::vector<std::string> details;   ///< further ones, for those who ask
    std::vector<std::string> warnings;  ///< what is not as it should be
    std::string doing;                  ///< what is being found out, or empty
};

/// An export that goes on in the background.
struct ExportProgress {
    std::string name;          ///< of the file; empty: nothing is being saved
    double share = 0.0;        ///< 0 to 1
    std::string text;          ///< "frame 12 of 180, 8.1 a second, 0:20 left"
    unsigned int texture = 0;  ///< the picture as it goes; 0: none
    glm::ivec2 size_px{0};
};

}  // namespace zeroset::ui
