#pragma once

#include "engine/language/expressions/context.hpp"
#include "engine/language/expressions/definition_values.hpp"
#include "engine/language/expressions/field_files.hpp"
#include "engine/language/expressions/free_names.hpp"
#include "engine/language/syntax/syntax.hpp"
#include "engine/language/values/graph_values.hpp"

#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace zeroset {

/// Makes values of a text's expressions. All functions return nothing after an error, which is in
/// the values.
class ExpressionReader {
public:
    using Built = GraphValues::Built;
    using Number = GraphValues::Number;
    /// How a number is treated where a condition is expected.
    enum class Numbers : std::uint8_t { Refused, TrueUnlessZero };
    struct Complaint {
        std::string reason;
        std::string hint;
    };

    /// `files`: where files that the text names come from; nullptr: none are read. All of them
    /// outlive this object.
    ExpressionReader(const SyntaxTree& tree, DefinitionTable& table, const FieldSource* files,
                     GraphValues& values)
        : tree_(tree), table_(table), values_(values), files_(files, values) {}

    Built build(SyntaxId id, const Context& context);
    /// A value of any kind; a condition as 1 or 0.
    Built operand(SyntaxId id, const Context& context);
    Number number(SyntaxId id, const Context& context);
    Number condition(SyntaxId id, const Context& context, Numbers numbers);
    std::optional<BuiltValues> operands(std::span<const SyntaxId> ids, const Context& context);
    std::optional<std::vector<NodeId>> numbers(std::span<const SyntaxId> ids,
                                               const Context& context);
    /// The exact value of a bound or an index, which must be a whole number.
    std::optional<double> whole_number(SyntaxId id, const Context& context,
                                       const Complaint& otherwise);

    /// Adds a note on what the text says; the bodies of library functions need none.
    void note(std::size_t offset, std::string text, const Context& context);
    /// The name that a definition gives, for an error at it.
    [[nodiscard]] const Syntax& name_of(const Definition& definition) const;
    /// Whether so many expressions are being built within each other that definitions are built
    /// before what uses them.
    [[nodiscard]] bool is_deep() const;

    [[nodiscard]] const SyntaxTree& tree() const { return tree_; }
    [[nodiscard]] DefinitionTable& table() { return table_; }
    [[nodiscard]] GraphValues& values() { return values_; }
    [[nodiscard]] FreeNames& names() { return names_; }
    [[nodiscard]] DefinitionValues& definitions() { return definitions_; }

private:
    Built literal(const Syntax& syntax, const Context& context);
    Built name(const Syntax& syntax, const Context& context);
    [[nodiscard]] bool is_imaginary_unit(std::string_view name);
    [[nodiscard]] bool numbers_coordinates();
    Built unknown(const Syntax& syntax, const Context& context);
    Built negated(const Syntax& syntax, const Context& context);
    Built power(const Syntax& syntax, const Context& context);
    Built sum(const Syntax& syntax, const Context& context);
    Built product(const Syntax& syntax, const Context& context);
    bool refuses_index(const Syntax& product, std::size_t factor);
    bool is_zero_by_name(const Syntax& syntax, const BuiltValue& divisor, const Context& context);
    Built with_local_value(const Syntax& syntax, const Context& context);
    Built last_of_list(const Syntax& syntax, const Context& context);

    // expression_reader_parts.cpp: vectors, lists and conditions
    Built vector(const Syntax& syntax, const Context& context);
    Built list(const Syntax& syntax, const Context& context);
    Built part(const Syntax& syntax, const Context& context);
    Built replaced(const Syntax& syntax, const Context& context);
    [[nodiscard]] std::string_view letter_of(const Syntax& part) const;
    Built compare(const Syntax& syntax, const Context& context);
    Built connected(const Syntax& syntax, Op op, const Context& context);
    Built opposite(const Syntax& syntax, const Context& context);
    Built cases(const Syntax& syntax, const Context& context);

    // calls.cpp
    Built call(const Syntax& syntax, const Context& context);
    Built plain_call(const Syntax& syntax, const Context& context);
    Built argument_of(const Function& function, std::size_t place, SyntaxId id,
                      const Context& context);
    Built applied(const Syntax& syntax, const BuiltValues& arguments, const Context& context);
    void note_if_real(const Syntax& call, const BuiltValue& of, const Context& context);
    Built kept_value(const Syntax& syntax, const Context& context);
    Built volume(const Syntax& syntax, const Context& context);

    const SyntaxTree& tree_;
    DefinitionTable& table_;
    GraphValues& values_;
    FreeNames names_{values_};
    DefinitionValues definitions_{*this};
    FieldFiles files_;
    std::unordered_map<SyntaxId, BuiltValue> earlier_;  ///< values of lists
    std::optional<bool> numbers_coordinates_;  ///< whether x_1, x_2 and x_3 are these, once asked
    std::optional<bool> has_complex_;          ///< whether the text has complex numbers, once asked
    std::map<double, NodeId> kept_;            ///< values kept by psh, by index
    int depth_ = 0;  ///< how many expressions are being built within each other
};

}  // namespace zeroset
