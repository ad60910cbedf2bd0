#include "app/cli/options/options.hpp"

#include "app/cli/options/surface_options.hpp"
#include "app/cli/options/view_options.hpp"
#include "document/framing.hpp"
#include "document/json/document_json.hpp"
#include "engine/base/text.hpp"
#include "engine/expr/spelling.hpp"
#include "engine/render/tracers.hpp"
#include "pipeline/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace zeroset {
namespace {

/// Applies the view options for clip box, w, camera and region.
std::optional<InputError> take_view(const ViewText& view, Document& document) {
    if (view.box) {
        const auto box = read_box("--box", *view.box);
        if (!box) return box.error();
        document.clip = *box;
        document.camera.reset();  // the old camera was meant for the old box
    }
    if (view.aspect) {
        const auto aspect = read_aspect(*view.aspect);
        if (!aspect) return aspect.error();
        document.aspect = *aspect;
    }
    if (view.w) {
        const auto w = read_number("--w", *view.w);
        if (!w) return w.error();
        set_value(document.w, *w);
    }
    if (view.sphere) document.region.ball.emplace();  // read below; nothing is stretched with it
    if (auto error = take_camera(view, document)) return error;
    const Camera camera = camera_of(document);
    const glm::dvec3 eye = camera.eye / camera.stretch;
    auto region = read_region(view, document.region, eye);
    if (!region) return region.error();
    document.region = std::move(*region);
    if (view.aspect && document.aspect != glm::dvec3(1.0) && document.region.ball)
        return InputError{.reason = "--aspect " + *view.aspect +
                                    ": a sphere is drawn as one; leave out --sphere, or cut by "
                                    "--section"};
    return read_section_looks(view, document.region, document.section_values);
}

/// Whether a reading is `name = NUMBER`; it may be written with signs, as 1/2.
bool says_number(const Reading& reading, const std::string& name) {
    const std::string start = name + " = ";
    if (reading.kind != StatementKind::Value || !reading.text.starts_with(start)) return false;
    return reading.text.find_first_not_of("0123456789.e+-*/^() ", start.size()) ==
           std::string::npos;
}

/// Returns an error for the first value whose parameter the program does not have.
std::optional<InputError> check_parameters(const Program& program,
                                           const ParameterValues& parameters) {
    for (const auto& [name, value] : parameters) {
        if (std::ranges::find(program.parameters, name) != program.parameters.end()) continue;
        const bool is_constant = std::ranges::any_of(
            program.readings, [&](const Reading& reading) { return says_number(reading, name); });
        if (is_constant) {
            return InputError{.reason = "--set " + name + ": " + name +
                                        " is a constant of the formula, which has its value "
                                        "there; leave that out to set it here"};
        }
        std::string known = "the formula has none";
        if (!program.parameters.empty()) {
            known = "the formula's are";
            for (const std::string& parameter : program.parameters)
                known += " " + parameter;
        }
        return InputError{.reason = "--set " + name + ": there is no such parameter; " + known};
    }
    return std::nullopt;
}

/// Applies --set to the sliders.
std::optional<InputError> take_parameters(const ViewText& view, InputDocument& input) {
    const auto values = read_parameters(view.set);
    if (!values) return values.error();
    if (input.rows) {
        if (auto unknown = check_parameters(*input.rows->program, *values)) return unknown;
    }
    for (const auto& [name, value] : *values) {
        Slider slider = slider_of(input.document, name);
        set_value(slider, value);
        input.document.parameters[name] = slider;
    }
    return std::nullopt;
}

/// Applies the options for colours, markers and single surfaces.
std::optional<InputError> take_appearance(const ViewText& view, InputDocument& input) {
    Document& document = input.document;
    if (auto error = read_look(view.look, document.coloring, document.markers)) return error;
    const auto choices = read_surface_choices(view.surfaces);
    if (!choices) return choices.error();
    if (!input.rows) return std::nullopt;
    if (auto missing = check_surface_choices(*input.rows->program, *choices)) return missing;
    take_surface_choices(*choices, input.rows->surface_rows, document);
    if (!choices->boxes.empty()) {
        auto rows = read_rows(document);
        if (!rows) return InputError{.reason = "--surface-box: " + rows.error().reason};
        input.rows = std::move(*rows);
    }
    if (const auto wrong = check_contours(*input.rows, document.coloring.lines))
        return contours_error(*wrong);
    const auto wrong = check_coloring(*input.rows, document.coloring);
    return wrong ? std::optional(color_by_error(*wrong)) : std::nullopt;
}

/// Reads the value of --axis-names.
std::optional<InputError> take_axis_names(const std::string& text, Document& document) {
    const std::vector<std::string_view> names = split(text, ',');
    const bool fit = std::ranges::all_of(
        names, [](std::string_view name) { return name.size() <= longest_label; });
    if (names.size() != document.axis_names.size() || !fit) {
        return InputError{.reason = "--axis-names " + text + ": type three names of at most " +
                                    std::to_string(longest_label) +
                                    " bytes each, such as u,v,height; one may be empty"};
    }
    std::ranges::copy(names, document.axis_names.begin());
    return std::nullopt;
}

}  // namespace

