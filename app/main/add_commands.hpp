#pragma once

#include "app/cli/commands.hpp"
#include "papers/commands/paper_commands.hpp"

#include <CLI/CLI.hpp>

namespace zeroset {

// Each adds a subcommand's options to `app`: first those that write files to take away.

CLI::App* add_render(CLI::App& app, RenderCommand& render);
CLI::App* add_turntable(CLI::App& app, FilmCommand& film);
CLI::App* add_animate(CLI::App& app, FilmCommand& film);
CLI::App* add_share(CLI::App& app, ShareCommand& share);
CLI::App* add_mesh(CLI::App& app, MeshCommand& mesh);
CLI::App* add_draw(CLI::App& app, DrawCommand& draw);

/// Adds what the options of all of these say of formats; to be called before `app` shows its help,
/// and only then, as it asks FFmpeg's libraries what they can write.
void describe_formats(CLI::App& app);

// Parts of `zeroset dev` that compare with papers.

CLI::App* add_compare(CLI::App& app, CompareCommand& compare);
CLI::App* add_traversal(CLI::App& app, TraversalCommand& traversal);

}  // namespace zeroset
