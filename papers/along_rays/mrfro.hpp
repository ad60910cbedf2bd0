#pragma once

#include "papers/along_rays/end_signs.hpp"
#include "papers/along_rays/ray_field.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace zeroset {

/// The method of mrfro.cpp, for RaySearch.
template <class Real>
class MrfRo {
public:
    explicit MrfRo(RayField<Real>& field) : field_(field), signs_(field), middles_(field) {}

    void examine(std::span<const RayTask> tasks, std::span<TaskOutcome> outcomes) {
        signs_.reject_by_ends(tasks, outcomes, open_);
        middles_.clear();
        for (const std::size_t i : open_)
            middles_.ask(tasks, i, EndSigns<Real>::Where::Middle);
        middles_.evaluate(tasks);
        for (const std::size_t i : open_)
            outcomes[i].bisect(signs_.of(i), middles_.middle(i));
    }

private:
    RayField<Real>& field_;
    EndSigns<Real> signs_, middles_;
    std::vector<std::size_t> open_;
};

}  // namespace zeroset
