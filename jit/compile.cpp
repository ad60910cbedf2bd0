#include "jit/compile.hpp"

#include "engine/expr/interpret.hpp"
#include "engine/num/sleef.hpp"
#include "jit/kernel_cache.hpp"
#include "jit/orc.hpp"

#include <optional>
#include <utility>

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

std::expected<int, CompileError> usable_lanes(const CompileOptions& options) {
    const int lanes = options.lanes == 0 ? host_lanes() : options.lanes;
    if (elementary_code(Elementary::Sin, lanes) == nullptr || lanes < 4) {
        return std::unexpected(CompileError{"this machine has no vectors of " +
                                            std::to_string(lanes) + " floats; its widest are of " +
                                            std::to_string(host_lanes())});
    }
    return lanes;
}

KernelCache& cache() {
    static KernelCache instance(64);
    return instance;
}

std::expected<std::shared_ptr<const MachineCode>, CompileError> cached_code(const Expr& expr,
                                                                            int lanes) {
    std::string key = std::to_string(lanes) + ":" + expr.key();
    if (auto known = cache().find(key)) return known;
    auto code = on_large_stack([&] { return make_code(expr, lanes); });
    if (code) cache().insert(std::move(key), *code);
    return code;
}

}  // namespace

int host_lanes() {
    for (const int lanes : {16, 8}) {
        if (elementary_code(Elementary::Sin, lanes) != nullptr) return lanes;
    }
    return 4;
}

std::expected<Kernel, CompileError> compile(const Expr& expr, const CompileOptions& options) {
    const auto lanes = usable_lanes(options);
    if (!lanes) return std::unexpected(lanes.error());
    auto code = cached_code(expr, *lanes);
    if (!code) return std::unexpected(code.error());
    Kernel kernel = kernel_without_code(expr);
    kernel.range_function = reinterpret_cast<Kernel::RangeFunction>((*code)->range());
    kernel.value_function = reinterpret_cast<Kernel::ValueFunction>((*code)->value());
    kernel.code = std::move(*code);
    return kernel;
}

std::expected<std::string, CompileError> ir(const Expr& expr, const CompileOptions& options) {
    const auto lanes = usable_lanes(options);
    if (!lanes) return std::unexpected(lanes.error());
    return on_large_stack([&] { return print_ir(expr, *lanes); });
}

std::expected<std::string, CompileError> assembly(const Expr& expr, const CompileOptions& options) {
    const auto lanes = usable_lanes(options);
    if (!lanes) return std::unexpected(lanes.error());
    return on_large_stack([&] { return print_assembly(expr, *lanes); });
}

}  // namespace zeroset::jit
