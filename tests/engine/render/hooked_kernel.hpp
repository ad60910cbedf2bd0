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
    visit_functions(change, kernel);
    return kernel;
}

}  // namespace zeroset::test
