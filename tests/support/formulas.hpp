#pragma once

#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/prepare.hpp"
#include "pipeline/volume_source.hpp"

#include <expected>
#include <map>
#include <memory>
#include <string>
#include <string_view>

// Formulas and scenes of texts, without a document. `files`: what they may name.

namespace zeroset::test {

using Files = std::shared_ptr<const FieldSource>;

inline std::expected<Program, InputError> read_formula(std::string_view text,
                                                       const Files& files = volume_source({})) {
    auto rows = read_document_text(text, files).rows;
    if (!rows) return std::unexpected(rows.error());
    return *rows->program;
}

inline std::expected<Formula, InputError> prepared_formula(std::string_view text, const Box& region,
                                                           Preparation how = Preparation::Quickest,
                                                           const Files& files = volume_source({})) {
    auto rows = read_document_text(text, files).rows;
    if (!rows) return std::unexpected(rows.error());
    return prepare_formula(std::move(*rows), region, how);
}

/// Machine code in float, and in `precision`, unless the formula is too large for that.
inline std::expected<Formula, InputError> compile_formula(std::string_view text,
                                                          const Box& region = {},
                                                          Precision precision = Precision::Float,
                                                          const Files& files = volume_source({})) {
    auto formula = prepared_formula(text, region, Preparation::Compiled, files);
    if (!formula || formula->code == CodeState::Interpreted || formula->has_code(precision))
        return formula;
    return with_machine_code(*formula, CodeUse::Pictures, precision);
}

/// All surfaces of a formula, in the palette's colours. Parameters without a value are 1.
inline Scene make_scene(const Formula& formula, const Box& clip, double w = 0.0,
                        const std::map<std::string, double>& parameters = {}) {
    Scene scene{{}, clip, {}};
    for (std::size_t i = 0; i < formula.kernels.size(); ++i)
        scene.surfaces.push_back(
            {.kernel = formula.kernels[i], .solid = {.unrestricted = formula.unrestricted[i]}});
    scene.uniforms.set(0, w);
    for (std::size_t i = 0; i < formula.program->parameters.size(); ++i) {
        const auto found = parameters.find(formula.program->parameters[i]);
        scene.uniforms.set(1 + i, found == parameters.end() ? 1.0 : found->second);
    }
    return scene;
}

}  // namespace zeroset::test
