#include "pipeline/mesh_solid.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/differences/derivatives.hpp"
#include "engine/rewrite/restriction.hpp"
#include "engine/rewrite/root_witnesses.hpp"
#include "engine/rewrite/polynomial/tighten.hpp"
#include "engine/trace/caps.hpp"
#include "jit/compile.hpp"
#include "pipeline/sample_region.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace zeroset {
namespace {

// LLVM takes about 1 ms for a node; larger graphs are interpreted.
constexpr std::size_t most_nodes = 3'000;

KernelFunction<RangeBatchOf<double>> ranges_of(const Expr& expr) {
    if (expr.nodes().size() <= most_nodes) {
        if (auto code = jit::compile_ranges(expr)) return std::move(*code);
    }
    return interpret(expr).in_double.range;
}

KernelFunction<ValueBatchOf<double>> values_of(const Expr& expr) {
    if (expr.nodes().size() <= most_nodes) {
        if (auto code = jit::compile_values(expr)) return std::move(*code);
    }
    return interpret(expr).in_double.value;
}

SolidPart part_of(const Expr& f, double sign, const Box& clip) {
    SolidPart part;
    const std::array<Expr, 3> slopes = gradient(f);
    {
        const std::jthread other([&] {
            part.range = ranges_of(f);
            part.value = values_of(f);
        });
        for (std::size_t axis = 0; axis < 3; ++axis)
            part.gradient[axis] = ranges_of(tightened(slopes[axis], sample_region(clip)));
    }
    part.sign = sign;
    const Kernel plain = interpret(f);
    part.branches = plain.branches;
    part.defined_everywhere = is_defined_everywhere(f);
    return part;
}

/// How each of the program's surfaces was read.
std::vector<std::string> readings_of(const Program& program) {
    std::vector<std::string> texts;
    for (const Reading& reading : program.readings) {
        if (reading.kind == StatementKind::Surface) texts.push_back(reading.text);
    }
    return texts;
}

}  // namespace

std::expected<std::vector<SurfaceSolid>, InputError> surface_solids(const PictureRequest& request) {
    const Scene scene = scene_of(request);
    const std::vector<std::string> texts = readings_of(*request.formula->program);
    std::vector<SurfaceSolid> solids;
    for (std::size_t i = 0; i < request.surfaces.size(); ++i) {
        const std::size_t index = request.surfaces[i].index;
        const RestrictedExpr restricted = without_restriction(request.formula->drawn[index]);
        SurfaceSolid surface{.number = index + 1, .text = texts[index], .solid = {}};
        MeshSolid& solid = surface.solid;
        solid.uniforms = scene.uniforms;
        solid.box = scene.clip;
        solid.cuts = cuts_of(scene.clip, scene.region);
        const double sign = solid_sign(scene, i) < 0 ? 1.0 : -1.0;
        solid.parts.push_back(part_of(restricted.function, sign, scene.clip));
        for (const Expr& bound : restricted.bounds)
            solid.parts.push_back(part_of(bound, 1.0, scene.clip));
        solids.push_back(std::move(surface));
    }
    return solids;
}

}  // namespace zeroset
