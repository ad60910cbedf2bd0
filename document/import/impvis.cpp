#include "document/import/names.hpp"
#include "document/import/readers.hpp"
#include "document/row_program.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <array>
#include <cmath>
#include <map>

// Presets of ImpVis: a table of TOML for each function, with its expression, code of GLSL around
// it, parameters, and a ball or box of some radius. Keys that say how it is drawn have no effect.

namespace zeroset {
namespace {

struct Entry {
    std::string value;
    std::size_t line;
};
using Table = std::map<std::string, Entry, std::less<>>;

struct Preset {
    std::string key;
    std::size_t line;
    Table table = {};
};

/// Reads the part of TOML that presets have: tables, texts of all four kinds, numbers, and lists
/// and inline tables as their text.
class TomlReader {
public:
    explicit TomlReader(std::string_view text) : text_(text) {}

    std::expected<std::vector<Preset>, std::string> run() {
        std::vector<Preset> presets{{.key = {}, .line = 1}};
        while (skip(true), at_ < text_.size()) {
            const std::size_t line = line_;
            if (text_[at_] == '[') {
                ++at_;
                const std::string key = until("]\n");
                if (!take(']')) return import_error(line, tr("a closing bracket is missing"));
                presets.push_back({.key = key, .line = line});
                continue;
            }
            const std::string key = until("=\n");
            if (!take('='))
                return import_error(line, tr("it is no line of TOML, such as key = value"));
            skip(false);
            auto entry = value();
            if (!entry) return std::unexpected(entry.error());
            presets.back().table.insert_or_assign(key, std::move(*entry));
        }
        return presets;
    }

private:
    [[nodiscard]] bool at(std::string_view mark) const {
        return text_.substr(at_).starts_with(mark);
    }

    void pass() {
        if (text_[at_] == '\n') ++line_;
        ++at_;
    }

    void skip(bool lines) {
        while (at_ < text_.size()) {
            if (text_[at_] == '#') {
                while (at_ < text_.size() && text_[at_] != '\n')
                    ++at_;
            } else if (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r' ||
                       (lines && text_[at_] == '\n')) {
                pass();
            } else {
                return;
            }
        }
    }

    std::string until(std::string_view ends) {
        const std::size_t begin = at_;
        at_ = std::min(text_.find_first_of(ends, at_), text_.size());
        return std::string(trimmed(text_.substr(begin, at_ - begin)));
    }

    bool take(char letter) {
        if (at_ >= text_.size() || text_[at_] != letter) return false;
        ++at_;
        return true;
    }

    std::expected<Entry, std::string> value() {
        for (const std::string_view quote : {"'''", R"(""")", "'", R"(")"})
            if (at(quote)) return quoted(quote);
        const std::size_t line = line_;
        int depth = 0;
        std::string result;
        while (at_ < text_.size()) {
            const char letter = text_[at_];
            if (depth == 0 && (letter == '\n' || letter == '#')) break;
            depth += letter == '[' || letter == '{' ? 1 : letter == ']' || letter == '}' ? -1 : 0;
            result += letter;
            pass();
        }
        return Entry{.value = std::string(trimmed(result)), .line = line};
    }

    std::expected<Entry, std::string> quoted(std::string_view quote) {
        const std::size_t line = line_;
        const bool escapes = quote[0] == '"';
        at_ += quote.size();
        if (quote.size() == 3 && at_ < text_.size() && text_[at_] == '\n') pass();
        std::string result;
        while (at_ < text_.size() && !at(quote)) {
            if (quote.size() == 1 && text_[at_] == '\n') break;
            if (escapes && text_[at_] == '\\' && at_ + 1 < text_.size()) {
                pass();
                result += text_[at_] == 'n' ? '\n' : text_[at_] == 't' ? '\t' : text_[at_];
            } else {
                result += text_[at_];
            }
            pass();
        }
        if (!at(quote)) return import_error(line, tr("the end of a text in quotes is missing"));
        at_ += quote.size();
        return Entry{.value = result, .line = line};
    }

    std::string_view text_;
    std::size_t at_ = 0, line_ = 1;
};

/// How ImpVis draws, by keys that no session has.
bool is_of_drawing(std::string_view key) {
    return key.starts_with("isosurface_") || key.starts_with("dvr_") || key.ends_with("_falloff") ||
           key == "max_abs_curvature" || key == "thumbnail" || key == "scale" || key == "comment" ||
           key == "title" || key == "name";
}

class PresetReader {
public:
    explicit PresetReader(const Preset& preset) : preset_(preset) {}

