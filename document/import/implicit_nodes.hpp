#pragma once

#include <pugixml.hpp>

#include <string_view>
#include <vector>

namespace zeroset {

/// An element's name without its prefix.
std::string_view local_name(const pugi::xml_node& node);

/// The first element in `node` of this name without its prefix; none is an empty one.
pugi::xml_node child_named(const pugi::xml_node& node, std::string_view name);

/// The nodes of a function of 3MF, each behind those that it refers to, as far as that is possible.
std::vector<pugi::xml_node> nodes_in_order(const pugi::xml_node& function);

}  // namespace zeroset
