#include "engine/language/dialects/function_steps.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/text_cursor.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

namespace zeroset {
namespace {

using Words = std::string_view;

constexpr std::size_t longest_condition = 500;  // bytes
constexpr int most_nested = 50;                 // choices within choices

/// Lines that belong together by how far they are set in.
class PythonBody {
public:
    PythonBody(Words text, std::size_t at, FunctionBody& body) : cursor_(text, at), body_(body) {}

    /// Writes the lines that are set in further than `outer`; returns the offset behind them.
    std::size_t write(std::size_t outer) {
        std::size_t end = cursor_.at();
        ++depth_;
        while (depth_ < most_nested && next_line()) {
            if (indent_ <= outer) break;
            line();
            end = cursor_.at();
        }
        --depth_;
        return end;
    }
    /// Writes what stands behind a colon: a step on the same line, or lines below.
    std::size_t write_behind_colon(std::size_t outer) {
        cursor_.skip_blanks();
        const std::size_t end = end_of_statement(cursor_.text(), cursor_.at());
        const Words row =
            without_remark(cursor_.text().substr(cursor_.at(), end - cursor_.at()), "#");
        if (row.empty()) return write(outer);
        simple(row);
        cursor_.skip(end - cursor_.at());
        return end;
    }

private:
    /// Goes to the start of the next line that says something; false: there is none.
    bool next_line() {
        for (;;) {
            const std::size_t line = cursor_.at();
            cursor_.skip_blanks();
            if (cursor_.is_at_end()) return false;
            const bool is_line_start = line == 0 || line_ends.contains(cursor_.text()[line - 1]);
            if (cursor_.take("#")) {
                cursor_.skip(
                    std::min(cursor_.rest().find_first_of(line_ends), cursor_.rest().size()));
            } else if (line_ends.contains(cursor_.rest().front()) ||
                       cursor_.rest().front() == ';') {
                cursor_.skip(1);
            } else {
                if (is_line_start) indent_ = cursor_.at() - line;
                return true;
            }
        }
    }
    void line() {
        const std::size_t own = indent_;
        if (cursor_.take_word("if")) {
            condition(own);
        } else if (const std::size_t length = docstring_length(cursor_.rest()); length > 0) {
            cursor_.skip(length);
        } else {
            const std::size_t end = end_of_statement(cursor_.text(), cursor_.at());
            const Words row = cursor_.text().substr(cursor_.at(), end - cursor_.at());
            cursor_.skip(row.size());
            simple(without_remark(row, "#"));
        }
    }
    /// The length of a text in three quotation marks, which may go over lines.
    static std::size_t docstring_length(Words text) {
        for (const Words marks : {R"(""")", "'''"}) {
            const std::size_t end = text.starts_with(marks) ? text.find(marks, 3) : Words::npos;
            if (end != Words::npos) return end + 3;
        }
        return 0;
    }
    void condition(std::size_t own) {
        const Words row = cursor_.rest();
        const std::size_t colon = find_outside(row, ":");
        if (colon == Words::npos) return cursor_.skip(row.size());
        body_.choice(trimmed(row.substr(0, colon)));
        cursor_.skip(colon + 1);
        write_behind_colon(own);
        const TextCursor before = cursor_;
        if (!next_line() || indent_ != own ||
            (cursor_.word() != "elif" && cursor_.word() != "else")) {
            cursor_ = before;
            return body_.close(cursor_.rest());
        }
        body_.otherwise(cursor_.rest());
        if (cursor_.take_word("elif")) {
            if (++depth_ < most_nested) condition(own);
            --depth_;
        } else {
            cursor_.skip(4);
            cursor_.skip_blanks();
            cursor_.take(":");
            write_behind_colon(own);
        }
        body_.close(cursor_.rest());
    }
    void simple(Words row) {
        constexpr std::array<Words, 5> idle{"pass", "global", "import", "from", "assert"};
        const Words word = row.substr(0, word_length(row));
        const bool is_remark = row.starts_with('"') || row.starts_with('\'');
        if (is_remark || std::ranges::find(idle, word) != idle.end()) return;
        if (word == "return") return body_.result(trimmed(row.substr(word.size())));
        body_.step(row);
    }

    TextCursor cursor_;
    FunctionBody& body_;
    std::size_t indent_ = 0;
    int depth_ = 0;
};

/// Steps in braces: JavaScript, R and Rust.
class BracesBody {
public:
    BracesBody(Words inside, FunctionBody& body) : cursor_(inside), body_(body) {}

    void write(int depth = 0) {
        while (depth < most_nested) {
            skip_idle();
            if (cursor_.is_at_end()) return;
            if (cursor_.take_word("if"))
                condition(depth);
            else
                simple();
        }
    }

private:
    void skip_idle() {
        for (;;) {
            cursor_.skip_any(" \t\n\v\r;");
            if (cursor_.rest().starts_with("//") || cursor_.rest().starts_with('#')) {
                cursor_.skip(
                    std::min(cursor_.rest().find_first_of(line_ends), cursor_.rest().size()));
            } else if (cursor_.rest().starts_with("/*")) {
                cursor_.skip(std::min(cursor_.rest().find("*/"), cursor_.rest().size() - 2) + 2);
            } else {
                return;
            }
        }
    }
    void condition(int depth) {
        const Words row = cursor_.rest();
        const std::size_t brace = row.find('{');
        auto inside = cursor_.take_brackets('(');
        if (!inside && brace != Words::npos) {
            inside = trimmed(row.substr(0, brace));
            cursor_.skip(brace);
        }
        body_.choice(inside.value_or(row));
        branch(depth);
        const TextCursor before = cursor_;
        skip_idle();
        if (cursor_.take_word("else")) {
            body_.otherwise(cursor_.rest());
            branch(depth);
        } else {
            cursor_ = before;
        }
        body_.close(cursor_.rest());
    }
    void branch(int depth) {
        skip_idle();
        if (const auto inside = cursor_.take_brackets('{'))
            return BracesBody(*inside, body_).write(depth + 1);
        if (cursor_.take_word("if"))
            return depth + 1 < most_nested ? condition(depth + 1) : simple();
        simple();
    }
    void simple() {
        const bool returns = cursor_.take_word("return");
        const std::size_t end = end_of_statement(cursor_.text(), cursor_.at());
        const Words row =
            without_remark(cursor_.text().substr(cursor_.at(), end - cursor_.at()), "//");
        cursor_.skip(std::max<std::size_t>(end - cursor_.at(), 1));
        if (returns)
            body_.result(row);
        else
            body_.step(row);
    }

    TextCursor cursor_;
    FunctionBody& body_;
};

/// Steps between words: Maple's proc ... end proc, and function ... end of MATLAB and Julia.
class WordsBody {
public:
    WordsBody(Words text, std::size_t at, FunctionBody& body) : cursor_(text, at), body_(body) {}

    /// Writes up to the function's end; returns the offset behind it; nothing where it has none.
    std::optional<std::size_t> write() {
        int open = 0;
        for (;;) {
            skip_idle();
            if (cursor_.is_at_end()) return open == 0 ? std::optional(cursor_.at()) : std::nullopt;
            if (cursor_.take_word("if") || cursor_.take_word("elif") ||
                cursor_.take_word("elseif")) {
                const bool is_further = last_ != "if";
                if (is_further) body_.otherwise(cursor_.rest());
                body_.choice(condition());
                closers_.push_back(is_further);
                open += is_further ? 0 : 1;
            } else if (cursor_.take_word("else")) {
                body_.otherwise(cursor_.rest());
            } else if (ends()) {
                if (open == 0) return cursor_.at();
                --open;
                close();
            } else {
                step();
            }
        }
    }

private:
    /// Goes to what is next, and keeps its word.
    void skip_idle() {
        for (;;) {
            cursor_.skip_any(" \t\n\v\r;:,");
            if (!cursor_.rest().starts_with('%') && !cursor_.rest().starts_with('#')) break;
            cursor_.skip(std::min(cursor_.rest().find_first_of(line_ends), cursor_.rest().size()));
        }
        last_ = cursor_.word();
    }
    bool ends() {
        for (const Words word : {"end", "fi", "endif", "endfunction"}) {
            if (!cursor_.take_word(word)) continue;
            for (const Words of : {"if", "proc", "function"}) {
                if (cursor_.take_word(of)) break;
            }
            return true;
        }
        return false;
    }
    Words condition() {
        const Words row = cursor_.rest();
        const std::size_t then = find_outside(row.substr(0, longest_condition), "then");
        const std::size_t line = std::min(row.find_first_of(line_ends), row.size());
        const std::size_t end = std::min(then, std::min(line, row.size()));
        cursor_.skip(end + (then == end ? 4 : 0));
        return trimmed(row.substr(0, end));
    }
    /// Closes the choice that ends, and those that went on in its "else".
    void close() {
        while (!closers_.empty()) {
            const bool is_further = closers_.back();
            closers_.pop_back();
            body_.close(cursor_.rest());
            if (!is_further) return;
        }
    }
    void step() {
        constexpr std::array<Words, 5> idle{"local", "global", "option", "description",
                                            "persistent"};
        const bool is_idle = std::ranges::find(idle, cursor_.word()) != idle.end();
        const bool returns = cursor_.take_word("return") || cursor_.take_word("RETURN");
        const std::size_t end = end_of_statement(cursor_.text(), cursor_.at());
        Words row = cursor_.text().substr(cursor_.at(), end - cursor_.at());
        for (const Words word : {"elif", "elseif", "else", "end", "fi"})
            row = row.substr(0, std::min(find_outside(row, word), row.size()));
        cursor_.skip(std::max<std::size_t>(row.size(), 1));
        row = without_remark(row, "%");
        if (row.ends_with(':')) row = trimmed(row.substr(0, row.size() - 1));
        if (is_idle || (returns && row.empty())) return;
        if (returns)
            body_.result(row);
        else
            body_.step(row);
    }

    TextCursor cursor_;
    FunctionBody& body_;
    Words last_;                 ///< the word that is next
    std::vector<bool> closers_;  ///< open choices; true: in the "else" of the one before
};

}  // namespace

std::size_t write_indented_steps(std::string_view text, std::size_t at, std::size_t indent,
                                 FunctionBody& body) {
    return PythonBody(text, at, body).write_behind_colon(indent);
}

void write_steps_in_braces(std::string_view inside, FunctionBody& body) {
    BracesBody(inside, body).write();
}

std::optional<std::size_t> write_steps_up_to_end(std::string_view text, std::size_t at,
                                                 FunctionBody& body) {
    return WordsBody(text, at, body).write();
}

}  // namespace zeroset
