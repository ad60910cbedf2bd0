#pragma once

#include "engine/language/syntax/syntax.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

// The definitions of a text, and which of them a name refers to.

namespace zeroset {

/// A statement `name = body` or `name(arguments) = body`.
struct Definition {
    std::string name;
    std::size_t statement = 0;
    SyntaxId body = 0;
    std::vector<std::string> arguments;
    bool is_function = false;
    bool is_certain = false;
    bool in_progress = false;  ///< its value is being built
    bool is_called = false;
    std::vector<std::size_t> called_with;  ///< of the first call: how many parts each argument has,
                                           ///< 1 for a number
};

/// A use of a name or function in a statement; names of arguments are none.
struct NameUse {
    SyntaxId at;
    bool calls;
};

class DefinitionTable {
public:
    /// Reads the statements; uses at offset `counted_end` or later do not make a definition. Adds
    /// notes on names defined again, names that hide a built-in function, and statements that are
    /// equations.
    DefinitionTable(const SyntaxTree& tree, std::size_t counted_end, Notes& notes);

    /// The error in the definitions themselves, if any.
    [[nodiscard]] const std::optional<ParseError>& error() const { return error_; }
    [[nodiscard]] std::vector<Definition>& all() { return definitions_; }
    /// The definition that a statement is; nullptr: it is none.
    [[nodiscard]] Definition* of_statement(std::size_t statement);
    /// The definition that a name refers to in a statement: in a surface the last one of the text;
    /// in a definition the last one before it, or if there is none the last one of the text.
    /// nullptr: none.
    [[nodiscard]] Definition* value(std::string_view name, std::size_t statement) {
        return found(values_, name, statement);
    }
    [[nodiscard]] Definition* function(std::string_view name, std::size_t statement) {
        return found(functions_, name, statement);
    }
    [[nodiscard]] std::span<const NameUse> uses(std::size_t statement) const;
    /// The definition that a use refers to; nullptr: none.
    [[nodiscard]] Definition* meant(const NameUse& use, std::size_t statement);
    /// The definitions whose values go by free names, directly or by other definitions.
    [[nodiscard]] std::set<const Definition*> going_by(std::span<const std::string> names);
    /// Whether an expression is seen to be a vector or a list.
    [[nodiscard]] bool is_bundle(SyntaxId root);

private:
    /// Number of enclosing arguments and indices, by name.
    using Bound = std::unordered_map<std::string_view, int>;
    using Lists = NameMap<std::vector<std::uint32_t>>;
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    bool read_definitions();
    [[nodiscard]] std::optional<Definition> definition_in(std::size_t index) const;
    [[nodiscard]] bool is_level_of_function(const Definition& definition) const;
    [[nodiscard]] bool mentions_any_of(const Definition& definition) const;
    void read_uses();
    void collect_uses(SyntaxId id, Bound& bound);
    void count_uses(std::size_t counted_end);
    [[nodiscard]] bool is_used(std::string_view name) const;
    void choose_built_in();
    void find_places();
    void choose_levels();
    void enter();
    void note_definitions(Notes& notes) const;
    void note_repetitions(const Lists& lists, Notes& notes) const;
    [[nodiscard]] std::size_t offset_of(std::uint32_t definition) const {
        return tree_.statements[definitions_[definition].statement].offset;
    }
    Definition* found(Lists& lists, std::string_view name, std::size_t statement);

    /// How a statement depends on the point.
    struct Places {
        bool axes = false;   ///< through x, y or z
        bool polar = false;  ///< through r, rho, theta or phi
        bool operator==(const Places&) const = default;
    };

    const SyntaxTree& tree_;
    std::vector<Definition> definitions_;
    std::vector<bool> out_;                    ///< definitions that turned out to be equations
    std::vector<std::uint32_t> of_statement_;  ///< index of its definition, or `none`
    std::vector<NameUse> uses_;
    std::vector<std::size_t> first_use_;  ///< index of each statement's first use in uses_, and one
                                          ///< past the last
    NameMap<std::size_t> counts_;         ///< number of uses of a name in other statements
    std::vector<Places> places_;          ///< one for each statement
    Lists values_;
    Lists functions_;
    std::optional<ParseError> error_;
};

}  // namespace zeroset
