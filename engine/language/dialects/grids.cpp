#include "engine/language/dialects/grids.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/command_arguments.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace zeroset {
namespace {

using Words = std::string_view;

/// The last word before the bracket of a call such as np.meshgrid(, and what is in the bracket.
struct GridCall {
    Words name;
    std::vector<Words> arguments;
};

std::optional<GridCall> call_of(Words text) {
    const std::size_t opener = text.find_first_of("([");
    if (opener == Words::npos || opener == 0) return std::nullopt;
    const Words path = trimmed(text.substr(0, opener));
    const std::size_t dot = path.rfind('.');
    const Words name = dot == Words::npos ? path : path.substr(dot + 1);
    if (!is_word(name)) return std::nullopt;
    const auto closer = closing_bracket(text.substr(opener));
    if (!closer) return std::nullopt;
    return GridCall{.name = name,
                    .arguments = split_outside(text.substr(opener + 1, *closer - 1), ',')};
}

/// `names = call`, split at its "=".
std::optional<std::pair<Words, Words>> assignment(Words row) {
    const std::size_t equals = find_outside(row, "=");
    if (equals == Words::npos || row.substr(equals).starts_with("==")) return std::nullopt;
    return std::pair(trimmed(row.substr(0, equals)), trimmed(row.substr(equals + 1)));
}

bool is_grid(Words name) { return name == "meshgrid" || name == "mgrid" || name == "ndgrid"; }

}  // namespace

bool Grids::makes_grid(std::string_view row) {
    const auto parts = assignment(row);
    const auto call = parts ? call_of(parts->second) : std::nullopt;
    return call && is_grid(call->name);
}

Grids::Grids(ExpressionWriter& writer, AskedBox& box) : writer_(writer), box_(box) {
    const Words typed = writer.text().typed();
    is_ahead_ = typed.contains("meshgrid") || typed.contains("ndgrid") || typed.contains("mgrid");
}

bool Grids::is_line(std::string_view value) {
    const auto call = call_of(value);
    if (call && (call->name == "linspace" || call->name == "arange" || is_grid(call->name)))
        return true;
    return find_outside(in_brackets(value).value_or(value), ":") != Words::npos;
}

bool Grids::write(std::string_view row) {
    if (write_surface(row)) return true;
    const auto parts = assignment(row);
    if (!parts) return false;
    const auto call = call_of(parts->second);
    if (call && is_grid(call->name)) return write_grid(parts->first, parts->second);
    if (!is_word(parts->first) || !is_ahead_) return false;
    if (const auto inner = assignment(parts->second)) {  // tx = ty = linspace(-8, 8, 41)
        if (!is_word(inner->first) || !ends_of(inner->second)) return false;
        remember_points(parts->first, inner->second);
        remember_points(inner->first, inner->second);
        return true;
    }
    if (!ends_of(parts->second)) return false;
    remember_points(parts->first, parts->second);
    return true;
}

void Grids::remember_points(std::string_view name, std::string_view value) {
    points_.emplace_back(name, *ends_of(value));
}

/// The ends of points on a line: -2:0.1:2, linspace(-2, 2, 50), arange(-2, 2, 0.1), or their name.
std::optional<Grids::Ends> Grids::ends_of(std::string_view argument) const {
    if (argument.ends_with('\'')) argument.remove_suffix(1);  // as a column
    argument = in_brackets(argument).value_or(argument);
    const auto known =
        std::ranges::find(points_, argument, &std::pair<std::string_view, Ends>::first);
    if (known != points_.end()) return known->second;
    const auto call = call_of(argument);
    if (call && (call->name == "linspace" || call->name == "arange") && call->arguments.size() > 1)
        return Ends{.lo = std::string(call->arguments[0]), .hi = std::string(call->arguments[1])};
    const auto parts = split_outside(argument, ':');
    if (parts.size() != 2 && parts.size() != 3) return std::nullopt;
    // In NumPy the number of points is last, an imaginary one.
    const bool has_count = parts.size() == 3 && parts[2].ends_with('j');
    return Ends{.lo = std::string(parts[0]),
                .hi = std::string(has_count ? parts[1] : parts.back())};
}

