#include "document/import/pov_script.hpp"
#include "engine/base/translation.hpp"

#include <cmath>

// Arrays of POV-Ray's scenes: an element is a value whose name has its indices, "A[0][2]".

namespace zeroset {
namespace {

constexpr int most_dimensions = 5;  // POV-Ray's own limit
constexpr double largest_index = 1e6;

std::string element(const std::string& array, std::size_t index) {
    return array + "[" + std::to_string(index) + "]";
}

}  // namespace

bool PovScript::at_array() const {
    const ScriptToken& token = tokens_.peek();
    return token.kind == ScriptKind::Name && tokens_.at_sign("[", 1) &&
           arrays_.contains(token.text);
}

std::string PovScript::element_name() {
    std::string name(tokens_.next().text);
    while (take_sign("[")) {
        const auto index = value();
        const bool usable = index && (*index)[0] >= 0.0 && (*index)[0] <= largest_index;
        if (!take_sign("]") || !usable) return {};
        name = element(name, static_cast<std::size_t>((*index)[0]));
    }
    return name;
}

ScriptToken PovScript::element_token() {
    const ScriptToken word = tokens_.peek();
    auto element = value_of(element_name());
    if (element) element = part_of(std::move(*element));
    if (element) return number_token((*element)[0], word.line);
    note(word.line, std::string(word.text) + "[]", tr("its value is not known; it is left out"));
    // No formula goes on with this.
    return {.kind = ScriptKind::Sign, .text = "[", .line = word.line};
}

bool PovScript::declare_array(const std::string& name, bool local) {
    if (!take_name("array")) return false;
    std::vector<double> sizes;
    while (take_sign("[")) {
        const auto size = value();
        sizes.push_back(size ? (*size)[0] : 0.0);
        if (!take_sign("]")) break;
    }
    arrays_.insert_or_assign(name, std::move(sizes));
    const std::size_t line = this->line();
    if (at_sign("{") && !read_elements(name, local, 0))
        note(line, "#declare " + name, tr("its value is not known; it is left out"));
    return true;
}

std::optional<PovValue> PovScript::array_size() {
    take_sign("(");
    const auto array = arrays_.find(next().text);
    const auto dimension = take_sign(",") ? value() : PovValue{1.0};
    if (!take_sign(")") || array == arrays_.end() || !dimension) return std::nullopt;
    for (std::size_t i = 0; i < array->second.size(); ++i) {
        if ((*dimension)[0] == static_cast<double>(i + 1)) return PovValue{array->second[i]};
    }
    return std::nullopt;
}

bool PovScript::read_elements(const std::string& name, bool local, int depth) {
    bool known = true;
    take_sign("{");
    for (std::size_t i = 0; !take_sign("}") && !tokens_.at_end(); ++i) {
        if (at_sign("{") && depth < most_dimensions) {
            known = read_elements(element(name, i), local, depth + 1) && known;
        } else {
            auto read = value();
            if (read && local)
                set_local(element(name, i), std::move(*read));
            else if (read)
                values_.insert_or_assign(element(name, i), std::move(*read));
            known = known && read;
            while (!at_sign(",") && !at_sign("}") && !tokens_.at_end())
                skip_item();
        }
        take_sign(",");
    }
    return known;
}

}  // namespace zeroset
