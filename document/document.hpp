#pragma once

#include "document/look.hpp"
#include "document/views.hpp"
#include "engine/language/parse.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// How wide a curve is drawn, or a point.
struct Thickness {
    double width = 0.0;      ///< above 0
    bool in_pixels = false;  ///< of the picture; else in units of the world

    bool operator==(const Thickness&) const = default;
};
inline constexpr double most_pixels_thick = 1000.0;

/// The thickness as it is typed: "0.05", or "3 px".
std::string thickness_text(const Thickness& thickness);
std::optional<Thickness> thickness_from(std::string_view text);

/// One row of the list of statements.
struct Statement {
    int id = 0;        ///< unique among the rows of a session, whatever their order and text
    std::string text;  ///< UTF-8; usually one statement
    bool visible = true;
    std::optional<std::uint32_t> color;  ///< 0xRRGGBB of a surface's front; none: not chosen yet
    SolidSide solid = SolidSide::Automatic;        ///< which side of its surface is solid
    std::optional<Look> look = std::nullopt;       ///< of its surface; none: the document's
    std::optional<double> opacity = std::nullopt;  ///< of its surface, 0 to 1; none: the look's
    /// How thick its curve or point is drawn; none: as suits the clip box.
    std::optional<Thickness> thickness = std::nullopt;
    /// A clip box of its own, within the document's; none: the document's alone.
    std::optional<Box> box = std::nullopt;

    bool operator==(const Statement&) const = default;
};

/// Behaviour of a playing slider at its ends: it turns back, or begins again.
enum class Repeat : std::uint8_t { Bounce, Loop };

/// The name of what happens, as files have it: "bounce".
std::string_view name_of(Repeat repeat);
std::optional<Repeat> repeat_named(std::string_view name);

/// A number that is chosen with a slider. All members are finite, at most largest_number in size.
struct Slider {
    double value = 1.0;
    double lo = -5.0;  ///< ends of the slider, lo < hi
    double hi = 5.0;
    double step = 0.0;   ///< values are lo + n * step; 0: any value
    double speed = 1.0;  ///< of playing, in ranges per seconds_per_range; above 0
    Repeat repeat = Repeat::Bounce;
    bool presented = true;  ///< a presentation shows it, too

    bool operator==(const Slider&) const = default;
};

inline constexpr double largest_number = 1e30;
inline constexpr double seconds_per_range = 4.0;
inline constexpr double slowest = 1.0 / 64.0;
inline constexpr double fastest = 64.0;

/// All that a session is about, however it is shown: what a file stores and what undo restores.
struct Document {
    std::vector<Statement> statements;
    std::map<std::string, Slider> parameters;  ///< those that differ from the default, by name
    Slider w{.value = 0.0, .lo = -2.0, .hi = 2.0};
    Box clip;
    Region region;  ///< the part of the clip box that is shown
    /// Lengths in the picture for one unit along each axis; none: all equal, unless the box's edges
    /// are very unequal.
    std::optional<glm::dvec3> aspect = std::nullopt;
    std::optional<Camera> camera;  ///< default_camera of the clip box when absent
    std::optional<Camera> home;    ///< where "reset view" goes, if not to the default
    std::vector<SavedView> views;  ///< in the order in which they were saved
    StopCriterion stop{.value = 14.0};
    bool mark_undecided = false;
    bool shadows = false;
    Antialias antialias = Antialias::Beams;
    bool jumps = false;     ///< whether sign changes of f in a jump are drawn, too
    bool axes = false;      ///< with ticks and numbers
    bool clip_box = false;  ///< the edges of the clip box
    bool grid = false;      ///< on the floor of the clip box
    /// UTF-8, each at most longest_label bytes.
    std::array<std::string, 3> axis_names{"x", "y", "z"};
    /// The direction that is up, not 0: dragging turns about it, unless it turns freely.
    glm::dvec3 up{0.0, 0.0, 1.0};
    bool trackball = false;  ///< dragging turns freely
    ColorChoice coloring;
    SectionChoice section_values;
    LightChoice light;
    std::vector<Marker> markers;  ///< in the order of their creation
    /// Where the files that its texts name come from; nullptr: they must not name any. Not saved.
    std::shared_ptr<const FieldSource> files = nullptr;

    bool operator==(const Document&) const = default;
};

/// Copies from `of` what a person sets for all surfaces: the search depth, the look, how dragging
/// turns.
void keep_settings(Document& document, const Document& of);

/// A document with one empty row.
Document empty_document();

/// Camera::stretch for pictures of the document.
glm::dvec3 stretch_of(const Document& document);
/// The document with nothing drawn stretched, for files that are no pictures.
Document unstretched(Document document);

/// An id that no row has.
int unused_id(const Document& document);
/// `document` with its rows numbered from `first` on.
Document renumbered(Document document, int first);

/// The slider of a parameter; the default one where the document has none.
Slider slider_of(const Document& document, const std::string& parameter);
/// Sets the value, and moves an end of the slider that it lies beyond.
void set_value(Slider& slider, double value);

/// Whether two documents differ in the camera at most.
bool same_work(const Document& a, const Document& b);

/// The rows as one text for read_program. No statement continues in the next row; within a row, a
/// line that starts with a sign continues the line before it.
struct JoinedRows {
    explicit JoinedRows(const std::vector<std::string>& rows);
    /// The row that holds a byte of the text; a byte between two rows belongs to the first of them.
    [[nodiscard]] std::size_t row_at(std::size_t offset) const;
    /// For each row that has a box: the part of the text that the row is, and the box that cuts it.
    [[nodiscard]] std::vector<CutText> cuts(std::span<const std::optional<Box>> boxes) const;

    std::string text;
    std::vector<std::size_t> begins;  ///< offset of each row in `text`
};
/// The boxes of the rows.
std::vector<std::optional<Box>> boxes_of(const Document& document);
/// The text with the boxes as remarks behind it, so that equal texts mean the same.
std::string text_with_cuts(std::string text, std::span<const CutText> cuts);
JoinedRows joined_rows(const Document& document);

}  // namespace zeroset
