#include "engine/language/dialects/parts.hpp"

#include "engine/base/text.hpp"

#include <algorithm>
#include <cctype>
#include <functional>

namespace zeroset {
namespace {

bool is_blank(char sign) { return std::isspace(static_cast<unsigned char>(sign)) != 0; }
bool is_of_word(char sign) {
    return std::isalnum(static_cast<unsigned char>(sign)) != 0 || sign == '_' ||
           static_cast<unsigned char>(sign) >= 0x80;
}

/// Goes over a text sign by sign and knows how deep brackets are open.
class BracketWalk {
public:
    explicit BracketWalk(std::string_view text) : text_(text) { skip(); }

    [[nodiscard]] bool is_at_end() const { return at_ >= text_.size(); }
    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] char sign() const { return text_[at_]; }
    [[nodiscard]] int depth() const { return depth_; }
    void next() {
        const char sign = text_[at_++];
        if (std::string_view("([{").contains(sign)) ++depth_;
        if (std::string_view(")]}").contains(sign)) --depth_;
        skip();
    }

private:
    /// Skips quotations and remarks.
    void skip() {
        while (const std::size_t length = skipped_length())
            at_ += length;
    }
    /// The length of a quotation or a remark that begins here; 0: none.
    std::size_t skipped_length() {
        const std::string_view rest = text_.substr(at_);
        if (rest.empty()) return 0;
        if (rest.front() == '"' || (rest.front() == '\'' && !is_behind_value()))
            return quotation_length(rest);
        if (rest.starts_with("(*") || rest.starts_with("/*")) return remark_length(rest);
        const bool is_rest = rest.starts_with("//") ||
                             (rest.front() == '#' && !rest.starts_with("#d")) ||
                             (rest.front() == '%' && is_at_line_start());
        return is_rest ? std::min(rest.find_first_of(line_ends), rest.size()) : 0;
    }
    static std::size_t quotation_length(std::string_view text) {
        const std::size_t end = text.find_first_of(text.front() == '"' ? "\"\n\v" : "'\n\v", 1);
        return end != std::string_view::npos && text[end] == text.front() ? end + 1 : 0;
    }
    std::size_t remark_length(std::string_view text) {
        return text.front() == '(' ? round_.length(text) : slashed_.length(text);
    }
    /// Whether a % begins a remark, as it does at the start of a line.
    [[nodiscard]] bool is_at_line_start() const {
        const std::size_t before = text_.substr(0, at_).find_last_not_of(" \t");
        return before == std::string_view::npos || line_ends.contains(text_[before]);
    }
    /// Whether a ' is a transposition or a derivative.
    [[nodiscard]] bool is_behind_value() const {
        return at_ > 0 && (is_of_word(text_[at_ - 1]) || text_[at_ - 1] == ')');
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    RemarkEnds round_{"*)"};
    RemarkEnds slashed_{"*/"};
};

}  // namespace

std::size_t RemarkEnds::length(std::string_view text) {
    const std::string_view near = text.substr(0, longest_remark);
    const bool is_known = std::less<>()(near.data(), none_before_);
    const auto known = is_known ? static_cast<std::size_t>(none_before_ - near.data()) : 0;
    const std::size_t end = near.find(mark_, std::max<std::size_t>(known, 2));
    if (end != std::string_view::npos) return end + mark_.size();
    none_before_ = near.data() + near.size() - 1;
    return 0;
}

std::size_t word_length(std::string_view text) {
    if (text.empty() || std::isdigit(static_cast<unsigned char>(text.front())) != 0) return 0;
    return static_cast<std::size_t>(std::ranges::find_if_not(text, is_of_word) - text.begin());
}

bool is_word(std::string_view text) { return !text.empty() && word_length(text) == text.size(); }

bool is_name(std::string_view text) {
    const bool is_sign = text.starts_with("\\[") && text.ends_with(']');
    return is_word(is_sign ? text.substr(2, text.size() - 3) : text);
}

std::size_t blank_length(std::string_view text) {
    return std::min(text.find_first_not_of(" \t"), text.size());
}

std::optional<std::size_t> closing_bracket(std::string_view text) {
    for (BracketWalk walk(text); !walk.is_at_end();) {
        const std::size_t at = walk.at();
        walk.next();
        if (walk.depth() == 0) return at;
    }
    return std::nullopt;
}

std::vector<std::string_view> split_outside(std::string_view text, char sign) {
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    for (BracketWalk walk(text); !walk.is_at_end(); walk.next()) {
        const bool is_sign = walk.sign() == sign || (sign == ' ' && is_blank(walk.sign()));
        if (!is_sign || walk.depth() != 0) continue;
        parts.push_back(trimmed(text.substr(begin, walk.at() - begin)));
        begin = walk.at() + 1;
    }
    parts.push_back(trimmed(text.substr(begin)));
    if (sign == ' ') std::erase_if(parts, [](std::string_view part) { return part.empty(); });
    return parts;
}

std::size_t find_outside(std::string_view text, std::string_view word) {
    bool in_word = false;
    for (BracketWalk walk(text); !walk.is_at_end(); walk.next()) {
        const std::string_view rest = text.substr(walk.at());
        const bool ends = !is_of_word(word.back()) || rest.size() == word.size() ||
                          (rest.size() > word.size() && !is_of_word(rest[word.size()]));
        const bool starts = !in_word || !is_of_word(word.front());
        if (walk.depth() == 0 && starts && rest.starts_with(word) && ends) return walk.at();
        in_word = is_of_word(rest.front());
    }
    return std::string_view::npos;
}

std::optional<std::string_view> in_brackets(std::string_view text) {
    text = trimmed(text);
    const bool opens = !text.empty() && std::string_view("([{").contains(text.front());
    if (!opens || closing_bracket(text) != text.size() - 1) return std::nullopt;
    return trimmed(text.substr(1, text.size() - 2));
}

std::optional<std::string_view> in_quotes(std::string_view text) {
    const bool opens = text.size() > 1 && std::string_view("'\"").contains(text.front());
    if (!opens || text.find(text.front(), 1) != text.size() - 1) return std::nullopt;
    return text.substr(1, text.size() - 2);
}

std::size_t end_of_statement(std::string_view text, std::size_t begin) {
    const std::string_view rest = text.substr(begin);
    for (BracketWalk walk(rest); !walk.is_at_end(); walk.next()) {
        const bool ends = walk.sign() == ';' || line_ends.contains(walk.sign());
        if (ends && walk.depth() <= 0) return begin + walk.at();
    }
    return text.size();
}

std::optional<NamedRange> named_range(std::string_view argument) {
    if (const auto inside = in_brackets(argument)) {
        const auto parts = split_outside(*inside, ',');
        if (parts.size() != 3 || !is_name(parts[0])) return std::nullopt;
        return NamedRange{.name = parts[0], .lo = parts[1], .hi = parts[2]};
    }
    const std::size_t length = word_length(argument);
    const std::string_view behind = trimmed(argument.substr(length));
    const std::size_t dots = behind.find("..");
    if (length == 0 || !behind.starts_with('=') || dots == std::string_view::npos)
        return std::nullopt;
    return NamedRange{.name = argument.substr(0, length),
                      .lo = trimmed(behind.substr(1, dots - 1)),
                      .hi = trimmed(behind.substr(dots + 2))};
}

std::optional<UnnamedFunction> unnamed_function(std::string_view text) {
    text = trimmed(text);
    const auto with = [](std::string_view names, std::string_view body) {
        return UnnamedFunction{.names = split_outside(names, ','), .body = trimmed(body)};
    };
    if (text.starts_with("lambda ")) {
        const std::size_t colon = text.find(':');
        if (colon == std::string_view::npos) return std::nullopt;
        return with(trimmed(text.substr(7, colon - 7)), text.substr(colon + 1));
    }
    if (text.starts_with("Function[") && text.ends_with(']')) {
        const auto parts = split_outside(text.substr(9, text.size() - 10), ',');
        if (parts.size() != 2) return std::nullopt;
        return with(in_brackets(parts[0]).value_or(parts[0]), parts[1]);
    }
    const bool is_handle = text.starts_with('@');
    const std::string_view list = is_handle ? trimmed(text.substr(1)) : text;
    const bool opens = list.starts_with('(');
    if (!opens && is_handle) return std::nullopt;
    const auto closer = opens ? closing_bracket(list) : std::optional(word_length(list));
    if (!closer || *closer == 0) return std::nullopt;
    const std::string_view names = opens ? list.substr(1, *closer - 1) : list.substr(0, *closer);
    const std::string_view behind = trimmed(list.substr(*closer + (opens ? 1 : 0)));
    if (is_handle) return with(names, behind);
    if (!behind.starts_with("->") && !behind.starts_with("=>")) return std::nullopt;
    return with(names, behind.substr(2));
}

}  // namespace zeroset
