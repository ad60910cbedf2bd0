#include "engine/language/dialects/dialects.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/language/dialects/command_arguments.hpp"
#include "engine/language/dialects/command_table.hpp"
#include "engine/language/dialects/commands.hpp"
#include "engine/language/dialects/functions_of_programs.hpp"
#include "engine/language/dialects/grids.hpp"
#include "engine/language/dialects/latex.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Words = std::string_view;

constexpr std::size_t longest_call = 20'000;  // bytes of a command with its arguments
constexpr int most_commands = 200;

/// First words of lines that draw nothing and stand around plotting commands.
constexpr std::array idle_words = std::to_array<Words>(
    {"syms",    "with",   "restart",  "clear",   "clearvars", "clc",      "close",
     "hold",    "figure", "axis",     "var",     "from",      "import",   "show",
     "xlabel",  "ylabel", "zlabel",   "title",   "view",      "colorbar", "camlight",
     "shading", "grid",   "lighting", "library", "using",     "load",     "colormap",
     "set",     "unset",  "Needs",    "alpha",   "Show",      "display"});

/// Whether a line only tells which names are variables: x, y = symbols('x y'), syms x y.
bool names_variables(Words line) {
    const std::size_t equals = line.find('=');
    const Words value = equals == Words::npos ? line : trimmed(line.substr(equals + 1));
    for (const Words word : {"var(", "symbols(", "sp.symbols(", "sympy.symbols(", "SR.var("}) {
        if (value.starts_with(word)) return true;
    }
    return false;
}

/// Whether a line loads what a program needs, which no formula begins with.
bool loads_library(Words line) {
    const Words word = line.substr(0, word_length(line));
    const Words behind = line.substr(word.size());
    const bool names = behind.starts_with(' ') && !trimmed(behind).starts_with('=');
    if (word == "import" || word == "syms" || word == "using") return names;
    if (word == "from") return names && line.contains(" import ");
    if (word == "with") return trimmed(behind).starts_with('(') && line.ends_with(':');
    if (line.starts_with("<<") || word == "Needs") return true;
    return names_variables(line);
}

bool is_idle(Words line) {
    const Words word = line.substr(0, word_length(line));
    const Words behind = trimmed(line.substr(word.size()));
    const bool is_known = std::ranges::find(idle_words, word) != idle_words.end();
    const bool shows = line.ends_with(".show()") && is_word(line.substr(0, line.size() - 7));
    return (is_known && !behind.starts_with('=')) || shows || loads_library(line);
}

/// Reads a text statement by statement.
class DialectReader {
public:
    explicit DialectReader(Words typed)
        : typed_(typed), result_{.text = SourceText(typed), .box = {}, .notes = {}, .wholes = {}} {}

    std::expected<std::optional<DialectText>, ParseError> read() {
        if (has_foreign_latex(typed_)) {
            write_latex(typed_, result_.text);
            return std::move(result_);
        }
        if (!is_foreign()) return std::nullopt;
        ExpressionWriter writer(result_.text);
        Grids grids(writer, result_.box);
        for (std::size_t at = 0; at < typed_.size();) {
            at = keep_blanks(at);
            if (at == typed_.size()) break;
            const std::size_t begin = at;
            if (!statement(at, writer, grids)) return std::unexpected(*error_);
            if (at == begin) ++at;
            result_.wholes.emplace_back(begin, at);
        }
        return std::move(result_);
    }

private:
    /// Whether there is anything here that the language does not read itself.
    [[nodiscard]] bool is_foreign() {
        if (has_foreign_expression(typed_)) return true;
        for (std::size_t at = 0; at < typed_.size();) {
            at = behind_prompt(behind_blanks(at));
            const std::size_t end = end_of_statement(typed_, at);
            const Words row = trimmed(typed_.substr(at, end - at));
            if (call_in(row) || loads_library(row) || Grids::makes_grid(row) ||
                row.starts_with("splot ") || end_of_function(at))
                return true;
            at = std::max(end, at + 1);
        }
        return false;
    }

