#pragma once

#include "document/row_program.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"
#include "engine/view/box.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/surface_code.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <vector>

namespace zeroset {

enum class CodeState : std::uint8_t {
    Machine,           ///< machine code, or that of the parts of what has many choices
    InterpretedFirst,  ///< interpreted until its machine code is there
    Interpreted,       ///< too large for machine code
};

/// The rows of a document, ready to be drawn.
struct Formula : RowProgram {
    std::vector<Expr> drawn{};      ///< the program's surfaces, each in its tightest form
    Box region;                     ///< where that is the tightest
    std::vector<Kernel> kernels{};  ///< of `drawn`
    /// Solid::unrestricted of each of `drawn`.
    std::vector<KernelFunction<ValueBatchOf<float>>> unrestricted{};
    CodeState code = CodeState::Machine;
    double compile_ms = 0.0;  ///< from text to code

    [[nodiscard]] bool uses_w() const;
    /// How many nodes the drawn graphs have.
    [[nodiscard]] std::size_t nodes() const;
    /// Whether it has code of this type; always for float.
    [[nodiscard]] bool has_code(Precision precision) const;
};

/// The code that a formula is prepared with.
enum class Preparation : std::uint8_t {
    Interpreted,  ///< the interpreters'; machine code may follow
    Quickest,     ///< machine code where an equal formula has some already, else the interpreters'
    Compiled,     ///< machine code unless it is too large for that; takes up to a few seconds
};

/// Makes the code of a program, its forms the tightest in `region`. Thread-safe.
std::expected<Formula, InputError> prepare_formula(RowProgram rows, const Box& region,
                                                   Preparation how);

/// The same formula with machine code, for one whose code is InterpretedFirst, also in `precision`.
/// Thread-safe.
std::expected<Formula, InputError> with_machine_code(const Formula& formula,
                                                     CodeUse use = CodeUse::FirstPicture,
                                                     Precision precision = Precision::Float);

/// Whether much of a surface may be left out in small cells.
bool has_many_choices(const Formula& formula);

/// Whether so much of a surface is left out in small cells that machine code is made of its parts
/// only, whatever it is for.
bool is_made_of_parts(const Formula& formula);

/// How many steps an interpreter takes for all surfaces in a small cell near them, where what does
/// not matter there is left out.
double steps_left(const Formula& formula);

/// The same formula with machine code in double beside that in float, interpreted if that cannot be
/// made. Takes as long as the code in float did. Thread-safe.
Formula with_double(const Formula& formula);

/// Whether its machine code will be there before a full picture without it is of use.
bool is_preview(const Formula& formula);

}  // namespace zeroset
