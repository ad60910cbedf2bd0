#pragma once

#include "document/look.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// One row of the list of statements.
struct Statement {
    int id = 0;        ///< tells the rows of a session apart, whatever their order and text
    std::string text;  ///< UTF-8; usually one statement
    bool visible = true;
    std::optional<std::uint32_t> color;  ///< 0xRRGGBB of a surface's front; none: not chosen yet
    SolidSide solid = SolidSide::Automatic;  ///< of a surface

    bool operator==(const Statement&) const = default;
};

/// What happens at the end of a slider that plays.
enum class Repeat : std::uint8_t { Bounce, Loop };

/// A number that is chosen with a slider. Finite, of a magnitude up to largest_number.
struct Slider {
    double value = 1.0;
    double lo = -5.0;  ///< ends of the slider, lo < hi
    double hi = 5.0;
    double step = 0.0;   ///< values are lo + n * step; 0: any value
    double speed = 1.0;  ///< how fast it plays: ranges in four seconds, above 0
    Repeat repeat = Repeat::Bounce;

    bool operator==(const Slider&) const = default;
};

inline constexpr double largest_number = 1e30;
inline constexpr double seconds_per_range = 4.0;
inline constexpr double slowest = 1.0 / 64.0;
inline constexpr double fastest = 64.0;

/// All that a session is about, whoever shows it: what a file keeps and what undo brings back.
struct Document {
    std::vector<Statement> statements;
    std::map<std::string, Slider> parameters;  ///< those not as they are at first, by name
    Slider w{.value = 0.0, .lo = -2.0, .hi = 2.0};
    Box clip;
    Region region;                 ///< what is shown of the clip box
    std::optional<Camera> camera;  ///< default_camera of the clip box when absent
    std::optional<Camera> home;    ///< what "reset view" goes back to, if not to the default
    StopCriterion stop{.value = 14.0};
    bool mark_undecided = false;
    bool shadows = false;
    bool antialias = false;
    bool jumps = false;     ///< draws where f changes its sign in a jump, too
    bool axes = false;      ///< with ticks and numbers
    bool clip_box = false;  ///< its edges
    bool grid = false;      ///< on the box's floor
    /// What is up, not 0: what dragging turns about, unless it turns freely.
    glm::dvec3 up{0.0, 0.0, 1.0};
    bool trackball = false;  ///< dragging turns freely
    ColorChoice coloring;
    std::vector<Marker> markers;  ///< in the order in which they were made

    bool operator==(const Document&) const = default;
};

/// What a person set for all surfaces: the search depth, the look, how dragging turns.
void keep_settings(Document& document, const Document& of);

/// A document with one empty row.
Document empty_document();

/// An id that no row has.
int unused_id(const Document& document);
/// The same rows with ids from `first` on.
Document renumbered(Document document, int first);

/// The slider of a parameter, as it is at first where the document does not say.
Slider slider_of(const Document& document, const std::string& parameter);
/// Sets the value; moves an end of the slider that it lies beyond.
void set_value(Slider& slider, double value);

/// Whether two documents are the same but for where they are looked at from.
bool same_work(const Document& a, const Document& b);

/// Rows for a text of one or more statements: one for each. A text that cannot be read becomes a
/// row a line.
std::vector<std::string> rows_of(std::string_view text);

/// A document whose rows are those of a text, numbered from 1; at least one row.
Document document_of_text(std::string_view text);

/// The rows as one text for read_program, in which no statement goes on in the next row, but a line
/// that starts with a sign goes on with the line before it in its row.
struct JoinedRows {
    explicit JoinedRows(const std::vector<std::string>& rows);
    /// The row of a byte of the text; one between two rows belongs to the first of them.
    [[nodiscard]] std::size_t row_at(std::size_t offset) const;

    std::string text;
    std::vector<std::size_t> begins;  ///< of each row in the text
};
JoinedRows joined_rows(const Document& document);

}  // namespace zeroset
