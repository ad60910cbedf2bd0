#include "document/import/math_model.hpp"
#include "document/import/readers.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// Scripts of MathMod: one model {"Iso3D": {...}}, or {"MathModels": [...]}. Numbers in texts may
// have DOTSYMBOL for their point, and strings may hold line ends.

namespace zeroset {
namespace {

using Json = nlohmann::json;

constexpr int deepest_bracket = 64;

/// A text as JSON allows it: line ends and tabs in strings as escapes. An error where brackets are
/// nested too deeply.
std::expected<std::string, std::string> strict_json(std::string_view text) {
    std::string strict;
    strict.reserve(text.size());
    bool quoted = false;
    int depth = 0;
    std::size_t line = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (letter == '\n') ++line;
        if (letter == '"') quoted = !quoted;
        if (quoted && letter == '\\' && i + 1 < text.size()) {
            strict += letter;
            strict += text[++i];
        } else if (quoted && static_cast<unsigned char>(letter) < ' ') {
            strict += letter == '\n' ? "\\n" : " ";
        } else {
            strict += letter;
        }
        if (quoted) continue;
        if (letter == '[' || letter == '{') ++depth;
        if (letter == ']' || letter == '}') --depth;
        if (depth > deepest_bracket)
            return import_error(line, tr("its brackets are nested too deeply"));
    }
    return strict;
}

std::string with_points(std::string text) {
    constexpr std::string_view symbol = "DOTSYMBOL";
    for (std::size_t at = 0; (at = text.find(symbol, at)) != std::string::npos;)
        text.replace(at, symbol.size(), ".");
    return text;
}

/// The texts of a value: of a list those in it, of a text the one.
std::vector<std::string> texts_of(const Json& value) {
    std::vector<std::string> texts;
    if (value.is_string()) texts.push_back(with_points(value.get<std::string>()));
    if (value.is_number()) texts.push_back(value.dump());
    if (value.is_array()) {
        for (const Json& item : value) {
            if (item.is_string())
                texts.push_back(with_points(item.get<std::string>()));
            else if (item.is_number())
                texts.push_back(item.dump());
        }
    }
    return texts;
}

std::vector<std::string> field_texts(const Json& object, const char* field) {
    const auto found = object.find(field);
    return found == object.end() ? std::vector<std::string>{} : texts_of(*found);
}

std::vector<ModelSlider> sliders_of(const Json& model) {
    std::vector<ModelSlider> sliders;
    const auto found = model.find("Sliders");
    if (found == model.end() || !found->is_object()) return sliders;
    const auto names = field_texts(*found, "Name");
    const std::array fields{field_texts(*found, "Position"), field_texts(*found, "Min"),
                            field_texts(*found, "Max"), field_texts(*found, "Step")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::array<double, 4> numbers{0.0, -100.0, 100.0, 1.0};
        for (std::size_t k = 0; k < fields.size(); ++k) {
            const auto number =
                i < fields[k].size() ? number_from<double>(trimmed(fields[k][i])) : std::nullopt;
            if (number && std::abs(*number) <= largest_number) numbers[k] = *number;
        }
        const std::string name(trimmed(names[i]));
        if (!name.empty())
            sliders.push_back({.name = name,
                               .value = numbers[0],
                               .lo = numbers[1],
                               .hi = numbers[2],
                               .step = numbers[3]});
    }
    return sliders;
}

class Collection {
public:
    void add_all(const Json& value) {
        if (value.is_array()) {
            for (const Json& item : value)
                add_all(item);
        } else if (value.is_object() && value.contains("MathModels")) {
            add_all(value["MathModels"]);
        } else if (value.is_object()) {
            add_models(value, "");
        }
    }

    Imported imported;

private:
    void add_models(const Json& object, const std::string& group) {
        const auto several = object.find("ParIso");
        if (several != object.end() && several->is_array()) {
            const auto names = field_texts(object, "Name");
            const std::string name = names.empty() ? "ParIso" : names[0];
            for (std::size_t i = 0; i < several->size(); ++i) {
                const Json& part = (*several)[i];
                if (part.is_object()) add_models(part, name + " " + std::to_string(i + 1));
            }
            return;
        }
        for (const auto& [kind, model] : object.items()) {
            const bool is_model = kind.starts_with("Iso3D") || kind.starts_with("Param");
            if (is_model && model.is_object()) add_model(object, kind, model, group);
        }
    }

    void add_model(const Json& object, const std::string& kind, const Json& json,
                   const std::string& group) {
        if (imported.documents.size() >= most_imported) return;
        MathModel model{.kind = kind, .name = group};
        for (const auto& [field, value] : json.items())
            model.fields[field] = texts_of(value);
        if (group.empty() && !model.text("Name", 0).empty()) model.name = model.text("Name", 0);
        model.sliders = sliders_of(object);
        ImportedDocument document = document_of(model);
        if (!group.empty()) document.note(0, "ParIso", tr("its surfaces are opened one by one"));
        for (const auto& [other, value] : object.items()) {
            const bool color = other == "Texture" || other == "Pigment";
            if (color) document.note(0, other, tr("colours by formulas are not taken over"));
            if (other == "Sliders" && value.is_object() && value.contains("SetNames"))
                document.note(0, "Sliders.SetNames",
                              tr("only the first set of positions is taken"));
        }
        imported.documents.push_back(std::move(document));
    }
};

}  // namespace

ReadImport read_mathmod(std::string_view text) {
    const auto strict = strict_json(text);
    if (!strict) return std::unexpected(strict.error());
    Json json;
    try {
        json = Json::parse(*strict);
    } catch (const Json::parse_error& error) {
        const std::size_t at = std::min(error.byte, strict->size());
        const auto lines = std::ranges::count(strict->substr(0, at), '\n') + 1;
        return import_error(static_cast<std::size_t>(lines),
                            tr("it is no JSON, as MathMod writes it"));
    } catch (const Json::out_of_range&) {
        return import_error(0, tr("a number in it is too large"));
    }
    Collection collection;
    collection.add_all(json);
    if (collection.imported.documents.empty())
        return import_error(0, tr("it has no Iso3D or Param3D, as a script of MathMod has"));
    return std::move(collection.imported);
}

}  // namespace zeroset
