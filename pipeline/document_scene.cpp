#include "pipeline/document_scene.hpp"

#include "document/colors.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace zeroset {

std::vector<int> surface_rows(const Document& document, const Program& program) {
    const JoinedRows joined = joined_rows(document);
    std::vector<int> rows;
    for (const Reading& reading : program.readings) {
        if (reading.kind != StatementKind::Surface) continue;
        rows.push_back(document.statements[joined.row_at(reading.offset)].id);
    }
    return rows;
}

std::vector<std::size_t> visible_surfaces(const Document& document, const std::vector<int>& rows) {
    std::vector<std::size_t> visible;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto row = std::ranges::find(document.statements, rows[i], &Statement::id);
        if (row != document.statements.end() && row->visible) visible.push_back(i);
    }
    return visible;
}

Scene document_scene(const Formula& formula, const Document& document,
                     const std::vector<int>& rows) {
    ParameterValues values;
    for (const auto& [name, slider] : document.parameters)
        values[name] = slider.value;
    Scene scene = make_scene(formula, document.clip, document.w.value, values);
    scene.region = document.region;
    scene.jumps = document.jumps;
    const std::vector<Kernel> all = std::exchange(scene.surfaces, {});
    const std::vector<Solid> solids = std::exchange(scene.solids, {});
    for (const std::size_t i : visible_surfaces(document, rows)) {
        const auto row = std::ranges::find(document.statements, rows[i], &Statement::id);
        scene.surfaces.push_back(all[i]);
        scene.solids.push_back({row->solid, solids[i].unrestricted});
        scene.colors.push_back(row->color ? surface_colors(*row->color) : colors_of(i));
    }
    return scene;
}

}  // namespace zeroset
