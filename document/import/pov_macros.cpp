#include "document/import/imported.hpp"
#include "document/import/pov_script.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

// Macros of POV-Ray's scenes. A call is read as the tokens of the macro's body, which are put
// behind all others until it ends. Arguments that have a value are local values there; others, such
// as objects, and all within formulas, stand in the body as they were written.

namespace zeroset {
namespace {

constexpr std::size_t most_calls = 100;  // within each other

bool is_name(const ScriptToken& token, std::string_view name) {
    return token.kind == ScriptKind::Name && token.text == name;
}

/// Whether the body declares `name` anew: then that changes what the caller named.
bool declares(std::span<const ScriptToken> body, std::string_view name) {
    for (std::size_t i = 0; i + 1 < body.size(); ++i) {
        if (is_name(body[i], "declare") && is_name(body[i + 1], name)) return true;
    }
    return false;
}

/// How a token changes the depth of brackets; < and > count within a vector.
int bracket_of(const ScriptToken& token, bool vector) {
    if (token.kind != ScriptKind::Sign) return 0;
    const std::string_view opening = vector ? "([{<" : "([{";
    const std::string_view closing = vector ? ")]}>" : ")]}";
    if (opening.contains(token.text)) return 1;
    return closing.contains(token.text) ? -1 : 0;
}

}  // namespace

void PovScript::define_macro() {
    const std::string name(tokens_.next().text);
    const auto macro = std::make_shared<Macro>();
    tokens_.take_sign("(");
    while (tokens_.peek().kind == ScriptKind::Name || tokens_.at_sign(",")) {
        const ScriptToken token = tokens_.next();
        if (token.kind == ScriptKind::Name && token.text != "optional")
            macro->parameters.emplace_back(token.text);
    }
    tokens_.take_sign(")");
    const std::size_t begin = tokens_.position();
    skip_to({});
    constexpr std::size_t closing = 2;  // #end
    const std::size_t end = std::max(tokens_.position(), begin + closing) - closing;
    if (!repeat(end - begin)) return;
    const auto body = tokens_.tokens().subspan(begin, end - begin);
    macro->body.assign(body.begin(), body.end());
    macros_.insert_or_assign(name, macro);
}

bool PovScript::at_macro() const {
    const ScriptToken& token = tokens_.peek();
    return token.kind == ScriptKind::Name && !macros_.empty() && tokens_.at_sign("(", 1) &&
           macros_.contains(token.text);
}

void PovScript::call_macro() {
    const ScriptToken word = tokens_.next();
    if (frames_.size() >= most_calls) {
        note(word.line, word.text, tr("macros are called too deeply; the call is left out"));
        tokens_.skip_block("(", ")");
        repeat(1);
        return;
    }
    // Its arguments may hold calls that declare it anew.
    const std::shared_ptr<const Macro> called = macros_.find(word.text)->second;
    const Macro& macro = *called;
    std::vector<Argument> given;
    tokens_.take_sign("(");
    while (!at_sign(")") && !tokens_.at_end()) {
        given.push_back(argument());
        if (!take_sign(",")) break;
    }
    take_sign(")");
    if (given.size() != macro.parameters.size())
        note(word.line, word.text,
             filled(tr("the macro has {0} parameters, but {1} are given"),
                    {std::to_string(macro.parameters.size()), std::to_string(given.size())}));
    given.resize(macro.parameters.size());
    auto body = expanded(macro, given);
    if (!body) return;
    body->push_back({.line = word.line});
    frames_.push_back(
        {.back = tokens_.position(), .begin = tokens_.tokens().size(), .blocks = blocks_.size()});
    tokens_.append(*body);
    tokens_.go_to(frames_.back().begin);
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i].value && given[i].tokens.empty())
            set_local(macro.parameters[i], std::move(*given[i].value));
    }
}

PovScript::Argument PovScript::argument() {
    if (in_formula_) return {.tokens = argument_tokens()};
    peek();
    const Place begin = place();
    const ScriptToken first = tokens_.peek();
    auto read = value();
    if (!read || !(at_sign(",") || at_sign(")"))) {
        go_to(begin);
        return {.tokens = argument_tokens()};
    }
    Argument result{.value = std::move(read)};
    const bool name_alone =
        first.kind == ScriptKind::Name && tokens_.position() == begin.position + 1;
    if (name_alone) result.tokens.push_back(first);
    return result;
}

