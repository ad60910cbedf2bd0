#include "app/cli/film_options.hpp"

#include "app/cli/options/option_reader.hpp"
#include "app/cli/options/view_options.hpp"
#include "document/camera_text.hpp"
#include "document/framing.hpp"
#include "document/views.hpp"
#include "engine/base/enum_names.hpp"
#include "engine/base/text.hpp"
#include "pipeline/plans/export_formats.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace zeroset {
namespace {

constexpr int most_frames = 100'000;
constexpr double usual_seconds = 6.0;
constexpr double longest_seconds = 86'400.0;
constexpr int most_blur = 64;

constexpr auto end_names = enum_names<FilmEnd>("stop", "loop", "bounce");
constexpr auto easing_names = enum_names<Easing>("linear", "smooth");

bool is_gif(const FilmCommand& command) {
    const FilmFormat* const format = film_format_of(command.output);
    return format != nullptr && format->codec == FilmCodec::Gif;
}

OrInputError<FrameRate> read_rate(const FilmCommand& command) {
    if (!command.fps) return FrameRate{.frames = is_gif(command) ? 25 : 30};
    const auto parts = split(*command.fps, '/');
    const std::string option = "--fps " + *command.fps;
    if (parts.size() > 2) return wrong_input(option + ": type N or N/D, such as 30000/1001");
    const auto frames = read_integer(option, std::string(parts.front()), 1, 240'000);
    if (!frames) return std::unexpected(frames.error());
    FrameRate rate{.frames = *frames};
    if (parts.size() == 2) {
        const auto seconds = read_integer(option, std::string(parts.back()), 1, 1001);
        if (!seconds) return std::unexpected(seconds.error());
        rate.seconds = *seconds;
    }
    if (rate.frames > 240 * rate.seconds)
        return wrong_input(option + ": at most 240 frames a second");
    return rate;
}

/// The two numbers of "A..B"; nothing where the text has another form.
std::optional<std::pair<std::string, std::string>> ends_of(std::string_view text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return std::nullopt;
    return std::pair(std::string(trimmed(text.substr(0, dots))),
                     std::string(trimmed(text.substr(dots + 2))));
}

OrInputError<int> read_frame_count(const FilmCommand& command, const FrameRate& rate) {
    if (command.frames && !ends_of(*command.frames)) {
        if (command.seconds)
            return wrong_input("--frames " + *command.frames + ": not together with --seconds");
        return read_integer("--frames", *command.frames, 1, most_frames);
    }
    double seconds = usual_seconds;
    if (command.seconds) {
        const auto number = read_number("--seconds", *command.seconds);
        if (!number) return std::unexpected(number.error());
        seconds = *number;
    }
    if (!(seconds > 0 && seconds <= longest_seconds))
        return wrong_input("--seconds " + command.seconds.value_or("") +
                           ": type more than 0, at most 86400");
    const double frames = std::round(seconds * rate.frames / rate.seconds);
    if (frames > most_frames)
        return wrong_input("--seconds: more than " + std::to_string(most_frames) + " frames");
    return std::max(1, static_cast<int>(frames));
}

OrInputError<glm::dvec3> read_axis(const std::string& text) {
    if (text == "x") return glm::dvec3(1, 0, 0);
    if (text == "y") return glm::dvec3(0, 1, 0);
    if (text == "z") return glm::dvec3(0, 0, 1);
    const auto numbers = read_numbers("--axis", text, 3);
    if (!numbers) return std::unexpected(numbers.error());
    const glm::dvec3 axis((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    if (glm::length(axis) == 0)
        return wrong_input("--axis " + text + ": the axis has no direction");
    return axis;
}

std::optional<InputError> read_turn(const FilmCommand& command, const Document& document,
                                    FilmPlan& plan) {
    if (!command.turntable && !command.turn) {
        if (command.axis)
            return InputError{.reason = "--axis " + *command.axis + ": only with --turn"};
        return std::nullopt;
    }
    CameraTurn turn{.axis = document.up};
    if (command.turn) {
        const auto degrees = read_number("--turn", *command.turn);
        if (!degrees) return degrees.error();
        turn.degrees = *degrees;
    }
    if (command.axis) {
        const auto axis = read_axis(*command.axis);
        if (!axis) return axis.error();
        turn.axis = *axis;
    }
    plan.turn = turn;
    return std::nullopt;
}

OrInputError<Sweep> read_sweep(const std::string& text, const InputDocument& document) {
    const std::string option = "--sweep " + text;
    const std::size_t equals = text.find('=');
    const auto ends = equals == std::string::npos ? std::nullopt : ends_of(text.substr(equals + 1));
    if (!ends) return wrong_input(option + ": type NAME=FROM..TO, for example a=0..2");
    Sweep sweep{.name = std::string(trimmed(text.substr(0, equals)))};
    for (const auto& [number, end] :
         {std::pair{&ends->first, &sweep.from}, {&ends->second, &sweep.to}}) {
        const auto value = read_number(option, *number);
        if (!value) return std::unexpected(value.error());
        if (std::abs(*value) > largest_number)
            return wrong_input(option + ": stay between -1e30 and 1e30");
        *end = *value;
    }
    const auto& names = document.rows->program->parameters;
    if (sweep.name != "w" && std::ranges::find(names, sweep.name) == names.end()) {
        std::string known;
        for (const std::string& name : names)
            known += " " + name;
        return wrong_input(
            option + ": there is no parameter " + sweep.name +
            (known.empty() ? "; a free letter in the formula is one" : "; there are:" + known));
    }
    return sweep;
}

/// The cameras of the way: texts of cameras, names of saved views, or all saved views.
OrInputError<std::vector<Camera>> read_path(const FilmCommand& command, const Document& document) {
    std::vector<Camera> path;
    if (command.through_views) {
        if (!command.waypoints.empty())
            return wrong_input("--through-views: not together with --through");
        for (const SavedView& view : document.views)
            path.push_back(view.camera);
        if (path.size() < 2)
            return wrong_input("--through-views: the document has " + std::to_string(path.size()) +
                               " saved views, and a way has two ends at least");
        return path;
    }
    const Camera camera = camera_of(document);
    for (const std::string& text : command.waypoints) {
        const bool is_name =
            find_view(document.views, trimmed(text)) != nullptr || !looks_like_camera(text);
        const auto read = is_name ? saved_camera("--through", text, document)
                                  : read_camera("--through", text, camera);
        if (!read) return std::unexpected(read.error());
        path.push_back(*read);
    }
    if (path.size() == 1)
        return wrong_input("--through " + command.waypoints.front() +
                           ": a way has two ends at least; give another --through");
    return path;
}

template <class Names, class Value>
std::optional<InputError> read_name(const char* option, const std::optional<std::string>& text,
                                    const Names& names, Value& value) {
    if (!text) return std::nullopt;
    const auto named = names.named(*text);
    if (named) {
        value = *named;
        return std::nullopt;
    }
    std::string all;
    for (const Value known : names.values())
        all += (all.empty() ? "" : ", ") + std::string(names.of(known));
    return InputError{.reason = std::string(option) + " " + *text + ": type one of " + all};
}

std::optional<InputError> read_blur(const FilmCommand& command, FilmPlan& plan) {
    if (command.blur) {
        const auto blur = read_integer("--blur", *command.blur, 1, most_blur);
        if (!blur) return blur.error();
        plan.blur = *blur;
    }
    if (!command.shutter) return std::nullopt;
    const auto shutter = read_number("--shutter", *command.shutter);
    if (!shutter) return shutter.error();
    if (!(*shutter > 0 && *shutter <= 1))
        return InputError{.reason =
                              "--shutter " + *command.shutter + ": type more than 0, at most 1"};
    plan.shutter = *shutter;
    return std::nullopt;
}

OrInputError<int> read_quality(const FilmCommand& command, const FilmFormat& format) {
    constexpr int usual = 90;
    if (!command.quality) return usual;
    if (!format.lossy)
        return wrong_input("--quality " + *command.quality + ": a film in " +
                           std::string(format.name) + " has no choice of it" +
                           export_use(ExportKind::Film, &ExportFormat::quality));
    return read_integer("--quality", *command.quality, 1, 100);
}

OrInputError<FilmTarget> read_frame_files(const FilmCommand& command, const Size& size) {
    const std::string option = "-o " + command.output;
    FilmTarget target{.path = command.output,
                      .settings = {},
                      .names = FrameNames::from(command.output),
                      .picture_options = {}};
    if (command.quality) return wrong_input("--quality " + *command.quality + ": it is for films");
    target.picture = picture_format_of(command.output);
    if (target.picture == nullptr)
        return wrong_input(option + ": " + other_name(ExportKind::Picture, command.output));
    target.picture_options = {.size = {.width = size.width, .height = size.height},
                              .bits = target.picture->bits[0],
                              .alpha = command.alpha};
    if (command.bits) {
        const auto bits = read_integer("--bits", *command.bits, 8, 32);
        if (!bits) return std::unexpected(bits.error());
        target.picture_options.bits = *bits;
    }
    if (const auto refused = refusal(*target.picture, target.picture_options))
        return wrong_input(option + ": " + *refused);
    return target;
}

}  // namespace

OrInputError<FilmPlan> read_film_plan(const FilmCommand& command, const InputDocument& document) {
    FilmPlan plan;
    OptionReader reader;
    reader.take(plan.rate, read_rate(command));
    reader.take(plan.frames, read_frame_count(command, plan.rate));
    reader.check(read_turn(command, document.document, plan));
    for (const std::string& text : command.sweeps)
        reader.take(plan.sweeps.emplace_back(), read_sweep(text, document));
    reader.take(plan.path, read_path(command, document.document));
    if (reader.error()) return std::unexpected(*reader.error());
    if (!plan.turn && plan.sweeps.empty() && plan.path.empty())
        return wrong_input(
            "nothing changes: give --sweep NAME=FROM..TO, --turn DEGREES, --through or "
            "--through-views");
    plan.end = plan.turn || !plan.path.empty() ? FilmEnd::Loop : FilmEnd::Bounce;
    reader.check(read_name("--end", command.end, end_names, plan.end));
    reader.check(read_name("--ease", command.ease, easing_names, plan.easing));
    reader.check(read_blur(command, plan));
    return reader.finish(std::move(plan));
}

OrInputError<FrameRange> read_frame_range(const FilmCommand& command, const FilmPlan& plan) {
    FrameRange range{.first = 0, .last = plan.frames - 1};
    const auto ends = command.frames ? ends_of(*command.frames) : std::nullopt;
    if (!ends) return range;
    const std::string option = "--frames " + *command.frames;
    OptionReader reader;
    reader.take(range.first, read_integer(option, ends->first, 0, range.last));
    reader.take(range.last, read_integer(option, ends->second, range.first, range.last));
    return reader.finish(range);
}

OrInputError<FrameRangeChoice> read_frame_range_choice(const FilmCommand& command) {
    const std::string text = command.frame_range.value_or("auto");
    if (text == "auto") return std::nullopt;
    if (text == "off") return 0;
    const std::string option = "--frame-range " + text;
    if (text.find_first_not_of("0123456789") != std::string::npos)
        return wrong_input(option + ": type auto, off or a number of frames, such as 8");
    return read_integer("--frame-range", text, 1, longest_frame_range);
}

OrInputError<FilmTarget> read_film_target(const FilmCommand& command, const Size& size,
                                          const FilmPlan& plan) {
    if (FrameNames::from(command.output)) return read_frame_files(command, size);
    const std::string option = "-o " + command.output;
    FilmTarget target{.path = command.output,
                      .film = film_format_of(command.output),
                      .settings = {},
                      .names = {},
                      .picture_options = {}};
    if (target.film == nullptr) {
        return wrong_input(option + ": " + other_name(ExportKind::Film, command.output));
    }
    for (const auto& [name, given] :
         {std::pair{"--resume", command.resume}, std::pair{"--bits", command.bits.has_value()}}) {
        if (given)
            return wrong_input(std::string(name) +
                               ": only with numbered pictures, -o frame####.png");
    }
    target.settings = {
        .width = size.width, .height = size.height, .rate = plan.rate, .alpha = command.alpha};
    if (const auto refused = refusal(*target.film, target.settings))
        return wrong_input(option + ": " + *refused);
    const auto quality = read_quality(command, *target.film);
    if (!quality) return std::unexpected(quality.error());
    target.settings.quality = *quality;
    return target;
}

}  // namespace zeroset
