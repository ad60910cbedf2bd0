// Anonymous functions as MATLAB, Python, Maple and JavaScript define them, and volumes.

#include "engine/language/words/lexer.hpp"
#include "engine/language/words/words_defined.hpp"

#include <optional>
#include <span>
#include <utility>

namespace zeroset {
namespace {

/// The tokens before a function's body.
struct ProgramHeader {
    std::span<const Token> name;  ///< one token, or empty
    std::span<const Token> arguments;
    std::size_t length;  ///< number of tokens before the body
};

class FunctionReader {
public:
    explicit FunctionReader(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

    std::vector<Token> read() {
        for (std::size_t at = 0; at < tokens_.size(); ++at) {
            bool starts = out_.empty() || out_.back().kind == TokenKind::Break;
            while (starts && !is_word(at, "def") && is_type_word(tokens_[at].text) &&
                   is_name(at + 1))
                out_.push_back(tokens_[at++]);
            if (starts && is_volume(at)) {
                write_volume(tokens_[at], tokens_[at + 2]);
                at += 2;
                continue;
            }
            const auto header = starts ? header_at(at) : std::nullopt;
            if (header) {
                write(*header, tokens_[at + header->length].offset);
                at += header->length;
                starts = false;
            }
            out_.push_back(tokens_[at]);
        }
        return std::move(out_);
    }

private:
    [[nodiscard]] bool is_name(std::size_t at) const {
        return at < tokens_.size() && tokens_[at].kind == TokenKind::Name;
    }
    [[nodiscard]] bool is(std::size_t at, std::string_view symbol) const {
        return at < tokens_.size() && is_symbol(tokens_[at], {symbol});
    }
    [[nodiscard]] bool is_word(std::size_t at, std::string_view word) const {
        return is_name(at) && tokens_[at].text == word;
    }
    [[nodiscard]] std::span<const Token> part(std::size_t begin, std::size_t end) const {
        return std::span(tokens_).subspan(begin, end - begin);
    }
    /// The index after the names, separated by commas, that start at `at`.
    [[nodiscard]] std::size_t end_of_names(std::size_t at) const {
        if (!is_name(at)) return at;
        ++at;
        while (is(at, ",") && is_name(at + 1))
            at += 2;
        return at;
    }
    /// Whether -> or => starts at `at`.
    [[nodiscard]] bool is_arrow(std::size_t at) const {
        return (is(at, "-") || is(at, "=")) && is(at + 1, ">") &&
               adjacent(tokens_[at], tokens_[at + 1]);
    }

    /// Whether `NAME = volume("FILE")` is a whole statement at `at`.
    [[nodiscard]] bool is_volume(std::size_t at) const {
        if (!is_name(at) || (!is(at + 1, "=") && !is(at + 1, ":="))) return false;
        if (at + 3 >= tokens_.size() || tokens_[at + 2].kind != TokenKind::Volume) return false;
        const TokenKind next = tokens_[at + 3].kind;
        return next == TokenKind::Break || next == TokenKind::End;
    }
    /// Writes it as a function of the point: NAME(x, y, z) := volume("FILE")(x, y, z).
    void write_volume(const Token& name, const Token& volume) {
        const auto add = [&](TokenKind kind, std::string_view text, std::size_t offset) {
            out_.push_back({.kind = kind, .text = text, .offset = offset});
        };
        const auto add_point = [&](std::size_t offset) {
            add(TokenKind::Symbol, "(", offset);
            for (const std::string_view axis : {"x", "y", "z"}) {
                if (axis != "x") add(TokenKind::Symbol, ",", offset);
                add(TokenKind::Name, axis, offset);
            }
            add(TokenKind::Symbol, ")", offset);
        };
        out_.push_back(name);
        add_point(name.end());
        add(TokenKind::Symbol, ":=", volume.offset);
        out_.push_back(volume);
        add_point(volume.end());
    }

    [[nodiscard]] std::optional<ProgramHeader> header_at(std::size_t at) const {
        if (is_word(at, "def") && is_name(at + 1)) return python_header(at + 1);
        const bool assigns = is_name(at) && (is(at + 1, "=") || is(at + 1, ":="));
        const auto header = assigns ? unnamed_header(at + 2) : std::nullopt;
        if (!header && is_name(at) && is(at + 1, "(") && is(at + 2, ")") && is(at + 3, ":"))
            return ProgramHeader{.name = {}, .arguments = {}, .length = 4};  // K3DSurf's F():
        if (!header) return handle_header(at, at);
        return ProgramHeader{
            .name = part(at, at + 1), .arguments = header->arguments, .length = header->length + 2};
    }
    /// Reads `def f(x, y): return`, from the name on.
    [[nodiscard]] std::optional<ProgramHeader> python_header(std::size_t name) const {
        const std::size_t end = end_of_names(name + 2);
        if (!is(name + 1, "(") || !is(end, ")") || !is(end + 1, ":")) return std::nullopt;
        std::size_t body = end + 2;
        while (body < tokens_.size() && tokens_[body].kind == TokenKind::Break)
            ++body;
        if (!is_word(body, "return")) return std::nullopt;
        return ProgramHeader{.name = part(name, name + 1),
                             .arguments = part(name + 2, end),
                             .length = body + 2 - name};
    }
    /// Reads `@(x, y)`.
    [[nodiscard]] std::optional<ProgramHeader> handle_header(std::size_t at,
                                                             std::size_t begin) const {
        const std::size_t end = end_of_names(at + 2);
        if (!is(at, "@") || !is(at + 1, "(") || !is(end, ")")) return std::nullopt;
        return ProgramHeader{.name = {}, .arguments = part(at + 2, end), .length = end + 1 - begin};
    }
    /// Reads `@(x, y)`, `lambda x, y:`, `(x, y) ->` or `x ->`.
    [[nodiscard]] std::optional<ProgramHeader> unnamed_header(std::size_t at) const {
        if (auto handle = handle_header(at, at)) return handle;
        if (is_word(at, "lambda")) {
            const std::size_t end = end_of_names(at + 1);
            if (is(end, ":"))
                return ProgramHeader{
                    .name = {}, .arguments = part(at + 1, end), .length = end + 1 - at};
        }
        if (is_name(at) && is_arrow(at + 1))
            return ProgramHeader{.name = {}, .arguments = part(at, at + 1), .length = 3};
        const std::size_t end = end_of_names(at + 1);
        if (!is(at, "(") || !is(end, ")") || !is_arrow(end + 1)) return std::nullopt;
        return ProgramHeader{.name = {}, .arguments = part(at + 1, end), .length = end + 3 - at};
    }

    /// Writes `name(arguments) :=`, or nothing for a function without a name.
    void write(const ProgramHeader& header, std::size_t body) {
        if (header.name.empty()) return;
        const auto symbol = [&](std::string_view text, std::size_t offset) {
            out_.push_back({.kind = TokenKind::Symbol, .text = text, .offset = offset});
        };
        out_.push_back(header.name[0]);
        symbol("(", header.name[0].end());
        out_.insert(out_.end(), header.arguments.begin(), header.arguments.end());
        symbol(")", body);
        symbol(":=", body);
    }

    std::vector<Token> tokens_;
    std::vector<Token> out_;
};

}  // namespace

std::vector<Token> with_plain_functions(std::vector<Token> tokens) {
    return FunctionReader(std::move(tokens)).read();
}

}  // namespace zeroset
