#include "app/formula_job.hpp"

#include <utility>

namespace zeroset {
namespace {

FormulaResult result_of(std::string text, std::expected<Formula, InputError> formula) {
    FormulaResult result{std::move(text), std::unexpected(InputError{})};
    if (formula) {
        result.formula = std::make_shared<const Formula>(std::move(*formula));
    } else {
        result.formula = std::unexpected(std::move(formula.error()));
    }
    return result;
}

}  // namespace

FormulaJob::FormulaJob(std::function<void()> on_result)
    : on_result_(std::move(on_result)),
      preparing_([this] { prepare_texts(); }),
      compiling_([this] { compile_more(); }) {}

FormulaJob::~FormulaJob() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
    }
    wake_.notify_all();
    preparing_.join();
    compiling_.join();
}

void FormulaJob::submit(std::string text, const Box& region) {
    {
        const std::scoped_lock lock(mutex_);
        newest_text_ = text;
        pending_ = Request{std::move(text), region};
        large_.reset();
    }
    wake_.notify_all();
}

std::optional<FormulaResult> FormulaJob::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(finished_, std::nullopt);
}

void FormulaJob::submit_double(std::shared_ptr<const Formula> formula) {
    {
        const std::scoped_lock lock(mutex_);
        deep_ = std::move(formula);
    }
    wake_.notify_all();
}

std::shared_ptr<const Formula> FormulaJob::take_double() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(double_, nullptr);
}

/// Hands the result on, unless a newer text is waiting.
void FormulaJob::publish(FormulaResult result) {
    {
        const std::scoped_lock lock(mutex_);
        if (result.text == newest_text_) {
            const bool large =
                result.formula && (*result.formula)->code == CodeState::InterpretedFirst;
            if (large) large_ = *result.formula;
            finished_ = std::move(result);
        }
    }
    wake_.notify_all();
    on_result_();
}

void FormulaJob::prepare_texts() {
    for (;;) {
        Request request;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return stop_ || pending_.has_value(); });
            if (stop_) return;
            request = std::move(*std::exchange(pending_, std::nullopt));
        }
        auto formula = prepare_formula(request.text, request.region);
        publish(result_of(std::move(request.text), std::move(formula)));
    }
}

/// Hands on the formula with code in double, unless another one waits for its own.
void FormulaJob::publish_double(const Formula& formula) {
    auto result = std::make_shared<const Formula>(with_double(formula));
    {
        const std::scoped_lock lock(mutex_);
        if (deep_ == nullptr) double_ = std::move(result);
    }
    on_result_();
}

void FormulaJob::compile_more() {
    for (;;) {
        std::shared_ptr<const Formula> large;
        std::shared_ptr<const Formula> deep;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return stop_ || large_ != nullptr || deep_ != nullptr; });
            if (stop_) return;
            deep = std::exchange(deep_, nullptr);
            if (deep == nullptr) large = std::exchange(large_, nullptr);
        }
        if (deep != nullptr) {
            publish_double(*deep);
        } else {
            publish(result_of(large->text, with_machine_code(*large)));
        }
    }
}

}  // namespace zeroset