    ImportedDocument run() {
        result_.name = text("name").empty() ? preset_.key : text("name");
        add_parameters();
        add_powers();
        add_code("code_global");
        add_code("code_local");
        add_expression();
        add_bounds();
        for (const auto& [key, entry] : preset_.table) {
            if (!used_.contains(key) && !is_of_drawing(key))
                result_.note(entry.line, key, tr("not taken over"));
        }
        return std::move(result_);
    }

private:
    const Entry* find(const std::string& key) {
        used_.insert(key);
        const auto found = preset_.table.find(key);
        return found == preset_.table.end() ? nullptr : &found->second;
    }

    std::string text(const std::string& key) {
        const Entry* const entry = find(key);
        return entry ? entry->value : std::string();
    }

    /// parameters = [{name = "k", value = 1}, ...]
    void add_parameters() {
        const Entry* const entry = find("parameters");
        if (entry == nullptr) return;
        for (std::string_view part : split(entry->value, '{')) {
            part = part.substr(0, part.find('}'));
            std::string name;
            std::optional<double> value;
            for (const std::string_view field : split(part, ',')) {
                const std::size_t equals = field.find('=');
                if (equals == std::string_view::npos) continue;
                const std::string_view key = trimmed(field.substr(0, equals));
                const std::string_view given = trimmed(field.substr(equals + 1));
                if (key == "name" && given.size() > 2) name = given.substr(1, given.size() - 2);
                if (key == "value") value = number_from<double>(given);
            }
            if (!name.empty()) add_parameter(name, value, entry->line);
        }
    }

    void add_parameter(const std::string& name, std::optional<double> value, std::size_t line) {
        if (!value || !(std::abs(*value) <= largest_number)) {
            result_.note(line, name, tr("its value cannot be read; it is left out"));
        } else if (can_have_slider(name)) {
            Slider slider;
            set_value(slider, *value);
            result_.document.parameters[name] = slider;
        } else {
            result_.add_definition(name + " := " + exact_number(*value), line);
            result_.note(line, name, tr("a constant of the text, without a slider"));
        }
    }

    void add_code(const std::string& key) {
        const Entry* const entry = find(key);
        if (entry == nullptr) return;
        const std::string_view code = trimmed(entry->value);
        if (!code.empty()) result_.add_definition(std::string(code), entry->line);
    }

    /// Powers that ImpVis has for GLSL: mpow2(x) to mpow18(x).
    void add_powers() {
        std::string all;
        for (const char* const key : {"code_global", "code_local", "expression"})
            all += text(key);
        for (int power = 2; power <= 18; ++power) {
            const std::string name = "mpow" + std::to_string(power);
            if (all.contains(name + "("))
                result_.add_definition(name + "(u) = u^" + std::to_string(power), 0);
        }
    }

    void add_expression() {
        const Entry* const entry = find("expression");
        std::string row;
        for (const std::string_view line : split(entry->value, '\n')) {
            if (line.empty()) continue;
            row += (row.empty() ? "" : " ") + std::string(line);
        }
        result_.add_row(row, entry->line);
    }

    void add_bounds() {
        const Entry* const radius = find("bounds_radius");
        const std::string shape = text("bounds_shape");
        const double value = radius ? number_from<double>(radius->value).value_or(0.0) : 0.0;
        if (!(value > 0.0 && value < largest_number)) return;
        result_.document.clip = Box::cube(value);
        result_.tells_box = true;
        if (shape != "box") result_.document.region.ball = Ball{.centre = {}, .radius = value};
    }

    const Preset& preset_;
    std::set<std::string, std::less<>> used_;
    ImportedDocument result_{.name = {}};
};

}  // namespace

ReadImport read_impvis(std::string_view text) {
    const auto presets = TomlReader(text).run();
    if (!presets) return std::unexpected(presets.error());
    Imported imported;
    for (const Preset& preset : *presets) {
        if (preset.table.contains("expression") && imported.documents.size() < most_imported)
            imported.documents.push_back(PresetReader(preset).run());
    }
    if (imported.documents.empty())
        return import_error(0, tr("it has no expression, as presets of ImpVis have"));
    return imported;
}

}  // namespace zeroset