    [[nodiscard]] std::size_t behind_blanks(std::size_t at) const {
        return std::min(typed_.find_first_not_of(" \t\n\v\r;", at), typed_.size());
    }
    /// The offset behind the prompt of a program, if there is one.
    [[nodiscard]] std::size_t behind_prompt(std::size_t at) const {
        for (const Words prompt : {"sage:", ">>>", ">>", "> "}) {
            if (typed_.substr(at).starts_with(prompt)) {
                at += prompt.size();
                return at + blank_length(typed_.substr(at));
            }
        }
        return at;
    }
    /// Keeps blanks and line ends, but no prompt; returns the offset behind them.
    std::size_t keep_blanks(std::size_t at) {
        const std::size_t end = behind_blanks(at);
        result_.text.keep(typed_.substr(at, end - at));
        return behind_prompt(end);
    }

    /// Writes the statement at `at` and goes behind it; false is an error.
    bool statement(std::size_t& at, ExpressionWriter& writer, Grids& grids) {
        const std::size_t end = end_of_statement(typed_, at);
        const Words row = trimmed(typed_.substr(at, end - at));
        if (const auto behind = function(at, writer)) {
            at = *behind;
            return true;
        }
        if (row.starts_with("splot ")) {
            at = end;
            return splot(row, writer);
        }
        if (grids.write(row)) {
            at = end;
            return true;
        }
        if (const auto call = call_in(row)) {
            at = end;
            return command(*call, row, writer);
        }
        const bool shows_plot = std::ranges::find(plots_, row) != plots_.end();
        if (!is_idle(row) && !shows_plot) writer.write(typed_.substr(at, end - at));
        at = end;
        return true;
    }

    /// Where the function of a program that starts at `at` ends.
    std::optional<std::size_t> end_of_function(std::size_t at) {
        constexpr int most_failed = 20;  // that began as one
        if (failed_functions_ > most_failed) return std::nullopt;
        SourceText scratch(typed_);
        ExpressionWriter trial(scratch);
        const auto end = write_program_function(at, trial);
        if (!end && !scratch.words().empty()) ++failed_functions_;
        return end;
    }
    std::optional<std::size_t> function(std::size_t at, ExpressionWriter& writer) {
        if (!end_of_function(at)) return std::nullopt;
        const std::size_t behind = *write_program_function(at, writer);
        writer.put("\n", typed_.substr(behind));
        return behind + (typed_.substr(behind).starts_with(':') ? 1 : 0);
    }

    /// The plotting command that a whole statement is, perhaps given a name.
    [[nodiscard]] std::optional<CommandCall> call_in(Words row) const {
        std::size_t length = word_length(row);
        const Words behind = trimmed(row.substr(length));
        for (const Words sign : {":=", "=", "<-"}) {
            if (length == 0 || !behind.starts_with(sign) || behind.starts_with("==")) continue;
            row = trimmed(behind.substr(sign.size()));
            length = word_length(row);
            break;
        }
        // The name of a library: plots.plot3d, plots:-plot3d, plots[plot3d], plot::Implicit3d.
        for (const Words sign : {"::", ":-", ":", "."}) {
            if (length == 0 || !row.substr(length).starts_with(sign)) continue;
            row = row.substr(length + sign.size());
            length = word_length(row);
        }
        const Words name = row.substr(0, length);
        if (known_command(name) == nullptr) return std::nullopt;
        const std::size_t opener = length + blank_length(row.substr(length));
        const bool calls = opener < row.size() && (row[opener] == '(' || row[opener] == '[');
        const auto closer =
            calls ? closing_bracket(row.substr(opener, longest_call)) : std::nullopt;
        if (!closer) return std::nullopt;
        const Words rest = trimmed(row.substr(opener + *closer + 1));
        if (!rest.empty() && rest != ":" && rest != ".show()") return std::nullopt;
        CommandCall call{.name = name,
                         .arguments = arguments_in(row.substr(opener + 1, *closer - 1))};
        if (!is_command(call) || defines_function(name)) return std::nullopt;
        return call;
    }
    [[nodiscard]] bool defines_function(Words name) const {
        SourceText scratch(typed_);
        return ExpressionWriter(scratch).is_function(name);
    }