/// Writes X := x; Y := y; Z := z, where these names are not those of the coordinates.
bool Grids::write_grid(std::string_view names, std::string_view call) {
    constexpr int most_grids = 20;
    if (++grid_count_ > most_grids) return false;
    const auto of = call_of(call);
    const auto grid = split_outside(in_brackets(names).value_or(names), ',');
    if (grid.size() < 2 || grid.size() > 3) return false;
    if (std::ranges::any_of(grid, [](Words name) { return !is_word(name); })) return false;
    if (grid.size() == 2 && draws_points(grid)) return write_parameters(grid, of->arguments);
    for (std::size_t k = 0; k < grid.size(); ++k) {
        const bool is_same = of->arguments.size() == 1;
        const bool has_ends = is_same || k < of->arguments.size();
        box_.at(k) = has_ends ? ends_of(of->arguments[is_same ? 0 : k]) : std::nullopt;
        if (grid[k] == axis_names.at(k)) continue;
        writer_.text().keep(grid[k]);
        writer_.put(" := ", grid[k]);
        writer_.put(axis_names.at(k), grid[k]);
        writer_.put(";", grid[k]);
    }
    const Words typed = writer_.text().typed();
    if (find_outside(typed, "eps") != Words::npos && !writer_.is_function("eps"))
        writer_.put("eps := 2^-52;", names);  // MATLAB's distance of 1 from the next number
    has_grid_ = true;
    return true;
}

/// Whether a surface is drawn over other places than those of a grid: surf(X, Y, Z) over [u, v].
bool Grids::draws_points(const std::vector<std::string_view>& grid) const {
    const Words typed = writer_.text().typed();
    for (const Words word : {"surf(", "mesh(", "surf (", "mesh (", "surfc(", "plot_surface("}) {
        const std::size_t at = typed.find(word);
        if (at == Words::npos) continue;
        const auto call = call_of(typed.substr(at));
        if (!call || call->arguments.size() < 3) continue;
        const Words first = call->arguments[0];
        const bool is_line =
            std::ranges::any_of(points_, [&](const auto& points) { return points.first == first; });
        return first != grid[0] && !is_line;
    }
    return false;
}

/// Keeps the ranges of a grid whose points are parameters.
bool Grids::write_parameters(const std::vector<std::string_view>& grid, const GridArguments& of) {
    for (std::size_t k = 0; k < grid.size(); ++k) {
        const auto ends = ends_of(of[of.size() == 1 ? 0 : k]);
        if (!ends) return false;
        parameters_ += ", " + ends->lo + " < " + std::string(grid[k]) + " < " + ends->hi;
    }
    has_grid_ = true;
    return true;
}

/// Writes isosurface(X, Y, Z, V, level), isosurface(V, level), marching_cubes(V, level) and surf(X,
/// Y, Z), perhaps as the value of a name.
bool Grids::write_surface(std::string_view row) {
    if (!has_grid_) return false;
    const auto parts = assignment(row);
    auto call = call_of(parts ? parts->second : row);
    if (call && call->name == "patch" && !call->arguments.empty())
        call = call_of(call->arguments[0]);
    if (!call) return false;
    const GridArguments& arguments = call->arguments;
    const bool is_height = call->name == "surf" || call->name == "mesh" ||
                           call->name == "plot_surface" || call->name == "surfc";
    if (call->name == "marching_cubes" && arguments.size() >= 2) {
        write_level(arguments[0], arguments[1]);
    } else if (call->name == "isosurface" && (arguments.size() == 2 || arguments.size() == 5)) {
        write_level(arguments[arguments.size() - 2], arguments.back());
    } else if (is_height && arguments.size() >= 3) {
        write_heights(arguments);
    } else {
        return false;
    }
    writer_.put(";", row.substr(row.size()));
    return true;
}

void Grids::write_level(std::string_view values, std::string_view level) {
    const std::size_t equals = level.find('=');  // marching_cubes(V, level=0)
    writer_.write(values);
    writer_.put(" - (", level);
    writer_.write(equals == Words::npos ? level : level.substr(equals + 1));
    writer_.put(") = 0", level);
}

/// Writes heights over the grid, or points over the parameters that it is of.
void Grids::write_heights(const GridArguments& places) {
    if (parameters_.empty()) {
        writer_.put("z = ", places[2]);
        return writer_.write(places[2]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        writer_.put(i == 0 ? "(" : ", ", places[i]);
        writer_.write(places[i]);
    }
    writer_.put(")" + parameters_, places[0]);
}

}  // namespace zeroset
