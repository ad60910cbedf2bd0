// Builds calls of the words of shapes.def.

#include "engine/base/translation.hpp"
#include "engine/language/elaborator.hpp"

#include <string>

namespace zeroset {
namespace {

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
        arguments.insert(arguments.begin(), Value::vector(std::move(point)));
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
    if (kind == 'v' && argument.is_single()) argument = Value::vector(Values(3, argument));
    if (argument.point()) return true;
    const std::string word(syntax.function->name);
    const std::string list(syntax.function->arguments);
    const std::string reason =
        filled(tr("{0} of {1} is a vector of 3 numbers, not {2}"),
               {name_at(list, index), word + "(" + list + ")", argument.described()});
    const std::string hint = filled(tr("type a vector such as {0}"), {"(x, y, z)"});
    if (argument.is_single()) {
        values_.fail_for_vector(at(syntax.offset), reason, hint);
    } else {
        fail(syntax.offset, reason, hint);
    }
    return false;
}

}  // namespace zeroset
