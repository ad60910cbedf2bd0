#include "jit/compile.hpp"

#include "engine/algebra/switches.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/real/rounding.hpp"
#include "engine/real/sleef.hpp"
#include "jit/kernel_cache.hpp"
#include "jit/llvm_module.hpp"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <utility>
#include <vector>

namespace zeroset::jit {
namespace {

/// The result of `work()`, an expected value, run on a thread with a stack large enough for LLVM on
/// a deep graph.
template <class Work>
auto on_large_stack(Work work) -> decltype(work()) {
    constexpr std::size_t stack_bytes = std::size_t{256} << 20U;
    struct Call {
        Work& work;
        std::optional<decltype(work())> result;
    } call{work, {}};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, stack_bytes);
    pthread_t thread{};
    const int error = pthread_create(
        &thread, &attributes,
        [](void* argument) -> void* {
            auto& c = *static_cast<Call*>(argument);
            c.result.emplace(c.work());
            return nullptr;
        },
        &call);
    pthread_attr_destroy(&attributes);
    if (error != 0) return std::unexpected(CompileError{"there is no memory for a thread"});
    pthread_join(thread, nullptr);
    return std::move(*call.result);
}

/// The vectors of the code in float and of the code in double.
struct Vectors {
    VectorKind in_float, in_double;
};

std::expected<Vectors, CompileError> usable_vectors(const CompileOptions& options) {
    const int lanes = options.lanes == 0 ? host_lanes() : options.lanes;
    if (elementary_code(Elementary::Sin, lanes) == nullptr || lanes < 4) {
        return std::unexpected(CompileError{"this machine has no vectors of " +
                                            std::to_string(lanes) + " floats; its widest are of " +
                                            std::to_string(host_lanes())});
    }
    return Vectors{.in_float = {.type = RealType::Float, .lanes = lanes},
                   .in_double = {.type = RealType::Double, .lanes = lanes / 2}};
}

constexpr std::size_t functions_kept = 256;

KernelCache<MachineCode>& cache() {
    static KernelCache<MachineCode> instance(functions_kept);
    return instance;
}

/// Cache of the functions that are made when they are called.
KernelCache<void>& later_functions() {
    static KernelCache<void> instance(functions_kept);
    return instance;
}

/// One function that is to be made.
struct Piece {
    VectorKind vector;
    KernelKind kind;
    bool hasty = false;

    [[nodiscard]] std::string key(const Expr& expr) const {
        const char* const type = vector.type == RealType::Float ? "f" : "d";
        const char* const how = hasty ? "hasty " : "";
        return how + std::to_string(vector.lanes) + type + symbol_of(kind) + ":" + expr.key();
    }
    [[nodiscard]] WantedCode wanted(const Expr& expr) const {
        return {.expr = expr, .vectors = vector, .kind = kind, .hasty = hasty};
    }
};

/// The code with the fields that it asks, which it only points to; the cache keeps no field.
std::shared_ptr<const MachineCode> with_fields(std::shared_ptr<const MachineCode> code,
                                               const Expr& expr) {
    struct Owner {
        std::shared_ptr<const MachineCode> code;
        std::vector<std::shared_ptr<const Field>> fields;
    };
    std::vector<std::shared_ptr<const Field>> fields = fields_of(expr);
    if (fields.empty()) return code;
    const auto owner = std::make_shared<const Owner>(std::move(code), std::move(fields));
    return {owner, owner->code.get()};
}

/// Code of a function, from the cache or made now; in any rounding mode of the caller.
Code cached_code(const Expr& expr, const Piece& piece) {
    std::string key = piece.key(expr);
    if (auto known = cache().find(key)) return with_fields(std::move(known), expr);
    const auto& llvm = llvm_module();
    if (!llvm) return std::unexpected(llvm.error());
    auto code = on_large_stack([&] {
        const NearestRounding guard;
        return (*llvm)->make(piece.wanted(expr));
    });
    if (!code) return code;
    cache().insert(std::move(key), *code);
    return with_fields(std::move(*code), expr);
}

template <class Batch>
void put_in(KernelFunction<Batch>& function, std::shared_ptr<const MachineCode> code) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the linker gives an address
    function.call = reinterpret_cast<void (*)(const void*, const Batch*)>(code->entry());
    function.code = std::move(code);
}

