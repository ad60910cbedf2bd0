#include "document/import/pov_formulas.hpp"

#include "engine/base/translation.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace zeroset {
namespace {

/// Functions that mean something else in the language, or are called otherwise there.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> renamed{
    {{"mod", "fmod"}, {"log", "log10"}, {"int", "trunc"}}};

}  // namespace

std::vector<std::string> PovFormulas::parameters(const std::vector<std::string>& usual) {
    std::vector<std::string> names;
    if (!script_.take_sign("(")) return usual;
    while (script_.peek().kind == ScriptKind::Name || script_.at_sign(",")) {
        const ScriptToken token = script_.next();
        if (token.kind == ScriptKind::Name && token.text != "float") names.emplace_back(token.text);
    }
    script_.take_sign(")");
    return names;
}

std::optional<std::string> PovFormulas::read(std::string_view wanted,
                                             const std::vector<std::string>& usual) {
    const std::vector<std::string> names = parameters(usual);
    const std::size_t line = script_.line();
    const auto refused = [&](std::string reason) {
        result_.note(line, wanted.empty() ? "function" : wanted, std::move(reason));
        return std::nullopt;
    };
    if (!script_.at_sign("{")) return refused(tr("a function is { ... }; it is left out"));
    for (const std::string_view word : {"pigment", "pattern", "spline", "transform"}) {
        if (!script_.name_follows(word)) continue;
        if (word == "pigment" || word == "pattern") return pattern(wanted, line);
        script_.skip_block();
        return refused(filled(tr("functions of a {0} are not taken over"), {word}));
    }
    TokenReader tokens(script_.block(names));
    auto term = read_term(tokens, {.parts_of_calls = true});
    if (!term) return refused(filled(tr("{0}; it is left out"), {term.error().reason}));
    if (!tokens.at_end()) {
        return refused(
            filled(tr("'{0}' does not continue the formula"), {tokens.peek().text.substr(0, 20)}));
    }
    // A call of a known function alone needs no row of its own.
    const bool plain = wanted.empty() && term->kind == TermKind::Call &&
                       term->operands.size() == 3 && text_of(term->operands[0]) == "x" &&
                       text_of(term->operands[1]) == "y" && text_of(term->operands[2]) == "z";
    if (plain) {
        if (auto own = find(term->text)) return own;
    }
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ", ") + name;
    const std::string formula = translated(std::move(*term), names);
    std::string own = names_.fresh(wanted.empty() ? "shape" : wanted);
    if (!wanted.empty() && own != wanted)
        result_.note(line, wanted, filled(tr("{0} is called {1}"), {wanted, own}));
    result_.add_definition(own + "(" + list + ") = " + formula, line);
    forget_colors(std::string(wanted));
    return own;
}

void PovFormulas::define_as(const std::string& name, const std::string& same) {
    if (name == same) return;
    functions_[name] = functions_.at(same);
    forget_colors(name);
    const auto colors = colors_.find(same);
    if (colors != colors_.end()) colors_[name] = colors->second;
}

void PovFormulas::forget_colors(const std::string& name) {
    colors_.erase(name);
    for (const char* const part : {".gray", ".grey", ".hf"})
        parts_.erase(name + part);
}

std::optional<std::string> PovFormulas::find(std::string_view name) const {
    const auto found = functions_.find(name);
    if (found == functions_.end()) return std::nullopt;
    return found->second;
}

std::string PovFormulas::add(std::string_view wanted, const std::string& formula,
                             std::size_t line) {
    std::string own = names_.fresh(wanted);
    result_.add_definition(own + "(x, y, z) = " + formula, line);
    return own;
}

std::string PovFormulas::translated(ForeignTerm term, const std::vector<std::string>& parameters) {
    for_each_part(term, [&](ForeignTerm& part) {
        if (part.kind == TermKind::Call) translate_call(part);
        if (part.kind == TermKind::Name) translate_name(part, parameters);
    });
    return text_of(term);
}

