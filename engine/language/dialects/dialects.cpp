#include "engine/language/dialects/dialects.hpp"

#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"
#include "engine/language/dialects/command_arguments.hpp"
#include "engine/language/dialects/command_table.hpp"
#include "engine/language/dialects/commands.hpp"
#include "engine/language/dialects/functions_of_programs.hpp"
#include "engine/language/dialects/gnuplot.hpp"
#include "engine/language/dialects/grids.hpp"
#include "engine/language/dialects/idle_lines.hpp"
#include "engine/language/dialects/latex.hpp"
#include "engine/language/dialects/names_in_text.hpp"
#include "engine/language/dialects/prompts.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

using Words = std::string_view;

constexpr std::size_t longest_call = 20'000;  // bytes of a command with its arguments
constexpr int most_commands = 200;
constexpr int most_unclosed_calls = 100;

/// Reads a text statement by statement.
class DialectReader {
public:
    explicit DialectReader(Words typed)
        : typed_(typed), result_{.text = SourceText(typed), .box = {}, .notes = {}, .wholes = {}} {}

    std::expected<std::optional<DialectText>, ParseError> read() {
        if (SourceText latex = latex_in_words(typed_); latex.is_changed()) {
            result_.text = std::move(latex);
            return std::move(result_);
        }
        if (!is_foreign()) return std::nullopt;
        if (error_) return std::unexpected(*error_);
        ExpressionWriter writer(result_.text);
        if (program_ == "Mathematica") writer.read_lists();
        if (draws_) writer.rename_always(names_of_axes());
        Grids grids(writer, result_.box);
        for (std::size_t at = 0; at < typed_.size();) {
            at = keep_blanks(at);
            if (at == typed_.size()) break;
            const std::size_t begin = at;
            if (prompts_.is_output(at))
                at = end_of_statement(typed_, at);
            else if (!statement(at, writer, grids))
                return std::unexpected(*error_);
            if (at == begin) ++at;
            result_.wholes.emplace_back(begin, at);
        }
        return std::move(result_);
    }

private:
    /// Whether there is anything here that the language does not read itself. Finds whose it is.
    [[nodiscard]] bool is_foreign() {
        bool is_foreign = has_foreign_expression(typed_) && rewrites();
        SourceText scratch(typed_);
        ExpressionWriter scratch_writer(scratch);
        for (std::size_t at = 0; at < typed_.size();) {
            at = prompts_.behind(behind_blanks(at));
            const std::size_t end = end_of_statement(typed_, at);
            const Words row = trimmed(typed_.substr(at, end - at));
            if (refuse_matrix(row)) return true;
            const auto call = call_in(row);
            const bool has_grid = Grids::makes_grid(row);
            draws_ = draws_ || call || has_grid;
            if (call) program_ = program_of_command(call->name);
            assigns_ = assigns_ || has_grid || loads_library(row) || (call && assigns(*call));
            is_foreign = is_foreign || draws_ || assigns_ || level_in(row) || swaps_angles(row) ||
                         row.starts_with("splot ") || function(at, scratch_writer);
            if (call) return true;
            at = std::max(end, at + 1);
        }
        return is_foreign;
    }

    /// Whether expressions of the text are written otherwise.
    [[nodiscard]] bool rewrites() const {
        SourceText scratch(typed_);
        ExpressionWriter(scratch).write(typed_);
        return scratch.is_changed();
    }

    /// Refuses M = {{2, 0}, {0, 1}} and M = [2 0; 0 1].
    bool refuse_matrix(Words row) {
        const Words name = row.substr(0, word_length(row));
        Words value = trimmed(row.substr(name.size()));
        if (name.empty() || !(value.starts_with('=') || value.starts_with(":="))) return false;
        value = trimmed(value.substr(value.find('=') + 1));
        const auto inside = in_brackets(value);
        const bool is_matrix = inside && (value.starts_with("{{") ||
                                          (value.starts_with('[') && inside->contains(';')));
        if (!is_matrix) return false;
        error_ = {
            .offset = result_.text.offset_of(value),
            .reason = filled(tr("matrices are not read: {0}"), {"'" + std::string(name) + "'"}),
            .hint = tr("to turn a point type rotate(p, axis, angle)")};
        return true;
    }

    /// Whether the program of a command assigns by "=", and compares by "==".
    static bool assigns(const CommandCall& call) {
        const Words program = program_of_command(call.name);
        return program == "Mathematica" || program == "MATLAB" || program == "SymPy" ||
               program == "Sage";
    }