void put_in(Kernel& kernel, const Piece& piece, std::shared_ptr<const MachineCode> code) {
    const bool in_float = piece.vector.type == RealType::Float;
    switch (piece.kind) {
#define ZEROSET_KERNEL_FUNCTION(name, Kind, Batch)                      \
    case KernelKind::Kind:                                              \
        return in_float ? put_in(kernel.in_float.name, std::move(code)) \
                        : put_in(kernel.in_double.name, std::move(code));
#include "engine/kernel/kernel_functions.def"
        case KernelKind::RayValue: return put_in(kernel.ray_value, std::move(code));
        case KernelKind::Points: assert(false); return;
    }
}

/// A function whose code is made once it has been called for enough items, as most formulas are
/// drawn without it. Until then, and where LLVM fails, `otherwise` does its work.
template <class Batch>
class OnCall {
public:
    /// `patience`: number of items for which `otherwise` does the work, giving the same bits as the
    /// code; 0 where its results differ.
    OnCall(Expr expr, const Piece& piece, KernelFunction<Batch> otherwise, std::size_t patience)
        : expr_(std::move(expr)),
          piece_(piece),
          otherwise_(std::move(otherwise)),
          patience_(patience),
          made_(otherwise_) {}

    static void call(const void* code, const Batch* batch) {
        const auto& self = *static_cast<const OnCall*>(code);
        if (!self.ready_.load(std::memory_order_acquire)) {
            // Let `otherwise` work during the patience and while another thread makes the code.
            const bool others_make_it = self.patience_ > 0 && self.begun_;
            if (others_make_it || self.items_.fetch_add(batch->size) < self.patience_)
                return self.otherwise_(*batch);
            self.make();
        }
        self.made_(*batch);
    }
    static void call_meanwhile(const void* code, const Batch* batch) {
        const auto& self = *static_cast<const OnCall*>(code);
        const bool ready = self.ready_.load(std::memory_order_acquire);
        (ready ? self.made_ : self.otherwise_)(*batch);
    }

private:
    void make() const {
        begun_ = true;
        std::call_once(once_, [&] {
            if (auto made = cached_code(expr_, piece_)) put_in(made_, *made);
            ready_.store(true, std::memory_order_release);
        });
    }

    Expr expr_;
    Piece piece_;
    KernelFunction<Batch> otherwise_;
    std::size_t patience_;
    mutable std::atomic<std::size_t> items_ = 0;
    mutable std::atomic<bool> begun_ = false;
    mutable std::once_flag once_;
    mutable KernelFunction<Batch> made_;
    mutable std::atomic<bool> ready_ = false;
};

template <class Batch>
void make_on_call(KernelFunction<Batch>& function, const Expr& expr, const Piece& piece,
                  const KernelFunction<Batch>& otherwise, std::size_t patience) {
    std::string key = piece.key(expr);
    auto code = later_functions().find(key);
    if (!code) {
        code = std::make_shared<const OnCall<Batch>>(expr, piece, otherwise, patience);
        if (fields_of(expr).empty()) later_functions().insert(std::move(key), code);
    }
    function = {OnCall<Batch>::call, std::move(code), OnCall<Batch>::call_meanwhile};
}

/// Replaces `function`, the interpreter's, by an OnCall that makes code once the interpreter has
/// evaluated `patient_nodes` nodes, which takes about as long.
template <class Batch>
void make_later(KernelFunction<Batch>& function, const Expr& expr, const Piece& piece,
                std::size_t patient_nodes) {
    make_on_call(function, expr, piece, KernelFunction<Batch>(function),
                 patient_nodes / expr.nodes().size());
}

