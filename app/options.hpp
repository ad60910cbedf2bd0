#pragma once

#include "app/formula.hpp"
#include "app/look_options.hpp"
#include "engine/trace/camera.hpp"
#include "engine/trace/scene.hpp"

#include "document/document.hpp"

#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The command line's values: text to numbers, and every way in which the text can be wrong.

namespace zeroset {

/// What the user typed for a view, as text; absent where an option was not given.
struct ViewText {
    std::optional<std::string> box, eye, look_at, up, fov, w;
    std::vector<std::string> set;  ///< NAME=VALUE of parameters
    LookText look;
};

/// What the user typed for tracing.
struct TraceText {
    std::optional<std::string> tracer, d_stop, epsilon, delta, threads;
    std::optional<bool> shadows, antialias;  ///< absent: as the document says, or not
};

/// A surface and how to look at it.
struct Surface {
    std::string equation;
    Box clip;
    double w = 0.0;
    std::optional<Camera> camera;  ///< default_camera(clip, aspect) when absent
    ParameterValues parameters;    ///< those that are given
    /// Of a file: its rows, colours and sliders, whose text `equation` is.
    std::optional<Document> document = std::nullopt;
    ColorChoice coloring = {};
    std::vector<Marker> markers = {};
};

/// The surface as a document: a row for each statement.
Document document_of(const Surface& surface);

struct Size {
    int width, height;
};

template <class Value>
using OrInputError = std::expected<Value, InputError>;

/// EQUATION, @NAME of the gallery, FILE.zeroset.json, or "-" for the text of standard input; then
/// the view options over what the gallery or the file says.
OrInputError<Surface> read_surface(const std::string& equation, const ViewText& view);

/// The equation of EQUATION, @NAME, FILE.zeroset.json or "-".
OrInputError<std::string> read_equation(const std::string& equation);

/// The values of --set NAME=VALUE; whether the formula has these parameters is for
/// check_parameters.
OrInputError<ParameterValues> read_parameters(const std::vector<std::string>& texts);

/// Sets shadows and smooth edges where they are given.
void take_look(const TraceText& text, Document& document);

/// All but shadows and smooth edges, which are a matter of the document.
OrInputError<TraceSettings> read_trace_settings(const TraceText& text);

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
