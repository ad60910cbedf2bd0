#include "pipeline/formula_job.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

// Tests of background compilation: the newest text wins, nothing blocks or is lost at the end.

namespace zeroset::test::formula_job_test {
namespace {

constexpr auto patience = std::chrono::minutes(10);

Sheet one_row(const std::string& text) { return {{1, text}}; }

/// Takes results when the job calls, as the window does.
class Receiver {
public:
    /// Returns the result for `text`, or nothing if it does not arrive in time.
    std::optional<FormulaResult> result_for(const std::string& text) {
        return first_of<std::optional<FormulaResult>>([&] {
            std::optional<FormulaResult> result = job.take();
            return result && result->sheet == one_row(text) ? result : std::nullopt;
        });
    }
    /// Returns the formula with code in double, or nullptr if it does not arrive in time.
    std::shared_ptr<const Formula> deepened() {
        return first_of<std::shared_ptr<const Formula>>([&] { return job.take_double(); });
    }

private:
    /// Returns the first result of `take`, tried after each call of the job; empty after
    /// `patience`.
    template <class Result, class Take>
    Result first_of(Take take) {
        const auto end = std::chrono::steady_clock::now() + patience;
        std::unique_lock lock(mutex_);
        for (;;) {
            if (Result result = take()) return result;
            woken_.wait_until(lock, end, [this] { return calls_ != seen_; });
            if (calls_ == seen_) return {};
            seen_ = calls_;
        }
    }
    void wake() {
        const std::scoped_lock lock(mutex_);
        ++calls_;
        woken_.notify_one();
    }

    std::mutex mutex_;
    std::condition_variable woken_;
    int calls_ = 0, seen_ = 0;

public:
    FormulaJob job{[this] { wake(); }};  // declared last: destroyed before what it wakes
};

TEST(FormulaJob, CompilesAText) {
    Receiver receiver;
    EXPECT_FALSE(receiver.job.take());
    receiver.job.submit(one_row("x^2 + y"), {});
    const auto result = receiver.result_for("x^2 + y");
    ASSERT_TRUE(result);
    ASSERT_TRUE(result->formula);
    EXPECT_EQ((*result->formula)->kernels.size(), 1);
    EXPECT_FALSE(receiver.job.take()) << "a result is taken once";
}

TEST(FormulaJob, ReportsAnErrorWithItsText) {
    Receiver receiver;
    receiver.job.submit(one_row("x + )"), {});
    const auto result = receiver.result_for("x + )");
    ASSERT_TRUE(result);
    ASSERT_TRUE(result->reading.reports.at(1).error);
    EXPECT_EQ(result->reading.reports.at(1).error->at, 4U);
    EXPECT_EQ(result->reading.surface_rows, std::vector{0}) << "there is nothing to draw";
}

TEST(FormulaJob, KeepsTheFormulaWhileARowIsWrong) {
    Receiver receiver;
    receiver.job.submit(one_row("x + y"), {});
    const auto good = receiver.result_for("x + y");
    receiver.job.submit(one_row("x + y +"), {});
    const auto wrong = receiver.result_for("x + y +");
    ASSERT_TRUE(good && good->formula && wrong && wrong->formula);
    EXPECT_EQ(*good->formula, *wrong->formula) << "the same code, not compiled again";
    EXPECT_TRUE(wrong->reading.reports.at(1).error->unfinished);
}

TEST(FormulaJob, TheNewestTextWins) {
    Receiver receiver;
    std::string text = "x";
    for (int i = 0; i < 100; ++i) {
        text += "+y";
        receiver.job.submit(one_row(text), {});
    }
    const auto result = receiver.result_for(text);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->formula);
    EXPECT_FALSE(receiver.job.take()) << "nothing comes after the newest";
}

TEST(FormulaJob, ALargeFormulaArrivesInterpretedAndThenCompiled) {
    Receiver receiver;
    const std::string text = "sum(sin(i x + y)*cos(i y - z)/i, i, 1, 300)";
    receiver.job.submit(one_row(text), {});
    const auto first = receiver.result_for(text);
    ASSERT_TRUE(first && first->formula);
    EXPECT_EQ((*first->formula)->code, CodeState::InterpretedFirst);
    const auto second = receiver.result_for(text);
    ASSERT_TRUE(second && second->formula);
    EXPECT_EQ((*second->formula)->code, CodeState::Machine);
}

TEST(FormulaJob, MakesCodeInDoubleForAFormula) {
    Receiver receiver;
    receiver.job.submit(one_row("x^2 + y"), {});
    const auto result = receiver.result_for("x^2 + y");
    ASSERT_TRUE(result && result->formula);
    EXPECT_EQ(receiver.job.take_double(), nullptr);
    receiver.job.submit_double(*result->formula);
    receiver.job.submit(one_row("x + )"),
                        {});  // the shown formula can be deepened although the new text is wrong
    const auto deep = receiver.deepened();
    ASSERT_NE(deep, nullptr);
    EXPECT_EQ(deep->text, "x^2 + y");
    EXPECT_TRUE(deep->has_code(Precision::Double));
    EXPECT_EQ(receiver.job.take_double(), nullptr) << "a result is taken once";
}

// Passes by returning: a job that does not end runs into the time limit of ctest, and what it still
// touches sanitizers tell.
TEST(FormulaJob, EndsWhileItWorks) {
    for (int i = 0; i < 5; ++i) {
        FormulaJob job([] {});
        job.submit(one_row("sin(x)*cos(y) + exp(z)*" + std::to_string(i)), {});
        job.submit(one_row("x^2 + y^2 + z^2 = " + std::to_string(i)), {});
    }
}

TEST(FormulaJob, MakesTheFormulasOfColors) {
    Receiver receiver;
    const std::string text = "x^2 + y = a";
    const ColorChoice choice{ColorBy::Expression, "a x"};
    receiver.job.submit(one_row(text), {}, choice);
    const auto result = receiver.result_for(text);
    ASSERT_TRUE(result && result->formula && result->colors);
    EXPECT_EQ(result->choice, choice);
    EXPECT_EQ(result->colors->by, ColorBy::Expression);
    EXPECT_EQ(result->colors->values.size(), 1U);
    EXPECT_FALSE(result->color_error);

    // Wrong colours leave the last good ones; a new formula starts with plain ones.
    receiver.job.submit(one_row(text), {}, {ColorBy::Expression, "b"});
    const auto wrong = receiver.result_for(text);
    ASSERT_TRUE(wrong && wrong->color_error);
    EXPECT_EQ(wrong->color_error->reason, "there is no parameter 'b'; the formula's are a");
    EXPECT_EQ(wrong->colors, result->colors);
    EXPECT_EQ(*wrong->formula, *result->formula);
    receiver.job.submit(one_row("x = 1"), {}, {ColorBy::Expression, "b"});
    const auto other = receiver.result_for("x = 1");
    ASSERT_TRUE(other && other->color_error && other->colors);
    EXPECT_EQ(other->colors->by, ColorBy::Plain);
}

}  // namespace
}  // namespace zeroset::test::formula_job_test