/// The functions made at once for these options, those that the beam tracer needs; longest first.
std::vector<Piece> pieces_of(const Vectors& vectors, const CompileOptions& options) {
    if (options.on_call) return {};
    const bool hasty = options.hasty;
    std::vector<Piece> pieces{
        {.vector = vectors.in_float, .kind = KernelKind::Form, .hasty = hasty}};
    if (!options.quick)
        pieces.push_back({.vector = vectors.in_float, .kind = KernelKind::RayForm, .hasty = hasty});
    pieces.push_back({.vector = vectors.in_float, .kind = KernelKind::Newton, .hasty = hasty});
    pieces.push_back({.vector = vectors.in_double, .kind = KernelKind::RayValue, .hasty = hasty});
    if (options.with_double) {
        pieces.push_back({.vector = vectors.in_double, .kind = KernelKind::Form, .hasty = hasty});
        pieces.push_back({.vector = vectors.in_double, .kind = KernelKind::Newton, .hasty = hasty});
        if (!options.quick)
            pieces.push_back(
                {.vector = vectors.in_double, .kind = KernelKind::RayForm, .hasty = hasty});
    }
    return pieces;
}

/// The codes of the pieces, made by two threads.
std::vector<Code> codes_of(const Expr& expr, std::span<const Piece> pieces) {
    std::vector<Code> codes(pieces.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < pieces.size(); i = next++)
            codes[i] = cached_code(expr, pieces[i]);
    };
    const std::jthread other(work);
    work();
    return codes;
}

/// Adds the functions that are to be made when they are called, which few formulas need.
void add_later_functions(Kernel& kernel, const Expr& expr, const Vectors& vectors,
                         const CompileOptions& options) {
    const bool hasty = options.hasty;
    const auto later = [&](auto& function, const VectorKind& vector, KernelKind kind) {
        make_later(function, expr, {vector, kind, hasty}, options.patient_nodes);
    };
    later(kernel.in_float.range, vectors.in_float, KernelKind::Range);
    later(kernel.in_float.value, vectors.in_float, KernelKind::Value);
    later(kernel.in_double.value, vectors.in_double, KernelKind::Value);
    if (options.with_double) later(kernel.in_double.range, vectors.in_double, KernelKind::Range);
    if (options.on_call) {
        later(kernel.in_float.form, vectors.in_float, KernelKind::Form);
        later(kernel.in_float.newton, vectors.in_float, KernelKind::Newton);
        later(kernel.ray_value, vectors.in_double, KernelKind::RayValue);
        if (options.with_double) {
            later(kernel.in_double.form, vectors.in_double, KernelKind::Form);
            later(kernel.in_double.newton, vectors.in_double, KernelKind::Newton);
        }
    }
    if (!options.quick && !options.on_call) return;
    make_on_call(kernel.in_float.ray_form, expr,
                 {.vector = vectors.in_float, .kind = KernelKind::RayForm, .hasty = hasty},
                 kernel.in_float.form, 0);
    if (options.with_double) {
        make_on_call(kernel.in_double.ray_form, expr,
                     {.vector = vectors.in_double, .kind = KernelKind::RayForm, .hasty = hasty},
                     kernel.in_double.form, 0);
    }
}

/// Makes the machine code of one function in double.
template <class Batch>
std::expected<KernelFunction<Batch>, CompileError> compiled_in_double(const Expr& expr,
                                                                      KernelKind kind) {
    const auto vectors = usable_vectors({});
    if (!vectors) return std::unexpected(vectors.error());
    auto code = cached_code(expr, {.vector = vectors->in_double, .kind = kind});
    if (!code) return std::unexpected(code.error());
    KernelFunction<Batch> function;
    put_in(function, std::move(*code));
    return function;
}

using Print = CodeText (*)(const WantedCode&);

