#include "engine/language/dialects/idle_lines.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/parts.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

using Words = std::string_view;

/// First words of lines that draw nothing and stand around plotting commands.
constexpr std::array idle_words = std::to_array<Words>(
    {"syms",    "with",   "restart",  "clear",   "clearvars", "clc",      "close",
     "hold",    "figure", "axis",     "var",     "from",      "import",   "show",
     "xlabel",  "ylabel", "zlabel",   "title",   "view",      "colorbar", "camlight",
     "shading", "grid",   "lighting", "library", "using",     "load",     "colormap",
     "set",     "unset",  "Needs",    "alpha",   "Show",      "display"});

/// Names that programs give to their windows and axes, and libraries that draw.
constexpr std::array drawing_words = std::to_array<Words>(
    {"plt", "fig", "ax", "axes", "mlab", "pl", "plotter", "pyplot", "cbar", "surf", "mcubes"});
/// Functions that only show or write something.
constexpr std::array showing_words =
    std::to_array<Words>({"patch", "Poly3DCollection", "print", "disp", "fprintf", "printf",
                          "Export", "Print", "caxis", "set", "legend"});

/// Whether a line calls a plotter, perhaps for a value: fig, ax = plt.subplots(),
/// ax.set_title("a").
bool calls_of_plotter(Words line) {
    const std::size_t equals = find_outside(line, "=");
    const Words call = equals == Words::npos || line.substr(equals).starts_with("==")
                           ? line
                           : trimmed(line.substr(equals + 1));
    const Words word = call.substr(0, word_length(call));
    const Words behind = call.substr(word.size());
    if (behind.starts_with('.') && std::ranges::find(drawing_words, word) != drawing_words.end())
        return true;
    return trimmed(behind).starts_with('(') &&
           std::ranges::find(showing_words, word) != showing_words.end();
}

/// Whether a line only tells which names are variables: x, y = symbols('x y'), syms x y.
bool names_variables(Words line) {
    const std::size_t equals = line.find('=');
    const Words value = equals == Words::npos ? line : trimmed(line.substr(equals + 1));
    for (const Words word : {"var(", "symbols(", "sp.symbols(", "sympy.symbols(", "SR.var("}) {
        if (value.starts_with(word)) return true;
    }
    return false;
}

}  // namespace

bool loads_library(Words line) {
    const Words word = line.substr(0, word_length(line));
    const Words behind = line.substr(word.size());
    const bool names = behind.starts_with(' ') && !trimmed(behind).starts_with('=');
    if (word == "import" || word == "syms" || word == "using") return names;
    if (word == "from") return names && line.contains(" import ");
    if (word == "with") return trimmed(behind).starts_with('(') && line.ends_with(':');
    if (line.starts_with("<<") || word == "Needs") return true;
    return names_variables(line);
}

bool is_idle(Words line) {
    if (calls_of_plotter(line)) return true;
    const Words word = line.substr(0, word_length(line));
    const Words behind = trimmed(line.substr(word.size()));
    const bool is_known = std::ranges::find(idle_words, word) != idle_words.end();
    const std::size_t show = line.find(".show(");
    const bool shows = show != Words::npos && is_word(line.substr(0, show));
    const bool computes = find_outside(line, "=") != Words::npos ||
                          (!behind.empty() && Words("*/^+-.").contains(behind.front()));
    return (is_known && !computes) || shows || loads_library(line);
}

}  // namespace zeroset
