#include "document/import/pov_script.hpp"

#include "document/import/real_functions.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace zeroset {
namespace {

constexpr std::size_t most_steps = 200'000;
constexpr std::size_t most_repeated = 10'000'000;  // tokens
constexpr int deepest = 100;
constexpr std::array<std::string_view, 7> openers{"if",  "ifdef",  "ifndef", "while",
                                                  "for", "switch", "macro"};
/// Files of POV-Ray's own whose functions, constants and colours are known.
constexpr std::array<std::string_view, 5> known_files{"functions.inc", "colors.inc", "math.inc",
                                                      "consts.inc", "transforms.inc"};

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

PovScript::PovScript(std::string_view text) : tokens_(script_tokens(text, true)) {}

void PovScript::note(std::size_t line, std::string_view entry, std::string reason) const {
    if (on_note) on_note(line, entry, std::move(reason));
}

const ScriptToken& PovScript::peek() {
    while (tokens_.at_sign("#") && directive_depth_ < deepest) {
        if (++steps_ > most_steps) {
            stop_long();
            break;
        }
        ++directive_depth_;
        directive();
        --directive_depth_;
    }
    return tokens_.peek();
}

void PovScript::stop_long() {
    note(tokens_.line(), "#", tr("the script runs too long; the rest is left out"));
    stop();
}

void PovScript::go_back(const Block& block) {
    repeated_ += tokens_.position() - block.begin;
    if (repeated_ > most_repeated) return stop_long();
    tokens_.go_to(block.begin);
    if (block.kind == Block::Kind::While) {
        begin_while(block.begin);
    } else {
        blocks_.push_back(block);
    }
}

void PovScript::stop() {
    while (!tokens_.at_end())
        tokens_.next();
    blocks_.clear();
}

const ScriptToken& PovScript::next() {
    peek();
    return tokens_.next();
}

void PovScript::skip_line(std::size_t line) {
    while (!tokens_.at_end() && tokens_.line() == line && !tokens_.at_sign("#"))
        tokens_.next();
}

void PovScript::directive() {
    const std::size_t line = tokens_.line();
    tokens_.next();
    const std::string word(tokens_.next().text);
    if (word == "declare" || word == "local") return declare();
    if (word == "if") return begin_if(condition());
    if (word == "ifdef" || word == "ifndef") {
        tokens_.take_sign("(");
        const bool known = value_of(tokens_.next().text).has_value();
        tokens_.take_sign(")");
        return begin_if(known == (word == "ifdef"));
    }
    if (word == "else" || word == "elseif") {
        skip_to({});
        if (!blocks_.empty()) blocks_.pop_back();
        return;
    }
    if (word == "while") return begin_while(tokens_.position());
    if (word == "for") return begin_for();
    if (word == "switch") return begin_switch();
    if (word == "break") {
        skip_to({});
        if (!blocks_.empty()) blocks_.pop_back();
        return;
    }
    if (word == "case" || word == "range") {
        tokens_.skip_block("(", ")");
        return;
    }
    if (word == "end") return end_block();
    if (word == "macro") {
        note(line, "#macro " + std::string(tokens_.peek().text), tr("macros are not called"));
        skip_to({});
        return;
    }
    if (word == "include") return include();
    if (word == "default") return tokens_.skip_block("{", "}");
    if (word == "undef") {
        tokens_.next();
        return;
    }
    skip_line(line);
}

void PovScript::include() {
    const ScriptToken file = tokens_.peek();
    if (file.kind != ScriptKind::Text) return;
    tokens_.next();
    if (!is_one_of(known_files, file.text)) {
        note(file.line, "#include " + std::string(file.text.substr(0, 60)),
             tr("other files are not read"));
    }
}

void PovScript::declare() {
    const std::size_t line = tokens_.line();
    const std::string name(tokens_.next().text);
    if (!tokens_.take_sign("=")) {
        skip_line(line);
        return;
    }
    if (on_declare && on_declare(name)) {
        values_.erase(name);
        tokens_.take_sign(";");
        return;
    }
    const std::size_t begin = tokens_.position();
    const auto read = value();
    if (read) {
        values_.insert_or_assign(name, *read);
    } else {
        values_.erase(name);
        tokens_.go_to(begin);
        note(line, "#declare " + name, tr("its value is not known; it is left out"));
        skip_line(line);
    }
    tokens_.take_sign(";");
}

std::string PovScript::skip_to(std::initializer_list<std::string_view> words) {
    std::size_t depth = 0;
    while (!tokens_.at_end()) {
        if (!tokens_.take_sign("#")) {
            tokens_.next();
            continue;
        }
        const std::string word(tokens_.next().text);
        if (depth == 0 && std::ranges::find(words, word) != words.end()) return word;
        if (is_one_of(openers, word)) ++depth;
        if (word == "end" && depth-- == 0) return word;
    }
    return "end";
}

void PovScript::begin_if(bool holds) {
    while (!holds) {
        const std::string word = skip_to({"else", "elseif"});
        if (word == "end") return;
        holds = word == "else" || condition();
    }
    blocks_.push_back({.kind = Block::Kind::If});
}

void PovScript::begin_while(std::size_t begin) {
    if (condition())
        blocks_.push_back({.kind = Block::Kind::While, .begin = begin});
    else
        skip_to({});
}

void PovScript::begin_for() {
    const std::size_t line = tokens_.line();
    tokens_.take_sign("(");
    const std::string name(tokens_.next().text);
    std::array<double, 3> numbers{0.0, 0.0, 1.0};
    for (std::size_t i = 0; i < numbers.size() && tokens_.take_sign(","); ++i) {
        const auto read = value();
        if (!read) note(line, "#for", tr("its value is not known; it is left out"));
        numbers[i] = read ? (*read)[0] : 0.0;
    }
    tokens_.take_sign(")");
    values_.insert_or_assign(name, PovValue{numbers[0]});
    const bool runs =
        numbers[2] > 0.0 ? numbers[0] <= numbers[1] : numbers[2] < 0.0 && numbers[0] >= numbers[1];
    if (!runs) {
        skip_to({});
        return;
    }
    blocks_.push_back({.kind = Block::Kind::For,
                       .begin = tokens_.position(),
                       .variable = name,
                       .last = numbers[1],
                       .step = numbers[2]});
}

void PovScript::begin_switch() {
    tokens_.take_sign("(");
    const auto chosen = value();
    tokens_.take_sign(")");
    const double number = chosen ? (*chosen)[0] : 0.0;
    while (true) {
        const std::string word = skip_to({"case", "range", "else"});
        if (word == "end") return;
        if (word == "else") break;
        tokens_.take_sign("(");
        const auto low = value();
        const auto high = tokens_.take_sign(",") ? value() : low;
        tokens_.take_sign(")");
        if (low && high && (*low)[0] <= number && number <= (*high)[0]) break;
    }
    blocks_.push_back({.kind = Block::Kind::Switch});
}

void PovScript::end_block() {
    if (blocks_.empty()) return;
    const Block block = blocks_.back();
    blocks_.pop_back();
    if (block.kind == Block::Kind::While) {
        go_back(block);
    } else if (block.kind == Block::Kind::For) {
        PovValue& variable = values_[block.variable];
        const double now = (variable.empty() ? block.last : variable[0]) + block.step;
        variable = {now};
        // A step that is lost in rounding would never end; steps_ ends it, too.
        if (block.step > 0.0 ? now > block.last + 1e-9 : now < block.last - 1e-9) return;
        go_back(block);
    }
}

bool PovScript::condition() {
    const std::size_t line = tokens_.line();
    const std::size_t begin = tokens_.position();
    tokens_.take_sign("(");
    const auto read = compared();
    if (!read) {
        note(line, "#if", tr("its condition is not known; it counts as false"));
        tokens_.go_to(begin);
        tokens_.skip_block("(", ")");
        return false;
    }
    tokens_.take_sign(")");
    return (*read)[0] != 0.0;
}

std::optional<PovValue> PovScript::compared() {
    auto result = sum();
    constexpr std::array<std::string_view, 9> signs{"<",  ">",  "<=", ">=", "=",
                                                    "==", "!=", "&",  "|"};
    while (result && peek().kind == ScriptKind::Sign && is_one_of(signs, peek().text)) {
        const std::string_view sign = next().text;
        const bool joins = sign == "&" || sign == "|";
        // All behind & and | is one deeper: sum() ends it.
        depth_ += joins ? 1 : 0;
        const auto other = joins ? compared() : sum();
        depth_ -= joins ? 1 : 0;
        if (!other) return std::nullopt;
        const double a = (*result)[0];
        const double b = (*other)[0];
        result = PovValue{holds(a, sign, b).value_or(false) ? 1.0 : 0.0};
    }
    return result;
}

std::optional<PovValue> PovScript::value() { return sum(); }

std::optional<PovValue> PovScript::value_of(std::string_view name) const {
    const auto found = values_.find(name);
    if (found != values_.end()) return found->second;
    return pov_constant(name);
}

std::optional<PovValue> PovScript::sum() {
    if (depth_ >= deepest) return std::nullopt;
    ++depth_;
    auto result = product();
    while (result && (at_sign("+") || at_sign("-"))) {
        const char sign = next().text[0];
        const auto other = product();
        result = other ? std::optional(joined(*result, sign, *other)) : std::nullopt;
    }
    --depth_;
    return result;
}

std::optional<PovValue> PovScript::product() {
    auto result = factor();
    while (result && (at_sign("*") || at_sign("/"))) {
        const char sign = next().text[0];
        const auto other = factor();
        result = other ? std::optional(joined(*result, sign, *other)) : std::nullopt;
    }
    return result;
}

std::optional<PovValue> PovScript::factor() {
    bool negative = false;
    while (at_sign("-") || at_sign("+"))
        negative = (next().text == "-") != negative;
    auto result = operand();
    if (result) result = part_of(std::move(*result));
    if (result && negative) result = joined({-1.0}, '*', *result);
    return result;
}

std::optional<PovValue> PovScript::part_of(PovValue value) {
    static constexpr std::array<std::string_view, 8> parts{"x",   "y",     "z",    "t",
                                                           "red", "green", "blue", "filter"};
    while (at_sign(".")) {
        next();
        const auto* const part = std::ranges::find(parts, next().text);
        if (part == parts.end()) return std::nullopt;
        const auto index = static_cast<std::size_t>(part - parts.begin()) % 4;
        value = {index < value.size() ? value[index] : 0.0};
    }
    return value;
}

std::optional<PovValue> PovScript::operand() {
    const ScriptToken token = peek();
    if (token.kind == ScriptKind::Number) {
        next();
        const auto number = number_from<double>(token.text);
        if (!number) return std::nullopt;
        return PovValue{*number};
    }
    if (take_sign("(")) {
        auto inner = compared();
        if (!take_sign(")")) return std::nullopt;
        return inner;
    }
    if (take_sign("<")) return vector();
    if (token.kind == ScriptKind::Name) return named();
    return std::nullopt;
}

std::optional<PovValue> PovScript::vector() {
    PovValue result;
    do {
        const auto part = sum();
        if (!part || result.size() == 5) return std::nullopt;
        result.push_back((*part)[0]);
        take_sign(",");
    } while (!at_sign(">") && !tokens_.at_end());
    if (!take_sign(">")) return std::nullopt;
    return result;
}

std::optional<PovValue> PovScript::named() {
    const std::string name(next().text);
    static constexpr std::array<std::string_view, 9> colors{
        "rgb", "rgbf", "rgbt", "rgbft", "srgb", "color", "colour", "srgbf", "srgbt"};
    if (is_one_of(colors, name)) {
        auto color = sum();
        if (!color) return std::nullopt;
        if (color->size() == 1 && name != "color" && name != "colour")
            color = PovValue(3, color->front());
        // rgbt: the fourth number is transmitted light, which stands fifth elsewhere.
        if ((name == "rgbt" || name == "srgbt") && color->size() == 4)
            color->insert(color->begin() + 3, 0.0);
        return color;
    }
    if (!at_sign("(")) return value_of(name);
    std::vector<PovValue> arguments;
    do {
        next();
        auto argument = sum();
        if (!argument) return std::nullopt;
        arguments.push_back(std::move(*argument));
    } while (at_sign(","));
    if (!take_sign(")")) return std::nullopt;
    return pov_function(name, arguments);
}

}  // namespace zeroset
