#pragma once

#include "document/import/imported.hpp"
#include "document/import/placement.hpp"
#include "document/import/pov_value.hpp"
#include "document/import/script_tokens.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// The tokens of a scene of POV-Ray with its directives carried out on the way: #if, #while, #for,
/// #switch and #declare of values. Whoever reads sees the tokens in between. Ends on any text.
class PovScript {
public:
    explicit PovScript(std::string_view text);

    /// What follows "#declare NAME =", where it is no value: reads it, and returns whether it knew
    /// it.
    std::function<bool(const std::string& name)> on_declare;
    std::function<void(std::size_t line, std::string_view entry, std::string reason)> on_note;

    /// The next token that is no directive's.
    const ScriptToken& peek();
    const ScriptToken& next();
    bool at_sign(std::string_view sign) { return peek(), tokens_.at_sign(sign); }
    bool at_name(std::string_view name) { return peek(), tokens_.at_name(name); }
    bool take_sign(std::string_view sign) { return peek(), tokens_.take_sign(sign); }
    bool take_name(std::string_view name) { return peek(), tokens_.take_name(name); }
    /// Passes over "{ ... }" without carrying out what is in it.
    void skip_block() { peek(), tokens_.skip_block("{", "}"); }
    [[nodiscard]] std::size_t line() { return peek().line; }
    /// Leaves out the rest.
    void stop();
    /// The tokens as they are, for a formula.
    TokenReader& raw() { return tokens_; }

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

    void note(std::size_t line, std::string_view entry, std::string reason) const;
    /// Leaves out the rest, and says so.
    void stop_long();
    /// Goes on with the next time of a loop.
    void go_back(const Block& block);
    void directive();
    void declare();
    void include();
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

    TokenReader tokens_;
    std::map<std::string, PovValue, std::less<>> values_;
    std::vector<Block> blocks_;
    int depth_ = 0;
    int directive_depth_ = 0;
    std::size_t steps_ = 0;
    std::size_t repeated_ = 0;  ///< tokens of loops, each time that they are read again
};

}  // namespace zeroset
