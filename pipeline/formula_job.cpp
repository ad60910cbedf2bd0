#include "pipeline/formula_job.hpp"

#include "engine/language/vocabulary/field_source.hpp"

#include <algorithm>
#include <utility>

namespace zeroset {
namespace {

/// Prepares sheets; remembers the last good text of each row and the last formula.
class Preparer {
public:
    FormulaResult prepare(Sheet sheet, const FormulaPlace& place, const ColorChoice& choice,
                          const std::shared_ptr<const FieldSource>& files, bool draws_old) {
        // Expressions of colours, too, may name files.
        const std::uint64_t version = files ? files->version() : 0;
        files_changed_ |= std::exchange(files_, version) != version;
        SheetReading reading = reader_.read(sheet, files, draws_old);
        FormulaResult result{.sheet = std::move(sheet),
                             .reading = std::move(reading),
                             .formula = last_,
                             .choice = choice};
        const RowProgram& rows = result.reading;
        if (last_ == nullptr || !same_functions(*last_, rows) || place_ != place) {
            auto formula = prepare_formula(rows, place, Preparation::Quickest);
            if (!formula) {
                result.formula = std::unexpected(formula.error());
                return result;
            }
            if (last_ == nullptr || !same_functions(*last_, rows) ||
                place_.stretch != place.stretch)
                colors_ = nullptr;
            last_ = std::make_shared<const Formula>(std::move(*formula));
            place_ = place;
        } else if (last_->surface_rows != rows.surface_rows || last_->files != rows.files) {
            files_changed_ |= last_->files != rows.files;
            Formula of_other_rows = *last_;
            of_other_rows.surface_rows = rows.surface_rows;
            of_other_rows.files = rows.files;
            last_ = std::make_shared<const Formula>(std::move(of_other_rows));
        }
        result.formula = last_;
        add_colors(result);
        return result;
    }

private:
    void add_colors(FormulaResult& result) {
        ColorChoice choice = result.choice;
        result.contour_error = check_contours(*last_, choice.lines);
        if (result.contour_error) choice.lines = {};
        const bool has_contours = choice.lines.contours == Contours::Expression;
        const std::string contours = has_contours ? choice.lines.expression : "";
        if (colors_ == nullptr || files_changed_ || colors_->by != choice.by ||
            colors_->expression != choice.expression || colors_->contour_expression != contours) {
            auto colors = color_formulas(*last_, choice, last_->stretch);
            if (colors) {
                files_changed_ = false;
                colors_ = std::make_shared<const ColorFormulas>(std::move(*colors));
            } else {
                result.color_error = colors.error();
                if (colors_ == nullptr) colors_ = std::make_shared<const ColorFormulas>();
            }
        }
        result.colors = colors_;
    }

    SheetReader reader_;
    std::shared_ptr<const Formula> last_;
    std::shared_ptr<const ColorFormulas> colors_;  ///< made for `last_`
    FormulaPlace place_;
    std::uint64_t files_ = 0;     ///< FieldSource::version() at the last sheet
    bool files_changed_ = false;  ///< since `colors_` were made
};

/// How long the first picture has all cores for itself before LLVM starts, unless it is done
/// sooner: a fifth of the time that LLVM takes for the formula, within 30 to 300 ms.
std::chrono::milliseconds head_start(const Formula& formula) {
    constexpr std::size_t least = 30;
    constexpr std::size_t most = 300;
    return std::chrono::milliseconds(std::clamp(formula.nodes() / 5, least, most));
}

/// Replaces the interpreter's code in the result by machine code.
FormulaResult compiled(FormulaResult result) {
    if (auto formula = with_machine_code(**result.formula)) {
        result.formula = std::make_shared<const Formula>(std::move(*formula));
    } else {
        result.formula = std::unexpected(std::move(formula.error()));
    }
    return result;
}

}  // namespace

FormulaJob::FormulaJob(std::function<void()> on_result)
    : on_result_(std::move(on_result)),
      preparing_([this] { prepare_sheets(); }),
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

void FormulaJob::submit(Sheet sheet, const FormulaPlace& place, const ColorChoice& choice,
                        std::shared_ptr<const FieldSource> files, bool draws_old) {
    {
        const std::scoped_lock lock(mutex_);
        pending_ = Request{.number = ++newest_,
                           .sheet = std::move(sheet),
                           .place = place,
                           .choice = choice,
                           .files = std::move(files),
                           .draws_old = draws_old};
        style_ = text_style();
        interpreted_.reset();
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

/// Publishes the result, unless a newer sheet is waiting.
void FormulaJob::publish(FormulaResult result) {
    {
        const std::scoped_lock lock(mutex_);
        if (result.number == newest_) {
            if (result.formula && (*result.formula)->code == CodeState::InterpretedFirst) {
                interpreted_ = result;
                compile_at_ = Clock::now() + head_start(**result.formula);
            }
            finished_ = std::move(result);
        }
    }
    wake_.notify_all();
    on_result_();
}

void FormulaJob::prepare_sheets() {
    Preparer preparer;
    for (;;) {
        Request request;
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return stop_ || pending_.has_value(); });
            if (stop_) return;
            request = std::move(*std::exchange(pending_, std::nullopt));
            set_language(style_);
        }
        FormulaResult result = preparer.prepare(std::move(request.sheet), request.place,
                                                request.choice, request.files, request.draws_old);
        result.number = request.number;
        publish(std::move(result));
    }
}

/// Publishes the formula with code in double, unless another formula waits for its own.
void FormulaJob::publish_double(const Formula& formula) {
    auto result = std::make_shared<const Formula>(with_double(formula));
    {
        const std::scoped_lock lock(mutex_);
        if (deep_ == nullptr) double_ = std::move(result);
    }
    on_result_();
}

void FormulaJob::drawn() {
    {
        const std::scoped_lock lock(mutex_);
        compile_at_ = Clock::now();
    }
    wake_.notify_all();
}

void FormulaJob::compile_more() {
    jit::can_compile();  // while nothing is to be compiled yet
    std::unique_lock lock(mutex_);
    while (!stop_) {
        if (deep_ != nullptr) {
            const auto deep = std::exchange(deep_, nullptr);
            lock.unlock();
            publish_double(*deep);
            lock.lock();
        } else if (interpreted_ && Clock::now() >= compile_at_) {
            FormulaResult interpreted = std::move(*std::exchange(interpreted_, std::nullopt));
            set_language(style_);
            lock.unlock();
            publish(compiled(std::move(interpreted)));
            lock.lock();
        } else if (interpreted_) {
            wake_.wait_until(lock, compile_at_);
        } else {
            wake_.wait(lock);
        }
    }
}

}  // namespace zeroset
