#include "engine/language/dialects/functions_of_programs.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/function_body.hpp"
#include "engine/language/dialects/function_steps.hpp"
#include "engine/language/dialects/text_cursor.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace zeroset {
namespace {

using Words = std::string_view;

constexpr std::size_t longest_function = 20'000;  // bytes

/// A function's name, and its arguments as typed.
struct Head {
    Words name, arguments;
};

/// Reads `NAME(arguments)`.
std::optional<Head> head_at(TextCursor& cursor) {
    const Words name = cursor.word();
    if (name.empty()) return std::nullopt;
    cursor.skip(name.size());
    cursor.skip_blanks();
    const auto arguments = cursor.take_brackets('(');
    if (!arguments) return std::nullopt;
    cursor.skip_blanks();
    return Head{.name = name, .arguments = *arguments};
}

/// Writes functions of all these languages.
class FunctionOfProgram {
public:
    FunctionOfProgram(std::size_t at, ExpressionWriter& writer)
        : text_(writer.text().typed().substr(0, at + longest_function)),
          start_(at),
          body_(writer) {}

    std::optional<std::size_t> write() {
        TextCursor cursor(text_, start_);
        if (cursor.take_word("def")) return python(cursor);
        for (const Words word : {"fn", "func", "fun"}) {
            if (cursor.take_word(word)) return braces_behind_type(cursor);
        }
        if (cursor.take_word("function")) return function(cursor);
        for (const Words word : {"const", "let", "var"})
            cursor.take_word(word);
        return assigned(cursor);
    }

private:
    std::optional<std::size_t> python(TextCursor cursor) {
        const auto head = head_at(cursor);
        if (!head) return std::nullopt;
        if (cursor.rest().starts_with("->"))
            cursor.skip(std::min(cursor.rest().find(':'), cursor.rest().size()));
        if (!cursor.take(":")) return std::nullopt;
        body_.begin(head->name, head->arguments);
        const std::size_t line = text_.find_last_of(line_ends, start_);
        const std::size_t indent = start_ - (line == Words::npos ? 0 : line + 1);
        const std::size_t end = write_indented_steps(text_, cursor.at(), indent, body_);
        body_.end(text_.substr(end));
        return end;
    }
    std::optional<std::size_t> braces_behind_type(TextCursor cursor) {
        const auto head = head_at(cursor);
        const std::size_t brace = cursor.rest().find('{');
        if (!head || brace == Words::npos) return std::nullopt;
        if (cursor.rest().substr(0, brace).find_first_of("=;") != Words::npos) return std::nullopt;
        cursor.skip(brace);
        return braces(*head, cursor);
    }
    /// Writes a body in braces, which begins at the cursor.
    std::optional<std::size_t> braces(const Head& head, TextCursor cursor) {
        const auto inside = cursor.take_brackets('{');
        if (!inside) return std::nullopt;
        body_.begin(head.name, head.arguments);
        write_steps_in_braces(*inside, body_);
        body_.end(cursor.rest());
        return cursor.at();
    }
    /// JavaScript's `function f(x) {`, or `function v = f(x) ... end`.
    std::optional<std::size_t> function(TextCursor cursor) {
        Words result;
        const std::size_t word = word_length(cursor.rest());
        const Words behind = trimmed(cursor.rest().substr(word));
        if (word > 0 && behind.starts_with('=')) {
            result = cursor.word();
            cursor.skip(offset_in(behind) + 1 - cursor.at());
            cursor.skip_blanks();
        }
        const auto head = head_at(cursor);
        if (!head) return std::nullopt;
        cursor.skip_any(" \t\n\v\r");
        if (result.empty() && cursor.rest().starts_with('{')) return braces(*head, cursor);
        body_.begin(head->name, head->arguments);
        const auto end = write_steps_up_to_end(text_, cursor.at(), body_);
        if (!end) return std::nullopt;
        if (!result.empty()) body_.result(result);
        body_.end(text_.substr(*end));
        return end;
    }
    /// `f = function(x) {`, `f <- function(x) x^2`, `f := proc(x)`, `f = (x) => {`.
    std::optional<std::size_t> assigned(TextCursor cursor) {
        const Words name = cursor.word();
        cursor.skip(name.size());
        cursor.skip_blanks();
        const bool is_arrow_of_r = cursor.rest().starts_with("<-");
        if (name.empty() || !(cursor.take(":=") || cursor.take("<-") || cursor.take("=")))
            return std::nullopt;
        cursor.skip_blanks();
        const bool is_function = cursor.take_word("function");
        const bool is_proc = !is_function && cursor.take_word("proc");
        const auto arguments = cursor.take_brackets('(');
        if (!arguments) return std::nullopt;
        const Head head{.name = name, .arguments = *arguments};
        cursor.skip_blanks();
        if (is_proc) {
            body_.begin(name, *arguments);
            const auto end = write_steps_up_to_end(text_, cursor.at(), body_);
            if (end) body_.end(text_.substr(*end));
            return end;
        }
        if (!is_function && !cursor.take("=>")) return std::nullopt;
        cursor.skip_any(" \t\n\v\r");
        if (cursor.rest().starts_with('{'))
            return has_steps(cursor) || is_arrow_of_r ? braces(head, cursor) : std::nullopt;
        if (!is_function || !is_arrow_of_r) return std::nullopt;
        const std::size_t end = end_of_statement(text_, cursor.at());
        body_.begin(name, *arguments);
        body_.result(without_remark(text_.substr(cursor.at(), end - cursor.at()), "#"));
        body_.end(text_.substr(end));
        return end;
    }
    /// Whether braces hold more than POV-Ray's one expression.
    [[nodiscard]] static bool has_steps(TextCursor cursor) {
        const auto inside = cursor.take_brackets('{');
        return inside && (inside->contains("return") || trimmed(*inside).contains('\n'));
    }
    [[nodiscard]] std::size_t offset_in(Words part) const {
        return static_cast<std::size_t>(part.data() - text_.data());
    }

    Words text_;
    std::size_t start_;
    FunctionBody body_;
};

}  // namespace

std::optional<std::size_t> write_program_function(std::size_t at, ExpressionWriter& writer) {
    return FunctionOfProgram(at, writer).write();
}

}  // namespace zeroset
