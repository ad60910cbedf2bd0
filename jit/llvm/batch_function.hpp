#pragma once

#include "jit/llvm/lanes.hpp"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <cstddef>
#include <cstdint>

// The frame of the functions that the JIT makes. Private to jit/ and to benchmarks of it.

namespace zeroset::jit {

/// A loop inside the body that improves a depth s step by step.
struct StepLoop {
    Lanes s;  ///< depth at the current step
    llvm::BasicBlock* head;
    llvm::PHINode* s_in;
    llvm::PHINode* steps_left;
};

/// An array pointer of the batch that may be null; one spare vector then replaces the whole array.
struct OptionalArray {
    llvm::Value* start;
    llvm::Value* step;  ///< 1, or 0 where the pointer is null
};

/// A function `void name(const void* code, const Batch* batch)` with a loop over the batch's items:
/// the code in `entry` runs once, that in `body` for each vector of items.
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

    /// Closes the loop and the function.
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

    /// Counts a node that has been emitted in the body. LLVM's time grows with the square of a
    /// basic block's length, so a long body becomes a chain of blocks; the conditional branches
    /// between them, which always go on, keep LLVM from joining the blocks again.
    void count_node() {
        if (++nodes_ % nodes_a_block != 0) return;
        llvm::LLVMContext& context = builder_.getContext();
        if (nowhere_ == nullptr) nowhere_ = llvm::BasicBlock::Create(context, "empty", function_);
        llvm::BasicBlock* const next = llvm::BasicBlock::Create(context, "further", function_);
        builder_.CreateCondBr(builder_.CreateICmpNE(size_, builder_.getInt64(0)), next, nowhere_);
        builder_.SetInsertPoint(next);
    }

    /// Loads an array pointer of the batch; call before go_to_body.
    llvm::Value* array(std::size_t offset) {
        return builder_.CreateLoad(builder_.getPtrTy(), member(offset));
    }
    /// Loads an array pointer that may be null, of numbers as wide as `integer()`; call before
    /// go_to_body.
    OptionalArray optional_array(std::size_t offset) {
        llvm::Value* const given = array(offset);
        llvm::Value* const room = builder_.CreateAlloca(emitter_.vector_of(emitter_.integer()));
        builder_.CreateAlignedStore(
            llvm::Constant::getNullValue(emitter_.vector_of(emitter_.integer())), room,
            alignment());
        llvm::Value* const there = builder_.CreateIsNotNull(given);
        return {.start = builder_.CreateSelect(there, given, room),
                .step = builder_.CreateZExt(there, builder_.getInt64Ty())};
    }
    /// Loads a std::size_t of the batch; call before go_to_body.
    llvm::Value* size_member(std::size_t offset) {
        return builder_.CreateLoad(builder_.getInt64Ty(), member(offset));
    }
    llvm::IRBuilder<>& builder() { return builder_; }
    [[nodiscard]] bool is_float() const { return emitter_.is_float(); }
    LaneMask mask(llvm::Value* value) { return {.emitter = &emitter_, .value = value}; }
    /// The integer `value`, as wide as the vectors' numbers, in all lanes.
    llvm::Value* splat_integer(std::uint64_t value) {
        return llvm::ConstantInt::get(emitter_.vector_of(emitter_.integer()), value);
    }
    /// Loads from an array the integers of the body's items, offset by `further` items.
    llvm::Value* load_integers(const OptionalArray& array, llvm::Value* further) {
        return builder_.CreateAlignedLoad(emitter_.vector_of(emitter_.integer()),
                                          place_in(array, builder_.CreateAdd(item_, further)),
                                          alignment());
    }
    void store_integers(const OptionalArray& array, llvm::Value* vector) {
        builder_.CreateAlignedStore(vector, place_in(array, item_), alignment());
    }
    void store(const OptionalArray& array, const Lanes& lanes) {
        builder_.CreateAlignedStore(lanes.value, place_in(array, item_), alignment());
    }
    Lanes load(llvm::Value* array) {
        llvm::Value* const address = builder_.CreateGEP(emitter_.real(), array, item_);
        return {.emitter = &emitter_,
                .value = builder_.CreateAlignedLoad(emitter_.real_vector(), address, alignment())};
    }
    /// Loads the number `array[index]` into all lanes.
    Lanes load_uniform(llvm::Value* array, std::size_t index) {
        llvm::Value* const address = builder_.CreateConstGEP1_64(emitter_.real(), array, index);
        llvm::Value* const one = builder_.CreateLoad(emitter_.real(), address);
        return {
            .emitter = &emitter_,
            .value = builder_.CreateVectorSplat(static_cast<unsigned>(emitter_.kind.lanes), one)};
    }
    void store(llvm::Value* array, const Lanes& lanes) { store_vector(array, lanes.value); }
    /// Stores a mask: all bits of a number are 1 where it holds, else 0.
    void store(llvm::Value* array, const LaneMask& mask) {
        store_vector(array,
                     builder_.CreateSExt(mask.value, emitter_.vector_of(emitter_.integer())));
    }

