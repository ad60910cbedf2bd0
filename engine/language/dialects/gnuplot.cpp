#include "engine/language/dialects/gnuplot.hpp"

#include "engine/base/text.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace zeroset {
namespace {

using Words = std::string_view;

/// Takes [x=-1:1][-1:1] off the front of a text.
AskedBox take_bracket_ranges(Words& text) {
    AskedBox box;
    for (std::size_t k = 0; k < box.size() && text.starts_with('['); ++k) {
        const auto closer = closing_bracket(text);
        if (!closer) break;
        const Words inside = text.substr(1, *closer - 1);
        const std::size_t equals = inside.find('=');
        const auto ends = split_outside(inside.substr(equals == Words::npos ? 0 : equals + 1), ':');
        if (ends.size() == 2 && !ends[0].empty() && !ends[1].empty())
            box.at(k) = AskedRange{.lo = std::string(ends[0]), .hi = std::string(ends[1])};
        text = trimmed(text.substr(*closer + 1));
    }
    return box;
}

/// The range of "set urange [a:b]" in a text.
std::optional<AskedRange> setting_in(Words typed, Words setting) {
    const std::size_t at = typed.find(setting);
    if (at == Words::npos) return std::nullopt;
    Words ends = trimmed(typed.substr(at + setting.size()));
    return take_bracket_ranges(ends)[0];
}

/// A formula without what tells how it looks.
Words formula_of(Words part) {
    for (const Words word : {"with", "w", "title", "notitle", "lc", "lt", "ls", "palette"})
        part = trimmed(part.substr(0, std::min(find_outside(part, word), part.size())));
    return part;
}

bool is_parametric(Words typed) {
    return typed.contains("set param") && !typed.contains("unset param");
}

void write_points(const std::vector<Words>& formulas, AskedBox ranges, ExpressionWriter& writer) {
    const Words typed = writer.text().typed();
    constexpr std::array<Words, 2> settings{"set urange", "set vrange"};
    for (std::size_t k = 0; k < settings.size(); ++k) {
        if (!ranges.at(k)) ranges.at(k) = setting_in(typed, settings.at(k));
        if (!ranges.at(k)) ranges.at(k) = AskedRange{.lo = "-5", .hi = "5"};
    }
    for (std::size_t i = 0; i + 2 < formulas.size(); i += 3) {
        writer.put(i == 0 ? "(" : "; (", formulas[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            if (k > 0) writer.put(", ", formulas[i + k]);
            writer.write(formulas[i + k]);
        }
        writer.put(")", formulas[i]);
        writer.put(", " + ranges[0]->lo + " < u < " + ranges[0]->hi, formulas[i]);
        writer.put(", " + ranges[1]->lo + " < v < " + ranges[1]->hi, formulas[i]);
    }
}

}  // namespace

AskedBox write_splot(std::string_view row, ExpressionWriter& writer) {
    Words rest = trimmed(row.substr(row.find(' ')));
    AskedBox box = take_bracket_ranges(rest);
    std::vector<Words> formulas;
    for (const Words part : split_outside(rest, ','))
        formulas.push_back(formula_of(part));
    const Words typed = writer.text().typed();
    if (is_parametric(typed)) {
        write_points(formulas, box, writer);
        box = {};
    } else {
        for (std::size_t i = 0; i < formulas.size(); ++i) {
            writer.put(i == 0 ? "z = " : "; z = ", formulas[i]);
            writer.write(formulas[i]);
        }
        constexpr std::array<Words, 3> settings{"set xrange", "set yrange", "set zrange"};
        for (std::size_t k = 0; k < box.size(); ++k) {
            if (!box.at(k)) box.at(k) = setting_in(typed, settings.at(k));
            if (!box.at(k) && k < 2) box.at(k) = AskedRange{.lo = "-10", .hi = "10"};
        }
    }
    writer.put(";", row.substr(row.size()));
    return box;
}

}  // namespace zeroset
