#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"
#include "engine/base/text.hpp"
#include "engine/export/file.hpp"
#include "engine/volume/files/write_nrrd.hpp"
#include "pipeline/sample_grid.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
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

OrInputError<SamplePlan> plan_of(const SampleCommand& command) {
    if (!lower_case(command.output).ends_with(".nrrd"))
        return wrong_input("-o " + command.output + ": type a name that ends in .nrrd");
    ViewText view;
    view.box = command.box;
    view.w = command.w;
    view.set = command.set;
    const auto input = read_document(command.equation, view);
    if (!input) return std::unexpected(input.error());
    if (!input->rows) return std::unexpected(input->rows.error());
    const Program& program = *input->rows->program;
    const auto surface = read_surface(command.surface, program.surfaces.size());
    if (!surface) return std::unexpected(surface.error());
    const auto size = read_grid_size(command.size, input->document.clip);
    if (!size) return std::unexpected(size.error());
    SamplePlan plan{.grid = {.box = input->document.clip, .size = *size},
                    .f = program.surfaces[*surface],
                    .uniforms = {},
                    .text = input->rows->surface_texts[*surface]};
    plan.uniforms.set(0, input->document.w.value);
    for (std::size_t i = 0; i < program.parameters.size(); ++i)
        plan.uniforms.set(i + 1, slider_of(input->document, program.parameters[i]).value);
    return plan;
}

}  // namespace

int run_sample(const SampleCommand& command) {
    const auto plan = plan_of(command);
    if (!plan) return report(plan.error());
    if (const auto unwritable = first_unwritable({command.output}))
        return report_run_time(*unwritable);
    const Samples samples = sampled(plan->f, plan->uniforms, plan->grid);
    const auto bytes = nrrd_bytes(samples, geometry_of(plan->grid), "f of " + plan->text);
    const auto written = write_file(command.output, bytes);
    return written ? exit_ok : report_run_time(written.error().message);
}

}  // namespace zeroset
