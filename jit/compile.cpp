#include "jit/compile.hpp"

#include "engine/expr/interpret.hpp"
#include "engine/num/sleef.hpp"
#include "jit/kernel_cache.hpp"
#include "jit/orc.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace zeroset::jit {
namespace {

/// The result of `work()`, run on a large stack.
template <class Work>
auto on_large_stack(Work work) {
    struct Call {
        Work& work;
        std::optional<decltype(work())> result;
    } call{work, {}};
    run_on_large_stack(
        [](void* argument) {
            auto& c = *static_cast<Call*>(argument);
            c.result.emplace(c.work());
        },
        &call);
    return std::move(*call.result);
}

/// The vectors of the code in float and, if wanted, of that in double.
std::expected<std::vector<VectorKind>, CompileError> usable_vectors(const CompileOptions& options) {
    const int lanes = options.lanes == 0 ? host_lanes() : options.lanes;
    if (elementary_code(Elementary::Sin, lanes) == nullptr || lanes < 4) {
        return std::unexpected(CompileError{"this machine has no vectors of " +
                                            std::to_string(lanes) + " floats; its widest are of " +
                                            std::to_string(host_lanes())});
    }
    std::vector<VectorKind> kinds{{RealType::Float, lanes}};
    if (options.with_double) kinds.push_back({RealType::Double, lanes / 2});
    return kinds;
}

KernelCache& cache() {
    static KernelCache instance(64);
    return instance;
}

using Code = std::expected<std::shared_ptr<const MachineCode>, CompileError>;

Code cached_code(const Expr& expr, const VectorKind& kind) {
    const char* const type = kind.type == RealType::Float ? "f:" : "d:";
    std::string key = std::to_string(kind.lanes) + type + expr.key();
    if (auto known = cache().find(key)) return known;
    auto code = on_large_stack([&] { return make_code(expr, kind); });
    if (code) cache().insert(std::move(key), *code);
    return code;
}

void put_in(Kernel& kernel, RealType type, std::shared_ptr<const MachineCode> code) {
    if (type == RealType::Float) {
        kernel.range_function = reinterpret_cast<Kernel::RangeFunction>(code->range());
        kernel.value_function = reinterpret_cast<Kernel::ValueFunction>(code->value());
        kernel.form_function = reinterpret_cast<Kernel::FormFunction>(code->form());
        kernel.code = std::move(code);
    } else {
        kernel.range_function_double =
            reinterpret_cast<Kernel::RangeFunctionOf<double>>(code->range());
        kernel.value_function_double =
            reinterpret_cast<Kernel::ValueFunctionOf<double>>(code->value());
        kernel.form_function_double =
            reinterpret_cast<Kernel::FormFunctionOf<double>>(code->form());
        kernel.code_double = std::move(code);
    }
}

using Print = std::expected<std::string, CompileError> (*)(const Expr&, const VectorKind&);

std::expected<std::string, CompileError> printed(Print print, const Expr& expr,
                                                 const CompileOptions& options) {
    const auto kinds = usable_vectors(options);
    if (!kinds) return std::unexpected(kinds.error());
    std::string text;
    for (const VectorKind& kind : *kinds) {
        const auto part = on_large_stack([&] { return print(expr, kind); });
        if (!part) return part;
        text += *part;
    }
    return text;
}

}  // namespace

int host_lanes() {
    for (const int lanes : {16, 8}) {
        if (elementary_code(Elementary::Sin, lanes) != nullptr) return lanes;
    }
    return 4;
}

std::expected<Kernel, CompileError> compile(const Expr& expr, const CompileOptions& options) {
    const auto kinds = usable_vectors(options);
    if (!kinds) return std::unexpected(kinds.error());
    Kernel kernel = kernel_without_code(expr);
    for (const VectorKind& kind : *kinds) {
        auto code = cached_code(expr, kind);
        if (!code) return std::unexpected(code.error());
        put_in(kernel, kind.type, std::move(*code));
    }
    return kernel;
}

std::expected<std::string, CompileError> ir(const Expr& expr, const CompileOptions& options) {
    return printed(print_ir, expr, options);
}

std::expected<std::string, CompileError> assembly(const Expr& expr, const CompileOptions& options) {
    return printed(print_assembly, expr, options);
}

}  // namespace zeroset::jit
