#pragma once

#include "engine/language/syntax/syntax.hpp"
#include "engine/language/vocabulary/parse_notes.hpp"
#include "engine/language/vocabulary/words_vocabulary.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

// Private to Elaborator: the definitions of a text and which of them a name means.

namespace zeroset {

/// A node or a truth value.
struct BuiltValue {
    NodeId id;
    bool condition;  ///< a truth value, not a number
};

/// A statement `name = body` or `name(arguments) = body`.
struct Definition {
    std::string name;
    std::size_t statement = 0;
    SyntaxId body = 0;
    std::vector<std::string> arguments;
    bool is_function = false;
    bool is_certain = false;
    bool in_progress = false;
    bool settled = false;
    bool is_called = false;
    std::optional<BuiltValue> value;  ///< of a value, once known
};

/// A name or call in a statement that is no argument of a function.
struct NameUse {
    SyntaxId at;
    bool calls;
};

class DefinitionTable {
public:
    /// Reads the statements; uses at `counted_end` or behind do not make a definition. Notes what
    /// is defined again, what hides a built-in function, and what is an equation.
    DefinitionTable(const SyntaxTree& tree, std::size_t counted_end, Notes& notes);

    /// What is wrong with the definitions by themselves.
    [[nodiscard]] const std::optional<ParseError>& error() const { return error_; }
    [[nodiscard]] std::vector<Definition>& all() { return definitions_; }
    /// The definition that a statement is; nullptr: it is none.
    [[nodiscard]] Definition* of_statement(std::size_t statement);
    /// What a name means in a statement: in a definition the last one before it, or if there is
    /// none the last of all; in a surface the last of all. nullptr: it is not defined.
    [[nodiscard]] Definition* value(std::string_view name, std::size_t statement) {
        return found(values_, name, statement);
    }
    [[nodiscard]] Definition* function(std::string_view name, std::size_t statement) {
        return found(functions_, name, statement);
    }
    [[nodiscard]] std::span<const NameUse> uses(std::size_t statement) const;
    /// The definition that a use means; nullptr: none.
    [[nodiscard]] Definition* meant(const NameUse& use, std::size_t statement);

private:
    /// How many arguments and indices around a place have a name.
    using Bound = std::unordered_map<std::string_view, int>;
    using Lists = NameMap<std::vector<std::uint32_t>>;
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    bool read_definitions();
    [[nodiscard]] std::optional<Definition> definition_in(std::size_t statement) const;
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

    /// In which way a statement depends on the place.
    struct Places {
        bool axes = false;   ///< by x, y or z
        bool polar = false;  ///< by r, rho, theta or phi
        bool operator==(const Places&) const = default;
    };

    const SyntaxTree& tree_;
    std::vector<Definition> definitions_;
    std::vector<bool> out_;                    ///< definitions that turn out to be equations
    std::vector<std::uint32_t> of_statement_;  ///< or none
    std::vector<NameUse> uses_;
    std::vector<std::size_t> first_use_;  ///< of each statement, and the end
    NameMap<std::size_t> counts_;         ///< of the uses of a name in other statements
    std::vector<Places> places_;          ///< of each statement
    Lists values_;
    Lists functions_;
    std::optional<ParseError> error_;
};

}  // namespace zeroset
