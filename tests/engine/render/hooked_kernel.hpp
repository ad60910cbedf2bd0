#pragma once

#include "engine/kernel/kernel.hpp"

#include <functional>
#include <memory>

namespace zeroset::test {

/// The kernel, whose functions call `hook` first, from any thread.
inline Kernel hooked(Kernel kernel, const std::function<void()>& hook) {
    const auto change = [&hook]<class Batch>(KernelFunction<Batch>& function) {
        struct Hooked {
            KernelFunction<Batch> whole;
            std::function<void()> hook;
        };
        auto code = std::make_shared<const Hooked>(function, hook);
        function = {[](const void* self, const Batch* batch) {
                        const auto& hooked = *static_cast<const Hooked*>(self);
                        hooked.hook();
                        hooked.whole(*batch);
                    },
                    std::move(code)};
    };
    change(kernel.range_float);
    change(kernel.value_float);
    change(kernel.form_float);
    change(kernel.ray_form_float);
    change(kernel.newton_float);
    change(kernel.ray_value);
    change(kernel.range_double);
    change(kernel.value_double);
    change(kernel.form_double);
    change(kernel.ray_form_double);
    change(kernel.newton_double);
    return kernel;
}

}  // namespace zeroset::test
