#include "jit/lower.hpp"

#include "engine/expr/algebra.hpp"
#include "engine/expr/frustum.hpp"
#include "engine/expr/kernel.hpp"
#include "jit/lanes.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <cstddef>

namespace zeroset::jit {
namespace {

/// A function `void name(const void* code, const Batch* batch)` with the loop over the batch's
/// items: `entry` runs once, `body` for each vector of items.
class BatchFunction {
public:
    BatchFunction(llvm::Module& module, const char* name, const VectorKind& kind,
                  std::size_t size_offset)
        : builder_(module.getContext()), emitter_{builder_, kind} {
        auto* const type = llvm::FunctionType::get(
            builder_.getVoidTy(), {builder_.getPtrTy(), builder_.getPtrTy()}, false);
        function_ = llvm::Function::Create(type, llvm::Function::ExternalLinkage, name, module);
        function_->addFnAttr(llvm::Attribute::StrictFP);
        function_->addFnAttr(llvm::Attribute::NoUnwind);
        entry_ = llvm::BasicBlock::Create(module.getContext(), "entry", function_);
        body_ = llvm::BasicBlock::Create(module.getContext(), "body", function_);
        builder_.SetInsertPoint(entry_);
        size_ = builder_.CreateLoad(builder_.getInt64Ty(), member(size_offset), "size");
        builder_.SetInsertPoint(body_);
        item_ = builder_.CreatePHI(builder_.getInt64Ty(), 2, "item");
        builder_.SetInsertPoint(entry_);
    }

    /// Closes the loop.
    void finish() {
        llvm::BasicBlock* const done =
            llvm::BasicBlock::Create(builder_.getContext(), "done", function_);
        llvm::Value* const next = builder_.CreateAdd(
            item_, builder_.getInt64(static_cast<std::uint64_t>(emitter_.kind.lanes)));
        builder_.CreateCondBr(builder_.CreateICmpULT(next, size_), body_, done);
        item_->addIncoming(next, builder_.GetInsertBlock());
        builder_.SetInsertPoint(done);
        builder_.CreateRetVoid();
        if (nowhere_ != nullptr) {
            builder_.SetInsertPoint(nowhere_);
            builder_.CreateRetVoid();
        }
        builder_.SetInsertPoint(entry_);
        builder_.CreateBr(body_);
        item_->addIncoming(builder_.getInt64(0), entry_);
    }

    void go_to_body() { builder_.SetInsertPoint(body_); }

    /// Tells that a node of the body has been emitted. LLVM's time grows with the square of a basic
    /// block's length, so a long body becomes a chain of blocks; the branches between them, never
    /// left out, keep LLVM from joining the blocks again.
    void count_node() {
        if (++nodes_ % nodes_a_block != 0) return;
        llvm::LLVMContext& context = builder_.getContext();
        if (nowhere_ == nullptr) nowhere_ = llvm::BasicBlock::Create(context, "empty", function_);
        llvm::BasicBlock* const next = llvm::BasicBlock::Create(context, "further", function_);
        builder_.CreateCondBr(builder_.CreateICmpNE(size_, builder_.getInt64(0)), next, nowhere_);
        builder_.SetInsertPoint(next);
    }

    /// An array pointer of the batch; call before go_to_body.
    llvm::Value* array(std::size_t offset) {
        return builder_.CreateLoad(builder_.getPtrTy(), member(offset));
    }
    Lanes load(llvm::Value* array) {
        llvm::Value* const address = builder_.CreateGEP(emitter_.real(), array, item_);
        return {&emitter_,
                builder_.CreateAlignedLoad(emitter_.real_vector(), address, alignment())};
    }
    /// The same number, `array[index]`, in all lanes.
    Lanes load_uniform(llvm::Value* array, std::size_t index) {
        llvm::Value* const address = builder_.CreateConstGEP1_64(emitter_.real(), array, index);
        llvm::Value* const one = builder_.CreateLoad(emitter_.real(), address);
        return {&emitter_,
                builder_.CreateVectorSplat(static_cast<unsigned>(emitter_.kind.lanes), one)};
    }
    void store(llvm::Value* array, const Lanes& lanes) { store_vector(array, lanes.value); }
    /// All ones where the mask holds.
    void store(llvm::Value* array, const LaneMask& mask) {
        store_vector(array,
                     builder_.CreateSExt(mask.value, emitter_.vector_of(emitter_.integer())));
    }

