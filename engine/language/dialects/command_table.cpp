#include "engine/language/dialects/command_table.hpp"

#include <algorithm>
#include <array>

namespace zeroset {
namespace {

constexpr std::array known_commands = std::to_array<KnownCommand>({
    {"ContourPlot3D", "Mathematica", Draws::Equations},
    {"RegionPlot3D", "Mathematica", Draws::Equations},
    {"Plot3D", "Mathematica", Draws::Heights},
    {"ParametricPlot3D", "Mathematica", Draws::Points},
    {"SphericalPlot3D", "Mathematica", Draws::Spherical},
    {"RevolutionPlot3D", "Mathematica", Draws::Turned},
    {"Show", "Mathematica", Draws::Commands},
    {"Manipulate", "Mathematica", Draws::Commands},
    {"implicitplot3d", "Maple", Draws::Equations},
    {"plot3d", "Maple, Sage or SymPy", Draws::Heights},
    {"spacecurve", "Maple", Draws::Points},
    {"display", "Maple", Draws::Commands},
    {"show", "Sage", Draws::Commands},
    {"Implicit3d", "MuPAD", Draws::Equations},
    {"implicit_plot3d", "Sage", Draws::Equations},
    {"parametric_plot3d", "Sage", Draws::Points},
    {"spherical_plot3d", "Sage", Draws::AroundFirst},
    {"revolution_plot3d", "Sage", Draws::Turned},
    {"plot3d_implicit", "SymPy", Draws::Equations},
    {"plot_implicit", "SymPy", Draws::Equations},
    {"plot3d_parametric_surface", "SymPy", Draws::ThreeParts},
    {"plot3d_parametric_line", "SymPy", Draws::ThreeParts},
    {"fimplicit3", "MATLAB", Draws::Zeros},
    {"fsurf", "MATLAB", Draws::Sheet},
    {"ezsurf", "MATLAB", Draws::Sheet},
    {"ezmesh", "MATLAB", Draws::Sheet},
    {"fplot3", "MATLAB", Draws::Track},
    {"ezplot3", "MATLAB", Draws::Track},
    {"Surface", "GeoGebra", Draws::Listed},
    {"Superficie", "GeoGebra", Draws::Listed},
    {"Oberfläche", "GeoGebra", Draws::Listed},
    {"Curve", "GeoGebra", Draws::Listed},
    {"Curva", "GeoGebra", Draws::Listed},
    {"Kurve", "GeoGebra", Draws::Listed},
    {"Courbe", "GeoGebra", Draws::Listed},
    {"implicit", "Maxima", Draws::FlatZeros},
    {"explicit", "Maxima", Draws::FlatHeights},
    {"parametric_surface", "Maxima", Draws::Listed},
    {"parametric", "Maxima", Draws::Listed},
    {"draw3d", "Maxima", Draws::Commands},
    {"wxdraw3d", "Maxima", Draws::Commands},
    {"wxplot3d", "Maxima", Draws::Heights},
});

}  // namespace

const KnownCommand* known_command(std::string_view name) {
    const auto* const found = std::ranges::find(known_commands, name, &KnownCommand::name);
    return found == known_commands.end() ? nullptr : found;
}

}  // namespace zeroset
