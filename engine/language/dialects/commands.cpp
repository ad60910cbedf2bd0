#include "engine/language/dialects/commands.hpp"

#include "engine/base/text.hpp"
#include "engine/language/dialects/command_arguments.hpp"
#include "engine/language/dialects/command_table.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

namespace zeroset {
namespace {

using Words = std::string_view;
using Parts = std::span<const Words>;

/// The command that a text begins with, and its arguments; nothing where it is no command.
std::optional<CommandCall> command_in(Words text) {
    const std::size_t length = word_length(text);
    const auto inside = known_command(text.substr(0, length)) == nullptr
                            ? std::nullopt
                            : in_brackets(text.substr(length));
    if (!inside) return std::nullopt;
    return CommandCall{.name = text.substr(0, length), .arguments = arguments_in(*inside)};
}

/// The arguments of a command that shows others, which may be in a list.
std::vector<Words> shown_by(const CommandCall& call) {
    const auto list = call.arguments.empty() ? std::nullopt : in_brackets(call.arguments[0]);
    return list ? split_outside(*list, ',') : call.arguments;
}

/// Writes the rows of one command.
class CommandWriter {
public:
    CommandWriter(const CommandCall& call, ExpressionWriter& rows)
        : call_(call), rows_(rows), all_(call.arguments) {}

    std::optional<CommandOutcome> write() {
        const bool has_gap = std::ranges::any_of(all_, &Words::empty);
        if (all_.empty() || has_gap || !written(known_command(call_.name)->draws))
            return std::nullopt;
        const bool has_other = !behind_.coordinates.empty() && !is_spherical_;
        if (has_other && lower_case(behind_.coordinates) != "cartesian") return std::nullopt;
        outcome_.left_out = std::move(behind_.left_out);
        return std::move(outcome_);
    }

private:
    bool written(Draws draws) {
        switch (draws) {
            case Draws::Equations: return take(ranges_and_options(from(1))) && equations();
            case Draws::Heights: return take(ranges_and_options(from(1))) && heights(all_[0]);
            case Draws::Points: return take(ranges_and_options(from(1))) && points();
            case Draws::ThreeParts: return take(ranges_and_options(from(3))) && first_three();
            case Draws::Spherical: return take(ranges_and_options(from(1))) && spherical(1, 0);
            case Draws::AroundFirst: return take(ranges_and_options(from(1))) && spherical(0, 1);
            case Draws::Turned: return take(ranges_and_options(from(1))) && turned();
            case Draws::Listed: return listed();
            case Draws::FlatZeros: return take(flat_ranges(from(1))) && equations();
            case Draws::FlatHeights: return take(flat_ranges(from(1))) && heights(all_[0]);
            case Draws::Zeros: return zeros();
            case Draws::Sheet: return sheet();
            case Draws::Track: return functions(1);
            case Draws::Commands: return commands();
        }
        return false;
    }

    /// The arguments from `first` on.
    [[nodiscard]] Parts from(std::size_t first) const {
        return Parts(all_).subspan(std::min(first, all_.size()));
    }
    /// Keeps what stands behind the formulas; false: it was not understood.
    bool take(std::optional<CommandArguments> behind) {
        if (behind) behind_ = std::move(*behind);
        return behind.has_value();
    }

    bool listed() {
        const auto inside = in_brackets(all_[0]);
        if (!inside) return take(flat_ranges(from(3))) && first_three();
        return take(flat_ranges(from(1))) && point(split_outside(*inside, ','));
    }
    bool zeros() {
        const auto function = unnamed_function(all_[0]);
        const Parts names = function ? Parts(function->names) : Parts(axis_names);
        return names.size() == 3 && take(interval_ranges(intervals(1), names)) && equations();
    }
    bool sheet() {
        const bool has_three =
            all_.size() >= 3 && (unnamed_function(all_[2]) || rows_.is_function(all_[2]));
        if (has_three) return functions(2);
        if (all_.size() >= 3 && in_quotes(all_[0]) && in_quotes(all_[1])) return false;
        const auto function = unnamed_function(all_[0]);
        const Parts names = function ? Parts(function->names) : Parts(axis_names).first(2);
        if (names.size() != 2 || !take(interval_ranges(intervals(1), names))) return false;
        return heights(function ? function->body : in_quotes(all_[0]).value_or(all_[0]));
    }

    /// The arguments from `first` on; the name of an interval is its value: ends = [-1 1].
    std::vector<Words> intervals(std::size_t first) {
        std::vector<Words> arguments(
            all_.begin() + static_cast<std::ptrdiff_t>(std::min(first, all_.size())), all_.end());
        if (!arguments.empty() && is_word(arguments[0])) {
            if (const Words value = rows_.value_of(arguments[0]); !value.empty())
                arguments[0] = value;
        }
        return arguments;
    }