OrInputError<std::vector<double>> read_numbers(const std::string& option, const std::string& text,
                                               std::size_t count) {
    const std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() != count) {
        return wrong_input(option + " " + text + ": " + std::to_string(count) +
                           (count == 1 ? " number is" : " numbers separated by commas are") +
                           " needed, not " + std::to_string(parts.size()));
    }
    std::vector<double> values;
    for (const std::string_view part : parts) {
        const std::optional<double> value = number_from<double>(part);
        if (!value || !std::isfinite(*value)) {
            return wrong_input(option + " " + text + ": " + quoted(part, part.size()) +
                               " is not a finite number");
        }
        values.push_back(*value);
    }
    return values;
}

std::optional<std::string> value_behind(std::string_view text, std::string_view word) {
    if (!text.starts_with(word)) return std::nullopt;
    const std::string_view rest = text.substr(word.size());
    if (rest.empty() || (rest.front() != ' ' && rest.front() != '=')) return std::nullopt;
    return std::string(trimmed(rest.substr(1)));
}

OrInputError<double> read_number(const std::string& option, const std::string& text) {
    const auto numbers = read_numbers(option, text, 1);
    if (!numbers) return std::unexpected(numbers.error());
    return numbers->front();
}

OrInputError<int> read_integer(const std::string& option, const std::string& text, int lowest,
                               int highest) {
    const std::optional<int> value = number_from<int>(trimmed(text));
    if (!value || *value < lowest || *value > highest) {
        return wrong_input(option + " " + text + ": type a whole number from " +
                           std::to_string(lowest) + " to " + std::to_string(highest));
    }
    return *value;
}

OrInputError<double> read_budget(const std::optional<std::string>& text) {
    if (!text) return default_budget_s;
    const auto seconds = read_number("--budget", *text);
    if (seconds && !(*seconds >= 1e-3 && *seconds <= 1e6))
        return wrong_input("--budget " + *text + ": type a number of seconds from 0.001 to 1e6");
    return seconds;
}

OrInputError<int> read_repeats(const std::optional<std::string>& text, int usual) {
    return text ? read_integer("--repeat", *text, 1, 10'000) : usual;
}

OrInputError<Size> read_size(const std::string& option, const std::string& text,
                             const SizeLimits& limits) {
    const auto [largest_side, most_pixels] = limits;
    const std::vector<std::string_view> parts = split(text, 'x');
    const std::optional<int> width = number_from<int>(parts.front());
    const std::optional<int> height = number_from<int>(parts.back());
    if (parts.size() > 2 || !width || !height) {
        return wrong_input(option + " " + text + ": type WIDTHxHEIGHT, for example 1024x768");
    }
    if (*width < 1 || *height < 1 || *width > largest_side || *height > largest_side) {
        return wrong_input(option + " " + text + ": each side must be from 1 to " +
                           std::to_string(largest_side) + " pixels");
    }
    if (static_cast<long long>(*width) * *height > most_pixels) {
        return wrong_input(option + " " + text + ": more than 100 million pixels");
    }
    return Size{.width = *width, .height = *height};
}

namespace {

/// Says on stderr what of a typed text was read in an unusual way.
void tell_notes(const InputDocument& input) {
    if (!input.rows || !input.typed) return;
    std::set<std::string> told;
    for (const Reading& reading : input.rows->program->readings) {
        for (const std::string& note : reading.notes) {
            if (told.insert(note).second) std::cerr << "zeroset: note: " << printable(note) << "\n";
        }
    }
}

/// Says on stderr that axes are drawn at scales of their own, or that a thin clip box is drawn so.
void tell_scales(const Document& document) {
    constexpr double most = 10.0;
    const glm::dvec3 stretch = stretch_of(document);
    const glm::dvec3 sides = stretch * (document.clip.hi - document.clip.lo);
    const auto [least, longest] = std::minmax({sides.x, sides.y, sides.z});
    if (longest > most * least) {
        std::cerr << "zeroset: note: the clip box is drawn " << short_number(longest / least, 3)
                  << " times as long as it is thin: what is in it may be too thin to see; "
                     "--aspect 1:1:0.01 draws z a hundredth as long\n";
    } else if (!document.aspect && stretch != glm::dvec3(1.0)) {
        std::cerr << "zeroset: note: pictures show one unit along x, y and z as "
                  << short_number(stretch.x) << ":" << short_number(stretch.y) << ":"
                  << short_number(stretch.z)
                  << " lengths, as the edges of the clip box are very unequal; --aspect 1:1:1 "
                     "shows them alike\n";
    }
}

}  // namespace

OrInputError<InputDocument> read_document(const std::string& equation, const ViewText& view,
                                          const std::shared_ptr<FileAccess>& access) {
    auto input = stored_document(equation, access);
    if (!input) return input;
    if (!view.quiet) tell_notes(*input);
    if (auto error = take_view(view, input->document)) return std::unexpected(*error);
    if (!view.quiet && (input->typed || view.box)) tell_scales(input->document);
    if (input->path.empty()) input->document.home = input->document.camera;
    // An unreadable text is reported before options that do not fit it.
    if (!input->rows && input->path.empty()) return input;
    if (auto error = take_parameters(view, *input)) return std::unexpected(*error);
    if (auto error = take_appearance(view, *input)) return std::unexpected(*error);
    return input;
}

OrInputError<InputDocument> read_document_with_rows(const std::string& equation,
                                                    const ViewText& view) {
    auto input = read_document(equation, view);
    if (input && !input->rows) return std::unexpected(input->rows.error());
    return input;
}

OrInputError<ParameterValues> read_parameters(const std::vector<std::string>& texts) {
    ParameterValues values;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        const std::string name(trimmed(std::string_view(text).substr(0, equals)));
        if (equals == std::string::npos || name.empty()) {
            return wrong_input("--set " + text + ": type NAME=VALUE, for example --set a=2");
        }
        const auto value = number_from<double>(trimmed(std::string_view(text).substr(equals + 1)));
        if (!value || !std::isfinite(*value)) {
            return wrong_input("--set " + text +
                               ": type a finite number behind the =, for example " + name + "=0.5");
        }
        if (std::abs(*value) > 1e30)
            return wrong_input("--set " + text + ": stay between -1e30 and 1e30");
        values[name] = *value;
    }
    return values;
}

