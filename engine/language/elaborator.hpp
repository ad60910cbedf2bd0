#pragma once

#include "engine/language/elaborator_definitions.hpp"
#include "engine/language/parse.hpp"
#include "engine/language/syntax/syntax.hpp"
#include "engine/language/values/graph_values.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

// Private to parse.hpp: builds one graph from the syntax trees.

namespace zeroset {

class Elaborator {
public:
    /// `files`: where files that the text names come from; nullptr: none are read. Text at offset
    /// `counted_end` or later does not decide whether an earlier statement is a definition.
    Elaborator(const SyntaxTree& tree, const FieldSource* files,
               std::size_t counted_end = std::string_view::npos)
        : tree_(tree), files_(files), notes_(tree.notes), table_(tree, counted_end, notes_) {
        if (table_.error()) values_.fail(*table_.error());
    }

    /// Cuts what `program` draws by these boxes, which outlive it.
    void cut(std::span<const CutText> cuts) { cuts_ = cuts; }
    std::expected<Program, ParseError> program();
    /// The value of the last statement, an expression.
    std::expected<Expr, ParseError> last_value();
    /// The only statement, an equation or an expression; its constants may be undefined.
    std::expected<Expr, ParseError> formula();

private:
    using Value = BuiltValue;
    using Built = GraphValues::Built;
    using Number = GraphValues::Number;

    /// A local name: a function's argument, a sum's index, or a value in a function's body.
    struct Binding {
        std::string_view name;
        Value value;
        const Binding* outer;
    };
    /// A function and its arguments, those of several parts as their number and their parts.
    using Call = std::pair<const Definition*, std::vector<NodeId>>;
    using Values = BuiltValues;
    struct CallHash {
        std::size_t operator()(const Call& call) const;
    };
    struct Surface {
        std::size_t statement;
        NodeId root;
        bool solid;             ///< the root is below 0 where a condition holds
        std::string text = {};  ///< how the row was read; empty: as the equation that it is
        std::string name = {};  ///< of a point
        bool sheet = false;     ///< neither side of it is solid
    };
    /// A variable and the range that a row gives it.
    struct Ranged {
        std::string name;
        SyntaxId lo, hi;
        std::size_t offset;
    };

    // elaborator.cpp: statements
    bool build_statements();
    bool build_surface(std::size_t index);
    void note_distance(std::size_t statement);
    [[nodiscard]] std::optional<ParseError> error_for_parametric();
    [[nodiscard]] bool defines_nothing_else(std::size_t statement, NodeId root) const;
    bool keep_without_surface(std::size_t statement);
    Number equation(const StatementSyntax& statement);
    std::nullopt_t refuse_row(const Value& value, std::size_t offset);
    Number restriction_of(const StatementSyntax& statement);
    Number restricted(NodeId f, const StatementSyntax& statement);
    bool build_definition(Definition& definition);
    bool note_unreadable(const Definition& definition);
    std::string hint_without_surface();
    bool add_surface(std::size_t statement, NodeId root);
    [[nodiscard]] std::optional<RowBox> box_of(std::size_t statement) const;
    NodeId cut_condition(const RowBox& box);
    bool cut_surface(Surface& surface);
    [[nodiscard]] ParseError no_place_error(std::size_t statement) const;
    std::optional<std::string> value_text(Definition& definition);
    std::optional<std::string> text_by_row(Definition& definition);
    std::vector<Binding> variables_of_row(const std::vector<std::string>& variables,
                                          std::vector<std::string>& names);
    void note_built_in(const Definition& definition, const Value& value);
    std::optional<std::string> function_text(Definition& definition);
    std::optional<std::string> function_text_of(Definition& definition,
                                                std::span<const std::size_t> sizes);
    [[nodiscard]] std::string text_of(const Value& value, std::span<const std::string> names);
    std::expected<Program, ParseError> result();
    [[nodiscard]] std::size_t longest_definition();