    /// Adds words and parts of the typed text.
    void add(std::initializer_list<Words> parts) {
        for (const Words part : parts) {
            if (rows_.text().is_part(part))
                rows_.write(part);
            else
                rows_.put(part, call_.name);
        }
    }
    void begin_row() {
        if (row_count_++ > 0) add({"; "});
    }
    void add_ranges() {
        for (const NamedRange& range : behind_.ranges)
            add({", ", range.lo, " < ", range.name, " < ", range.hi});
    }
    /// Makes ranges of x, y and z the box. False: other variables have ranges, or not all.
    bool take_box() {
        for (const NamedRange& range : behind_.ranges) {
            const auto axis = static_cast<std::size_t>(std::ranges::find(axis_names, range.name) -
                                                       axis_names.begin());
            if (axis == axis_names.size()) return false;
            outcome_.box.at(axis) =
                AskedRange{.lo = rows_.words_of(range.lo), .hi = rows_.words_of(range.hi)};
        }
        return true;
    }
    /// Lets the variables of three ranges that are not called x, y and z be those that are left.
    void rename() {
        std::vector<Words> left(axis_names.begin(), axis_names.end());
        for (const NamedRange& range : behind_.ranges)
            std::erase(left, range.name);
        for (NamedRange& range : behind_.ranges) {
            const bool is_axis = std::ranges::find(axis_names, range.name) != axis_names.end();
            if (is_axis || left.empty()) continue;
            add({range.name, " := ", left.front(), "; "});
            range.name = left.front();
            left.erase(left.begin());
        }
    }

    bool equations() {
        if (behind_.ranges.size() == 3) rename();
        if (!take_box()) return false;
        if (const auto table = table_in(all_[0])) {
            for (const Table::Term& term : table->terms)
                rows_.with_term(term, [&] { equation(table->body); });
            return true;
        }
        const auto list = in_brackets(all_[0]);
        const bool is_list = list && !all_[0].starts_with('(');
        for (const Words value : is_list ? split_outside(*list, ',') : std::vector{all_[0]})
            equation(value);
        return true;
    }
    /// Writes f, or a = b, or f at each of the levels.
    void equation(Words value) {
        const auto unnamed = unnamed_function(value);
        const Words f = unnamed ? unnamed->body : value;
        const Words call = is_word(f) && rows_.is_function(f) ? "(x, y, z)" : "";
        const bool has_levels = !behind_.levels.empty() && !f.contains("==");
        if (!has_levels) {
            begin_row();
            add_equation(f, call);
            add_condition();
        }
        for (std::size_t i = 0; has_levels && i < behind_.levels.size(); ++i) {
            begin_row();
            add({"(", f, call, ") = ", behind_.levels[i]});
            add_condition();
        }
    }
    /// Writes a = b so that it is no definition of a.
    void add_equation(Words f, Words call) {
        const std::size_t equals = find_outside(f, "==");
        const Words left = trimmed(f.substr(0, std::min(equals, f.size())));
        const bool defines = equals != Words::npos && is_word(left) &&
                             std::ranges::find(axis_names, left) == axis_names.end();
        if (defines)
            add({"(", f.substr(equals + 2), ") - (", left, ") = 0"});
        else
            add({f, call});
    }
    void add_condition() {
        if (behind_.condition) add({", ", behind_.condition->body});
    }

    /// Writes heights over the ranges of two variables, or a point of three.
    bool heights(Words all) {
        const std::string coordinates = lower_case(behind_.coordinates);
        is_spherical_ = coordinates == "spherical";
        if (is_spherical_) return spherical(0, 1);
        if (behind_.ranges.size() != 2) return false;
        const auto list = in_brackets(all);
        const auto values =
            list && !all.starts_with('(') ? split_outside(*list, ',') : std::vector{all};
        const Words a = behind_.ranges[0].name;
        const Words b = behind_.ranges[1].name;
        const bool over_axes = (a == "x" && b == "y") || (a == "y" && b == "x");
        // In Mathematica a list holds heights.
        if (values.size() == 3 && (!over_axes || call_.name != "Plot3D")) return point(values);
        for (const Words value : values) {
            begin_row();
            if (over_axes) {
                add({"z = ", value, is_word(value) && rows_.is_function(value) ? "(x, y)" : ""});
                add_condition();
            } else {
                add({"(", a, ", ", b, ", ", value, ")"});
                add_ranges();
            }
        }
        return !over_axes || take_box();
    }

