#pragma once

#include "app/cli/options/input_document.hpp"
#include "app/cli/options/light_options.hpp"
#include "app/cli/options/look_options.hpp"
#include "document/document.hpp"
#include "engine/scene/settings.hpp"
#include "engine/view/camera.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/prepare.hpp"

#include <expected>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Converts the text of command-line options to values, and reports every way in which it can be
// wrong.

namespace zeroset {

/// The values of --solid, --opacity, --surface-look, --color, --thickness and --surface-box as
/// typed: VALUE for all surfaces, or N:VALUE for number N.
struct SurfaceTexts {
    std::vector<std::string> solids = {}, opacities = {}, looks = {};
    std::vector<std::string> colors = {}, thicknesses = {}, boxes = {};
};

/// The view options as typed; empty where an option was not given.
struct ViewText {
    std::optional<std::string> box, aspect, eye, look_at, up, fov, projection, w, sphere;
    std::optional<std::string> camera;      ///< as read_camera reads it
    std::optional<std::string> saved_view;  ///< the name of one of the document's views
    std::vector<std::string> sections;
    SurfaceTexts surfaces;
    bool hollow = false;  ///< no section is capped
    std::optional<std::string> section_shows, section_map, section_range;
    std::vector<std::string> set;  ///< NAME=VALUE of parameters
    bool fit = false;
    bool quiet = false;  ///< no notes on what was read in an unusual way
    LookText look;
};

/// Options for tracing and for the look, as typed.
struct TraceText {
    std::optional<std::string> tracer, d_stop, epsilon, delta, levels, threads;
    std::optional<std::string> aa;  ///< as read_antialias reads it
    /// True or false as given; absent: the document's choice. `antialias`: the same as an `aa`.
    std::optional<bool> shadows, antialias, jumps, axes, clip_box, grid, textbook;
    std::optional<std::string> axis_names;
    LightText light;
};

/// Values of parameters, by name.
using ParameterValues = std::map<std::string, double>;

struct Size {
    int width, height;
};

/// Reads EQUATION, @NAME of the gallery, FILE.zeroset.json, or "-" for the text of standard input,
/// then applies the view options. Rows that cannot be read are no error here: the window shows
/// them. `access`: by which its texts read files.
OrInputError<InputDocument> read_document(
    const std::string& equation, const ViewText& view,
    const std::shared_ptr<FileAccess>& access = std::make_shared<FileAccess>());

/// Does read_document, but takes rows that cannot be read for an error.
OrInputError<InputDocument> read_document_with_rows(const std::string& equation,
                                                    const ViewText& view);

/// Reads the values of --set NAME=VALUE.
OrInputError<ParameterValues> read_parameters(const std::vector<std::string>& texts);

/// Applies the given options for the look to the document.
[[nodiscard]] std::optional<InputError> take_look(const TraceText& text, Document& document);

/// Reads the value of --aa.
OrInputError<Antialias> read_antialias(const std::string& text);

/// Reads the options for tracing; those for the look belong to the document, see take_look.
OrInputError<TraceSettings> read_trace_settings(const TraceText& text);

/// An error where the document shows jumps and the tracer does not know of any.
std::optional<InputError> check_jumps(const Document& document, const TraceSettings& settings);

inline constexpr double default_budget_s = 30.0;

/// Reads the seconds of --budget, 0.001 to 1,000,000; default_budget_s if absent.
OrInputError<double> read_budget(const std::optional<std::string>& text);

/// Reads how often a frame is timed by --repeat, 1 to 10,000; `usual` if absent.
OrInputError<int> read_repeats(const std::optional<std::string>& text, int usual);

/// The rest of `text` behind a word that begins it and a blank or "=": "2" of "power 2"; nothing
/// where it does not begin so.
std::optional<std::string> value_behind(std::string_view text, std::string_view word);

/// Sizes of pictures that are in memory as a whole, and of those that need not be.
struct SizeLimits {
    int largest_side;
    long long most_pixels;
};
inline constexpr SizeLimits in_memory{.largest_side = 16384, .most_pixels = 100'000'000};
inline constexpr SizeLimits in_bands{.largest_side = 65536, .most_pixels = 65536LL * 65536LL};

/// Reads "WxH", or "N" for a square; each side 1 at least.
OrInputError<Size> read_size(const std::string& option, const std::string& text,
                             const SizeLimits& limits = in_memory);

/// Reads `count` finite numbers separated by commas; `option` names them in errors.
OrInputError<std::vector<double>> read_numbers(const std::string& option, const std::string& text,
                                               std::size_t count);
OrInputError<double> read_number(const std::string& option, const std::string& text);
/// Reads a whole number from `lowest` to `highest`.
OrInputError<int> read_integer(const std::string& option, const std::string& text, int lowest,
                               int highest);

}  // namespace zeroset
