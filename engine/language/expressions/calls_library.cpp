// Builds calls of the functions of library.def and the words of shapes.def.

#include "engine/base/translation.hpp"
#include "engine/language/expressions/calls.hpp"

#include <string>

namespace zeroset {
namespace {

/// The name of the argument at `index` of a list "p, r, h".
std::string_view name_at(std::string_view list, std::size_t index) {
    for (; index > 0; --index)
        list.remove_prefix(list.find(',') + 2);
    return list.substr(0, list.find(','));
}

/// Makes sure that an argument is a vector of 3 numbers.
bool make_point(const CallSite& site, std::size_t index, BuiltValue& argument) {
    const Function& function = *site.call.function;
    if (function.kinds[index] == 'v' && argument.is_single())
        argument = BuiltValue::vector(BuiltValues(3, argument));
    if (argument.point()) return true;
    const std::string reason =
        filled(tr("{0} of {1} is a vector of 3 numbers, not {2}"),
               {name_at(function.arguments, index), call_of(function), argument.described()});
    const std::string hint = filled(tr("type a vector such as {0}"), {"(x, y, z)"});
    if (argument.is_single()) {
        site.values().fail_for_vector(site.offset(), reason, hint);
    } else {
        refuse_call(site, reason, hint);
    }
    return false;
}

/// Puts (x, y, z) in place of a point that is left out, and three numbers in place of one for a
/// size. False if an argument is of another kind than the word takes.
bool fits(const CallSite& site, BuiltValues& arguments) {
    const Function& function = *site.call.function;
    if (arguments.size() + 1 == function.kinds.size()) {
        BuiltValues point;
        for (const int axis : {0, 1, 2})
            point.push_back({.id = site.builder().variable(axis)});
        if (!site.values().done(point.back().id, site.offset())) return false;
        arguments.insert(arguments.begin(), BuiltValue::vector(std::move(point)));
    }
    const std::size_t added = arguments.size() - site.call.operands.size();
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const char kind = function.is_word() ? function.kinds[i] : 'n';
        const std::size_t offset = i < added ? site.offset() : site.offset_of(i - added);
        if (kind == 'n' && !site.values().number_of(arguments[i], offset)) return false;
        if (kind != 'n' && kind != 'a' && !make_point(site, i, arguments[i])) return false;
    }
    return true;
}

}  // namespace

GraphValues::Built read_library_call(const CallSite& site) {
    const LibraryFunction& function = site.reader.tree().library.at(site.call.function);
    auto arguments = site.reader.operands(site.call.operands, site.context);
    if (!arguments || !fits(site, *arguments)) return std::nullopt;
    std::vector<LocalName> names;
    names.reserve(arguments->size());
    for (std::size_t i = 0; i < arguments->size(); ++i) {
        names.push_back({.name = function.arguments[i],
                         .value = (*arguments)[i],
                         .outer = i == 0 ? nullptr : &names[i - 1]});
    }
    Context body = site.context.with(&names.back());
    body.library_offset = site.offset();
    return site.reader.build(function.body, body);
}

}  // namespace zeroset
