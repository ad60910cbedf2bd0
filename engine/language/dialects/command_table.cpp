#include "engine/language/dialects/command_table.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

constexpr KnownCommand row(std::string_view name, std::string_view program, Draws draws) {
    return {.name = name, .program = program, .draws = draws};
}

constexpr std::array known_commands{
    row("ContourPlot3D", "Mathematica", Draws::Equations),
    row("RegionPlot3D", "Mathematica", Draws::Equations),
    row("Plot3D", "Mathematica", Draws::Heights),
    row("ParametricPlot3D", "Mathematica", Draws::Points),
    row("SphericalPlot3D", "Mathematica", Draws::Spherical),
    row("RevolutionPlot3D", "Mathematica", Draws::Turned),
    row("Show", "Mathematica", Draws::Commands),
    row("Manipulate", "Mathematica", Draws::Commands),
    row("implicitplot3d", "Maple", Draws::Equations),
    row("plot3d", "Maple, Sage or SymPy", Draws::Heights),
    row("spacecurve", "Maple", Draws::Points),
    row("display", "Maple", Draws::Commands),
    row("show", "Sage", Draws::Commands),
    row("Implicit3d", "MuPAD", Draws::Equations),
    row("implicit_plot3d", "Sage", Draws::Equations),
    row("parametric_plot3d", "Sage", Draws::Points),
    row("spherical_plot3d", "Sage", Draws::AroundFirst),
    row("revolution_plot3d", "Sage", Draws::Turned),
    row("plot3d_implicit", "SymPy", Draws::Equations),
    row("plot_implicit", "SymPy", Draws::Equations),
    row("plot3d_parametric_surface", "SymPy", Draws::ThreeParts),
    row("plot3d_parametric_line", "SymPy", Draws::ThreeParts),
    row("fimplicit3", "MATLAB", Draws::Zeros),
    row("fsurf", "MATLAB", Draws::Sheet),
    row("ezsurf", "MATLAB", Draws::Sheet),
    row("ezmesh", "MATLAB", Draws::Sheet),
    row("fplot3", "MATLAB", Draws::Track),
    row("ezplot3", "MATLAB", Draws::Track),
    row("Surface", "GeoGebra", Draws::Listed),
    row("Superficie", "GeoGebra", Draws::Listed),
    row("Oberfläche", "GeoGebra", Draws::Listed),
    row("Curve", "GeoGebra", Draws::Listed),
    row("Curva", "GeoGebra", Draws::Listed),
    row("Kurve", "GeoGebra", Draws::Listed),
    row("Courbe", "GeoGebra", Draws::Listed),
    row("implicit", "Maxima", Draws::FlatZeros),
    row("explicit", "Maxima", Draws::FlatHeights),
    row("parametric_surface", "Maxima", Draws::Listed),
    row("parametric", "Maxima", Draws::Listed),
    row("draw3d", "Maxima", Draws::Commands),
    row("wxdraw3d", "Maxima", Draws::Commands),
    row("wxplot3d", "Maxima", Draws::Heights),
};

}  // namespace

const KnownCommand* known_command(std::string_view name) {
    const auto* const found = std::ranges::find(known_commands, name, &KnownCommand::name);
    return found == known_commands.end() ? nullptr : found;
}

}  // namespace zeroset