bool PovFormulas::translate_part(ForeignTerm& call) {
    const std::size_t dot = call.text.find('.');
    if (dot == std::string::npos) return false;
    const std::string own =
        part_of(call.text.substr(0, dot), std::string_view(call.text).substr(dot + 1), call.line);
    if (!own.empty()) call.text = own;
    return true;
}

void PovFormulas::translate_call(ForeignTerm& call) {
    if (translate_part(call)) return;
    if (const auto own = find(call.text)) {
        call.text = *own;
        return;
    }
    const auto* const other =
        std::ranges::find(renamed, call.text, [](const auto& r) { return r.first; });
    if (other != renamed.end()) {
        call.text = other->second;
    } else if (call.text == "sqr" && call.operands.size() == 1) {
        call.kind = TermKind::Power;
        call.operands.push_back(number_term(2.0, call.line));
    } else if (call.text == "div" && call.operands.size() == 2) {
        ForeignTerm quotient{.kind = TermKind::Chain,
                             .operands = std::move(call.operands),
                             .signs = {"", "/"},
                             .line = call.line};
        std::vector<ForeignTerm> one;
        one.push_back(std::move(quotient));
        call = call_of("trunc", std::move(one), call.line);
    } else if ((call.text == "sum" || call.text == "prod") && call.operands.size() == 4) {
        // The formula is the last argument there, and the first one here.
        std::ranges::rotate(call.operands, call.operands.begin() + 3);
    }
}

void PovFormulas::translate_name(ForeignTerm& name, const std::vector<std::string>& parameters) {
    if (std::ranges::find(parameters, name.text) != parameters.end()) return;
    const auto value = script_.value_of(name.text);
    if (!value || name.text == "pi" || pov_constant(name.text)) {
        if (value && name.text != "pi" && value->size() == 1)
            name = number_term((*value)[0], name.line);
        return;
    }
    if (value->size() != 1) {
        result_.note(name.line, name.text, tr("a vector in a formula; it is left out"));
        return;
    }
    const auto key = std::pair(name.text, (*value)[0]);
    if (!constants_.contains(key)) {
        constants_[key] = names_.fresh(name.text);
        result_.add_definition(constants_[key] + " := " + exact_number(key.second), name.line);
    }
    name.text = constants_[key];
}

std::optional<std::string> PovFormulas::pattern(std::string_view wanted, std::size_t line) {
    const auto read = PovPattern::read(script_, modifiers_, result_);
    if (!read) {
        result_.note(line, wanted.empty() ? "function" : wanted, read.error());
        return std::nullopt;
    }
    const std::string name(wanted.empty() ? "pattern" : wanted);
    std::string value = add(name, read->call, line);
    if (!read->moved.empty()) {
        // The pattern in its own coordinates, which turbulence bends, and then where it stands.
        value = add(name, value + "(" + read->moved + ")", line);
    }
    if (read->map.empty()) return value;
    forget_colors(name);
    std::array<std::string, 3>& channels = colors_[name];
    for (int channel = 0; channel < 3; ++channel) {
        const std::string mapped = read->mapped(value + "(x, y, z)", channel);
        const bool known = channel > 0 && mapped == read->mapped(value + "(x, y, z)", channel - 1);
        const auto index = static_cast<std::size_t>(channel);
        channels[index] = known ? channels[index - 1] : add(name, mapped, line);
    }
    return channels[0];
}

std::string PovFormulas::part_of(const std::string& function, std::string_view part,
                                 std::size_t line) {
    const auto colors = colors_.find(function);
    if (colors == colors_.end()) return {};
    const auto& [red, green, blue] = colors->second;
    if (part == "red" || part == "x") return red;
    if (part == "green" || part == "y") return green;
    if (part == "blue" || part == "z") return blue;
    if (part != "gray" && part != "grey" && part != "hf") return {};
    if (red == green && green == blue) return red;
    std::string& own = parts_[function + "." + std::string(part)];
    if (!own.empty()) return own;
    const std::string at = "(x, y, z)";
    own =
        add(function,
            part == "hf" ? "0.996093*(" + red + at + " + " + green + at + "/255)"
                         : "0.297*" + red + at + " + 0.589*" + green + at + " + 0.114*" + blue + at,
            line);
    return own;
}

}  // namespace zeroset