    // elaborator_solids.cpp: conditions that stand alone
    Number solid(const Value& condition, const StatementSyntax& statement);
    Number boundary(NodeId condition, std::size_t offset);
    [[nodiscard]] bool joins(const Node& condition) const;
    [[nodiscard]] std::optional<NodeId> part_without_boundary(NodeId id) const;
    Number boundary_by_parts(NodeId id);

    /// A row by whose variables definitions go, as long as it lives; these take their values from
    /// `variables`, which may change.
    class Row {
    public:
        Row(Elaborator& of, std::vector<std::string> names);
        ~Row();
        Row(const Row&) = delete;
        Row& operator=(const Row&) = delete;

    private:
        Elaborator& of_;
    };

    // elaborator_patches.cpp: parametric surfaces, curves and points
    void bind_row(const Binding* variables);
    [[nodiscard]] bool goes_by_row(const Definition& definition) const;
    [[nodiscard]] SyntaxId point_in(const StatementSyntax& statement) const;
    bool add_ranges(SyntaxId id, std::vector<Ranged>& ranges) const;
    [[nodiscard]] bool may_be_patch(const StatementSyntax& statement);
    bool check_ranges(const StatementSyntax& statement, std::vector<Ranged>& ranges);
    std::optional<std::vector<Binding>> bind_ranges(const std::vector<Ranged>& ranges);
    std::optional<std::vector<Binding>> bind_names(const std::vector<Ranged>& ranges);
    std::optional<std::array<NodeId, 3>> point_over(const StatementSyntax& statement,
                                                    const std::vector<Binding>& bindings);
    bool check_order(const std::vector<Ranged>& ranges, const std::vector<Binding>& names);
    std::string open_variable(std::size_t statement, const std::vector<Ranged>& ranges);
    std::string patch_text(const std::array<NodeId, 3>& point, const std::vector<Ranged>& ranges,
                           const std::vector<Binding>& bindings);
    bool build_patch(std::size_t index);
    [[nodiscard]] static bool draws_nothing(const Definition& definition);
    bool add_named_point(const Definition& definition, const std::string& text);
    [[nodiscard]] bool is_meeting(const Syntax& relation) const;
    bool build_meeting(std::size_t index);
    bool add_patch(std::size_t index, PatchKind kind, const std::array<NodeId, 3>& point,
                   std::string text);

    // elaborator_things.cpp: segments, vectors and polygons
    using Point = std::array<NodeId, 3>;
    std::nullopt_t refuse_thing(const Syntax& syntax);
    bool build_thing(std::size_t index, const Function& thing);
    std::optional<std::vector<Point>> corners_of(const Syntax& call, std::string& text);
    bool check_corner(const Value& value, const Syntax& call, std::size_t place);
    bool build_straight(std::size_t index, const Function& thing, const std::vector<Point>& ends,
                        std::string text);
    bool build_polygon(std::size_t index, const std::vector<Point>& corners, std::string text);
    Point difference(const Point& a, const Point& b);
    Point cross(const Point& a, const Point& b);
    NodeId dot(const Point& a, const Point& b);
    bool is_zero(const Point& way, std::size_t offset);
    bool check_plane(const std::vector<Point>& corners, const Point& normal, const Syntax& call);
    [[nodiscard]] bool is_convex(const std::vector<Point>& corners, const Point& normal);
    NodeId inside_polygon(const std::vector<Point>& corners, const Point& normal, bool convex);

    // elaborator_graphs.cpp: functions that stand alone
    bool build_graphs();
    bool build_graph(Definition& definition);

    // elaborator_value.cpp: expressions
    Built build(SyntaxId id, const Binding* scope);
    Number number(SyntaxId id, const Binding* scope);
    Built literal(const Syntax& syntax);
    Built name(const Syntax& syntax, const Binding* scope);
    /// The built-in value that the text names; remembers which name of w it uses.
    Built said(const Syntax& syntax);
    Built built_in(std::string_view name);
    Built parameter(const std::string& name, std::size_t offset);
    void note_capital(const std::string& name, std::size_t offset);
    Built defined_value(Definition& definition, const Syntax& syntax);
    bool settle(Definition& definition);
    Built unknown(const Syntax& syntax);
    Built negated(const Syntax& syntax, const Binding* scope);
    Built power(const Syntax& syntax, const Binding* scope);
    Built sum(const Syntax& syntax, const Binding* scope);
    Built product(const Syntax& syntax, const Binding* scope);
    bool is_zero_by_name(SyntaxId id, const Value& divisor);
    Built with_local_value(const Syntax& syntax, const Binding* scope);
    Built last_of_list(const Syntax& syntax);

