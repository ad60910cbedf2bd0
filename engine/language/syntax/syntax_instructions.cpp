// Lists of instructions as Fidget and libfive store models (.vm). Each line has a name for its
// result, the operation, and the names of the operands. The last result is the formula.

#include "engine/base/translation.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/language/syntax/syntax_parser.hpp"
#include "engine/language/words/words.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace zeroset {
namespace {

/// Operations whose functions have other names here.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> other_words{
    {{"log", "ln"}, {"rem", "mod"}, {"nth-root", "root"}}};

constexpr std::array<std::pair<std::string_view, char>, 4> arithmetic{
    {{"add", '+'}, {"sub", '-'}, {"mul", '*'}, {"div", '/'}}};

const Function* function_of(std::string_view word) {
    for (const auto& [other, name] : other_words) {
        if (other == word) return find_function(name);
    }
    return find_function(word);
}

}  // namespace

SyntaxParser::Parsed SyntaxParser::instructions() {
    const std::size_t offset = next().offset;
    NameMap<SyntaxId> known;
    std::vector<SyntaxId> values;
    while (next().kind != TokenKind::End && next().text != ";") {
        if (next().kind == TokenKind::Break) {
            take();
            continue;
        }
        const Token& name = take();
        if (name.kind != TokenKind::Name)
            return fail(name, tr("an instruction starts with a name"));
        const Parsed value = instruction(known);
        if (!value) return value;
        if (!at_break()) return refuse(surplus());
        values.push_back(*value);
        known[full_name(name)] = *value;
    }
    tree_.notes.add(offset,
                    tr("this is read as a list of instructions, the last of them the formula"));
    return add(SyntaxKind::List, offset, std::move(values));
}

SyntaxParser::Parsed SyntaxParser::instruction(const NameMap<SyntaxId>& known) {
    const Token& word = take();
    if (word.text == "const") return instruction_number();
    if (word.text == "var" && next_is("-")) {
        take();
        const Token& axis = take();
        if (axis.text == "x" || axis.text == "y" || axis.text == "z")
            return add(SyntaxKind::Name, axis.offset, {}, {}, axis.text);
        return fail(axis, tr("the variables are var-x, var-y and var-z"));
    }
    if (word.kind != TokenKind::Name) return fail(word, tr("an instruction is missing here"));
    return instruction_value(word, known);
}

SyntaxParser::Parsed SyntaxParser::instruction_number() {
    const std::size_t offset = next().offset;
    const bool negative = next_is("-");
    if (next_is_one_of({"-", "+"})) take();
    if (next().kind != TokenKind::Number)
        return fail(next(), tr("a number is missing behind 'const'"));
    const SyntaxId number = add(SyntaxKind::Number, offset, {}, {}, take().text);
    return negative ? add(SyntaxKind::Negate, offset, {number}) : number;
}

SyntaxParser::Parsed SyntaxParser::instruction_value(const Token& word,
                                                     const NameMap<SyntaxId>& known) {
    std::vector<SyntaxId> operands;
    while (!at_break()) {
        const Token& name = take();
        const auto earlier = known.find(full_name(name));
        if (earlier == known.end()) {
            return fail(name, filled(tr("{0} is no instruction before this one"),
                                     {quoted(full_name(name))}));
        }
        operands.push_back(add(SyntaxKind::Earlier, name.offset, {earlier->second}));
    }
    const auto sign =
        std::ranges::find(arithmetic, word.text, &std::pair<std::string_view, char>::first);
    if (sign != arithmetic.end() && operands.size() == 2) {
        const bool sum = sign->second == '+' || sign->second == '-';
        return add(sum ? SyntaxKind::Sum : SyntaxKind::Product, word.offset, std::move(operands),
                   std::string(1, sign->second));
    }
    if (operands.size() == 1 && word.text == "neg")
        return add(SyntaxKind::Negate, word.offset, std::move(operands));
    if (operands.size() == 1 && (word.text == "square" || word.text == "recip")) {
        const bool square = word.text == "square";
        const SyntaxId number = add(SyntaxKind::Number, word.offset, {}, {}, square ? "2" : "1");
        if (square) return add(SyntaxKind::Power, word.offset, {operands[0], number});
        return add(SyntaxKind::Product, word.offset, {number, operands[0]}, "/");
    }
    const Function* const function = function_of(full_name(word));
    if (function == nullptr || function->repeats() || !function->takes(operands.size())) {
        return fail(
            word,
            filled(tr("{0} is no instruction for {1} values"),
                   {quoted(full_name(word)), std::to_string(operands.size())}),
            tr("known are const, var-x, neg, add, sub, mul, div, min, max, sqrt, square, ..."));
    }
    return add_call(*function, word.offset, std::move(operands));
}

}  // namespace zeroset
