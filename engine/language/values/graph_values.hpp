#pragma once

#include "engine/algebra/facts.hpp"
#include "engine/language/values/built_value.hpp"
#include "engine/language/values/complex_functions.hpp"
#include "engine/language/vocabulary/functions.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"

#include <expected>
#include <functional>
#include <span>
#include <string_view>

namespace zeroset {

/// The values of one graph: makes numbers, vectors, lists and conditions of others, knows facts of
/// its nodes, holds the budget of its size and of steps, and keeps the first error. What makes a
/// value returns nothing after an error. Offsets are where errors and notes are shown.
class GraphValues {
public:
    using Built = std::optional<BuiltValue>;
    using Number = std::optional<NodeId>;
    using Make = std::function<NodeId(std::span<const NodeId>)>;
    using Binary = NodeId (*)(ExprBuilder&, NodeId, NodeId);

    /// Remarks go to `notes`, which outlives this object.
    explicit GraphValues(Notes& notes) : notes_(notes) {}

    ExprBuilder& builder() { return builder_; }
    [[nodiscard]] const ExprBuilder& builder() const { return builder_; }

    /// Takes constants such as 1/0 as they are from now on; else they are errors.
    void keep_undefined() { refuses_undefined_ = false; }
    [[nodiscard]] bool refuses_undefined() const { return refuses_undefined_; }

    // Errors and notes.
    /// Keeps the error unless there is one already.
    std::nullopt_t fail(ParseError error);
    std::nullopt_t fail(std::size_t offset, std::string reason, std::string hint = {});
    /// Keeps such an error, which is a number in place of a vector.
    std::nullopt_t fail_for_vector(std::size_t offset, std::string reason, std::string hint);
    [[nodiscard]] bool failed() const { return error_.has_value(); }
    /// The error, which there is, and which is none of this object any more.
    [[nodiscard]] std::unexpected<ParseError> failure();
    /// An error that no value is made after.
    [[nodiscard]] std::unexpected<ParseError> failure(std::size_t offset, std::string reason,
                                                      std::string hint = {});
    /// Whether the error, the last one that was taken included, is that of `fail_for_vector`.
    [[nodiscard]] bool wanted_vector() const { return wanted_vector_; }
    void note(std::size_t offset, std::string text) { notes_.add(offset, std::move(text)); }

    // The budget.
    /// The node as a value; an error if the graph is too large or a constant in it is undefined.
    Built done(NodeId id, std::size_t offset, bool condition = false);
    /// Counts a step; an error if there are too many.
    bool counts(std::size_t offset);
    /// Counts a step that is never the last one before an error.
    void count_step() { ++steps_; }

    // Facts of nodes that went through `done`.
    [[nodiscard]] const Facts& facts(NodeId id) const { return facts_[id]; }
    [[nodiscard]] bool uses_space(NodeId id) const { return !facts_[id].uniform; }
    [[nodiscard]] bool is_zero(NodeId id) const;
    [[nodiscard]] bool never_holds(NodeId condition) const;
    /// The truth value of a condition that is constant; nullopt: it is not.
    [[nodiscard]] std::optional<bool> known_truth(NodeId condition) const;
    /// The middle of a number that is known, as far as it is.
    [[nodiscard]] std::optional<double> middle_of(NodeId id) const;

    // Vectors and lists (graph_values_parts.cpp).
    /// A function of numbers over values: lists element by element, vectors part by part; a single
    /// value stands for each part of the others.
    Built mapped(std::span<const BuiltValue> values, std::size_t offset, const Make& make);
    Built combined(const BuiltValue& a, const BuiltValue& b, std::size_t offset, Binary make);
    /// The parts of a vector or the elements of a list joined by a function that joins or repeats.
    Built joined_parts(const Function& function, const BuiltValue& of, std::size_t offset);
    /// The length of a vector, or of one with all the given parts; of each vector in a list.
    Built length(const Function& function, const BuiltValues& values, std::size_t offset);
    /// vec2, vec3 or vec4 of numbers and vectors, as in GLSL: one number stands for all.
    Built made_vector(const Function& function, const BuiltValues& values, std::size_t offset);
    /// The parts of a vector, or of each in a list, that letters such as xz name; `name`: the
    /// letter that it is, if it is one.
    Built part_of(const BuiltValue& of, std::string_view letters, std::size_t offset,
                  std::string_view name = {});
    /// A vector with other numbers in place of the parts that letters name, which it has.
    Built with_parts(const BuiltValue& old, std::string_view letters, const BuiltValue& by,
                     std::size_t offset);
    /// The error for p[1], which is no product where p is a vector or a list.
    std::nullopt_t refuse_index(const BuiltValue& of, std::size_t offset);

    // Complex numbers (graph_values_complex.cpp).
    Built complex(const ComplexNodes& number, std::size_t offset);
    /// A function of numbers some of which are complex, or one that asks for something of a complex
    /// number.
    Built complex_call(const Function& function, const BuiltValues& values, std::size_t offset);
    /// Makes numbers complex where another one of them is, so that `mapped` takes part by part.
    void make_alike(std::span<BuiltValue> values);
    /// Keeps the error that a complex number stands where a real one is wanted.
    std::nullopt_t refuse_complex(std::size_t offset);

    // Truth values (graph_values_conditions.cpp).
    /// A single value as a number: a condition as 1 where it holds, 0 elsewhere, with a note.
    Number number_of(const BuiltValue& value, std::size_t offset);
    /// A single value as a condition: a number holds where it is not 0, with a note.
    Number condition_of(const BuiltValue& value, std::size_t offset);
    /// The condition of a mark of SyntaxKind::Compare.
    Number compared(char mark, const BuiltValue& left, const BuiltValue& right, std::size_t offset);

private:
    [[nodiscard]] bool divides_by_zero(const Node& node) const;
    Built sizes_differ(const BuiltValue& a, const BuiltValue& b, std::size_t offset);
    ComplexNodes nodes_of(const BuiltValue& value);
    Built complex_combined(const BuiltValue& a, const BuiltValue& b, std::size_t offset,
                           Binary make);
    bool numbers_of(const BuiltValue& value, std::size_t offset, std::vector<NodeId>& numbers);
    Number equality(const BuiltValue& left, const BuiltValue& right, std::size_t offset);
    Number same_truth(const BuiltValue& condition, const BuiltValue& other);

    Notes& notes_;
    ExprBuilder builder_;
    std::vector<Facts> facts_;  ///< of the builder's nodes, by index
    std::optional<ParseError> error_;
    bool wanted_vector_ = false;
    bool refuses_undefined_ = true;
    std::size_t steps_ = 0;
};

}  // namespace zeroset
