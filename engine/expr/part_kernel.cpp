#include "engine/expr/part_kernel.hpp"

#include <memory>
#include <type_traits>

namespace zeroset {
namespace {

/// Shape and constants, at an address that does not change.
struct PartCode {
    const PartShape* shape;
    const Part* part;
};

template <class Batch>
constexpr bool over_points =
    requires(const Batch& batch) { batch.gradient; } || std::is_same_v<Batch, RayValueBatch>;

/// Calls the function of the shape's kernel.
template <auto function, class Batch>
void call_part(const void* code, const Batch* batch) {
    const auto& [shape, part] = *static_cast<const PartCode*>(code);
    Batch own = *batch;
    if constexpr (over_points<Batch>) {
        own.uniforms = point_uniforms(*shape, *part, batch->uniforms);
    } else {
        own.uniforms = box_uniforms(*shape, *part, batch->uniforms);
    }
    (shape->kernel.*function)(own);
}

template <auto function, class Batch>
void set(KernelFunction<Batch> Kernel::* /*which*/, Kernel& kernel,
         const std::shared_ptr<const PartCode>& code) {
    kernel.*function = {call_part<function, Batch>, code};
}

}  // namespace

Kernel kernel_of_part(const Parts& parts, std::uint32_t part) {
    const Part& of = parts.parts[part];
    const PartShape& shape = parts.shapes[of.shape];
    const auto code = std::make_shared<const PartCode>(PartCode{&shape, &of});
    Kernel kernel;
    const auto put = [&]<auto... functions>() { (set<functions>(functions, kernel, code), ...); };
    put.template operator()<&Kernel::range_float, &Kernel::value_float, &Kernel::form_float,
                            &Kernel::ray_form_float, &Kernel::newton_float, &Kernel::ray_value,
                            &Kernel::range_double, &Kernel::value_double, &Kernel::form_double,
                            &Kernel::ray_form_double, &Kernel::newton_double>();
    kernel.has_double = shape.kernel.has_double;
    kernel.branches = shape.kernel.branches;
    return kernel;
}

}  // namespace zeroset
