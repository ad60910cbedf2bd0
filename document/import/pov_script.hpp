#pragma once

#include "document/import/imported.hpp"
#include "document/import/placement.hpp"
#include "document/import/pov_value.hpp"
#include "document/import/script_tokens.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

/// The tokens of a scene of POV-Ray with its directives carried out on the way: #if, #while, #for,
/// #switch, #declare of values, and calls of macros. Whoever reads sees the tokens in between.
/// Ends on any text.
class PovScript {
public:
    explicit PovScript(std::string_view text);

    /// Reads what follows "#declare NAME =" where it is no value, and returns whether it knew it.
    std::function<bool(const std::string& name)> on_declare;
    std::function<void(std::size_t line, std::string_view entry, std::string reason)> on_note;
    /// The text of a file that the scene includes; nothing where it must not be read.
    std::function<std::optional<std::string>(std::string_view name)> on_include;

    /// Tells of a token's line of which file it is: empty for the scene's own.
    struct FileLine {
        std::size_t line = 0;  ///< of the file
        std::string file = {};
        std::size_t included_at = 0;  ///< in the scene
    };
    [[nodiscard]] FileLine file_line(std::size_t line) const;

    /// The next token that is no directive's.
    const ScriptToken& peek();
    const ScriptToken& next();
    bool at_sign(std::string_view sign) { return peek(), tokens_.at_sign(sign); }
    bool at_name(std::string_view name) { return peek(), tokens_.at_name(name); }
    bool take_sign(std::string_view sign) { return peek(), tokens_.take_sign(sign); }
    bool take_name(std::string_view name) { return peek(), tokens_.take_name(name); }
    /// Passes over "{ ... }" without carrying out what is in it.
    void skip_block() { peek(), tokens_.skip_block("{", "}"); }
    /// Passes over the next token, or over all of a block if that is next.
    void skip_item() { at_sign("{") ? skip_block() : static_cast<void>(next()); }
    /// Passes over what is left of a block, and its "}".
    void skip_rest_of_block() {
        while (!take_sign("}") && peek().kind != ScriptKind::End)
            skip_item();
    }
    [[nodiscard]] std::size_t line() { return peek().line; }
    /// Leaves out the rest.
    void stop();
    /// Whether the sign or name follows the next token, which is not looked at.
    [[nodiscard]] bool sign_follows(std::string_view sign) const {
        return tokens_.at_sign(sign, 1);
    }
    [[nodiscard]] bool name_follows(std::string_view name) const {
        return tokens_.at_name(name, 1);
    }
    /// The tokens of the block { ... } that is next, without its braces, with an End. Names whose
    /// values a loop or a macro has in it are replaced by numbers, but those of `kept`.
    std::vector<ScriptToken> block(std::span<const std::string> kept);

    /// Reads a value; nothing where none is next, and then some tokens may have been read.
    std::optional<PovValue> value();
    /// The value of a name; nothing where it is not known.
    [[nodiscard]] std::optional<PovValue> value_of(std::string_view name) const;

private:
    struct Block {
        enum class Kind : std::uint8_t { If, While, For, Switch } kind;
        std::size_t begin = 0;  ///< of the condition
        std::string variable = {};
        double last = 0.0, step = 0.0;
    };

    /// A macro, and a call of it that is being read: its tokens lie behind all others.
    struct Macro {
        std::vector<std::string> parameters = {};
        std::vector<ScriptToken> body = {};
    };
    struct Frame {
        std::size_t back = 0;    ///< the position behind the call
        std::size_t begin = 0;   ///< of its tokens
        std::size_t blocks = 0;  ///< open before it
        std::map<std::string, std::optional<PovValue>, std::less<>> hidden = {};  ///< by its own
    };
    /// A value, or where that is not known, tokens.
    struct Argument {
        std::optional<PovValue> value = {};
        std::vector<ScriptToken> tokens = {};
    };
    struct Place {
        std::size_t position, frames;
    };

    void define_macro();
    [[nodiscard]] bool at_macro() const;
    void call_macro();
    Argument argument();
    ScriptToken number_token(double value, std::size_t line);
    std::vector<ScriptToken> argument_tokens();
    /// The body of a macro with what stands for its parameters; nothing where that is too long.
    std::optional<std::vector<ScriptToken>> expanded(const Macro& macro,
                                                     std::vector<Argument>& given);
    /// Leaves the innermost call.
    void leave_macro();
    /// Gives a name a value until the innermost call ends.
    void set_local(const std::string& name, PovValue value);
    [[nodiscard]] Place place() const {
        return {.position = tokens_.position(), .frames = frames_.size()};
    }
    /// Goes back to where the same call, or one around it, was read.
    void go_to(const Place& place);

    void note(std::size_t line, std::string_view entry, std::string reason) const;
    /// Counts tokens that are read again; false where there are too many, and the rest is left out.
    bool repeat(std::size_t tokens);
    /// Leaves out the rest, and says so.
    void stop_long();
    /// Goes on with the next time of a loop.
    void go_back(const Block& block);
    void directive();
    void declare(bool local);
    /// Whether an array with an index is next.
    [[nodiscard]] bool at_array() const;
    /// Reads "A[i][j]" as the name of that element; empty where an index is none.
    std::string element_name();
    /// Reads an element within a formula as its number; as a sign that no formula has, with a note,
    /// where that is not known.
    ScriptToken element_token();
    /// Reads an array that is declared; false where none is next.
    bool declare_array(const std::string& name, bool local);
    /// Reads "(A, n)" behind dimension_size.
    std::optional<PovValue> array_size();
    /// Reads "{ ... }" as the elements of an array, or of a part of one; false where a value is
    /// not known.
    bool read_elements(const std::string& name, bool local, int depth);
    /// Puts the tokens of a file in place of the directive that begins there.
    void include(std::size_t begin);
    void leave_loop();
    void begin_if(bool holds);
    void begin_while(std::size_t begin);
    void begin_for();
    void begin_switch();
    void end_block();
    void skip_line(std::size_t line);
    /// Passes over what is not carried out, up to behind the #end of the block, or one of the
    /// words at its level; the word at which it stopped.
    std::string skip_to(std::initializer_list<std::string_view> words);
    bool condition();
    std::optional<PovValue> compared();
    std::optional<PovValue> sum();
    std::optional<PovValue> product();
    std::optional<PovValue> factor();
    std::optional<PovValue> operand();
    std::optional<PovValue> vector();
    std::optional<PovValue> named();
    std::optional<PovValue> part_of(PovValue value);
    /// The values of seed(n) and rand(stream).
    std::optional<PovValue> random(std::string_view name, const PovValue& argument);

    struct Included {
        std::string name;
        std::string text;  ///< which its tokens are views of
        std::size_t line;  ///< of the directive
    };

    TokenReader tokens_;
    std::deque<Included> included_;
    std::size_t included_bytes_ = 0;
    std::map<std::string, PovValue, std::less<>> values_;
    /// Sizes of arrays; their elements are values.
    std::map<std::string, std::vector<double>, std::less<>> arrays_;
    std::vector<Block> blocks_;
    std::map<std::string, std::shared_ptr<const Macro>, std::less<>> macros_;
    std::vector<Frame> frames_;
    std::vector<std::uint32_t> streams_;  ///< of random numbers
    std::deque<std::string> numbers_;     ///< the texts of tokens that stand for values
    bool in_formula_ = false;
    int depth_ = 0;
    int directive_depth_ = 0;
    std::size_t steps_ = 0;
    std::size_t repeated_ = 0;  ///< tokens of loops, and macros, each time that they are read again
};

}  // namespace zeroset
