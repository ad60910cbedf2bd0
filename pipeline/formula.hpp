#pragma once

#include "document/row_program.hpp"
#include "engine/expr/patch_graph.hpp"
#include "engine/kernel/surface_facts.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"
#include "engine/view/box.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/surface_code.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <string>
#include <vector>

namespace zeroset {

enum class CodeState : std::uint8_t {
    Machine,  ///< machine code, of the whole or of the parts of a formula with many choices
    InterpretedFirst,  ///< interpreted until its machine code is ready
    Interpreted,       ///< too large for machine code
};

/// A surface of a formula that is a curve or a point.
struct ThickSurface {
    std::size_t surface;
    PatchKind kind;
};

/// A surface of a formula that is a point.
struct PointRow {
    std::size_t surface;
    PatchGraphs graphs;
};

/// The rows of a document with the code that draws them.
struct Formula : RowProgram {
    /// The program's surfaces, each in its tightest form; of a parametric one as it is there.
    std::vector<Expr> drawn{};
    glm::dvec3 stretch{1.0};        ///< of the world in which `drawn` is (Camera)
    Box region;                     ///< the region of that world in which `drawn` is tightest
    std::vector<Kernel> kernels{};  ///< one for each of `drawn`
    /// The facts known of each of `drawn`, whatever its code is: its kernels have them. nullptr for
    /// parametric ones, whose only kernel has them.
    std::vector<std::shared_ptr<const SurfaceFacts>> facts{};
    /// The surfaces that are curves or points, as the uniforms behind the parameters tell their
    /// thickness (pipeline/patch_surface.hpp), one after the other.
    std::vector<ThickSurface> thick{};
    std::vector<PointRow> points{};  ///< the surfaces that are points
    /// Solid::unrestricted for each of `drawn`.
    std::vector<KernelFunction<ValueBatchOf<float>>> unrestricted{};
    /// The function that sections show of each surface, as it was typed; none for parametric ones.
    std::vector<PointFunction> section_values{};
    CodeState code = CodeState::Machine;
    double compile_ms = 0.0;  ///< time from text to code

    [[nodiscard]] bool uses_w() const;
    /// Number of nodes of all drawn graphs.
    [[nodiscard]] std::size_t nodes() const;
    /// True if there is code in this precision; always true for float.
    [[nodiscard]] bool has_code(Precision precision) const;
};

/// Which code to make for a formula.
enum class Preparation : std::uint8_t {
    Interpreted,  ///< the interpreters' code; machine code may follow
    Quickest,  ///< machine code if an equal formula has some already, else the interpreters' code
    Compiled,  ///< machine code unless the formula is too large for it; takes up to a few seconds
};

/// Where a formula is looked at, and how it is drawn there.
struct FormulaPlace {
    Box region;
    glm::dvec3 stretch;  ///< of the world in which it is drawn (Camera)

    // NOLINTNEXTLINE(google-explicit-constructor): a box is such a place where nothing is stretched
    FormulaPlace(const Box& box = {}, const glm::dvec3& drawn = glm::dvec3(1.0))
        : region(box), stretch(drawn) {}
    bool operator==(const FormulaPlace&) const = default;
};

/// Makes the code of a program, in forms that are tightest in the place's region. Thread-safe.
std::expected<Formula, InputError> prepare_formula(RowProgram rows, const FormulaPlace& place,
                                                   Preparation how);

/// Returns the formula with machine code, also in `precision`; its code must be InterpretedFirst.
/// Thread-safe.
std::expected<Formula, InputError> with_machine_code(const Formula& formula,
                                                     CodeUse use = CodeUse::FirstPicture,
                                                     Precision precision = Precision::Float);

/// True if a surface has so many choices that much of it may be left out in small cells.
bool has_many_choices(const Formula& formula);

/// True if so much of a surface is left out in small cells that machine code is made only of its
/// parts, whatever the code is for.
bool is_made_of_parts(const Formula& formula);

/// Number of interpreter steps for all surfaces in a small cell near them, after leaving out what
/// does not matter there.
double steps_left(const Formula& formula);

/// Returns the formula with machine code in double beside that in float, or with interpreted double
/// if that cannot be made. Takes as long as making the code in float. Thread-safe.
Formula with_double(const Formula& formula);

/// A short line about the formula's code for the user; empty where the code is as expected.
std::string note_on_code(const Formula& formula);

/// True if machine code will be ready before a full picture without it would be of use.
bool is_preview(const Formula& formula);

}  // namespace zeroset
