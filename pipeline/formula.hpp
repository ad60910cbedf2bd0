#pragma once

#include "engine/language/parse.hpp"
#include "engine/scene/precision.hpp"
#include "engine/scene/scene.hpp"
#include "engine/view/box.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/surface_code.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace zeroset {

/// Values of parameters, by name.
using ParameterValues = std::map<std::string, double>;

enum class CodeState : std::uint8_t {
    Machine,           ///< machine code, or that of the parts of what has many choices
    InterpretedFirst,  ///< interpreted until its machine code is there
    Interpreted,       ///< too large for machine code
};

/// A text ready to be drawn.
struct Formula {
    std::string text;
    Program program;
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

/// Text to graphs.
std::expected<Program, InputError> read_formula(std::string_view text);

/// Text to a formula that is interpreted, its forms the tightest in `region`. Thread-safe.
std::expected<Formula, InputError> interpreted_formula(std::string_view text, const Box& region);

/// Text to a formula for a first picture: interpreted, unless there is machine code of an equal
/// one already. Its forms are the tightest in `region`. Thread-safe.
std::expected<Formula, InputError> prepare_formula(std::string_view text, const Box& region);
/// A formula for a first picture, as above, of a text that was read to `program` already.
std::expected<Formula, InputError> prepare_formula(std::string_view text, Program program,
                                                   const Box& region);

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

/// Text to machine code, unless it is too large for that, also in `precision`; takes up to a few
/// seconds.
std::expected<Formula, InputError> compile_formula(std::string_view text, const Box& region = {},
                                                   Precision precision = Precision::Float);

/// Whether its machine code will be there before a full picture without it is of use.
bool is_preview(const Formula& formula);

/// What is drawn of the formula; parameters without a value are 1.
Scene make_scene(const Formula& formula, const Box& clip, double w,
                 const ParameterValues& parameters);

/// The program's parameters in its order; those without a value are 1.
std::vector<double> values_of(const Program& program, const ParameterValues& parameters);

/// An error for the first value whose parameter the program does not have.
std::optional<InputError> check_parameters(const Program& program,
                                           const ParameterValues& parameters);

}  // namespace zeroset
