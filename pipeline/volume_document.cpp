#include "pipeline/volume_document.hpp"

#include "engine/volume/histogram.hpp"
#include "engine/volume/volume.hpp"
#include "pipeline/fit_view.hpp"
#include "pipeline/prepare.hpp"
#include "pipeline/volume_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace zeroset {
namespace {

/// The volumes that the program's surfaces ask.
std::vector<std::shared_ptr<const Volume>> volumes_of(const Program& program) {
    std::vector<std::shared_ptr<const Volume>> volumes;
    for (const Expr& surface : program.surfaces) {
        for (const auto& field : fields_of(surface)) {
            if (auto volume = std::dynamic_pointer_cast<const Volume>(field))
                volumes.push_back(std::move(volume));
        }
    }
    return volumes;
}

}  // namespace

void fit_to_program(const Program& program, Document& document) {
    std::optional<Box> box;
    for (const auto& volume : volumes_of(program)) {
        const std::array<double, 6> bounds = volume->data().bounds();
        const Box own{.lo = {bounds[0], bounds[1], bounds[2]},
                      .hi = {bounds[3], bounds[4], bounds[5]}};
        box = box ? Box{.lo = glm::min(box->lo, own.lo), .hi = glm::max(box->hi, own.hi)} : own;
    }
    if (const auto asked = asked_box(program)) box = asked;
    if (!box) return;
    document.clip = *box;
    document.camera.reset();
}

std::map<std::string, std::shared_ptr<const Volume>> isovalues(const Program& program) {
    std::map<std::string, std::shared_ptr<const Volume>> found;
    for (const Expr& surface : program.surfaces) {
        const auto add = [&](const Node& value, const Node& level) {
            if (value.op != Op::Field || value.number != 0) return;
            if (level.op != Op::Variable || level.number <= variable_w) return;
            auto volume = std::dynamic_pointer_cast<const Volume>(value.field);
            const auto name = variable_name(level.number, surface.parameters());
            if (volume != nullptr) found.try_emplace(std::string(name), std::move(volume));
        };
        for (const Node& node : surface.nodes()) {
            if (node.op != Op::Subtract) continue;
            add(surface.node(node.a), surface.node(node.b));
            add(surface.node(node.b), surface.node(node.a));
        }
    }
    return found;
}

Slider isovalue_slider(const Volume& volume) {
    const SampleRange range = volume.data().range();
    const double lo = std::clamp(range.lo, -largest_number, largest_number);
    const double hi = std::clamp(range.hi, -largest_number, largest_number);
    constexpr std::size_t parts = 256;
    const auto histogram = quick_histogram(volume.data().samples(), range, parts);
    const double level = histogram ? dividing_value(*histogram) : 0.5 * (lo + hi);
    Slider slider{.value = std::clamp(level, lo, hi), .lo = lo, .hi = hi};
    if (!(lo < hi)) slider.hi = lo + std::max(1.0, 1e-6 * std::abs(lo));
    return slider;
}

OrInputError<Document> document_of_volume(const std::filesystem::path& file,
                                          const std::shared_ptr<FileAccess>& access) {
    access->allow(file);
    const std::string name = file.string();
    ReadDocument read = read_document_text("scan = volume(\"" + name + "\")\nscan(x, y, z) = a",
                                           volume_source({}, access));
    if (!read.rows) return std::unexpected(read.rows.error());
    const Program& program = *read.rows->program;
    fit_to_program(program, read.document);
    read.document.parameters["a"] = isovalue_slider(*volumes_of(program).front());
    // In scans bodies are what is above; air is at most faces of the box, but not at all.
    read.document.statements.back().solid = SolidSide::Above;
    return std::move(read.document);
}

}  // namespace zeroset