OrInputError<Antialias> read_antialias(const std::string& text) {
    const auto antialias = antialias_named(text);
    if (!antialias) return wrong_input("--aa " + text + ": type iaa, none, 4, 9, 16 or 64");
    return *antialias;
}

std::optional<InputError> take_look(const TraceText& text, Document& document) {
    if (text.aa) {
        const auto antialias = read_antialias(*text.aa);
        if (!antialias) return antialias.error();
        document.antialias = *antialias;
    } else if (text.antialias) {
        document.antialias = smooth_edges(*text.antialias);
    }
    if (auto wrong = take_light(text.light, document.light)) return wrong;
    document.shadows = text.shadows.value_or(document.shadows);
    document.jumps = text.jumps.value_or(document.jumps);
    document.axes = text.axes.value_or(text.textbook.value_or(document.axes));
    document.clip_box = text.clip_box.value_or(text.textbook.value_or(document.clip_box));
    document.grid = text.grid.value_or(text.textbook.value_or(document.grid));
    return text.axis_names ? take_axis_names(*text.axis_names, document) : std::nullopt;
}

std::optional<InputError> check_jumps(const Document& document, const TraceSettings& settings) {
    if (!document.jumps || find_tracer(settings.tracer)->finds_jumps) return std::nullopt;
    return InputError{.reason = "--jumps: only the tracer " + std::string(usual_tracer().name) +
                                " finds jumps; leave out --tracer " + settings.tracer};
}

OrInputError<TraceSettings> read_trace_settings(const TraceText& text) {
    TraceSettings settings;
    if (text.tracer) {
        if (find_tracer(*text.tracer) == nullptr) {
            std::string names;
            for (const Tracer& tracer : tracers())
                names += " " + std::string(tracer.name);
            return wrong_input("--tracer " + *text.tracer +
                               ": there is no such tracer; type one of:" + names);
        }
        settings.tracer = *text.tracer;
    }
    if (text.d_stop) {
        const auto depth = read_integer("--dstop", *text.d_stop, 1, max_d_stop);
        if (!depth) return std::unexpected(depth.error());
        settings.stop = {.rule = StopRule::DStop, .value = static_cast<double>(*depth)};
    }
    for (const auto& [option, typed, rule] :
         {std::tuple{"--epsilon", &text.epsilon, StopRule::Epsilon},
          std::tuple{"--delta", &text.delta, StopRule::Delta}}) {
        if (!*typed) continue;
        const auto value = read_number(option, **typed);
        if (!value) return std::unexpected(value.error());
        if (!(*value > 0))
            return wrong_input(std::string(option) + " " + **typed + ": must be above 0");
        settings.stop = {.rule = rule, .value = *value};
    }
    if (text.levels) {
        constexpr int min_levels = 10;
        const int max_levels = find_tracer(settings.tracer)->needs.levels;
        if (max_levels == 0) {
            return wrong_input("--levels " + *text.levels + ": the tracer " + settings.tracer +
                               " has none; type --dstop, or add --tracer octree");
        }
        const auto levels = read_integer("--levels", *text.levels, min_levels, max_levels);
        if (!levels) return std::unexpected(levels.error());
        settings.stop = {.rule = StopRule::DStop, .value = static_cast<double>(*levels)};
    }
    if (text.threads) {
        const auto threads = read_integer("--threads", *text.threads, 1, 1024);
        if (!threads) return std::unexpected(threads.error());
        settings.threads = *threads;
    }
    return settings;
}

}  // namespace zeroset
