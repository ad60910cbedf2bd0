#include "document/import/implicit_nodes.hpp"

#include <cstddef>
#include <cstdint>
#include <map>

namespace zeroset {

std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child_named(const pugi::xml_node& node, std::string_view name) {
    for (const pugi::xml_node& inner : node.children())
        if (local_name(inner) == name) return inner;
    return {};
}

std::vector<pugi::xml_node> nodes_in_order(const pugi::xml_node& function) {
    std::vector<pugi::xml_node> nodes;
    std::map<std::string_view, std::size_t> index;
    for (const pugi::xml_node& node : function.children()) {
        const std::string_view kind = local_name(node);
        if (node.type() != pugi::node_element || kind == "in" || kind == "out") continue;
        index.emplace(node.attribute("identifier").value(), nodes.size());
        nodes.push_back(node);
    }
    enum class State : std::uint8_t { New, Begun, Done };
    std::vector<State> states(nodes.size(), State::New);
    std::vector<pugi::xml_node> result;
    std::vector<std::size_t> open;
    for (std::size_t first = 0; first < nodes.size(); ++first) {
        open.push_back(first);
        while (!open.empty()) {
            const std::size_t at = open.back();
            if (states[at] != State::New) {
                open.pop_back();
                if (states[at] == State::Begun) result.push_back(nodes[at]);
                states[at] = State::Done;
                continue;
            }
            states[at] = State::Begun;
            for (const pugi::xml_node& in : child_named(nodes[at], "in").children()) {
                const std::string_view reference = in.attribute("ref").value();
                const auto needed = index.find(reference.substr(0, reference.find('.')));
                if (needed != index.end() && states[needed->second] == State::New)
                    open.push_back(needed->second);
            }
        }
    }
    return result;
}

}  // namespace zeroset
