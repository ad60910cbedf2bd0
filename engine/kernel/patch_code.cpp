#include "engine/kernel/patch_code.hpp"

#include "engine/kernel/surface_facts.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace zeroset {
namespace {

template <class Real>
constexpr Real no_bound = std::numeric_limits<Real>::infinity();
template <class Real>
constexpr Real not_known = std::numeric_limits<Real>::quiet_NaN();

template <class Real>
void fill(Real* numbers, std::size_t size, Real value) {
    if (numbers != nullptr) std::fill_n(numbers, size, value);
}

template <class Real>
void know_nothing(const void*, const RangeBatchOf<Real>* batch) {
    fill(batch->f_neg_lo, batch->size, no_bound<Real>);
    fill(batch->f_hi, batch->size, no_bound<Real>);
    fill(batch->continuous, batch->size, ContinuityMask<Real>{0});
    fill(batch->branches, batch->size, ContinuityMask<Real>{0});
}

template <class Real>
void know_nothing(const void*, const ValueBatchOf<Real>* batch) {
    fill(batch->f, batch->size, not_known<Real>);
    for (Real* const gradient : batch->gradient)
        fill(gradient, batch->size, not_known<Real>);
}

template <class Real>
void know_nothing(const void*, const FormBatchOf<Real>* batch) {
    fill(batch->c, batch->size, Real{0});
    for (Real* const k : batch->k)
        fill(k, batch->size, Real{0});
    for (Real* const bound : {batch->e, batch->r, batch->slope_neg_lo, batch->slope_hi})
        fill(bound, batch->size, no_bound<Real>);
    fill(batch->continuous, batch->size, ContinuityMask<Real>{0});
    fill(batch->nowhere, batch->size, ContinuityMask<Real>{0});
    fill(batch->branches, batch->size, ContinuityMask<Real>{0});
    fill(batch->cut_from, batch->size, no_bound<Real>);
    fill(batch->cut_to, batch->size, -no_bound<Real>);
}

template <class Real>
void know_nothing(const void*, const NewtonBatchOf<Real>* batch) {
    for (Real* const gradient : batch->gradient)
        fill(gradient, batch->size, not_known<Real>);
    fill(batch->per_slope, batch->size, not_known<Real>);
}

void know_nothing(const void*, const RayValueBatch* batch) {
    fill(batch->f, batch->size, not_known<double>);
}

template <class Batch>
void set(KernelFunction<Batch>& function, const std::shared_ptr<const void>& code) {
    function = {.call = [](const void* own, const Batch* batch) { know_nothing(own, batch); },
                .code = code,
                .meanwhile = nullptr};
}

}  // namespace

Kernel patch_kernel(std::array<Kernel, 3> point, const std::optional<std::array<double, 6>>& box,
                    std::shared_ptr<const PatchModeler> modeler,
                    std::optional<std::vector<std::size_t>> reads) {
    const auto code = std::make_shared<const PatchCode>(PatchCode{.point = std::move(point),
                                                                  .box = box,
                                                                  .modeler = std::move(modeler),
                                                                  .reads = std::move(reads)});
    Kernel kernel;
    kernel.facts = std::make_shared<const SurfaceFacts>(SurfaceFacts{.patch = code});
    // The functions of different surfaces differ by what they hold on to.
    const auto identity = std::make_shared<const int>(0);
    visit_functions([&](auto& function) { set(function, identity); }, kernel);
    const Kernel& first = code->point[0];
    kernel.lane_multiple = first.lane_multiple;
    kernel.has_double = true;
    kernel.parameters = first.parameters;
    for (const Kernel& coordinate : code->point) {
        kernel.uses_w = kernel.uses_w || coordinate.uses_w;
        kernel.interpreted = kernel.interpreted || coordinate.interpreted;
    }
    return kernel;
}

bool is_patch(const Kernel& kernel) { return surface_facts(kernel).patch != nullptr; }

}  // namespace zeroset
