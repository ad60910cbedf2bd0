#include "document/import/implicit_graph.hpp"

#include "document/import/implicit_matrices.hpp"
#include "document/import/implicit_nodes.hpp"
#include "document/import/imported.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <optional>

// Nodes of the implicit extension of 3MF (3MF Volumetric and Implicit Extensions 1.0, part II).

namespace zeroset {
namespace {

constexpr std::size_t most_definitions = 100'000;
constexpr std::size_t most_nodes = 1'000'000;
constexpr int deepest_call = 16;
constexpr int most_function_calls = 10'000;

/// Nodes that do the same with each component, and how that is written: A, B, C for the inputs.
struct Componentwise {
    std::string_view node, pattern;
};
constexpr std::array componentwise{Componentwise{.node = "addition", .pattern = "A + B"},
                                   Componentwise{.node = "subtraction", .pattern = "A - B"},
                                   Componentwise{.node = "multiplication", .pattern = "A*B"},
                                   Componentwise{.node = "division", .pattern = "A/B"},
                                   Componentwise{.node = "sin", .pattern = "sin(A)"},
                                   Componentwise{.node = "cos", .pattern = "cos(A)"},
                                   Componentwise{.node = "tan", .pattern = "tan(A)"},
                                   Componentwise{.node = "arcsin", .pattern = "asin(A)"},
                                   Componentwise{.node = "arccos", .pattern = "acos(A)"},
                                   Componentwise{.node = "arctan", .pattern = "atan(A)"},
                                   Componentwise{.node = "arctan2", .pattern = "atan2(A, B)"},
                                   // lib3mf calls them so, other than the specification.
                                   Componentwise{.node = "asin", .pattern = "asin(A)"},
                                   Componentwise{.node = "acos", .pattern = "acos(A)"},
                                   Componentwise{.node = "atan", .pattern = "atan(A)"},
                                   Componentwise{.node = "atan2", .pattern = "atan2(A, B)"},
                                   Componentwise{.node = "min", .pattern = "min(A, B)"},
                                   Componentwise{.node = "max", .pattern = "max(A, B)"},
                                   Componentwise{.node = "abs", .pattern = "abs(A)"},
                                   Componentwise{.node = "fmod", .pattern = "fmod(A, B)"},
                                   Componentwise{.node = "mod", .pattern = "mod(A, B)"},
                                   Componentwise{.node = "pow", .pattern = "pow(A, B)"},
                                   Componentwise{.node = "sqrt", .pattern = "sqrt(A)"},
                                   Componentwise{.node = "exp", .pattern = "exp(A)"},
                                   Componentwise{.node = "log", .pattern = "ln(A)"},
                                   Componentwise{.node = "log2", .pattern = "log2(A)"},
                                   Componentwise{.node = "log10", .pattern = "log10(A)"},
                                   Componentwise{.node = "cosh", .pattern = "cosh(A)"},
                                   Componentwise{.node = "sinh", .pattern = "sinh(A)"},
                                   Componentwise{.node = "tanh", .pattern = "tanh(A)"},
                                   Componentwise{.node = "round", .pattern = "round(A)"},
                                   Componentwise{.node = "ceil", .pattern = "ceil(A)"},
                                   Componentwise{.node = "floor", .pattern = "floor(A)"},
                                   Componentwise{.node = "sign", .pattern = "sign(A)"},
                                   Componentwise{.node = "fract", .pattern = "fract(A)"},
                                   Componentwise{.node = "clamp", .pattern = "clamp(A, min, max)"},
                                   Componentwise{.node = "select", .pattern = "if(A < B, C, D)"}};

std::optional<std::string> number_text(const char* text) {
    const auto number = number_from<double>(trimmed(text));
    if (!number || !(std::abs(*number) <= largest_number)) return std::nullopt;
    return exact_number(*number, true);
}

/// Nodes with inputs that make or take apart vectors and matrices.
constexpr std::array<std::string_view, 14> of_vectors_kinds{"composevector",
                                                            "decomposevector",
                                                            "vectorfromscalar",
                                                            "dot",
                                                            "length",
                                                            "cross",
                                                            "composematrix",
                                                            "matrixfromrows",
                                                            "transpose",
                                                            "matrixfromcolumns",
                                                            "inverse",
                                                            "matvecmultiplication",
                                                            "matrixvectormultiplication",
                                                            "functioncall"};

/// The node's kind, where a draft of the extension called it otherwise.
std::string_view kind_of(const pugi::xml_node& node) {
    using Names = std::pair<std::string_view, std::string_view>;
    constexpr std::array drafts{Names{"sinus", "sin"},
                                Names{"cosinus", "cos"},
                                Names{"dotproduct", "dot"},
                                Names{"crossproduct", "cross"},
                                Names{"composematrixfromcolumnvectors", "matrixfromcolumns"},
                                Names{"composematrixfromrowvectors", "matrixfromrows"}};
    const std::string_view kind = local_name(node);
    const auto* const draft = std::ranges::find(drafts, kind, &Names::first);
    return draft == drafts.end() ? kind : draft->second;
}

bool is_known(std::string_view kind) {
    return kind.starts_with("const") ||
           std::ranges::find(of_vectors_kinds, kind) != of_vectors_kinds.end() ||
           std::ranges::find(componentwise, kind, &Componentwise::node) != componentwise.end();
}

/// Whether a component is 0 at every place.
bool is_zero(const std::string& component) { return component == "0" || component == "(-0)"; }

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

void GraphWriter::add_function(const pugi::xml_node& function) {
    functions_.insert_or_assign(function.attribute("id").value(),
                                Function{.element = function, .nodes = nodes_in_order(function)});
}

std::string GraphWriter::named(const std::string& expression) {
    const std::string name = "n_" + std::to_string(++count_);
    definitions_ += (definitions_.empty() ? "" : "\n") + name + " := " + expression;
    return name;
}

std::expected<std::string, std::string> GraphWriter::output(const std::string& id,
                                                            const std::string& channel,
                                                            const GraphValue& position) {
    const auto result = call(id, channel, {{"pos", position}});
    if (!result) return std::unexpected(result.error());
    if (result->size() != 1) return std::unexpected(filled(tr("{0} is no scalar"), {channel}));
    return (*result)[0];
}

GraphWriter::Result GraphWriter::call(const std::string& id, const std::string& channel,
                                      const Inputs& inputs) {
    const auto found = functions_.find(id);
    if (images_.contains(id))
        return std::unexpected(
            filled(tr("function {0} is made of an image, which is not taken over"), {id}));
    if (found == functions_.end())
        return std::unexpected(filled(tr("there is no implicit function {0} before it"), {id}));
    if (depth_ >= deepest_call || ++calls_ > most_function_calls)
        return std::unexpected(tr("functions that call each other are nested too deeply"));
    ++depth_;
    Scope scope;
    for (const auto& [name, value] : inputs)
        scope.values["inputs." + name] = value;
    for (const pugi::xml_node& node : found->second.nodes) {
        // A node that fails matters only where another one refers to it.
        if (const auto done = evaluate(node, scope); !done)
            scope.failures[node.attribute("identifier").value()] = done.error();
        if (is_too_long()) break;
    }
    --depth_;
    if (is_too_long()) return std::unexpected(tr("its functions have too many nodes"));
    const std::string missing = filled(tr("function {0} has no output {1}"), {id, channel});
    for (const pugi::xml_node& out : child_named(found->second.element, "out").children()) {
        if (channel == out.attribute("identifier").value())
            return scope.value(out.attribute("ref").value(), missing);
    }
    return std::unexpected(missing);
}

std::expected<GraphValue, std::string> GraphWriter::Scope::value(
    const std::string& reference, const std::string& otherwise) const {
    const auto found = values.find(reference);
    if (found != values.end()) return found->second;
    for (const std::string& name : {reference, reference.substr(0, reference.find('.'))}) {
        const auto failure = failures.find(name);
        if (failure != failures.end()) return std::unexpected(failure->second);
    }
    return std::unexpected(otherwise);
}

bool GraphWriter::is_too_long() const {
    return nodes_ > most_nodes || count_ > most_definitions || calls_ > most_function_calls;
}

std::expected<GraphWriter::Inputs, std::string> GraphWriter::inputs_of(const pugi::xml_node& node,
                                                                       const Scope& scope) {
    Inputs inputs;
    for (const pugi::xml_node& in : child_named(node, "in").children()) {
        const std::string reference = in.attribute("ref").value();
        auto value =
            scope.value(reference, filled(tr("{0} refers to {1}, which has no value"),
                                          {node.attribute("identifier").value(), reference}));
        if (!value) return std::unexpected(value.error());
        inputs[in.attribute("identifier").value()] = std::move(*value);
    }
    return inputs;
}

std::expected<void, std::string> GraphWriter::evaluate(const pugi::xml_node& node, Scope& scope) {
    ++nodes_;
    if (is_too_long()) return std::unexpected(tr("its functions have too many nodes"));
    const std::string_view kind = kind_of(node);
    if (!is_known(kind)) return std::unexpected(filled(tr("nodes {0} are not taken over"), {kind}));
    const std::string name = node.attribute("identifier").value();
    auto& values = scope.values;
    if (kind == "constresourceid") {
        // Files of drafts of the extension call it resourceid.
        const pugi::xml_attribute id = node.attribute("value");
        values[name + ".value"] = {(id ? id : node.attribute("resourceid")).value()};
        return {};
    }
    if (kind == "functioncall") return call_node(node, scope);
    auto inputs = inputs_of(node, scope);
    if (!inputs) return std::unexpected(inputs.error());
    if (kind == "decomposevector") {
        const GraphValue& vector = (*inputs)["A"];
        for (std::size_t i = 0; i < vector.size() && i < 3; ++i)
            values[name + "." + "xyz"[i]] = {vector[i]};
        return {};
    }
    auto result = of_vectors(kind, node, *inputs);
    if (!result) return std::unexpected(result.error());
    if (result->empty() && kind == "division" && std::ranges::any_of((*inputs)["B"], is_zero))
        return std::unexpected(filled(tr("node {0} divides by 0"), {name}));
    if (result->empty()) result = of_components(kind, *inputs);
    if (!result) return std::unexpected(result.error());
    // The outputs have one value; constants call it value, vector or matrix.
    for (const char* const output : {"result", "value", "vector", "matrix"})
        values[name + "." + output] = *result;
    for (const pugi::xml_node& out : child_named(node, "out").children())
        values[name + "." + out.attribute("identifier").value()] = *result;
    return {};
}

std::expected<void, std::string> GraphWriter::call_node(const pugi::xml_node& node, Scope& scope) {
    auto inputs = inputs_of(node, scope);
    if (!inputs) return std::unexpected(inputs.error());
    const GraphValue id = (*inputs)["functionID"];
    inputs->erase("functionID");
    const std::string name = node.attribute("identifier").value();
    for (const pugi::xml_node& out : child_named(node, "out").children()) {
        const std::string channel = out.attribute("identifier").value();
        auto result = call(id.empty() ? std::string() : id[0], channel, *inputs);
        if (result)
            scope.values[name + "." + channel] = std::move(*result);
        else
            scope.failures[name + "." + channel] = result.error();
    }
    return {};
}

/// A scalar, vector or matrix that is told by numbers.
GraphWriter::Result GraphWriter::constant_of(std::string_view kind, const pugi::xml_node& node) {
    if (kind == "constant") {
        const auto number = number_text(node.attribute("value").value());
        if (!number) return std::unexpected(tr("a constant is no number"));
        return GraphValue{*number};
    }
    if (kind == "constvec") {
        GraphValue vector;
        for (const char* const part : {"x", "y", "z"}) {
            const auto number = number_text(node.attribute(part).value());
            if (!number) return std::unexpected(tr("a constant is no number"));
            vector.push_back(*number);
        }
        return vector;
    }
    if (kind == "constmat") {
        GraphValue matrix;
        for (const std::string_view word : split(node.attribute("matrix").value(), ' ')) {
            const auto number = number_text(std::string(word).c_str());
            if (number) matrix.push_back(*number);
        }
        // 16 numbers, of which the turn and scale are taken.
        if (matrix.size() != 16)
            return std::unexpected(tr("a constant is no matrix of 16 numbers"));
        return matrix;
    }
    return std::unexpected(filled(tr("nodes {0} are not taken over"), {kind}));
}

/// Nodes that make vectors and matrices or take them apart; nothing for others.
GraphWriter::Result GraphWriter::of_vectors(std::string_view kind, const pugi::xml_node& node,
                                            Inputs& in) {
    const auto at = [](const GraphValue& value, std::size_t i) {
        return i < value.size() ? value[i] : std::string("0");
    };
    const auto sum_of_products = [&](const GraphValue& a, std::size_t first, std::size_t step,
                                     const GraphValue& b) {
        return named(at(a, first) + "*" + at(b, 0) + " + " + at(a, first + step) + "*" + at(b, 1) +
                     " + " + at(a, first + 2 * step) + "*" + at(b, 2));
    };
    if (kind.starts_with("const")) return constant_of(kind, node);
    if (kind == "composevector") return GraphValue{at(in["x"], 0), at(in["y"], 0), at(in["z"], 0)};
    if (kind == "vectorfromscalar") return GraphValue(3, at(in["A"], 0));
    if (kind == "dot") return GraphValue{sum_of_products(in["A"], 0, 1, in["B"])};
    if (kind == "length")
        return GraphValue{named("sqrt(" + sum_of_products(in["A"], 0, 1, in["A"]) + ")")};
    if (kind == "cross") {
        const GraphValue& a = in["A"];
        const GraphValue& b = in["B"];
        GraphValue result;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t k = (i + 2) % 3;
            result.push_back(named(at(a, j) + "*" + at(b, k) + " - " + at(a, k) + "*" + at(b, j)));
        }
        return result;
    }
    return matrix_value(kind, in, [this](const std::string& text) { return named(text); });
}

GraphWriter::Result GraphWriter::of_components(std::string_view kind, Inputs& in) {
    const auto* const found = std::ranges::find(componentwise, kind, &Componentwise::node);
    if (found == componentwise.end())
        return std::unexpected(
            filled(tr("{0} lacks an input, or has one of another type"), {kind}));
    std::size_t parts = 1;
    for (const auto& [name, value] : in)
        parts = std::max(parts, value.size());
    GraphValue result;
    for (std::size_t i = 0; i < parts; ++i) {
        std::string text;
        const std::string_view pattern = found->pattern;
        for (std::size_t at = 0; at < pattern.size();) {
            std::size_t end = at;
            while (end < pattern.size() && is_letter_or_digit(pattern[end]))
                ++end;
            const bool is_call = end < pattern.size() && pattern[end] == '(';
            if (end == at || is_call) {
                end = std::max(end, at + 1);
                text += pattern.substr(at, end - at);
            } else {
                const auto input = in.find(pattern.substr(at, end - at));
                if (input == in.end() || input->second.empty())
                    return std::unexpected(
                        filled(tr("{0} lacks an input, or has one of another type"), {kind}));
                text += input->second[std::min(i, input->second.size() - 1)];
            }
            at = end;
        }
        result.push_back(named(text));
    }
    return result;
}

}  // namespace zeroset