    /// Of a number of the vectors' type.
    Lanes splat(double value) { return like(Lanes{&emitter_, nullptr}, value); }
    LaneMask everywhere() {
        return {&emitter_,
                llvm::Constant::getAllOnesValue(emitter_.vector_of(builder_.getInt1Ty()))};
    }

private:
    llvm::Value* member(std::size_t offset) {
        return builder_.CreateConstGEP1_64(builder_.getInt8Ty(), function_->getArg(1), offset);
    }
    void store_vector(llvm::Value* array, llvm::Value* vector) {
        llvm::Value* const address = builder_.CreateGEP(emitter_.real(), array, item_);
        builder_.CreateAlignedStore(vector, address, alignment());
    }
    [[nodiscard]] llvm::Align alignment() const {
        return llvm::Align(emitter_.is_float() ? sizeof(float) : sizeof(double));
    }

    llvm::IRBuilder<> builder_;
    Emitter emitter_;
    llvm::Function* function_ = nullptr;
    llvm::BasicBlock* entry_ = nullptr;
    llvm::BasicBlock* body_ = nullptr;
    llvm::Value* size_ = nullptr;
    llvm::PHINode* item_ = nullptr;

    static constexpr std::size_t nodes_a_block = 100;
    std::size_t nodes_ = 0;
    llvm::BasicBlock* nowhere_ = nullptr;  ///< where an empty batch would go
};

template <class Real>
void lower_range(const Expr& expr, std::span<const Facts> facts, const VectorKind& kind,
                 llvm::Module& module) {
    using Batch = RangeBatchOf<Real>;
    BatchFunction function(module, range_symbol, kind, offsetof(Batch, size));
    std::array<llvm::Value*, 3> neg_lo{};
    std::array<llvm::Value*, 3> hi{};
    for (std::size_t i = 0; i < 3; ++i) {
        neg_lo[i] = function.array(offsetof(Batch, neg_lo) + i * sizeof(Real*));
        hi[i] = function.array(offsetof(Batch, hi) + i * sizeof(Real*));
    }
    llvm::Value* const uniforms = function.array(offsetof(Batch, uniforms));
    llvm::Value* const f_neg_lo = function.array(offsetof(Batch, f_neg_lo));
    llvm::Value* const f_hi = function.array(offsetof(Batch, f_hi));
    llvm::Value* const continuous = function.array(offsetof(Batch, continuous));

    const auto leaf = [&](const Node& node, const Facts& fact) -> Enclosure<Lanes> {
        if (fact.constant) {
            const auto box = fact.constant_box<Real>();
            return {{function.splat(static_cast<double>(box.neg_lo)),
                     function.splat(static_cast<double>(box.hi))}};
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v < 3) return {{function.load(neg_lo[v]), function.load(hi[v])}};
        return {{function.load_uniform(uniforms, 2 * (v - 3)),
                 function.load_uniform(uniforms, 2 * (v - 3) + 1)}};
    };
    IntervalAlgebra<Lanes> algebra;
    const Enclosure<Lanes> f = evaluate(
        expr, facts, algebra, leaf, [&] { function.go_to_body(); }, [&] { function.count_node(); });
    const Interval<Lanes> range = answer(f);
    function.store(f_neg_lo, range.neg_lo);
    function.store(f_hi, range.hi);
    function.store(continuous,
                   conjunction(f.everywhere, f.continuous).value_or(function.everywhere()));
    function.finish();
}

template <class Real>
void lower_form(const Expr& expr, std::span<const Facts> facts, const VectorKind& kind,
                llvm::Module& module) {
    using Batch = FormBatchOf<Real>;
    BatchFunction function(module, form_symbol, kind, offsetof(Batch, size));
    const auto array = [&](std::size_t offset) { return function.array(offset); };
    const std::array in{array(offsetof(Batch, u)), array(offsetof(Batch, v)),
                        array(offsetof(Batch, s)), array(offsetof(Batch, s_radius))};
    llvm::Value* const frustum = array(offsetof(Batch, frustum));
    llvm::Value* const uniforms = array(offsetof(Batch, uniforms));
    const std::array k{array(offsetof(Batch, k)), array(offsetof(Batch, k) + sizeof(Real*)),
                       array(offsetof(Batch, k) + 2 * sizeof(Real*))};
    const std::array out{array(offsetof(Batch, c)),        array(offsetof(Batch, e)),
                         array(offsetof(Batch, r)),        array(offsetof(Batch, slope_neg_lo)),
                         array(offsetof(Batch, slope_hi)), array(offsetof(Batch, continuous)),
                         array(offsetof(Batch, nowhere))};
    const auto view = frustum_lanes<Lanes>(
        [&](std::size_t index) { return function.load_uniform(frustum, index); });
    std::optional<CellLanes<Lanes>> cell;

    const auto leaf = [&](const Node& node, const Facts& fact) -> BeamValue<Lanes> {
        if (fact.constant) {
            return constant_form<Lanes>(
                fact, Real{}, [&](Real x) { return function.splat(static_cast<double>(x)); });
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) {
            return uniform_form<Lanes>({function.load_uniform(uniforms, 2 * (v - 3)),
                                        function.load_uniform(uniforms, 2 * (v - 3) + 1)});
        }
        return coordinate(view, *cell, v);
    };
    BeamAlgebra<Lanes> algebra;
    const auto varying = [&] {
        function.go_to_body();
        cell = {function.load(in[0]), function.load(in[1]), function.load(in[2]),
                function.load(in[3])};
    };
    const BeamValue<Lanes> f =
        evaluate(expr, facts, algebra, leaf, varying, [&] { function.count_node(); });
    const FormResult<Lanes> result = form_result(f);
    for (std::size_t i = 0; i < 3; ++i)
        function.store(k[i], result.k[i]);
    function.store(out[0], result.c);
    function.store(out[1], result.e);
    function.store(out[2], result.r);
    function.store(out[3], result.slope.neg_lo);
    function.store(out[4], result.slope.hi);
    function.store(out[5], result.continuous.value_or(function.everywhere()));
    function.store(out[6], no(result.somewhere.value_or(function.everywhere())));
    function.finish();
}

template <class Real>
void lower_value(const Expr& expr, std::span<const Facts> facts, const VectorKind& kind,
                 llvm::Module& module) {
    using Batch = ValueBatchOf<Real>;
    BatchFunction function(module, value_symbol, kind, offsetof(Batch, size));
    std::array<llvm::Value*, 3> x{};
    std::array<llvm::Value*, 3> gradient{};
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = function.array(offsetof(Batch, x) + i * sizeof(Real*));
        gradient[i] = function.array(offsetof(Batch, gradient) + i * sizeof(Real*));
    }
    llvm::Value* const uniforms = function.array(offsetof(Batch, uniforms));
    llvm::Value* const value = function.array(offsetof(Batch, f));

