#include "app/dev/bench_suite.hpp"

#include "engine/base/text.hpp"
#include "pipeline/gallery.hpp"
#include "pipeline/input_error.hpp"
#include "pipeline/volume_source.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

/// The value of w for surfaces of a suite file.
constexpr double suite_w = 0.5;
constexpr double least_domain = 1e-12;
constexpr double largest_domain = 1e9;

/// The library's message without its prefix "[json.exception...] ".
std::string plain_message(const std::exception& error) {
    const std::string_view text = error.what();
    const std::size_t end = text.find("] ");
    return std::string(end == std::string_view::npos ? text : text.substr(end + 2));
}

}  // namespace

std::vector<BenchItem> gallery_suite() {
    std::vector<BenchItem> items;
    for (const GalleryItem& item : gallery()) {
        if (item.group != suite_group) continue;
        BenchItem& added = items.emplace_back(item.name, read_document(item));
        added.read.document.camera = suite_camera(item.clip.hi.x);
    }
    return items;
}

std::vector<BenchItem> whole_gallery() {
    std::vector<BenchItem> items;
    for (const GalleryItem& item : gallery()) {
        items.push_back({.name = item.name, .read = read_document(item)});
        items.back().read.document.light = {};
    }
    return items;
}

OrInputError<std::vector<BenchItem>> suite_of_file(const std::string& path) {
    std::ifstream file(path);
    std::error_code ignored;
    if (!file || std::filesystem::is_directory(path, ignored))
        return wrong_input("--suite " + path + ": the file cannot be read");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    std::vector<BenchItem> items;
    try {
        const Json json = Json::parse(text);
        const Json& view = json.at("camera");
        const auto direction = view.at("direction").get<std::array<double, 3>>();
        for (const Json& surface : json.at("surfaces")) {
            const double domain = surface.at("domain");
            const double distance = view.at("distance");
            Camera camera;
            camera.eye = distance * domain *
                         glm::normalize(glm::dvec3(direction[0], direction[1], direction[2]));
            if (direction[0] == 0.0 && direction[1] == 0.0) camera.up = {0, 1, 0};
            camera.fov_rad = glm::radians(view.at("fov").get<double>());
            const std::string name = printable(surface.at("name").get<std::string>());
            if (!(domain >= least_domain && domain <= largest_domain))
                return wrong_input("--suite " + path + ": the domain of '" + name +
                                   "' must be from 1e-12 to 1e9");
            if (!(distance > 0.0) || direction == std::array<double, 3>{})
                return wrong_input("--suite " + path +
                                   ": 'distance' must be above 0, and 'direction' not 0 along all "
                                   "axes; for example 4 and [1, -1.6, 0.9]");
            if (const char* const defect = camera_defect(camera))
                return wrong_input("--suite " + path + ": the camera of '" + name +
                                   "' sees nothing: " + defect);
            ReadDocument read =
                read_document_text(surface.at("f").get<std::string>(), volume_source({}));
            read.document.clip = Box::cube(domain);
            read.document.camera = camera;
            read.document.w.value = suite_w;
            items.push_back({.name = name, .read = std::move(read)});
        }
    } catch (const nlohmann::json::exception& error) {
        return wrong_input("--suite " + path +
                           ": it must be {\"camera\": {\"direction\", \"distance\", \"fov\"}, "
                           "\"surfaces\": [{\"name\", \"f\", \"domain\"}]}; " +
                           plain_message(error));
    }
    return items;
}

}  // namespace zeroset
