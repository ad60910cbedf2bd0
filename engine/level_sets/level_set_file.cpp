#include "engine/level_sets/level_set_file.hpp"

#include "engine/base/text.hpp"
#include "engine/export/package.hpp"
#include "engine/level_sets/function_nodes.hpp"

namespace zeroset {
namespace {

using Output = FunctionNodes::Output;

std::string attribute(const char* name, const std::string& value) {
    return " " + std::string(name) + "=\"" + value + "\"";
}

Output plus(FunctionNodes& nodes, const Output& a, double b) {
    return b == 0.0 ? a : nodes.node("addition", {a, nodes.constant(b)});
}

/// dot(normal, p) - offset.
Output plane_of(FunctionNodes& nodes, const LevelSetPlane& plane) {
    Output sum;
    for (int axis = 0; axis < 3; ++axis) {
        if (plane.normal[axis] == 0.0) continue;
        const Output part = nodes.node(
            "multiplication", {nodes.constant(plane.normal[axis]), nodes.coordinate(axis)});
        sum = sum.empty() ? part : nodes.node("addition", {sum, part});
    }
    return plus(nodes, sum.empty() ? nodes.constant(0.0) : sum, -plane.offset);
}

/// |p - centre| - radius.
Output ball_of(FunctionNodes& nodes, const LevelSetBall& ball) {
    Output sum;
    for (int axis = 0; axis < 3; ++axis) {
        const Output part = plus(nodes, nodes.coordinate(axis), -ball.centre[axis]);
        const Output square = nodes.node("multiplication", {part, part});
        sum = sum.empty() ? square : nodes.node("addition", {sum, square});
    }
    return plus(nodes, nodes.node("sqrt", {sum}), -ball.radius);
}

/// The function of a surface that is above 0 outside of all that ends it.
std::expected<Output, std::string> shape_of(FunctionNodes& nodes, const LevelSetFile& file,
                                            const LevelSet& surface) {
    const auto f = nodes.add(surface.function, file.values);
    if (!f) return f;
    Output shape = surface.side < 0.0 ? nodes.node("subtraction", {nodes.constant(0.0), *f}) : *f;
    const auto end = [&](const Output& bound) { shape = nodes.node("max", {shape, bound}); };
    for (const Expr& bound : surface.bounds) {
        const auto output = nodes.add(bound, file.values);
        if (!output) return output;
        end(*output);
    }
    for (const LevelSetPlane& plane : file.planes)
        end(plane_of(nodes, plane));
    for (const LevelSetBall& ball : file.balls)
        end(ball_of(nodes, ball));
    return shape;
}

/// A box of 12 triangles whose normals point outward.
std::string box_mesh(const glm::dvec3& lo, const glm::dvec3& hi) {
    constexpr std::array<std::array<int, 3>, 12> triangles{{{0, 2, 1},
                                                            {1, 2, 3},
                                                            {4, 5, 6},
                                                            {5, 7, 6},
                                                            {0, 1, 4},
                                                            {1, 5, 4},
                                                            {2, 6, 3},
                                                            {3, 6, 7},
                                                            {0, 4, 2},
                                                            {2, 4, 6},
                                                            {1, 3, 5},
                                                            {3, 7, 5}}};
    std::string text = "<mesh><vertices>\n";
    for (int corner = 0; corner < 8; ++corner) {
        text += "<vertex" + attribute("x", digits_of((corner & 1) != 0 ? hi.x : lo.x)) +
                attribute("y", digits_of((corner & 2) != 0 ? hi.y : lo.y)) +
                attribute("z", digits_of((corner & 4) != 0 ? hi.z : lo.z)) + "/>\n";
    }
    text += "</vertices><triangles>\n";
    for (const auto& t : triangles) {
        text += "<triangle" + attribute("v1", std::to_string(t[0])) +
                attribute("v2", std::to_string(t[1])) + attribute("v3", std::to_string(t[2])) +
                "/>\n";
    }
    return text + "</triangles></mesh>";
}

std::string head_of(const LevelSetFile& file) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
        "xmlns:v=\"http://schemas.3mf.io/3dmanufacturing/volumetric/2022/01\" "
        "xmlns:i=\"http://schemas.3mf.io/3dmanufacturing/implicit/2023/12\" "
        "requiredextensions=\"v i\">\n"
        "<metadata name=\"Application\">Zeroset</metadata>\n<metadata name=\"Description\">";
    for (const std::string& line : file.comment)
        text += xml_escaped(line) + "\n";
    return text + "</metadata>\n<resources>\n";
}

/// The map from millimetres to the formula's units.
std::string transform_of(const LevelSetFile& file) {
    const std::string scale = digits_of(1.0 / file.mm_per_unit);
    return scale + " 0 0 0 " + scale + " 0 0 0 " + scale + " 0 0 0";
}

}  // namespace

std::expected<EncodedLevelSets, std::string> encode_level_sets(const LevelSetFile& file) {
    EncodedLevelSets result{.bytes = {}, .surfaces = file.surfaces.size()};
    constexpr const char* box_id = "1";
    std::string text = head_of(file) + "<object" + attribute("id", box_id) +
                       attribute("type", "model") + attribute("name", "box") + ">" +
                       box_mesh(file.mm_per_unit * file.lo, file.mm_per_unit * file.hi) +
                       "</object>\n";
    std::string items;
    std::size_t id = 1;
    for (const LevelSet& surface : file.surfaces) {
        const std::string color_id = std::to_string(++id);
        const std::string function_id = std::to_string(++id);
        const std::string object_id = std::to_string(++id);
        FunctionNodes nodes;
        const auto shape = shape_of(nodes, file, surface);
        if (!shape) return std::unexpected(shape.error());
        result.nodes += nodes.count();
        const std::string name = xml_escaped(surface.name);
        text += "<m:colorgroup" + attribute("id", color_id) + "><m:color" +
                attribute("color", hex_of(surface.color)) + "/></m:colorgroup>\n";
        text += "<i:implicitfunction" + attribute("id", function_id) +
                attribute("displayname", name) +
                ">\n<i:in><i:vector identifier=\"pos\"/></i:in>\n" + nodes.xml() +
                "<i:out><i:scalarref identifier=\"shape\"" + attribute("ref", *shape) +
                "/></i:out>\n</i:implicitfunction>\n";
        // Points where a function is undefined are outside: above 0.
        text += "<object" + attribute("id", object_id) + attribute("type", "model") +
                attribute("name", name) + attribute("pid", color_id) + attribute("pindex", "0") +
                "><v:levelset" + attribute("functionid", function_id) +
                attribute("channel", "shape") + attribute("transform", transform_of(file)) +
                attribute("meshid", box_id) + attribute("meshbboxonly", "true") +
                attribute("fallbackvalue", "1") + "/></object>\n";
        items += "<item" + attribute("objectid", object_id) + "/>";
    }
    text += "</resources>\n<build>" + items + "</build>\n</model>\n";
    auto bytes = package_of_3mf(text);
    if (!bytes) return std::unexpected(bytes.error());
    result.bytes = std::move(*bytes);
    return result;
}

}  // namespace zeroset
