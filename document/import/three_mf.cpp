#include "document/import/implicit_graph.hpp"
#include "document/import/implicit_nodes.hpp"
#include "document/import/placement.hpp"
#include "document/import/readers.hpp"
#include "document/import/three_mf_package.hpp"
#include "engine/base/text.hpp"
#include "engine/base/translation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

// Packages of 3MF: the level sets of the volumetric extension whose functions are implicit. What is
// inside has f <= 0 and is in the box of the level set's mesh.

namespace zeroset {
namespace {

constexpr int deepest_component = 16;

/// A matrix of 3MF: 12 numbers, for points as rows.
std::optional<Placement> placement_of(const char* text) {
    Placement result;
    if (*text == '\0') return result;
    std::vector<double> m;
    for (const std::string_view word : split(text, ' ')) {
        if (word.empty()) continue;
        const auto number = number_from<double>(word);
        if (!number) return std::nullopt;
        m.push_back(*number);
    }
    if (m.size() != 12) return std::nullopt;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            result.linear[i][j] = m[static_cast<std::size_t>(3 * i + j)];
        result.shift[i] = m[static_cast<std::size_t>(9 + i)];
    }
    return result;
}

class PackageReader {
public:
    ReadImport run(std::string_view text) {
        pugi::xml_document xml;
        if (!xml.load_buffer(text.data(), text.size()))
            return import_error(0, tr("its model is no XML"));
        for (const pugi::xml_node& model : xml.children()) {
            if (local_name(model) != "model") continue;
            for (const pugi::xml_node& part : model.children()) {
                if (local_name(part) == "resources") add_resources(part);
                if (local_name(part) == "build") build(part);
            }
        }
        if (!all_)
            return import_error(
                0, lost_.empty()
                       ? tr("it has no level set of an implicit function; its meshes are not read")
                       : lost_);
        result_.document.clip = scaled(*all_, 1.02);
        result_.tells_box = true;
        Imported imported;
        imported.documents.push_back(std::move(result_));
        return imported;
    }

private:
    void add_resources(const pugi::xml_node& resources) {
        for (const pugi::xml_node& resource : resources.children()) {
            const std::string_view kind = local_name(resource);
            if (kind == "implicitfunction")
                functions_.add_function(resource);
            else if (kind == "object")
                objects_.insert_or_assign(resource.attribute("id").value(), resource);
            else if (kind == "colorgroup" || kind == "basematerials")
                colors_.insert_or_assign(resource.attribute("id").value(), resource);
            else if (kind == "functionfromimage3d")
                functions_.add_image(resource.attribute("id").value());
            else if (resource.type() == pugi::node_element)
                result_.note(0, kind, tr("not taken over"));
        }
    }

    void build(const pugi::xml_node& items) {
        for (const pugi::xml_node& item : items.children()) {
            const auto placement = placement_of(item.attribute("transform").value());
            if (!placement)
                result_.note(0, "build/item", tr("its transform is no matrix; it is left out"));
            add_object(item.attribute("objectid").value(), placement.value_or(Placement{}), 0);
        }
    }

    void add_object(const std::string& id, const Placement& placement, int depth) {
        const auto found = objects_.find(id);
        if (found == objects_.end() || depth > deepest_component) return;
        for (const pugi::xml_node& part : found->second.children()) {
            const std::string_view kind = local_name(part);
            if (kind == "levelset")
                add_level_set(part, placement, "object " + id, color_of(found->second),
                              part.attribute("meshid").value());
            if (kind == "mesh") add_mesh(part, placement, id, color_of(found->second));
            if (kind != "components") continue;
            for (const pugi::xml_node& component : part.children()) {
                if (++components_ > 1000) return;
                const auto inner = placement_of(component.attribute("transform").value());
                add_object(component.attribute("objectid").value(),
                           inner.value_or(Placement{}).then(placement), depth + 1);
            }
        }
    }

    /// A mesh as drafts of the extension have it: with a function that is its boundary.
    void add_mesh(const pugi::xml_node& mesh, const Placement& placement, const std::string& id,
                  std::optional<std::uint32_t> color) {
        const pugi::xml_node volume = child_named(mesh, "volumedata");
        for (const char* const name : {"boundary", "levelset"}) {
            if (const pugi::xml_node boundary = child_named(volume, name))
                return add_level_set(boundary, placement, "object " + id, color, id);
        }
        result_.note(0, "object " + id, tr("meshes are not taken over"));
    }