std::vector<ScriptToken> PovScript::argument_tokens() {
    std::vector<ScriptToken> result;
    const bool vector = at_sign("<");
    int depth = 0;
    while (!tokens_.at_end()) {
        const ScriptToken token = peek();
        const int change = bracket_of(token, vector);
        const bool comma = token.kind == ScriptKind::Sign && token.text == ",";
        if (depth == 0 && (comma || change < 0)) break;
        depth += change;
        result.push_back(token);
        tokens_.next();
        if (!repeat(1)) break;
    }
    return result;
}

std::optional<std::vector<ScriptToken>> PovScript::expanded(const Macro& macro,
                                                            std::vector<Argument>& given) {
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i].value && !declares(macro.body, macro.parameters[i])) given[i].tokens.clear();
    }
    std::vector<ScriptToken> result;
    for (const ScriptToken& token : macro.body) {
        const auto parameter = std::ranges::find(macro.parameters, token.text);
        const auto index = static_cast<std::size_t>(parameter - macro.parameters.begin());
        const bool stands = token.kind == ScriptKind::Name && parameter != macro.parameters.end() &&
                            !given[index].tokens.empty();
        if (!repeat(stands ? given[index].tokens.size() + 2 : 1)) return std::nullopt;
        if (!stands) {
            result.push_back(token);
            continue;
        }
        const std::vector<ScriptToken>& tokens = given[index].tokens;
        const bool bracketed = in_formula_ && tokens.size() > 1;
        const ScriptToken open{.kind = ScriptKind::Sign, .text = "(", .line = token.line};
        const ScriptToken close{.kind = ScriptKind::Sign, .text = ")", .line = token.line};
        if (bracketed) result.push_back(open);
        result.insert(result.end(), tokens.begin(), tokens.end());
        if (bracketed) result.push_back(close);
    }
    return result;
}

void PovScript::leave_macro() {
    Frame frame = std::move(frames_.back());
    frames_.pop_back();
    blocks_.resize(std::min(blocks_.size(), frame.blocks));
    tokens_.truncate(frame.begin);
    tokens_.go_to(frame.back);
    for (auto& [name, value] : frame.hidden) {
        if (value)
            values_.insert_or_assign(name, std::move(*value));
        else
            values_.erase(name);
    }
}

void PovScript::set_local(const std::string& name, PovValue value) {
    if (!frames_.empty() && !frames_.back().hidden.contains(name)) {
        const auto outer = values_.find(name);
        frames_.back().hidden[name] =
            outer == values_.end() ? std::nullopt : std::optional(outer->second);
    }
    values_.insert_or_assign(name, std::move(value));
}

void PovScript::go_to(const Place& place) {
    // The tokens of a call that has ended since are gone.
    if (frames_.size() < place.frames) return;
    while (frames_.size() > place.frames)
        leave_macro();
    tokens_.go_to(place.position);
}

ScriptToken PovScript::number_token(double value, std::size_t line) {
    return {.kind = ScriptKind::Number,
            .text = numbers_.emplace_back(exact_number(value)),
            .line = line};
}

std::vector<ScriptToken> PovScript::block(std::span<const std::string> kept) {
    struct Named {
        std::size_t index;
        PovValue value;
    };
    std::vector<ScriptToken> result;
    std::vector<Named> names;
    const bool outer = std::exchange(in_formula_, true);
    int depth = take_sign("{") ? 1 : 0;
    while (depth > 0 && peek().kind != ScriptKind::End) {
        if (at_array()) {
            result.push_back(element_token());
            continue;
        }
        const ScriptToken token = next();
        depth += token.kind == ScriptKind::Sign ? (token.text == "{") - (token.text == "}") : 0;
        if (depth == 0) break;
        auto value =
            token.kind == ScriptKind::Name ? value_of(token.text) : std::optional<PovValue>();
        if (value && value->size() > 1 && at_sign(".")) {
            const auto part = part_of(std::move(*value));
            result.push_back(number_token(part ? (*part)[0] : 0.0, token.line));
            continue;
        }
        if (value && value->size() == 1 && std::ranges::find(kept, token.text) == kept.end())
            names.push_back({.index = result.size(), .value = *value});
        result.push_back(token);
    }
    in_formula_ = outer;
    for (const Named& name : names) {
        ScriptToken& token = result[name.index];
        if (value_of(token.text) == name.value) continue;
        token = number_token(name.value[0], token.line);
    }
    result.push_back({.line = tokens_.line()});
    return result;
}

}  // namespace zeroset