CodeText printed(Print LlvmModule::* print, const Expr& expr, const CompileOptions& options) {
    const auto vectors = usable_vectors(options);
    if (!vectors) return std::unexpected(vectors.error());
    const auto& llvm = llvm_module();
    if (!llvm) return std::unexpected(llvm.error());
    std::vector<VectorKind> vector_kinds{vectors->in_float};
    if (options.with_double) vector_kinds.push_back(vectors->in_double);
    std::string text;
    for (const VectorKind& vector : vector_kinds) {
        for (const KernelKind kind : kernel_kinds) {
            const bool always_double = kind == KernelKind::RayValue;
            if (always_double && vector.type == RealType::Float) continue;
            const Piece piece{.vector = vector, .kind = kind};
            const auto code = on_large_stack([&] { return ((*llvm)->*print)(piece.wanted(expr)); });
            if (!code) return code;
            text += *code;
        }
    }
    return text;
}

}  // namespace

void forget_code() {
    cache().clear();
    later_functions().clear();
}

int host_lanes() {
    for (const int lanes : {16, 8}) {
        if (elementary_code(Elementary::Sin, lanes) != nullptr) return lanes;
    }
    return 4;
}

std::expected<Kernel, CompileError> compile(const Expr& expr, const CompileOptions& options) {
    const auto vectors = usable_vectors(options);
    if (!vectors) return std::unexpected(vectors.error());
    const std::vector<Piece> pieces = pieces_of(*vectors, options);
    const std::vector<Code> codes = codes_of(expr, pieces);
    Kernel kernel = interpret(expr);
    kernel.interpreted = false;
    kernel.steps = 0;
    kernel.branches = has_branches(expr);
    kernel.specializer = nullptr;
    kernel.lane_multiple = static_cast<std::size_t>(vectors->in_float.lanes);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!codes[i]) return std::unexpected(codes[i].error());
        put_in(kernel, pieces[i], *codes[i]);
    }
    kernel.has_double = options.with_double;
    add_later_functions(kernel, expr, *vectors, options);
    return kernel;
}

Kernel compile_when_called(const Expr& expr, const CompileOptions& options) {
    Kernel kernel = interpret(expr);
    const auto vectors = usable_vectors(options);
    if (!vectors) return kernel;
    const auto later = [&](auto& function, KernelKind kind) {
        make_later(function, expr, {vectors->in_double, kind, options.hasty},
                   options.patient_nodes);
    };
    later(kernel.in_double.range, KernelKind::Range);
    later(kernel.in_double.value, KernelKind::Value);
    later(kernel.in_double.form, KernelKind::Form);
    return kernel;
}

bool is_compiled(const Expr& expr, const CompileOptions& options) {
    const auto vectors = usable_vectors(options);
    return vectors && std::ranges::all_of(pieces_of(*vectors, options), [&](const Piece& piece) {
               return cache().find(piece.key(expr)) != nullptr;
           });
}

std::expected<PointFunction, CompileError> compile_points(const Expr& expr) {
    return compiled_in_double<ValueBatchOf<double>>(expr, KernelKind::Points);
}

std::expected<KernelFunction<RangeBatchOf<double>>, CompileError> compile_ranges(const Expr& expr) {
    return compiled_in_double<RangeBatchOf<double>>(expr, KernelKind::Range);
}

std::expected<KernelFunction<ValueBatchOf<double>>, CompileError> compile_values(const Expr& expr) {
    return compiled_in_double<ValueBatchOf<double>>(expr, KernelKind::Value);
}

std::expected<std::string, CompileError> ir(const Expr& expr, const CompileOptions& options) {
    return printed(&LlvmModule::ir, expr, options);
}

std::expected<std::string, CompileError> assembly(const Expr& expr, const CompileOptions& options) {
    return printed(&LlvmModule::assembly, expr, options);
}

}  // namespace zeroset::jit
