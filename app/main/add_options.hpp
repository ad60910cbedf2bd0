#pragma once

#include "app/cli/options/options.hpp"
#include "engine/base/text.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

// The options that several subcommands share.

namespace zeroset {

/// Adds an option with a value; spaces at both ends of the value are dropped.
template <class Value>
CLI::Option* add_value(CLI::App& app, const std::string& names, Value& value,
                       const std::string& about) {
    const std::function<std::string(std::string)> trim = [](const std::string& text) {
        return std::string(trimmed(text));
    };
    return app.add_option(names, value, about)->transform(trim);
}

/// Adds the argument EQUATION: what is drawn.
void add_equation(CLI::App& app, std::string& equation);

/// Adds the pair --NAME and --no-NAME.
CLI::Option* add_switch(CLI::App& app, const std::string& name, std::optional<bool>& value,
                        const std::string& about);

/// Adds an option that may be given several times.
void add_repeated(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                  const std::string& about);

void add_color_options(CLI::App& app, LookText& look);
void add_parameters(CLI::App& app, std::vector<std::string>& set);
/// Options for what is shown of the surfaces.
void add_region_options(CLI::App& app, ViewText& view);
/// Options for region, camera and look.
void add_view_options(CLI::App& app, ViewText& view);
void add_trace_options(CLI::App& app, TraceText& trace);
/// Options for axes, clip box and grid.
void add_axes_options(CLI::App& app, TraceText& trace);

}  // namespace zeroset
