#pragma once

#include "app/cli/options/options.hpp"
#include "app/dev/bench_suite.hpp"
#include "engine/scene/settings.hpp"
#include "papers/commands/paper_commands.hpp"
#include "papers/compare/printed_tables.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/picture_request.hpp"

#include <optional>
#include <string_view>

namespace zeroset {

/// A paper's scene, seen from the suite's direction.
BenchItem item_of(const PrintedScene& scene);
/// Compiles a surface for pictures of a size, in plain light.
OrInputError<PictureRequest> compiled(const BenchItem& item, const TraceSettings& settings,
                                      const Size& size);

/// The options that comparisons of one scene have, read.
struct ComparedSettings {
    TraceSettings settings;
    int size_px = 0;

    [[nodiscard]] Size size() const { return {.width = size_px, .height = size_px}; }
};

/// Refuses the options that tables alone have; `what`: what it is that is no table. The usual
/// d_stop and size where none is typed.
OrInputError<ComparedSettings> read_compared_settings(const CompareCommand& command,
                                                      std::string_view what, const char* d_stop,
                                                      int size_px);

}  // namespace zeroset