    /// Loads floats of the body's items, converted to the vectors' type.
    Lanes load_floats(llvm::Value* array) {
        llvm::Type* const narrow = emitter_.vector_of(builder_.getFloatTy());
        llvm::Value* const address = builder_.CreateGEP(builder_.getFloatTy(), array, item_);
        llvm::Value* const numbers =
            builder_.CreateAlignedLoad(narrow, address, llvm::Align(sizeof(float)));
        return {.emitter = &emitter_,
                .value = emitter_.is_float()
                             ? numbers
                             : builder_.CreateFPExt(numbers, emitter_.real_vector())};
    }
    /// Loads a number of the batch itself into all lanes; call before go_to_body.
    Lanes member_uniform(std::size_t offset) { return load_uniform(member(offset), 0); }
    /// Loads an int of the batch; call before go_to_body.
    llvm::Value* count(std::size_t offset) {
        return builder_.CreateLoad(builder_.getInt32Ty(), member(offset));
    }

    /// Begins a loop of one step and at most `more` further ones; call in the body.
    StepLoop begin_steps(const Lanes& start, llvm::Value* more) {
        llvm::BasicBlock* const before = builder_.GetInsertBlock();
        llvm::BasicBlock* const head =
            llvm::BasicBlock::Create(builder_.getContext(), "step", function_);
        builder_.CreateBr(head);
        builder_.SetInsertPoint(head);
        llvm::PHINode* const s = builder_.CreatePHI(emitter_.real_vector(), 2, "s");
        llvm::PHINode* const left = builder_.CreatePHI(builder_.getInt32Ty(), 2, "left");
        s->addIncoming(start.value, before);
        left->addIncoming(more, before);
        return {
            .s = {.emitter = &emitter_, .value = s}, .head = head, .s_in = s, .steps_left = left};
    }
    /// Ends the loop's step: goes on with `next` where `again` holds in any lane and steps are
    /// left.
    void end_steps(const StepLoop& loop, const Lanes& next, const LaneMask& again) {
        llvm::Value* const left = builder_.CreateSub(loop.steps_left, builder_.getInt32(1));
        llvm::Value* const wanted =
            builder_.CreateAnd(builder_.CreateOrReduce(again.value),
                               builder_.CreateICmpSGE(left, builder_.getInt32(0)));
        loop.s_in->addIncoming(next.value, builder_.GetInsertBlock());
        loop.steps_left->addIncoming(left, builder_.GetInsertBlock());
        llvm::BasicBlock* const done =
            llvm::BasicBlock::Create(builder_.getContext(), "found", function_);
        builder_.CreateCondBr(wanted, loop.head, done);
        builder_.SetInsertPoint(done);
    }

    /// The number `value` in all lanes.
    Lanes splat(double value) { return like(Lanes{.emitter = &emitter_, .value = nullptr}, value); }
    LaneMask everywhere() {
        return {.emitter = &emitter_,
                .value = llvm::Constant::getAllOnesValue(emitter_.vector_of(builder_.getInt1Ty()))};
    }

private:
    llvm::Value* place_in(const OptionalArray& array, llvm::Value* item) {
        return builder_.CreateGEP(emitter_.integer(), array.start,
                                  builder_.CreateMul(item, array.step));
    }
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
    llvm::BasicBlock* nowhere_ = nullptr;  ///< target of the branches for an empty batch
};

}  // namespace zeroset::jit