    // elaborator_vector.cpp: vectors and lists
    /// A value of any kind; a condition as 1 or 0.
    Built operand(SyntaxId id, const Binding* scope);
    Built vector(const Syntax& syntax, const Binding* scope);
    Built list(const Syntax& syntax, const Binding* scope);
    Built part(const Syntax& syntax, const Binding* scope);
    [[nodiscard]] std::string hint_for_vector(const Syntax& part) const;
    Built replaced(const Syntax& syntax, const Binding* scope);
    std::optional<Values> operands(std::span<const SyntaxId> ids, const Binding* scope);
    void note(std::size_t offset, std::string text);

    // elaborator_condition.cpp: truth values
    /// How a number is treated where a condition is expected.
    enum class Numbers : std::uint8_t { Refused, TrueUnlessZero };
    Number condition(SyntaxId id, const Binding* scope, Numbers numbers);
    Built compare(const Syntax& syntax, const Binding* scope);
    Built connected(const Syntax& syntax, Op op, const Binding* scope);
    Built cases(const Syntax& syntax, const Binding* scope);

    // elaborator_call.cpp: functions
    Built call(const Syntax& syntax, const Binding* scope);
    Built repeated(const Syntax& syntax, const Binding* scope);
    Built repeated_from(const Syntax& syntax, const Binding* scope, double first, double last);
    Built argument_of(const Function& function, std::size_t place, SyntaxId id,
                      const Binding* scope);
    Built repeated_up_to(const Syntax& syntax, const Binding* scope, double first, NodeId last);
    Built defined_call(const Syntax& syntax, const Binding* scope);
    Built function_value(Definition& definition, const Values& arguments);
    void add_key(const Value& value, std::vector<NodeId>& key);
    Built applied(const Syntax& syntax, const Values& arguments);
    Built library_call(const Syntax& syntax, const Binding* scope);
    bool fits(const Syntax& syntax, Values& arguments);
    bool make_point(char kind, Value& argument, const Syntax& syntax, std::size_t index);

    // elaborator_iteration.cpp: steps done again and again
    Built iterated(const Syntax& syntax, const Binding* scope);
    Built distance_estimate(const Syntax& syntax, const Binding* scope);
    std::optional<int> step_count(const Syntax& syntax, const Binding* scope);
    bool is_within_budget(const Syntax& syntax, std::size_t before, int steps);
    /// The value after the last step; `take` is called with the first one and with that of each
    /// step, and false ends it.
    Built stepped(const Syntax& syntax, const Binding* scope,
                  const std::function<bool(const Value&)>& take);
    NodeId square_of(const Value& value);
    NodeId distance_where(NodeId square, const std::array<NodeId, 3>& gradient);

    // elaborator_fields.cpp, elaborator_blobs.cpp: noise, soft balls
    Built noise(const Syntax& syntax, const Binding* scope);
    std::optional<std::array<NodeId, 3>> leading_point(const Syntax& syntax, Values& arguments);
    /// An argument behind the point, which is a whole number.
    struct WholeArgument {
        std::size_t place;
        double otherwise;  ///< where it is left out
        double least, most;
        std::string rule;  ///< the reason of the error
    };
    std::optional<double> whole_argument(const Syntax& syntax, const Values& rest,
                                         const WholeArgument& argument);
    Built blobs(const Syntax& syntax, const Binding* scope);
    std::optional<std::array<NodeId, 3>> point_of_blobs(const Syntax& syntax, Values before);
    bool add_blob(const Syntax& syntax, const Value& from, const Values& radius,
                  std::vector<std::array<NodeId, 4>>& blobs);
    Built blobs_field_of(const Syntax& syntax, const std::array<NodeId, 3>& point,
                         const std::vector<std::array<NodeId, 4>>& balls);
    Built blobs_formula(const Syntax& syntax, const std::array<NodeId, 3>& point,
                        const std::vector<std::array<NodeId, 4>>& balls);
    Built octaves(const Syntax& syntax, std::array<NodeId, 3> point, const Values& rest,
                  std::uint32_t seed);
    Built volume(const Syntax& syntax, const Binding* scope);
    std::shared_ptr<const Field> field_of(const Syntax& syntax);
    Built kept_value(const Syntax& syntax, const Binding* scope);
    struct Complaint {
        std::string reason;
        std::string hint;
    };
    std::optional<double> whole_number(SyntaxId id, const Binding* scope,
                                       const Complaint& otherwise);
    std::optional<std::vector<NodeId>> numbers(std::span<const SyntaxId> ids, const Binding* scope);