    /// The colour of an object: that of its property group at its index, "#RRGGBB" or "#RRGGBBAA".
    [[nodiscard]] std::optional<std::uint32_t> color_of(const pugi::xml_node& object) const {
        const auto group = colors_.find(object.attribute("pid").value());
        if (group == colors_.end()) return std::nullopt;
        int index = object.attribute("pindex").as_int();
        for (const pugi::xml_node& color : group->second.children()) {
            if (index-- != 0) continue;
            const pugi::xml_attribute base = color.attribute("displaycolor");
            const std::string_view text = (base ? base : color.attribute("color")).value();
            std::uint32_t value = 0;
            if (text.size() < 7 || text[0] != '#') return std::nullopt;
            const auto read = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
            return read.ptr == text.data() + 7 ? std::optional(value) : std::nullopt;
        }
        return std::nullopt;
    }

    std::optional<Box> box_of_mesh(const std::string& id) {
        const auto found = objects_.find(id);
        if (found == objects_.end()) return std::nullopt;
        std::optional<Box> box;
        for (const pugi::xml_node& mesh : found->second.children()) {
            for (const pugi::xml_node& list : mesh.children()) {
                for (const pugi::xml_node& vertex : list.children()) {
                    if (local_name(vertex) != "vertex") continue;
                    const glm::dvec3 at(vertex.attribute("x").as_double(),
                                        vertex.attribute("y").as_double(),
                                        vertex.attribute("z").as_double());
                    if (!box) box = Box{.lo = at, .hi = at};
                    box->lo = glm::min(box->lo, at);
                    box->hi = glm::max(box->hi, at);
                }
            }
        }
        return box;
    }

    /// Notes that a level set is left out.
    void lose(const std::string& entry, const std::string& reason) {
        if (lost_.empty()) lost_ = entry + ": " + reason;
        result_.note(0, entry, reason);
    }

    void add_level_set(const pugi::xml_node& set, const Placement& placement,
                       const std::string& entry, std::optional<std::uint32_t> color,
                       const std::string& mesh) {
        const auto to_field = placement_of(set.attribute("transform").value());
        const auto back = placement.inverse();
        const auto box = box_of_mesh(mesh);
        if (!to_field || !back || !box) {
            return lose(entry,
                        tr("it has no mesh that bounds it, or a transform that is no matrix; "
                           "it is left out"));
        }
        if (!set.attribute("meshbboxonly").as_bool())
            result_.note(0, entry, tr("it is cut by its mesh's box, not by the mesh"));
        const GraphValue inside = named_coordinates(*back);
        const auto f =
            functions_.output(set.attribute("functionid").value(), set.attribute("channel").value(),
                              named_coordinates(back->then(*to_field)));
        if (!f) return lose(entry, filled(tr("{0}; it is left out"), {f.error()}));
        const std::string& all = functions_.definitions();
        const std::string fresh(trimmed(std::string_view(all).substr(written_)));
        written_ = all.size();
        if (!fresh.empty()) result_.add_definition(fresh, 0);
        std::string text = "max(" + *f;
        for (int i = 0; i < 3; ++i) {
            const std::string& letter = inside[static_cast<std::size_t>(i)];
            text += ", " + exact_number(box->lo[i]) + " - " + letter + ", " + letter + " - " +
                    exact_number(box->hi[i], true);
        }
        result_.add_row(text + ") = 0", 0, color);
        extend(*box, placement);
    }

    /// The coordinates that a map brings (x, y, z) to, each with a name.
    GraphValue named_coordinates(const Placement& map) {
        if (map.is_identity()) return {"x", "y", "z"};
        GraphValue names;
        const std::string all = coordinates_of(map);
        for (const std::string_view part : split(all, ','))
            names.push_back(functions_.named(std::string(part)));
        return names;
    }

    void extend(const Box& box, const Placement& placement) {
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 at = placement.of({(corner & 1) != 0 ? box.hi.x : box.lo.x,
                                                (corner & 2) != 0 ? box.hi.y : box.lo.y,
                                                (corner & 4) != 0 ? box.hi.z : box.lo.z});
            if (!all_) all_ = Box{.lo = at, .hi = at};
            all_->lo = glm::min(all_->lo, at);
            all_->hi = glm::max(all_->hi, at);
        }
    }

    ImportedDocument result_{.name = {}};
    GraphWriter functions_;
    std::size_t written_ = 0;
    std::size_t components_ = 0;
    std::string lost_;  ///< the first level set that is left out, and why
    std::map<std::string, pugi::xml_node, std::less<>> objects_, colors_;
    std::optional<Box> all_;
};

}  // namespace

ReadImport read_three_mf(std::string_view bytes) {
    const auto model = model_of_package(bytes);
    if (!model) return std::unexpected(model.error());
    return PackageReader().run(*model);
}

}  // namespace zeroset
