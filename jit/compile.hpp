#pragma once

#include "engine/expr/expr.hpp"
#include "engine/kernel/kernel.hpp"

#include <expected>
#include <optional>
#include <string>

namespace zeroset::jit {

struct CompileOptions {
    int lanes = 0;  ///< floats in a vector: 4, 8 or 16; half as many doubles; 0: the machine's most
    /// Makes all code in double as well. Without it only values at points have code in double;
    /// ranges and forms in double are the interpreter's.
    bool with_double = false;
    /// Makes at once only what a first picture needs; forms on rays, too, are made when first
    /// called.
    bool quick = false;
    /// Makes nothing at once: the code of each function when it is first called.
    bool on_call = false;
    /// Halves the time of compilation, for code that is slower by some 10 to 40 %.
    bool hasty = false;
    /// Number of nodes that the interpreter evaluates for a function that few formulas need, before
    /// its code is made.
    std::size_t patient_nodes = 0;

    bool operator==(const CompileOptions&) const = default;
};

struct CompileError {
    std::string message;
};

/// Makes machine code for the graph: at once what the beam tracer always needs (forms, Newton's
/// method, values on rays), the other functions when they have been called for long enough, forms
/// on rays when they are first called. Until then, and in Kernel::without_waiting until they are
/// there, the interpreter does their work with the same bits, and forms do the work of forms on
/// rays. Thread-safe. Equal graphs compiled lately share their code, function by function: a later
/// call with double makes only what is missing. LLVM runs on threads of its own with a large stack.
std::expected<Kernel, CompileError> compile(const Expr& expr, const CompileOptions& options = {});

/// A kernel of which only what is in double is quick: its ranges, values and forms become machine
/// code, each once it has been called for as many items as the interpreter does in about the time
/// that LLVM takes. Until then, and where LLVM fails, the interpreter does their work with the same
/// bits. Thread-safe.
Kernel compile_when_called(const Expr& expr, const CompileOptions& options = {});

/// Whether all that `compile` makes at once for these options is in the cache.
bool is_compiled(const Expr& expr, const CompileOptions& options = {});

/// Makes machine code for the values alone, in double, at once.
std::expected<PointFunction, CompileError> compile_points(const Expr& expr);

/// Makes machine code for ranges alone, or for values with gradients, in double, at once.
std::expected<KernelFunction<RangeBatchOf<double>>, CompileError> compile_ranges(const Expr& expr);
std::expected<KernelFunction<ValueBatchOf<double>>, CompileError> compile_values(const Expr& expr);

/// The LLVM IR or the assembly of the code that `compile` makes: first in float, then in double.
std::expected<std::string, CompileError> ir(const Expr& expr, const CompileOptions& options = {});
std::expected<std::string, CompileError> assembly(const Expr& expr,
                                                  const CompileOptions& options = {});

/// Whether code can be made: false where LLVM, a module beside the program, cannot be loaded. The
/// first call loads it, which takes about 80 ms. Thread-safe.
bool can_compile();

/// One line on why no code can be made, once it was tried; nothing before, and where it can.
std::optional<std::string> missing_code();

/// Forgets all code, so that everything is compiled anew; for measurements.
void forget_code();

/// Number of floats in this machine's widest vectors.
int host_lanes();

}  // namespace zeroset::jit
