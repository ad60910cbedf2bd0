#pragma once

#include "engine/expr/expr.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// Functions composed of several operators, one for each row of functions.def, specials.def,
/// noises.def and written_out.def.
enum class Composed : std::uint8_t {
#define ZEROSET_FUNCTION(id, name, least, most, arguments, meaning) id,
#include "engine/language/vocabulary/functions.def"
#undef ZEROSET_FUNCTION
#define ZEROSET_WRITTEN(section, id, name, least, most, arguments, meaning) id,
#include "engine/language/vocabulary/noises.def"
#include "engine/language/vocabulary/specials.def"
#include "engine/language/vocabulary/written_out.def"
#undef ZEROSET_WRITTEN
};

/// The sections of the help for the rows of shapes.def, noises.def, written_out.def and
/// specials.def.
enum class WordSection : std::uint8_t {
    None,
    Vectors,
    Bodies,
    Moves,
    Blends,
    Things,
    Noise,
    Complex,
    Polynomials,
    Special
};

/// A function of the language. Exactly one of `op`, `composed` and `body` is set.
struct Function {
    std::string_view name;
    int least;  ///< fewest arguments
    int most;   ///< most arguments; -1: any number
    std::string_view arguments;
    std::string_view meaning;          ///< one line of help, in English
    std::optional<Op> op;              ///< the operator, for a row of op.def
    std::optional<Composed> composed;  ///< for a row of functions.def, specials.def, noises.def or
                                       ///< written_out.def
    std::string_view body = {};        ///< for a row of library.def or shapes.def: the formula, in
                                       ///< the language itself
    std::string_view kinds = {};       ///< for a row of shapes.def: a letter for each argument
    WordSection section = WordSection::None;

    /// Whether the second argument is the name of an index: sum, prod, least, greatest.
    [[nodiscard]] bool repeats() const {
        return composed == Composed::Sum || composed == Composed::Product ||
               composed == Composed::Least || composed == Composed::Greatest;
    }
    /// Whether the first argument is the name of a value that goes from step to step.
    [[nodiscard]] bool iterates() const {
        return composed == Composed::Iterate || composed == Composed::DistanceEstimate;
    }
    /// Whether the function makes one vector of what it is given.
    [[nodiscard]] bool makes_vector() const {
        return composed == Composed::Vector2 || composed == Composed::Vector3 ||
               composed == Composed::Vector4;
    }
    /// Whether the function takes any number of values, as those of a list.
    [[nodiscard]] bool joins() const {
        return op == Op::Min || op == Op::Max || composed == Composed::Union ||
               composed == Composed::Intersect;
    }
    /// Whether the function is a row of shapes.def, noises.def, specials.def or written_out.def,
    /// which gives way to what the text defines and is a word before a bracket only.
    [[nodiscard]] bool is_word() const { return section != WordSection::None; }
    /// Whether a call of the function is a row by itself, and no value.
    [[nodiscard]] bool is_thing() const { return kinds == "T"; }
    /// Whether the function is a row of noises.def.
    [[nodiscard]] bool is_noise() const { return section == WordSection::Noise; }
    /// Whether the function asks for something of a complex number.
    [[nodiscard]] bool is_of_complex() const { return section == WordSection::Complex; }
    /// Whether the function is a polynomial whose first argument is its degree, or another one
    /// that is known by a name.
    [[nodiscard]] bool is_polynomial() const { return section == WordSection::Polynomials; }
    /// Whether the function is a row of specials.def.
    [[nodiscard]] bool is_special() const { return section == WordSection::Special; }
    /// Whether the function is written in the language: a row of library.def or shapes.def.
    [[nodiscard]] bool is_of_library() const { return !body.empty(); }
    /// Whether a call may have this many arguments; one may have to be a list or vector.
    [[nodiscard]] bool takes(std::size_t arguments_given) const;
    /// Whether one number may be the only argument.
    [[nodiscard]] bool takes_a_number() const { return least == 1 && !repeats(); }
    /// The error for another number of arguments than the function takes.
    [[nodiscard]] std::string refusal(std::size_t arguments_given) const;
};

/// All functions: the rows of op.def and of the tables *.def in this folder.
std::span<const Function> functions();
/// Finds a function that is no word, as find_function does.
const Function* find_fixed_function(std::string_view name);
/// Finds a function by its name or by another usual spelling (arcsin, sgn, tg); nullptr: none.
const Function* find_function(std::string_view name);
/// All spellings that find_function knows.
std::vector<std::string_view> function_spellings();
/// The inverse function, which f^-1 means: asin for sin; nullptr where there is none.
const Function* inverse_of(const Function& function);

/// The node of a call of a function of op.def or functions.def, except those that the elaborator
/// writes out: sum, prod, least, greatest, iterate, distance_estimate, psh, csd, noise, special
/// functions and the rows of written_out.def. `arguments`: as many as the function takes.
NodeId make_function(ExprBuilder& builder, const Function& function,
                     std::span<const NodeId> arguments);

}  // namespace zeroset