    bool command(const CommandCall& call, Words row, ExpressionWriter& writer) {
        const auto refuse = [&] {
            error_ = {.offset = result_.text.offset_of(call.name),
                      .reason = filled(tr("{0} is a command of another program"),
                                       {"'" + std::string(call.name) + "'"}),
                      .hint = tr("type only the equation in it")};
            return false;
        };
        if (++commands_ > most_commands) return refuse();
        SourceText scratch(typed_);
        ExpressionWriter trial(scratch);
        if (!write_command(call, trial)) return refuse();
        const auto outcome = write_command(call, writer);
        writer.put(";", row.substr(row.size()));
        if (const std::size_t name = word_length(row); row.data() != call.name.data())
            plots_.push_back(row.substr(0, name));
        note(call, *outcome);
        take(outcome->box, result_.text.offset_of(call.name));
        return true;
    }
    void note(const CommandCall& call, const CommandOutcome& outcome) {
        const std::size_t offset = result_.text.offset_of(call.name);
        const std::string program(program_of_command(call.name));
        if (outcome.left_out.empty()) {
            result_.notes.add(
                offset, filled(tr("this is read as {0}'s {1}"), {program, std::string(call.name)}));
            return;
        }
        std::string names;
        for (const Words name : outcome.left_out)
            names += (names.empty() ? "" : ", ") + std::string(name);
        result_.notes.add(offset, filled(tr("this is read as {0}'s {1}, without {2}"),
                                         {program, std::string(call.name), names}));
    }
    void take(const AskedBox& box, std::size_t offset) {
        for (std::size_t k = 0; k < box.size(); ++k) {
            if (!box.at(k)) continue;
            result_.box.at(k) = box.at(k);
            result_.box_offset = offset;
        }
    }

    /// The ranges that gnuplot draws: those before the formulas, else those of "set xrange [a:b]",
    /// else -10 to 10 of x and y.
    AskedBox box_of_splot(Words& formulas) const {
        AskedBox box = take_bracket_ranges(formulas);
        constexpr std::array<Words, 3> settings{"set xrange", "set yrange", "set zrange"};
        for (std::size_t k = 0; k < box.size(); ++k) {
            const std::size_t at = typed_.find(settings.at(k));
            if (box.at(k)) continue;
            Words ends =
                at == Words::npos ? Words() : trimmed(typed_.substr(at + settings.at(k).size()));
            box.at(k) = take_bracket_ranges(ends)[0];
            if (!box.at(k) && k < 2) box.at(k) = AskedRange{.lo = "-10", .hi = "10"};
        }
        return box;
    }

    /// Writes gnuplot's formulas of x and y.
    bool splot(Words row, ExpressionWriter& writer) {
        Words formulas = trimmed(row.substr(6));
        take(box_of_splot(formulas), result_.text.offset_of(row));
        bool is_first = true;
        for (const Words part : split_outside(formulas, ',')) {
            Words formula = part;
            for (const Words word : {"with", "w", "title", "t", "notitle", "lc", "lt", "ls"})
                formula = trimmed(
                    formula.substr(0, std::min(find_outside(formula, word), formula.size())));
            writer.put(is_first ? "z = " : "; z = ", part);
            writer.write(formula);
            is_first = false;
        }
        writer.put(";", row.substr(row.size()));
        result_.notes.add(result_.text.offset_of(row),
                          filled(tr("this is read as {0}'s {1}"), {"gnuplot", "splot"}));
        return true;
    }

    Words typed_;
    DialectText result_;
    std::optional<ParseError> error_;
    std::vector<Words> plots_;  ///< names that commands are given
    int commands_ = 0;
    int failed_functions_ = 0;  ///< statements that might have been one
};

}  // namespace

std::size_t DialectText::statement_offset(std::size_t place) const {
    const std::size_t typed = text.typed_offset(place);
    for (const auto& [begin, end] : wholes) {
        if (begin <= typed && typed < end) return begin;
    }
    return typed;
}

std::expected<std::optional<DialectText>, ParseError> read_dialects(std::string_view typed) {
    return DialectReader(typed).read();
}

}  // namespace zeroset
