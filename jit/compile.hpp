#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"

#include <expected>
#include <string>

namespace zeroset::jit {

struct CompileOptions {
    int lanes = 0;  ///< floats a vector: 4, 8 or 16, half as many doubles; 0: this machine's widest
    /// Also all code in double; without, only that of points, and the interpreter's ranges and
    /// forms.
    bool with_double = false;
    /// Only what a first picture needs is made at once; forms on rays are made when they are first
    /// called, too.
    bool quick = false;
    /// Code in half the time, which is slower by some 10 to 40 %.
    bool hasty = false;
    /// How many nodes the interpreter evaluates for a function that few formulas need, before its
    /// code is made.
    std::size_t patient_nodes = 0;

    bool operator==(const CompileOptions&) const = default;
};

struct CompileError {
    std::string message;
};

/// Machine code for the graph: at once what the beam tracer always needs (forms, Newton's method,
/// values on rays), the other functions when they have been called for long enough, forms on rays
/// when they are first called. Until then, and in Kernel::without_waiting until they are there, the
/// interpreter does their work with the same bits, and forms that of forms on rays. Thread-safe;
/// equal graphs compiled lately share their code, function by function: asking for double later
/// makes what is missing. LLVM runs on threads of its own with a large stack.
std::expected<Kernel, CompileError> compile(const Expr& expr, const CompileOptions& options = {});

/// Whether `compile` has all that it makes at once for these options.
bool is_compiled(const Expr& expr, const CompileOptions& options = {});

/// Machine code for the values alone, in double; at once.
std::expected<PointFunction, CompileError> compile_points(const Expr& expr);

/// The LLVM IR or the assembly that `compile` makes machine code of; double's behind float's.
std::expected<std::string, CompileError> ir(const Expr& expr, const CompileOptions& options = {});
std::expected<std::string, CompileError> assembly(const Expr& expr,
                                                  const CompileOptions& options = {});

/// Compiles everything anew from here on: for measurements.
void forget_code();

/// The widest vectors of this machine, in floats.
int host_lanes();

}  // namespace zeroset::jit
