#pragma once

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

// The command line's values: text to numbers, and every way in which the text can be wrong.

namespace zeroset {

/// What the user typed for a view, as text; absent where an option was not given.
struct ViewText {
    std::optional<std::string> box, eye, look_at, up, fov, projection, w, sphere;
    std::vector<std::string> sections, solids;
    bool hollow = false;           ///< no section is capped
    std::vector<std::string> set;  ///< NAME=VALUE of parameters
    bool fit = false;
    LookText look;
};

/// What the user typed for tracing and for the look.
struct TraceText {
    std::optional<std::string> tracer, d_stop, epsilon, delta, threads;
    /// Absent: as the document says, or not.
    std::optional<bool> shadows, antialias, jumps, axes, clip_box, grid;
};

/// A document that was asked for, with what the options say of its view, colours and solids.
struct InputDocument : ReadDocument {
    std::string path = {};  ///< of its file; empty: it is no file
    std::string note = {};  ///< LoadedDocument::note of the file
};

/// Values of parameters, by name.
using ParameterValues = std::map<std::string, double>;

struct Size {
    int width, height;
};

/// Reads EQUATION, @NAME of the gallery, FILE.zeroset.json, or "-" for the text of standard input;
/// then the view options over what the gallery or the file says. Rows that cannot be read are no
/// error yet: the window shows them.
OrInputError<InputDocument> read_document(const std::string& equation, const ViewText& view);

/// The values of --set NAME=VALUE.
OrInputError<ParameterValues> read_parameters(const std::vector<std::string>& texts);

/// Sets what is given of the look.
void take_look(const TraceText& text, Document& document);

/// All but the look, which is a matter of the document.
OrInputError<TraceSettings> read_trace_settings(const TraceText& text);

inline constexpr double default_budget_s = 30.0;

/// The seconds of --budget, from a millisecond to a million seconds; default_budget_s if absent.
OrInputError<double> read_budget(const std::optional<std::string>& text);

/// "WxH" or "N" for a square, each side at least 1 and at most 16384, 100 million pixels in all.
OrInputError<Size> read_size(const std::string& option, const std::string& text);

/// `count` finite numbers separated by commas; `option` names them in the error.
OrInputError<std::vector<double>> read_numbers(const std::string& option, const std::string& text,
                                               std::size_t count);
OrInputError<double> read_number(const std::string& option, const std::string& text);
/// A whole number from `lowest` to `highest`.
OrInputError<int> read_integer(const std::string& option, const std::string& text, int lowest,
                               int highest);

}  // namespace zeroset