    [[nodiscard]] std::size_t behind_blanks(std::size_t at) const {
        return std::min(typed_.find_first_not_of(" \t\n\v\r;", at), typed_.size());
    }
    /// Names of their own for x, y and z where a program gives them values, which a command asks
    /// for later: x = u*cos(v); plot3d([x, y, z], ...).
    [[nodiscard]] ExpressionWriter::Names names_of_axes() const {
        constexpr std::array<std::pair<Words, Words>, 3> own{
            {{"x", "x_value"}, {"y", "y_value"}, {"z", "z_value"}}};
        ExpressionWriter::Names names;
        for (std::size_t at = 0; at < typed_.size();) {
            at = prompts_.behind(behind_blanks(at));
            const std::size_t end = end_of_statement(typed_, at);
            const Words row = trimmed(typed_.substr(at, end - at));
            at = std::max(end, at + 1);
            const auto* const axis = std::ranges::find(own, row.substr(0, word_length(row)),
                                                       &std::pair<Words, Words>::first);
            if (axis != own.end() && gives_value(trimmed(row.substr(1)))) names.push_back(*axis);
        }
        return names;
    }
    /// Whether `= value` stands behind a name, and the value is no grid's line and no symbol.
    [[nodiscard]] bool gives_value(Words behind) const {
        const bool is_certain = behind.starts_with(":=");
        const bool is_plain = assigns_ && behind.starts_with('=') && !behind.starts_with("==");
        if (!is_certain && !is_plain) return false;
        Words value = trimmed(behind.substr(is_certain ? 2 : 1));
        if (value.ends_with(':')) value.remove_suffix(1);  // Maple's end of a statement
        return !loads_library(behind) && !Grids::is_line(value);
    }
    /// Keeps blanks and line ends, but no prompt; returns the offset behind them.
    std::size_t keep_blanks(std::size_t at) {
        const std::size_t end = behind_blanks(at);
        result_.text.keep(typed_.substr(at, end - at));
        return prompts_.behind(end);
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
        if (swaps_angles(row)) {
            writer.put("theta := acos(z/sqrt(x^2 + y^2 + z^2)); phi := atan2(y, x)", row);
            at = end;
            return true;
        }
        if (const auto call = call_in(row)) {
            at = end;
            return command(*call, row, writer);
        }
        if (const auto level = level_in(row)) {
            const auto& [call, value, constant] = *level;
            result_.text.keep(call);
            writer.put(" := ", value);
            writer.write(value);
            writer.put("; ", constant);
            result_.text.keep(call);
            writer.put(" = ", constant);
            writer.write(constant);
            at = end;
            return true;
        }
        const bool shows_plot = std::ranges::find(plots_, row) != plots_.end();
        if (!is_idle(row) && !shows_plot) other_statement(typed_.substr(at, end - at), writer);
        at = end;
        return true;
    }

    /// Whether the row is angles_swapped, in words or letters.
    static bool swaps_angles(Words row) {
        if (!row.starts_with("swap ")) return false;
        const auto names = split_outside(row.substr(5), ',');
        return names.size() == 2 && (names[0] == "theta" || names[0] == "\u03B8") &&
               (names[1] == "phi" || names[1] == "\u03C6");
    }

    /// The parts of F(x, y, z) = x^2 + y^2 + z^2 - 1 = 0, as papers have it.
    static std::optional<std::array<Words, 3>> level_in(Words row) {
        const Words name = row.substr(0, word_length(row));
        const std::size_t first = find_outside(row, "=");
        if (name.empty() || first == Words::npos || is_built_in(name)) return std::nullopt;
        const Words call = trimmed(row.substr(0, first));
        const auto arguments = in_brackets(call.substr(name.size()));
        const auto parts = split_outside(row.substr(first + 1), '=');
        const bool is_plain =
            parts.size() == 2 && row.find_first_of("<>!:?,|&", first) == Words::npos &&
            find_outside(row, "or") == Words::npos && find_outside(row, "and") == Words::npos;
        if (!arguments || !is_plain || parts[0].empty() || parts[1].empty()) return std::nullopt;
        const auto names = split_outside(*arguments, ',');
        if (!std::ranges::all_of(names, is_word)) return std::nullopt;
        return std::array{call, parts[0], parts[1]};
    }

