#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"
#include "engine/base/text.hpp"
#include "engine/export/file.hpp"
#include "engine/export/new_file.hpp"
#include "engine/volume/files/write_nrrd.hpp"
#include "pipeline/patch_surface.hpp"
#include "pipeline/sample_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zeroset {
namespace {

constexpr std::uint64_t most_samples_a_side = 4096;
constexpr std::uint64_t most_samples = std::uint64_t{1} << 30U;

struct SamplePlan {
    GridPlan grid;
    Expr f;
    Uniforms uniforms;
    std::string text;
    double tolerance = 0;  ///< of distances
};

/// Reads N or NXxNYxNZ; of a single number the longest edge of the box has so many samples, and the
/// others as many as keep the spacing.
OrInputError<GridSize> read_grid_size(const std::string& text, const Box& box) {
    const auto wrong = [&] {
        return wrong_input("--size " + text + ": type N or NXxNYxNZ, each from 2 to " +
                           std::to_string(most_samples_a_side) + ", together at most 2^30");
    };
    std::vector<std::uint64_t> numbers;
    for (const std::string_view part : split(text, 'x')) {
        std::uint64_t number = 0;
        for (const char c : part) {
            if (c < '0' || c > '9' || number > most_samples_a_side) return wrong();
            number = 10 * number + static_cast<std::uint64_t>(c - '0');
        }
        if (part.empty() || number < 2 || number > most_samples_a_side) return wrong();
        numbers.push_back(number);
    }
    GridSize size{};
    if (numbers.size() == 1) {
        const double step = box.size() / static_cast<double>(numbers[0] - 1);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<int>(i);
            const double steps = std::round((box.hi[axis] - box.lo[axis]) / step);
            size[i] = static_cast<std::uint64_t>(std::max(steps, 1.0)) + 1;
        }
    } else if (numbers.size() == 3) {
        size = {numbers[0], numbers[1], numbers[2]};
    } else {
        return wrong();
    }
    if (size[0] * size[1] * size[2] > most_samples) return wrong();
    return size;
}

OrInputError<std::size_t> read_surface(const std::optional<std::string>& text, std::size_t count) {
    if (!text) {
        if (count == 1) return 0;
        return wrong_input("there are " + std::to_string(count) +
                           " surfaces: type --surface N for one of them");
    }
    for (std::size_t n = 1; n <= count; ++n) {
        if (*text == std::to_string(n)) return n - 1;
    }
    return wrong_input("--surface " + *text + ": type a number from 1 to " + std::to_string(count));
}

/// The tolerance of distances: what was typed, or a twentieth of the least spacing.
OrInputError<double> read_tolerance(const SampleCommand& command, const GridPlan& grid) {
    const Geometry geometry = geometry_of(grid);
    if (!command.tolerance) {
        constexpr double share = 0.05;
        return share * std::min({geometry.world_from_index[0][0], geometry.world_from_index[1][1],
                                 geometry.world_from_index[2][2]});
    }
    if (!command.distance) return wrong_input("--tolerance is of distances: type --distance, too");
    const auto number = read_number("--tolerance", *command.tolerance);
    if (!number) return std::unexpected(number.error());
    if (!(*number > 0 && *number <= 1e9)) {
        return wrong_input("--tolerance " + *command.tolerance +
                           ": type a distance in world units, above 0");
    }
    return *number;
}

OrInputError<SamplePlan> plan_of(const SampleCommand& command) {
    if (!lower_case(command.output).ends_with(".nrrd"))
        return wrong_input("-o " + command.output + ": type a name that ends in .nrrd");
    ViewText view;
    view.box = command.box;
    view.w = command.w;
    view.set = command.set;
    const auto input = read_document_with_rows(command.equation, view);
    if (!input) return std::unexpected(input.error());
    const Program& program = *input->rows->program;
    const auto surface = read_surface(command.surface, program.surfaces.size());
    if (!surface) return std::unexpected(surface.error());
    if (is_patch(program.surfaces[*surface]))
        return wrong_input(
            "samples are those of an f: type an equation in x, y and z instead of a "
            "parametric surface");
    const auto size = read_grid_size(command.size, input->document.clip);
    if (!size) return std::unexpected(size.error());
    SamplePlan plan{.grid = {.box = input->document.clip, .size = *size},
                    .f = program.surfaces[*surface],
                    .uniforms = {},
                    .text = input->rows->surface_texts[*surface]};
    const auto tolerance = read_tolerance(command, plan.grid);
    if (!tolerance) return std::unexpected(tolerance.error());
    plan.tolerance = *tolerance;
    plan.uniforms.set(0, input->document.w.value);
    for (std::size_t i = 0; i < program.parameters.size(); ++i)
        plan.uniforms.set(i + 1, slider_of(input->document, program.parameters[i]).value);
    return plan;
}

/// One line about samples whose distance is not proved.
void warn_of(const DistanceGrid& grid, double tolerance) {
    if (grid.unproved == 0) return;
    const std::string worst = std::isfinite(grid.worst)
                                  ? "off by up to " + short_number(grid.worst, 3)
                                  : "larger: the surface is not proved to be so near";
    std::fprintf(
        stderr, "zeroset: of %llu of %llu samples the distance is not proved to %s; it may be %s\n",
        static_cast<unsigned long long>(grid.unproved),
        static_cast<unsigned long long>(grid.samples.count()), short_number(tolerance, 3).c_str(),
        worst.c_str());
}

/// Writes the samples of f as they are computed.
std::expected<void, FileError> write_values(const SamplePlan& plan, const std::string& header,
                                            const std::string& path) {
    NewFile file(path);
    if (!file.append(std::as_bytes(std::span(header)))) return file.error();
    const auto append = [&](std::span<const float> samples) {
        return file.append(std::as_bytes(samples));
    };
    if (!sample_in_order({plan.f, plan.uniforms, plan.grid}, append)) return file.error();
    return file.keep();
}

}  // namespace

int run_sample(const SampleCommand& command) {
    const auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    if (const auto unwritable = first_unwritable({command.output}))
        return report_run_time(*unwritable);
    const Geometry geometry = geometry_of(plan->grid);
    std::expected<void, FileError> written;
    if (command.distance) {
        const auto grid = sampled_distance(plan->f, plan->uniforms, plan->grid, plan->tolerance);
        if (!grid) return report(grid.error());
        warn_of(*grid, plan->tolerance);
        const std::string content =
            "signed distance, to " + short_number(plan->tolerance, 3) + ", of " + plan->text;
        written = write_file(command.output, nrrd_bytes(grid->samples, geometry, content));
    } else {
        const std::string header =
            nrrd_header(SampleType::Float, plan->grid.size, geometry, "f of " + plan->text);
        written = write_values(*plan, header, command.output);
    }
    return written ? exit_ok : report_run_time(written.error().message);
}

}  // namespace zeroset
