#include "app/cli/options/view_options.hpp"
#include "engine/image/color_map.hpp"

#include <string>

namespace zeroset {
namespace {

std::optional<InputError> read_shows(const std::string& text, Region& region) {
    const bool cap = text == "cap" || text == "values-in-cap";
    const bool values = text == "values" || text == "values-in-cap";
    if (!cap && !values && text != "nothing") {
        return InputError{.reason = "--section-shows " + text +
                                    ": type cap, values, values-in-cap or nothing"};
    }
    if (region.sections.empty()) {
        return InputError{.reason = "--section-shows " + text +
                                    ": there is no section; add one, such as --section x=0"};
    }
    for (Section& section : region.sections) {
        section.cap = cap;
        section.values = values;
    }
    return std::nullopt;
}

std::optional<InputError> read_map(const std::string& text, SectionChoice& choice) {
    const auto map = color_map_named(text);
    if (!map) {
        std::string names;
        for (const ColorMap known : color_maps())
            names += " " + std::string(name_of(known));
        return InputError{.reason = "--section-map " + text +
                                    ": there is no such map; type one of:" + names};
    }
    choice.map = *map == ColorMap::Gray ? std::nullopt : map;
    return std::nullopt;
}

std::optional<InputError> read_range(const std::string& text, SectionChoice& choice) {
    choice.range.reset();
    if (text == "auto") return std::nullopt;
    const auto numbers = read_numbers("--section-range", text, 2);
    if (!numbers) return numbers.error();
    const ValueRange range{.lo = (*numbers)[0], .hi = (*numbers)[1]};
    if (!(range.lo < range.hi)) {
        return InputError{.reason = "--section-range " + text +
                                    ": the first number must be below the second, for example 0,1"};
    }
    choice.range = range;
    return std::nullopt;
}

}  // namespace

std::optional<InputError> read_section_looks(const ViewText& view, Region& region,
                                             SectionChoice& values) {
    if (view.section_shows) {
        if (auto error = read_shows(*view.section_shows, region)) return error;
    }
    if (view.section_map) {
        if (auto error = read_map(*view.section_map, values)) return error;
    }
    return view.section_range ? read_range(*view.section_range, values) : std::nullopt;
}

}  // namespace zeroset