    bool first_three() { return all_.size() >= 3 && point(Parts(all_).first(3)); }
    /// Writes a point of three numbers over the ranges.
    bool point(Parts numbers) {
        const std::size_t count = behind_.ranges.size();
        if (numbers.size() != 3 || count == 0 || count > 2) return false;
        begin_row();
        rename_parameters();
        add({"(", numbers[0], ", ", numbers[1], ", ", numbers[2], ")"});
        add_ranges();
        rows_.rename({});
        return true;
    }
    /// Gives parameters that are called x, y or z other names.
    void rename_parameters() {
        std::vector<std::pair<Words, Words>> names;
        for (std::size_t i = 0; i < behind_.ranges.size(); ++i) {
            const Words name = behind_.ranges[i].name;
            if (std::ranges::find(axis_names, name) != axis_names.end())
                names.emplace_back(name, i == 0 ? "u" : "v");
        }
        rows_.rename(std::move(names));
    }
    /// Writes a point in brackets or by its name, or a list of such.
    bool points() {
        const auto inside = in_brackets(all_[0]);
        if (!inside) {
            begin_row();
            add({all_[0]});
            add_ranges();
            return !behind_.ranges.empty() && behind_.ranges.size() <= 2;
        }
        const auto parts = split_outside(*inside, ',');
        if (parts.size() > 3 && behind_.ranges.empty()) {  // Maple's [x, y, z, t = 0..1]
            auto behind = ranges_and_options(Parts(parts).subspan(3));
            if (!behind) return false;
            behind_ = std::move(*behind);
            return point(Parts(parts).first(3));
        }
        if (!in_brackets(parts[0])) return point(parts);
        return std::ranges::all_of(parts, [&](Words part) {
            const auto of = in_brackets(part);
            return of && point(split_outside(*of, ','));
        });
    }
    /// Writes a point at a distance over two angles: the one around the z axis, and the one from
    /// it.
    bool spherical(std::size_t around, std::size_t tilted) {
        if (behind_.ranges.size() != 2 || in_brackets(all_[0])) return false;
        const Words turn = behind_.ranges[around].name;
        const Words tilt = behind_.ranges[tilted].name;
        const Words r = all_[0];
        begin_row();
        rename_parameters();
        add({"((", r, ")*sin(", tilt, ")*cos(", turn, "), (", r, ")*sin(", tilt, ")*sin(", turn,
             "), (", r, ")*cos(", tilt, "))"});
        add_ranges();
        rows_.rename({});
        return true;
    }
    /// Writes a height over the distance from the z axis, or a distance and a height, turned around
    /// it.
    bool turned() {
        const std::size_t count = behind_.ranges.size();
        if (count == 0 || count > 2) return false;
        const Words own = behind_.ranges[0].name;
        const auto list = in_brackets(all_[0]);
        const auto parts = list ? split_outside(*list, ',') : std::vector{own, all_[0]};
        if (parts.size() != 2) return false;
        const Words turn = count == 2 ? behind_.ranges[1].name : own == "s" ? Words("t") : "s";
        begin_row();
        rename_parameters();
        add({"((", parts[0], ")*cos(", turn, "), (", parts[0], ")*sin(", turn, "), ", parts[1],
             ")"});
        add_ranges();
        if (count == 1) add({", 0 < ", turn, " < 2 pi"});
        rows_.rename({});
        return true;
    }
    /// Writes three functions, without a name or by their names, as a point over their variables.
    bool functions(std::size_t variables) {
        if (all_.size() < 3) return false;
        std::vector<Words> names;
        for (const Words argument : Parts(all_).first(3)) {
            const auto function = unnamed_function(argument);
            if (!function && !rows_.is_function(argument)) return false;
            if (!function) continue;
            if (!names.empty() && function->names != names) return false;
            names = function->names;
        }
        if (names.empty()) names = {variables == 1 ? "t" : "u", "v"};
        names.resize(std::min(names.size(), variables));
        if (names.size() != variables || !take(interval_ranges(intervals(3), names))) return false;
        begin_row();
        for (std::size_t i = 0; i < 3; ++i) {
            add({i == 0 ? "(" : ", "});
            add_value(all_[i], names);
        }
        add({")"});
        add_ranges();
        return true;
    }
    /// Writes the body of a function, or a call of one by its name.
    void add_value(Words function, const std::vector<Words>& names) {
        if (const auto unnamed = unnamed_function(function)) return add({unnamed->body});
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (i == 0) add({function, "("});
            if (i > 0) add({", "});
            add({names[i]});
        }
        add({")"});
    }

    /// Writes the commands among the arguments; others are options.
    bool commands() {
        for (const Words argument : shown_by(call_)) {
            const auto inner = command_in(argument);
            if (!inner) {
                const std::size_t name = word_length(argument);
                behind_.left_out.push_back(argument.substr(0, name > 0 ? name : Words::npos));
                continue;
            }
            begin_row();
            const auto outcome = write_command(*inner, rows_);
            if (!outcome) return false;
            std::ranges::copy(outcome->left_out, std::back_inserter(behind_.left_out));
            for (std::size_t k = 0; k < outcome->box.size(); ++k) {
                if (outcome->box.at(k)) outcome_.box.at(k) = outcome->box.at(k);
            }
        }
        return row_count_ > 0;
    }

    const CommandCall& call_;
    ExpressionWriter& rows_;
    std::vector<Words> all_;   ///< the arguments
    CommandArguments behind_;  ///< what stands behind the formulas
    CommandOutcome outcome_;
    bool is_spherical_ = false;  ///< the coordinates that were asked for
    int row_count_ = 0;
};

}  // namespace

bool is_command(const CommandCall& call) {
    const KnownCommand* const known = known_command(call.name);
    if (known == nullptr || known->draws != Draws::Commands) return known != nullptr;
    return std::ranges::any_of(shown_by(call),
                               [](Words argument) { return command_in(argument).has_value(); });
}

std::string_view program_of_command(std::string_view name) { return known_command(name)->program; }

std::optional<CommandOutcome> write_command(const CommandCall& call, ExpressionWriter& rows) {
    return CommandWriter(call, rows).write();
}

}  // namespace zeroset
