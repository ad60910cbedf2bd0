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

// Machine code of surfaces: of a surface as a whole, of a shape that several share, or of its
// parts. Thread-safe.

namespace zeroset {

/// The use that machine code is made for.
enum class CodeUse : std::uint8_t {
    FirstPicture,  ///< a picture wanted soon, and more of them
    OnePicture,  ///< one picture soon and no other; code that takes longer to make than it saves is
                 ///< not made
    LongPicture,  ///< as OnePicture, but compiled as a whole, not by parts, as that is quicker and
                  ///< pays
    Pictures,     ///< many pictures, each as quick as possible
};

/// True if the surface has so many choices that much of it may be left out in small cells.
bool has_many_choices(const Expr& surface);

/// Number of steps that the interpreter takes in a small cell near the surface, after leaving out
/// what does not matter there. `region`: where such cells are sampled.
double steps_left(const Expr& surface, const Kernel& interpreted, const Box& region);

/// True if so much is left out in small cells that interpreting the rest draws pictures quicker
/// than machine code of the whole.
bool is_made_of_parts(const Expr& surface, const Box& region);

/// Makes kernels in machine code, or interpreters with machine code of the parts. Surfaces that
/// differ only in their constants share code. Unless `use` is Pictures, they also share the code of
/// earlier surfaces: if only such numbers have changed as changed before, nothing is compiled.
std::expected<std::vector<Kernel>, jit::CompileError> machine_code(std::span<const Expr> surfaces,
                                                                   const Box& region, CodeUse use,
                                                                   Precision precision);

/// Number of nodes that `machine_code` compiles if it compiles the surfaces as wholes; surfaces of
/// equal shape count once.
std::size_t nodes_of_shapes(std::span<const Expr> surfaces);

/// True if the machine code of each of the surfaces, as a whole, exists already.
bool is_compiled(std::span<const Expr> surfaces, CodeUse use);

}  // namespace zeroset
