#pragma once

#include "document/import/placement.hpp"

#include <pugixml.hpp>

#include <array>
#include <cstddef>
#include <expected>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {

/// A scalar, vector or matrix (row by row) of a function of 3MF: the texts of its components, each
/// a name or a number.
using GraphValue = std::vector<std::string>;
using GraphInputs = std::map<std::string, GraphValue, std::less<>>;  ///< by their identifiers

/// Writes the functions of a 3MF model as definitions of the language, node by node.
class GraphWriter {
public:
    /// Makes `function` known, an implicitfunction element. Its nodes may stand in any order.
    void add_function(const pugi::xml_node& function);
    /// Makes known that a function is made of an image, which none can call here.
    void add_image(const std::string& id) { images_.insert(id); }

    /// The output `channel` of a function at a position; the error is one line.
    std::expected<std::string, std::string> output(const std::string& id,
                                                   const std::string& channel,
                                                   const GraphValue& position);
    /// The definitions so far, a line each.
    [[nodiscard]] const std::string& definitions() const { return definitions_; }
    /// A name for an expression.
    std::string named(const std::string& expression);

private:
    using Inputs = GraphInputs;
    /// The values of a function's outputs so far, and why some have none.
    struct Scope {
        std::map<std::string, GraphValue, std::less<>> values = {};     ///< by "node.output"
        std::map<std::string, std::string, std::less<>> failures = {};  ///< by node or output

        /// The value of an output; the error says why the node that has it failed, else
        /// `otherwise`.
        [[nodiscard]] std::expected<GraphValue, std::string> value(
            const std::string& reference, const std::string& otherwise) const;
    };
    using Result = std::expected<GraphValue, std::string>;

    Result call(const std::string& id, const std::string& channel, const Inputs& inputs);
    std::expected<void, std::string> evaluate(const pugi::xml_node& node, Scope& scope);
    std::expected<void, std::string> call_node(const pugi::xml_node& node, Scope& scope);
    static Result constant_of(std::string_view kind, const pugi::xml_node& node);
    Result of_vectors(std::string_view kind, const pugi::xml_node& node, Inputs& in);
    Result of_components(std::string_view kind, Inputs& in);
    [[nodiscard]] static std::expected<Inputs, std::string> inputs_of(const pugi::xml_node& node,
                                                                      const Scope& scope);

    /// Whether the functions take more than is read.
    [[nodiscard]] bool is_too_long() const;

    struct Function {
        pugi::xml_node element;
        std::vector<pugi::xml_node> nodes;  ///< each behind those that it refers to
    };
    std::map<std::string, Function, std::less<>> functions_;
    std::set<std::string, std::less<>> images_;  ///< functions that are made of images
    std::string definitions_;
    std::size_t count_ = 0;
    std::size_t nodes_ = 0;  ///< that were evaluated
    int depth_ = 0;
    int calls_ = 0;
};

}  // namespace zeroset
