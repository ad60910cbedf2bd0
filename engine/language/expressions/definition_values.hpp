#pragma once

#include "engine/language/expressions/context.hpp"
#include "engine/language/expressions/definition_table.hpp"
#include "engine/language/values/graph_values.hpp"

#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace zeroset {

class ExpressionReader;

/// A function and its arguments, those of several parts as their number and their parts.
using FunctionCall = std::pair<const Definition*, std::vector<NodeId>>;
struct FunctionCallHash {
    std::size_t operator()(const FunctionCall& call) const;
};

/// The values of definitions and calls that are built.
struct KnownValues {
    std::unordered_map<const Definition*, BuiltValue> values;
    std::unordered_map<FunctionCall, BuiltValue, FunctionCallHash> calls;
    std::unordered_set<const Definition*> settled;  ///< what they need was built before them
};

/// The variables of a row, u and v in (u, v, 0), 0 < u < 1, 0 < v < 1, and the definitions whose
/// values go by them: these have values of their own there.
class RowScope {
public:
    /// `going_by`: such definitions; outlives this object.
    explicit RowScope(const std::set<const Definition*>& going_by) : going_by_(going_by) {}

    /// Gives the variables other values; `innermost` and those around it outlive this object.
    void bind(const LocalName* innermost) {
        variables_ = innermost;
        known = {};
    }
    [[nodiscard]] const LocalName* variables() const { return variables_; }
    [[nodiscard]] bool holds(const Definition& definition) const {
        return variables_ != nullptr && going_by_.contains(&definition);
    }

    KnownValues known;  ///< for the values that the variables have

private:
    const std::set<const Definition*>& going_by_;
    const LocalName* variables_ = nullptr;
};

/// The values of what a text defines, each built once.
class DefinitionValues {
public:
    explicit DefinitionValues(ExpressionReader& reader) : reader_(reader) {}

    /// The value of a definition that is no function, which `name` asks for: a built-in name keeps
    /// its meaning within its own definition.
    GraphValues::Built value(Definition& definition, const Syntax& name, const Context& context);
    /// The value of a function for as many arguments as it has.
    GraphValues::Built value(Definition& function, const BuiltValues& arguments,
                             const Context& context);
    /// A call of a function that the text defines.
    GraphValues::Built call(const Syntax& call, const Context& context);
    /// The value of a definition that was built, and goes by no variables of a row; nullptr: none.
    [[nodiscard]] const BuiltValue* known(const Definition& definition) const;

private:
    bool settle(Definition& definition, const Context& context);
    void add_key(const BuiltValue& value, std::vector<NodeId>& key);

    ExpressionReader& reader_;
    KnownValues known_;  ///< where no variables of a row matter
};

}  // namespace zeroset
