#pragma once

#include "document/import/imported.hpp"

#include <string_view>

// The readers, one for each format. They take any bytes, and refuse what they do not know with one
// line. The rows of their documents are not checked yet.

namespace zeroset {

ReadImport read_jsurf(std::string_view text);
ReadImport read_surf_script(std::string_view text);
/// A model or a collection of MathMod: JSON.
ReadImport read_mathmod(std::string_view text);
/// Equations of K3DSurf.
ReadImport read_k3ds(std::string_view text);
/// A list of instructions of Fidget or libfive.
ReadImport read_instructions(std::string_view text);
/// Presets of ImpVis: TOML.
ReadImport read_impvis(std::string_view text);
/// A scene of POV-Ray: its isosurfaces.
ReadImport read_pov(std::string_view text, const ImportFiles& files);
/// Formulas of the language, a row for each.
ReadImport read_formulas(std::string_view text, const ImportFiles& files);
/// A package of 3MF with implicit functions.
ReadImport read_three_mf(std::string_view bytes);

}  // namespace zeroset
