#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"
#include "engine/scene/precision.hpp"
#include "engine/view/box.hpp"
#include "jit/compile.hpp"

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <vector>

// Machine code of surfaces: of each as a whole, of a shape that several have, or of its parts.
// Thread-safe.

namespace zeroset {

/// The pictures that machine code is made for.
enum class CodeUse : std::uint8_t {
    FirstPicture,  ///< that comes soon, and more
    OnePicture,    ///< soon, and no other: code that takes longer than it saves is not made
    LongPicture,   ///< as OnePicture, but of no parts: code of all is quicker and pays
    Pictures,      ///< many, as quick as can be
};

/// Whether much of the surface may be left out in small cells: it has many choices.
bool has_many_choices(const Expr& surface);

/// How many steps the interpreter takes in a small cell near the surface, where what does not
/// matter there is left out. `region`: where that is looked for.
double steps_left(const Expr& surface, const Kernel& interpreted, const Box& region);

/// Whether so much is left out in small cells that pictures are drawn quicker by an interpreter of
/// the rest than by machine code of all.
bool is_made_of_parts(const Expr& surface, const Box& region);

/// Kernels in machine code, or of interpreters that have machine code of the parts. Surfaces that
/// differ in nothing but their constants share their code, and, unless it is for many pictures,
/// with those that it was made for before: where numbers have changed that did before, nothing is
/// compiled.
std::expected<std::vector<Kernel>, jit::CompileError> machine_code(std::span<const Expr> surfaces,
                                                                   const Box& region, CodeUse use,
                                                                   Precision precision);

/// How many nodes `machine_code` compiles of the surfaces as wholes: those of each shape once.
std::size_t nodes_of_shapes(std::span<const Expr> surfaces);

/// Whether the machine code of all of them is there, of each as a whole.
bool is_compiled(std::span<const Expr> surfaces, CodeUse use);

}  // namespace zeroset
