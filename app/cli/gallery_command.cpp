#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"
#include "pipeline/gallery.hpp"

#include <nlohmann/json.hpp>

#include <iostream>

namespace zeroset {
namespace {

void print_json() {
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    for (const GalleryItem& item : gallery()) {
        items.push_back({{"name", item.name},
                         {"group", item.group},
                         {"title", item.title},
                         {"equation", item.equation},
                         {"about", item.about},
                         {"look", name_of(item.light.look)},
                         {"reflections", item.light.reflections},
                         {"source", item.source}});
    }
    std::cout << items.dump(2) << "\n";
}

void print_text() {
    std::string group;
    for (const GalleryItem& item : gallery()) {
        if (item.group != group) {
            std::cout << (group.empty() ? "" : "\n") << item.group << "\n";
            group = item.group;
        }
        std::cout << "\n  @" << item.name << "  " << item.title << "\n    " << item.equation
                  << "\n    " << item.about << "\n    Source: " << item.source << "\n";
    }
    std::cout << "\nDraw one: zeroset render @" << gallery().front().name << " -o "
              << gallery().front().name << ".png\n";
}

}  // namespace

int run_gallery(const GalleryCommand& command) {
    if (command.names) {
        for (const GalleryItem& item : gallery())
            std::cout << item.name << "\n";
    } else if (command.json) {
        print_json();
    } else {
        print_text();
    }
    return exit_ok;
}

}  // namespace zeroset