    // Offsets within the body of a library function are shown at its call.
    [[nodiscard]] std::size_t at(std::size_t offset) const {
        return library_offset_.value_or(offset);
    }
    bool counts(std::size_t offset) { return values_.counts(at(offset)); }
    Built done(NodeId id, std::size_t offset, bool condition = false) {
        return values_.done(id, at(offset), condition);
    }
    Number number_of(const Value& value, std::size_t offset) {
        return values_.number_of(value, at(offset));
    }
    Built mapped(std::span<const Value> values, std::size_t offset, const GraphValues::Make& make) {
        return values_.mapped(values, at(offset), make);
    }
    Built combined(const Value& a, const Value& b, std::size_t offset, GraphValues::Binary make) {
        return values_.combined(a, b, at(offset), make);
    }
    std::nullopt_t fail(std::size_t offset, std::string reason, std::string hint = {}) {
        return values_.fail(at(offset), std::move(reason), std::move(hint));
    }

    const SyntaxTree& tree_;
    const FieldSource* files_;
    std::span<const CutText> cuts_;
    Notes notes_;
    DefinitionTable table_;
    GraphValues values_{notes_};
    ExprBuilder& builder_ = values_.builder();
    std::unordered_map<std::string, std::size_t> parameter_index_;
    std::vector<std::string> parameters_;
    std::unordered_map<Call, Value, CallHash> calls_;
    std::unordered_map<SyntaxId, Value> earlier_;                 ///< values of lists
    std::map<std::string, std::shared_ptr<const Field>> fields_;  ///< by their text
    std::map<double, NodeId> kept_;                               ///< values kept by psh, by index
    std::optional<std::size_t> library_offset_;  ///< offset of the library call whose body is
                                                 ///< being built
    std::vector<Surface> surfaces_;
    std::vector<std::size_t> without_surface_;  ///< statements such as e = 3 whose names are not
                                                ///< used
    std::map<std::size_t, Reading> readings_;   ///< by statement
    std::size_t binding_ = 1;                   ///< number of times row_ was given, from 1
    const Binding* row_ = nullptr;              ///< the variables of the row that is being built
    /// The definitions that go by the variables of a row, by the names of these.
    std::map<std::vector<std::string>, std::set<const Definition*>> going_by_;
    /// Their values where the variables are parameters of their own, as readings have them.
    std::map<std::vector<std::string>, std::map<const Definition*, Value>> values_in_readings_;
    const std::set<const Definition*>* going_by_row_ = nullptr;  ///< those of the row, if any
    std::map<const Definition*, Value> row_values_;              ///< values of these
    std::unordered_map<Call, Value, CallHash> row_calls_;
    std::map<const Definition*, std::vector<std::string>> rows_;  ///< the variables that
                                                                  ///< definitions have from rows
    std::size_t statement_ = 0;                      ///< the statement in which names are looked up
    bool is_solid_ = false;                          ///< of the surface that is being built
    std::unordered_map<NodeId, Number> boundaries_;  ///< of conditions
    bool says_w_ = false;                            ///< the text has w for the fourth coordinate
    bool says_t_ = false;                            ///< and t
    bool reads_function_ = false;  ///< its arguments are parameters that stand for any number
    int depth_ = 0;
};

}  // namespace zeroset