    /// Writes a statement that is neither a command nor a function. Where programs assign by "=",
    /// it defines, several names at once, too.
    void other_statement(Words text, ExpressionWriter& writer) const {
        const Words row = trimmed(text);
        const std::size_t equals = assigns_ ? find_outside(row, "=") : Words::npos;
        const bool compares = equals == Words::npos || row.substr(equals).starts_with("==") ||
                              (equals > 0 && Words("<>!:").contains(row[equals - 1]));
        const auto names =
            compares ? std::vector<Words>() : split_outside(row.substr(0, equals), ',');
        const auto values = compares ? names : split_outside(row.substr(equals + 1), ',');
        const bool defines = !names.empty() && names.size() == values.size() &&
                             std::ranges::all_of(names, [](Words name) { return is_word(name); });
        const bool is_axis = !names.empty() && writer.other_name(names[0]).empty() &&
                             std::ranges::find(axis_names, names[0]) != axis_names.end();
        if (!defines || is_axis) return writer.write(text);
        const auto list = in_brackets(values[0]);
        const bool is_row_of_numbers = list && values[0].starts_with('[') && !list->contains(',');
        if (is_row_of_numbers) return;  // ends for a command, as MATLAB has them
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (i > 0) writer.put("; ", names[i]);
            writer.write(names[i]);
            writer.put(" := ", values[i]);
            writer.write(values[i]);
        }
    }

    /// Writes the function of a program that starts at `at`; returns the offset behind it.
    std::optional<std::size_t> function(std::size_t at, ExpressionWriter& writer) {
        constexpr int most_failed = 20;  // that began as one
        if (failed_functions_ > most_failed) return std::nullopt;
        const std::size_t before = writer.text().words().size();
        const auto behind = write_program_function(at, writer);
        if (!behind) {
            failed_functions_ += writer.text().words().size() > before ? 1 : 0;
            writer.text().cut_back(before);
            return std::nullopt;
        }
        writer.put("\n", typed_.substr(*behind));
        return *behind + (typed_.substr(*behind).starts_with(':') ? 1 : 0);
    }

    /// The plotting command that a whole statement is, perhaps given a name.
    [[nodiscard]] std::optional<CommandCall> call_in(Words row) {
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
        if (const Words inner = in_index(row, length); known_command(inner) != nullptr) {
            const auto arguments = in_brackets(row.substr(length + inner.size() + 2));
            if (arguments) return CommandCall{.name = inner, .arguments = arguments_in(*arguments)};
        }
        const Words name = row.substr(0, length);
        if (known_command(name) == nullptr) return std::nullopt;
        const std::size_t opener = length + blank_length(row.substr(length));
        const bool calls = opener < row.size() && (row[opener] == '(' || row[opener] == '[');
        if (!calls || unclosed_calls_ > most_unclosed_calls) return std::nullopt;
        const auto closer = closing_bracket(row.substr(opener, longest_call));
        unclosed_calls_ += closer ? 0 : 1;
        if (!closer) return std::nullopt;
        const Words rest = trimmed(row.substr(opener + *closer + 1));
        const bool ends = rest.empty() || rest == ":" || rest == "$" ||
                          rest.starts_with(".show(") || rest == "// Evaluate";
        if (!ends) return std::nullopt;
        CommandCall call{.name = name,
                         .arguments = arguments_in(row.substr(opener + 1, *closer - 1))};
        if (!is_command(call) || is_function_in(typed_, name)) return std::nullopt;
        return call;
    }
    /// The name in plots[implicitplot3d], behind the first `length` bytes.
    static Words in_index(Words row, std::size_t length) {
        const Words behind = row.substr(length);
        if (length == 0 || !behind.starts_with('[')) return {};
        const Words name = behind.substr(1, word_length(behind.substr(1)));
        return behind.substr(1 + name.size()).starts_with("](") ? name : Words();
    }

    bool command(const CommandCall& call, Words row, ExpressionWriter& writer) {
        if (++commands_ > most_commands) return refuse(call.name);
        const auto outcome = write_command(call, writer);
        if (!outcome) return refuse(call.name);
        writer.put(";", row.substr(row.size()));
        if (const std::size_t name = word_length(row); row.data() != call.name.data())
            plots_.push_back(row.substr(0, name));
        note(call, *outcome);
        take(outcome->box, result_.text.offset_of(call.name));
        return true;
    }
    bool refuse(Words command) {
        error_ = {.offset = result_.text.offset_of(command),
                  .reason = filled(tr("{0} is a command of another program"),
                                   {"'" + std::string(command) + "'"}),
                  .hint = tr("type only the equation in it")};
        return false;
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

    bool splot(Words row, ExpressionWriter& writer) {
        if (++commands_ > most_commands) return refuse(row.substr(0, word_length(row)));
        take(write_splot(row, writer), result_.text.offset_of(row));
        result_.notes.add(result_.text.offset_of(row),
                          filled(tr("this is read as {0}'s {1}"), {"gnuplot", "splot"}));
        return true;
    }

    Words typed_;
    Prompts prompts_{typed_};
    DialectText result_;
    std::optional<ParseError> error_;
    Words program_;             ///< whose command the text begins with
    std::vector<Words> plots_;  ///< names that commands are given
    bool draws_ = false;        ///< there is a command, or a grid to draw on
    bool assigns_ = false;      ///< "=" gives a name its value, and is no equation
    int commands_ = 0;
    int unclosed_calls_ = 0;
    int failed_functions_ = 0;  ///< statements that might have been one
};

}  // namespace

std::size_t DialectText::statement_offset(std::size_t place) const {
    const std::size_t typed = text.typed_offset(place);
    const auto behind =
        std::ranges::upper_bound(wholes, typed, {}, &std::pair<std::size_t, std::size_t>::first);
    const bool is_within = behind != wholes.begin() && typed < std::prev(behind)->second;
    return is_within ? std::prev(behind)->first : typed;
}

std::expected<std::optional<DialectText>, ParseError> read_dialects(std::string_view typed) {
    return DialectReader(typed).read();
}

}  // namespace zeroset
