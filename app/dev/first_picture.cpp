#include "app/cli/report.hpp"
#include "app/dev/bench_suite.hpp"
#include "engine/base/clock.hpp"
#include "engine/render/render_job.hpp"
#include "jit/compile.hpp"
#include "pipeline/formula_job.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// Times the way from an edit to pixels through the window's jobs, without panels and OpenGL.

namespace zeroset {
namespace {

using Clock = std::chrono::steady_clock;

/// Times from an edit to each result.
struct EditTimes {
    double formula_ms = 0.0;  ///< until there is code to draw with
    double picture_ms = 0.0;  ///< until the first picture
    double machine_ms = 0.0;  ///< until there is machine code
    int width = 0, height = 0;
    std::size_t nodes = 0;  ///< nodes of the drawn graphs
};

/// The window's jobs; the calling thread takes the place of the window's thread.
class Editor {
public:
    explicit Editor(const FirstPicturePlan& plan) : plan_(plan) {}

    /// Replaces the last text by the document's and times what follows.
    OrInputError<EditTimes> edit(const Document& document);
    /// Waits until the picture is complete or a person might have gone on typing, and long enough
    /// for the next request to count as no motion.
    void rest();

private:
    void wake() {
        const std::scoped_lock lock(mutex_);
        ++calls_;
        woken_.notify_one();
    }
    void wait() {
        std::unique_lock lock(mutex_);
        woken_.wait(lock, [this] { return calls_ != seen_; });
        seen_ = calls_;
    }
    std::uint64_t submit_picture(const Document& document, const FormulaResult& result, bool again);