    const auto leaf = [&](const Node& node, const Facts& fact) -> Dual<Lanes> {
        if (fact.constant) {
            return {function.splat(static_cast<double>(fact.constant_point<Real>())), {}};
        }
        const auto v = static_cast<std::size_t>(node.number);
        if (v >= 3) return {function.load_uniform(uniforms, v - 3), {}};
        Dual<Lanes> variable{function.load(x[v]), {}};
        variable.slope[v] = function.splat(1.0);
        return variable;
    };
    DualAlgebra<Lanes> algebra;
    const Dual<Lanes> f = evaluate(
        expr, facts, algebra, leaf, [&] { function.go_to_body(); }, [&] { function.count_node(); });
    function.store(value, f.value);
    for (std::size_t i = 0; i < 3; ++i) {
        function.store(gradient[i], f.slope[i].value_or(function.splat(0.0)));
    }
    function.finish();
}

}  // namespace

std::unique_ptr<llvm::Module> lower(const Expr& expr, const VectorKind& kind,
                                    llvm::LLVMContext& context) {
    auto module = std::make_unique<llvm::Module>("zeroset", context);
    const std::vector<Facts> facts = facts_of(expr);
    if (kind.type == RealType::Float) {
        lower_range<float>(expr, facts, kind, *module);
        lower_value<float>(expr, facts, kind, *module);
        lower_form<float>(expr, facts, kind, *module);
    } else {
        lower_range<double>(expr, facts, kind, *module);
        lower_value<double>(expr, facts, kind, *module);
        lower_form<double>(expr, facts, kind, *module);
    }
    return module;
}

}  // namespace zeroset::jit
