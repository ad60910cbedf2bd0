#pragma once

#include "engine/language/dialects/asked_box.hpp"
#include "engine/language/dialects/parts.hpp"
#include "engine/language/dialects/source_text.hpp"
#include "engine/language/dialects/tables.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Expressions of other programs in the words of the language.

namespace zeroset {

/// Adds expressions to a text. What the language reads itself is kept as typed; sums, cases and
/// choices that other programs write otherwise are put into its words.
class ExpressionWriter {
public:
    explicit ExpressionWriter(SourceText& text) : text_(text) {}

    void write(std::string_view expression);
    /// The words of an expression, which may also be no part of the typed text.
    [[nodiscard]] std::string words_of(std::string_view expression) const;
    void put(std::string_view words, std::string_view near) {
        text_.put(words, text_.offset_of(near));
    }
    /// Whether the typed text gives this name to a function: f = @(x, y), f[x_] := ..., def f(x).
    [[nodiscard]] bool is_function(std::string_view name) const;
    /// The list in brackets that the typed text gives a name: ends = [-1 1]; empty: none.
    [[nodiscard]] std::string_view value_of(std::string_view name) const;
    using Names = std::vector<std::pair<std::string_view, std::string_view>>;
    /// Puts other names in place of these, until it is told otherwise.
    void rename(Names names) { renamed_ = std::move(names); }
    /// Does something with more words in place of names.
    void with_term(const Table::Term& term, const std::function<void()>& write);
    /// Puts other names in place of these, where `rename` says nothing of them.
    void rename_always(Names names) { always_renamed_ = std::move(names); }
    /// The name that stands in place of a word; empty: itself.
    [[nodiscard]] std::string_view other_name(std::string_view word) const;
    /// Reads {a, b, c} as a vector, as Mathematica does.
    void read_lists() { reads_lists_ = true; }
    [[nodiscard]] SourceText& text() { return text_; }

private:
    std::size_t write_other(std::string_view expression, std::size_t at,
                            const std::function<void()>& flush);
    std::size_t write_list(std::string_view text, std::string_view opener,
                           const std::function<void()>& flush);
    bool write_call(std::string_view word, std::string_view inside);
    bool write_sum(std::string_view word, std::string_view inside);
    bool write_list_by_index(std::string_view word, std::string_view inside);
    bool write_cases(std::string_view word, std::string_view inside);
    void write_joined(std::string_view open, std::string_view a, std::string_view sign,
                      std::string_view b, std::string_view close);
    bool write_choice(std::string_view expression);

    SourceText& text_;
    Names renamed_, always_renamed_;
    bool reads_lists_ = false;
    RemarkEnds remarks_{"*)"};
    int depth_ = 0;     ///< calls within calls
    int unclosed_ = 0;  ///< calls without an end
};

/// Whether the expressions of a text have something that only `ExpressionWriter` reads.
bool has_foreign_expression(std::string_view text);

}  // namespace zeroset