    const FirstPicturePlan& plan_;
    std::mutex mutex_;
    std::condition_variable woken_;
    int calls_ = 0, seen_ = 0;
    FormulaJob formulas_{
        [this] { wake(); }};  // declared last, so that the jobs end before what they wake
    RenderJob pictures_{[this] { wake(); }};
};

std::uint64_t Editor::submit_picture(const Document& document, const FormulaResult& result,
                                     bool again) {
    RenderRequest request =
        render_request(picture_request(*result.formula, result.colors, document, plan_.settings,
                                       {plan_.size.width, plan_.size.height}));
    request.settings.antialias = plan_.settings.antialias;
    request.preview = is_preview(**result.formula);
    request.again = again;
    return pictures_.submit(std::move(request));
}

OrInputError<EditTimes> Editor::edit(const Document& document) {
    const auto start = Clock::now();
    EditTimes times;
    bool machine = false;
    std::optional<std::uint64_t> first;
    const Sheet sheet = sheet_of(document);
    formulas_.submit(sheet, document.clip, document.coloring, document.files);
    while (times.width == 0 || !machine) {
        wait();
        const auto result = formulas_.take();
        if (result && result->sheet == sheet) {
            if (!result->formula) return std::unexpected(result->formula.error());
            const Formula& formula = **result->formula;
            const std::uint64_t request = submit_picture(document, *result, first.has_value());
            if (!first) times.formula_ms = ms_since(start);
            if (!first) first = request;
            times.nodes = formula.nodes();
            machine = formula.code != CodeState::InterpretedFirst;
            if (machine) times.machine_ms = ms_since(start);
        }
        const auto picture = pictures_.take();
        if (!picture || !first || picture->request < *first || times.width > 0) continue;
        times.picture_ms = ms_since(start);
        times.width = picture->frame->width;
        times.height = picture->frame->height;
        formulas_.drawn();
    }
    return times;
}

void Editor::rest() {
    const auto start = Clock::now();
    constexpr auto longest = std::chrono::milliseconds(400);
    constexpr auto shortest = std::chrono::milliseconds(150);
    while (Clock::now() - start < longest && (pictures_.busy() || Clock::now() - start < shortest))
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

bool same_shape(const Program& a, const Program& b) {
    const auto same_node = [](const Node& x, const Node& y) {
        return x.op == y.op && x.number == y.number && x.a == y.a && x.b == y.b && x.c == y.c;
    };
    const auto same_graph = [&](const Expr& x, const Expr& y) {
        return std::ranges::equal(x.nodes(), y.nodes(), same_node);
    };
    return std::ranges::equal(a.surfaces, b.surfaces, same_graph);
}

/// Returns the text with one of its numbers a little larger, such that the formula keeps its shape;
/// nothing if no number allows that.
std::optional<std::string> with_other_number(const std::string& text, const std::string& digits,
                                             const FieldSource* files) {
    const auto whole = read_program(text, files);
    if (!whole) return std::nullopt;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    for (std::size_t end = text.size(); end > 0; --end) {
        if (!is_digit(text[end - 1]) || (end < text.size() && is_digit(text[end]))) continue;
        std::size_t begin = end;
        while (begin > 0 && (is_digit(text[begin - 1]) || text[begin - 1] == '.'))
            --begin;
        const bool has_point = text.substr(begin, end - begin).contains('.');
        std::string other = text;
        other.insert(end, has_point ? digits : "." + digits);
        const auto read = read_program(other, files);
        if (read && same_shape(*whole, *read)) return other;
    }
    return std::nullopt;
}

struct Medians {
    EditTimes text;
    std::optional<double> number_ms;  ///< time of an edit that changes a number
};

double median(std::vector<double> times) {
    std::ranges::sort(times);
    return times[times.size() / 2];
}

/// Returns the item's document with another text.
Document document_with(const BenchItem& item, const std::string& text) {
    Document document = item.read.document;
    document.statements = read_text(text, document.files).document.statements;
    return document;
}

OrInputError<Medians> measure(Editor& editor, const BenchItem& item, int repeats) {
    std::vector<double> formula, picture, machine, number;
    Medians medians;
    if (!item.read.rows) return std::unexpected(item.read.rows.error());
    const std::string& typed = item.read.rows->text;
    const auto other = with_other_number(typed, "01", item.read.document.files.get());
    for (int i = 0; i < repeats; ++i) {
        jit::forget_code();
        const auto times = editor.edit(document_with(item, typed));
        if (!times) return std::unexpected(times.error());
        medians.text = *times;
        formula.push_back(times->formula_ms);
        picture.push_back(times->picture_ms);
        machine.push_back(times->machine_ms);
        editor.rest();
        const auto after = editor.edit(document_with(item, other.value_or("x + y + z = 1")));
        if (!after) return std::unexpected(after.error());
        if (other) number.push_back(after->picture_ms);
        editor.rest();
    }
    medians.text.formula_ms = median(formula);
    medians.text.picture_ms = median(picture);
    medians.text.machine_ms = median(machine);
    if (other) medians.number_ms = median(number);
    return medians;
}

void print_row(const std::string& name, const Medians& medians) {
    const EditTimes& text = medians.text;
    std::printf("%-24s %6zu %9.1f %9.1f %5dx%-4d %10.1f", name.c_str(), text.nodes, text.formula_ms,
                text.picture_ms, text.width, text.height, text.machine_ms);
    if (medians.number_ms) std::printf(" %9.1f", *medians.number_ms);
    std::printf("\n");
    std::fflush(stdout);
}

void print_spread(const char* title, std::vector<double> times) {
    if (times.empty()) return;
    std::ranges::sort(times);
    const auto at = [&](double part) {
        return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
    };
    std::printf("%-24s median %.1f ms, 90 %% within %.1f ms, all within %.1f ms\n", title, at(0.5),
                at(0.9), at(1.0));
}

}  // namespace

int print_first_pictures(const FirstPicturePlan& plan) {
    std::printf(
        "%dx%d, medians of %d; from an edit until there is code to draw with, the first picture, "
        "machine code; then after another edit, of a number\n%-24s %6s %9s %9s %10s %10s %9s\n",
        plan.size.width, plan.size.height, plan.repeats, "surface", "nodes", "ready ms", "first ms",
        "size", "machine ms", "number ms");
    Editor editor(plan);
    const BenchItem warm_up{.name = "", .read = read_document_text("x^2 + y^2 + z^2 = 1.25")};
    if (const auto warm = measure(editor, warm_up, 1); !warm) return report(warm.error());
    std::vector<double> texts, numbers;
    for (const BenchItem& item : plan.items) {
        const auto medians = measure(editor, item, plan.repeats);
        if (!medians) {
            std::printf("%-24s ", item.name.c_str());
            std::fflush(stdout);
            return report(medians.error());
        }
        print_row(item.name, *medians);
        texts.push_back(medians->text.picture_ms);
        if (medians->number_ms) numbers.push_back(*medians->number_ms);
    }
    print_spread("a new text", texts);
    print_spread("a number in it", numbers);
    return exit_ok;
}

}  // namespace zeroset
