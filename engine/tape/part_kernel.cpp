#include "engine/tape/parts.hpp"

#include <memory>
#include <type_traits>
#include <utility>

namespace zeroset {
namespace {

/// Shape and constants, at an address that does not change.
struct PartCode {
    const PartShape* shape;
    const Part* part;
};

/// A PartCode that owns its shape and constants.
struct OwnPartCode {
    explicit OwnPartCode(ShapedGraph shaped) : graph(std::move(shaped)) {}
    OwnPartCode(const OwnPartCode&) = delete;
    OwnPartCode& operator=(const OwnPartCode&) = delete;
    ~OwnPartCode() = default;

    ShapedGraph graph;
    PartCode code{.shape = &graph.shape, .part = &graph.part};
};

template <class Batch>
constexpr bool over_points =
    requires(const Batch& batch) { batch.gradient; } || std::is_same_v<Batch, RayValueBatch>;

/// The batch with the part's uniforms.
template <class Batch>
Batch batch_of_part(const PartCode& code, const Batch& batch) {
    Batch own = batch;
    if constexpr (over_points<Batch>) {
        own.uniforms = point_uniforms(*code.shape, *code.part, batch.uniforms);
    } else {
        own.uniforms = box_uniforms(*code.shape, *code.part, batch.uniforms);
    }
    return own;
}

/// Calls the function of the shape's kernel that `pick` names.
template <auto pick, class Batch>
void call_part(const void* code, const Batch* batch) {
    const auto& part = *static_cast<const PartCode*>(code);
    pick(part.shape->kernel)(batch_of_part(part, *batch));
}

/// Calls a function as call_part does, but never waits for code.
template <auto pick, class Batch>
void call_part_meanwhile(const void* code, const Batch* batch) {
    const auto& part = *static_cast<const PartCode*>(code);
    const auto& of_shape = pick(part.shape->kernel);
    const Batch own = batch_of_part(part, *batch);
    (of_shape.meanwhile != nullptr ? of_shape.meanwhile : of_shape.call)(of_shape.code.get(), &own);
}

template <auto pick, class Batch>
void set(KernelFunction<Batch>& function, const std::shared_ptr<const PartCode>& code) {
    function = {call_part<pick, Batch>, code, call_part_meanwhile<pick, Batch>};
}

/// Sets the functions of a part, and what is to be known of them.
void set_code(Kernel& kernel, const std::shared_ptr<const PartCode>& code) {
#define ZEROSET_KERNEL_FUNCTION(name, kind, Batch)                                              \
    set<[](const Kernel& k) -> const auto& { return k.in_float.name; }>(kernel.in_float.name,   \
                                                                        code);                  \
    set<[](const Kernel& k) -> const auto& { return k.in_double.name; }>(kernel.in_double.name, \
                                                                         code);
#include "engine/kernel/kernel_functions.def"
    set<[](const Kernel& k) -> const auto& { return k.ray_value; }>(kernel.ray_value, code);
    const Kernel& of_shape = code->shape->kernel;
    kernel.has_double = of_shape.has_double;
    kernel.branches = of_shape.branches;
}

}  // namespace

Kernel kernel_of_shape(Kernel interpreted, ShapedGraph graph) {
    Kernel kernel = std::move(interpreted);
    const auto own = std::make_shared<const OwnPartCode>(std::move(graph));
    kernel.lane_multiple = own->graph.shape.kernel.lane_multiple;
    kernel.interpreted = false;
    kernel.steps = 0;
    kernel.specializer = nullptr;
    set_code(kernel, {own, &own->code});
    return kernel;
}

Kernel kernel_of_part(const Parts& parts, std::uint32_t part) {
    const Part& of = parts.parts[part];
    Kernel kernel;
    set_code(kernel, std::make_shared<const PartCode>(
                         PartCode{.shape = &parts.shapes[of.shape], .part = &of}));
    return kernel;
}

}  // namespace zeroset
