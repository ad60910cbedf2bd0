#include "engine/language/expressions/free_names.hpp"

#include "engine/base/translation.hpp"
#include "engine/expr/constants.hpp"
#include "engine/expr/simplify.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"

#include <cassert>

namespace zeroset {

NodeId FreeNames::built_in(std::string_view name) {
    ExprBuilder& builder = values_.builder();
    const auto radius = [&](int dimensions) {
        NodeId squares = make_power(builder, builder.variable(0), builder.constant(2.0));
        for (int i = 1; i < dimensions; ++i) {
            squares = make_add(builder, squares,
                               make_power(builder, builder.variable(i), builder.constant(2.0)));
        }
        return make_call(builder, Op::Sqrt, squares);
    };
    if (name == "x" || name == "y" || name == "z") return builder.variable(name[0] - 'x');
    if (name == "w" || name == "t") return builder.variable(variable_w);
    if (name == "r") return radius(3);
    if (name == "rho") return radius(2);
    if (name == "theta")
        return make_call(builder, Op::Atan2, builder.variable(1), builder.variable(0));
    if (name == "phi")
        return make_call(builder, Op::Acos, make_divide(builder, builder.variable(2), radius(3)));
    for (const NamedConstant& known : named_constants) {
        if (name == known.name) return make_constant(builder, known);
    }
    assert(name == "golden");
    const NodeId root5 = make_call(builder, Op::Sqrt, builder.constant(5.0));
    return make_divide(builder, make_add(builder, builder.constant(1.0), root5),
                       builder.constant(2.0));
}

GraphValues::Built FreeNames::said(std::string_view name, std::size_t offset) {
    says_w_ = says_w_ || name == "w";
    says_t_ = says_t_ || name == "t";
    return values_.done(built_in(name), offset);
}

GraphValues::Built FreeNames::parameter(const std::string& name, std::size_t offset) {
    const auto [entry, is_new] = index_.try_emplace(name, parameters_.size());
    if (is_new) {
        if (parameters_.size() == ProgramLimits::parameters) {
            return values_.fail(offset, filled(tr("there are more than {0} parameters"),
                                               {std::to_string(ProgramLimits::parameters)}));
        }
        parameters_.push_back(name);
        note_other_meaning(name, offset);
    }
    const int variable = variable_w + 1 + static_cast<int>(entry->second);
    return values_.done(values_.builder().variable(variable), offset);
}

/// Notes that X, E and i are parameters here, but the coordinate, 2.718... and the imaginary unit
/// elsewhere.
void FreeNames::note_other_meaning(const std::string& name, std::size_t offset) {
    if (name == "i") {
        values_.note(offset, filled(tr("i is a parameter; it is the imaginary unit in {0}"),
                                    {"|x + i y|, Re(...), Im(...), arg(...)"}));
    }
    const bool is_axis = name == "X" || name == "Y" || name == "Z";
    if (!is_axis && name != "E") return;
    const char* const note = is_axis ? tr("{0} is a parameter; for the coordinate type {1}")
                                     : tr("{0} is a parameter; for 2.718... type {1}");
    values_.note(offset, filled(note, {name, in_small_letters(name)}));
}

}  // namespace zeroset
