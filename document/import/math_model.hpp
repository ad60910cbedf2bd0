#pragma once

#include "document/import/imported.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// A slider of MathMod.
struct ModelSlider {
    std::string name;
    double value, lo, hi, step;
};

/// A model of MathMod or K3DSurf as its file has it: lists of texts by the names of MathMod's
/// fields, such as Fxyz, Const, Xmin.
struct MathModel {
    std::string kind;  ///< Iso3D, Param3D or a kind that is not drawn
    std::string name;
    std::size_t line = 0;
    std::map<std::string, std::vector<std::string>, std::less<>> fields = {};
    std::vector<ModelSlider> sliders = {};
    /// Names of fields as notes tell them, where the file calls them otherwise: "[x]".
    std::map<std::string, std::string, std::less<>> names_in_file = {};

    /// The texts of a field; none where it is missing.
    [[nodiscard]] const std::vector<std::string>& texts(std::string_view field) const;
    /// The text of a component; empty where there is none.
    [[nodiscard]] std::string_view text(std::string_view field, std::size_t component) const;
};

/// The model as a document. Formulas are those of fparser: % is the remainder with the sign of the
/// first number, int rounds, t is the time of animations.
ImportedDocument document_of(const MathModel& model);

}  // namespace zeroset
