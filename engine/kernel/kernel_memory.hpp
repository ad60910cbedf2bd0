#pragma once

#include <memory>
#include <mutex>
#include <typeindex>
#include <utility>
#include <vector>

namespace zeroset {

/// Things that tracers have found out of a kernel's function and keep for later frames: one of each
/// type, empty when it is first asked for. Copies of a kernel share it, so it goes with the
/// last one. Any thread; the things look after their own threads.
class KernelMemory {
public:
    template <class Thing>
    std::shared_ptr<Thing> of() {
        const std::scoped_lock lock(mutex_);
        if (auto kept = kept_of<Thing>()) return kept;
        auto thing = std::make_shared<Thing>();
        things_.emplace_back(typeid(Thing), thing);
        return thing;
    }
    /// The thing, if it was asked for by `of` before; else nullptr.
    template <class Thing>
    std::shared_ptr<const Thing> find() const {
        const std::scoped_lock lock(mutex_);
        return kept_of<Thing>();
    }

private:
    template <class Thing>
    std::shared_ptr<Thing> kept_of() const {
        for (const auto& [type, thing] : things_) {
            if (type == typeid(Thing)) return std::static_pointer_cast<Thing>(thing);
        }
        return nullptr;
    }

    mutable std::mutex mutex_;
    std::vector<std::pair<std::type_index, std::shared_ptr<void>>> things_;
};

}  // namespace zeroset
