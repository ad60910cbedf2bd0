// Builds calls of the words of shapes.def, and iterations.

#include "engine/base/translation.hpp"
#include "engine/language/elaborator.hpp"

#include <string>

namespace zeroset {
namespace {

constexpr double most_steps = 100;
constexpr std::size_t most_nodes = 20'000;  // of one iteration

/// The name of the argument at `index` of a list "p, r, h".
std::string_view name_at(std::string_view list, std::size_t index) {
    for (; index > 0; --index)
        list.remove_prefix(list.find(',') + 2);
    return list.substr(0, list.find(','));
}

}  // namespace

/// Puts (x, y, z) in place of a point that is left out, and three numbers in place of one for a
/// size. False if an argument is of another kind than the word takes.
bool Elaborator::fits(const Syntax& syntax, Values& arguments) {
    const Function& function = *syntax.function;
    if (arguments.size() + 1 == function.kinds.size()) {
        Values point;
        for (const int axis : {0, 1, 2})
            point.push_back({.id = builder_.variable(axis)});
        if (!done(point.back().id, syntax.offset)) return false;
        arguments.insert(arguments.begin(), bundle(Value::Kind::Vector, std::move(point)));
    }
    const std::size_t added = arguments.size() - syntax.operands.size();
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const char kind = function.is_word() ? function.kinds[i] : 'n';
        const std::size_t offset =
            i < added ? syntax.offset : tree_[syntax.operands[i - added]].offset;
        if (kind == 'n' && !number_of(arguments[i], offset)) return false;
        if (kind != 'n' && kind != 'a' && !make_point(kind, arguments[i], syntax, i)) return false;
    }
    return true;
}

/// Makes sure that an argument is a vector of 3 numbers.
bool Elaborator::make_point(char kind, Value& argument, const Syntax& syntax, std::size_t index) {
    if (kind == 'v' && argument.is_single())
        argument = bundle(Value::Kind::Vector, Values(3, argument));
    if (point_of(argument)) return true;
    wants_vector_ = wants_vector_ || argument.is_single();
    const std::string word(syntax.function->name);
    const std::string list(syntax.function->arguments);
    const std::string_view name = name_at(list, index);
    fail(syntax.offset,
         filled(tr("{0} of {1} is a vector of 3 numbers, not {2}"),
                {name, word + "(" + list + ")", described(argument)}),
         filled(tr("type a vector such as {0}"), {"(x, y, z)"}));
    return false;
}

/// Writes out iterate(p, n, start, step).
Elaborator::Built Elaborator::iterated(const Syntax& syntax, const Binding* scope) {
    const Syntax& name = tree_[syntax.operands[0]];
    const std::string example = filled(tr("for example {0}"), {"iterate(u, 3, x, u^2 + y)"});
    if (name.kind != SyntaxKind::Name)
        return fail(name.offset, tr("the first argument of iterate is a name"), example);
    const auto count =
        whole_number(syntax.operands[1], scope,
                     {.reason = tr("the number of steps is a whole number"), .hint = example});
    if (!count) return std::nullopt;
    if (*count < 0 || *count > most_steps) {
        return fail(tree_[syntax.operands[1]].offset,
                    filled(tr("iterate takes from 0 to {0} steps"),
                           {std::to_string(static_cast<int>(most_steps))}),
                    tr("use fewer"));
    }
    Built value = operand(syntax.operands[2], scope);
    const std::size_t before = builder_.size();
    for (int step = 0; value && step < static_cast<int>(*count); ++step) {
        const Binding binding{.name = name.text, .value = *value, .outer = scope};
        value = operand(syntax.operands[3], &binding);
        if (value && builder_.size() - before > most_nodes) {
            return fail(syntax.offset,
                        filled(tr("{0} steps of this iteration have more than {1} operations"),
                               {std::to_string(step + 1), std::to_string(most_nodes)}),
                        tr("use fewer steps or a shorter step"));
        }
    }
    return value;
}

}  // namespace zeroset
