#include "app/cli/commands.hpp"
#include "app/cli/report.hpp"
#include "engine/base/text.hpp"
#include "engine/expr/patch_graph.hpp"
#include "engine/interpret/interpret.hpp"
#include "engine/rewrite/traceable.hpp"
#include "jit/compile.hpp"
#include "pipeline/input_error.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

/// f and its gradient at the point of --at.
struct ValueAt {
    double value = 0.0;
    std::array<double, 3> gradient{};
};

/// A surface as it was read and as it is drawn.
struct Explained {
    const Expr* expr = nullptr;
    Expr drawn;
    std::optional<ValueAt> at;
};

struct Explanation {
    std::shared_ptr<const Program> program;
    std::vector<Explained> surfaces;
    std::array<double, 4> point{};
    std::vector<double> parameters;  ///< the program's parameters, in its order
};

OrInputError<std::optional<std::array<double, 4>>> point_of(const ExplainCommand& command) {
    if (!command.at) return std::nullopt;
    const auto commas = std::ranges::count(*command.at, ',');
    const auto numbers = read_numbers("--at", *command.at, commas == 3 ? 4 : 3);
    if (!numbers) return std::unexpected(numbers.error());
    std::array<double, 4> point{};
    std::ranges::copy(*numbers, point.begin());
    return point;
}

ValueAt value_of(const Expr& expr, const Explanation& explanation) {
    const Dual<double> f = value_at(expr, explanation.point, explanation.parameters);
    ValueAt result{.value = f.value, .gradient = {}};
    for (std::size_t i = 0; i < 3; ++i)
        result.gradient[i] = f.slope[i].value_or(0.0);
    return result;
}

OrInputError<Explanation> explained(const ExplainCommand& command) {
    ViewText parameters;
    parameters.set = command.set;
    parameters.quiet = true;
    const auto input = read_document_with_rows(command.equation, parameters);
    if (!input) return std::unexpected(input.error());
    const auto point = point_of(command);
    if (!point) return std::unexpected(point.error());
    Explanation result{.program = input->rows->program,
                       .surfaces = {},
                       .point = point->value_or(std::array<double, 4>{}),
                       .parameters = {}};
    for (const std::string& name : result.program->parameters)
        result.parameters.push_back(slider_of(input->document, name).value);
    for (const Expr& expr : result.program->surfaces) {
        Explained surface{.expr = &expr, .drawn = traceable(expr), .at = std::nullopt};
        if (*point) surface.at = value_of(expr, result);
        result.surfaces.push_back(std::move(surface));
    }
    return result;
}

/// Prints one line; bytes that are no UTF-8 become replacement characters.
void print(const Json& json) {
    std::cout << json.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
}

int fail(const InputError& error, bool as_json) {
    if (!as_json) return report(error);
    const Json column = error.column ? Json(*error.column) : Json(nullptr);
    print(Json{{"ok", false},
               {"error", error.reason},
               {"column", column},
               {"unfinished", error.unfinished}});
    return exit_wrong_input;
}

Json json_of(const Explained& surface) {
    const std::optional<ValueAt>& at = surface.at;
    return {{"canonical", surface.expr->canonical()},
            {"drawn_as", surface.drawn.canonical()},
            {"value", at ? Json(at->value) : Json(nullptr)},
            {"gradient", at ? Json(at->gradient) : Json(nullptr)},
            {"nodes", surface.expr->nodes().size()}};
}

/// Prints the first surface's members, then everything else that the text says.
void print_json(const Explanation& explanation) {
    Json json{{"ok", true}};
    json.update(json_of(explanation.surfaces.front()));
    json["parameters"] = explanation.program->parameters;
    json["surfaces"] = Json::array();
    for (const Explained& surface : explanation.surfaces)
        json["surfaces"].push_back(json_of(surface));
    json["readings"] = Json::array();
    json["notes"] = Json::array();
    for (const Reading& reading : explanation.program->readings) {
        json["readings"].push_back(reading.text);
        for (const std::string& note : reading.notes)
            json["notes"].push_back(note);
    }
    print(json);
}

std::string list(const auto& values) {
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "" : ", ") + short_number(value, 17);
    return text;
}

void print_notes(const Reading& reading) {
    for (const std::string& note : reading.notes)
        std::cout << "note      " << note << "\n";
}

void print_surface(std::size_t index, const Reading& reading, const Explanation& explanation) {
    const Explained& surface = explanation.surfaces[index];
    const bool is_point = is_patch(*surface.expr);
    const bool is_equation = !is_point && !explanation.program->sheets[index];
    const std::string read = is_equation ? equation_text(*surface.expr) : reading.text;
    const std::string drawn = is_point ? read : equation_text(surface.drawn);
    std::cout << "read as   " << read << "\n";
    print_notes(reading);
    if (drawn != read) std::cout << "drawn as  " << drawn << "\n";
    std::cout << "graph     " << surface.expr->nodes().size() << " nodes\n";
    if (!surface.at) return;
    std::cout << "at        " << list(explanation.point) << "  (x, y, z, w)\n"
              << "f         " << short_number(surface.at->value, 17) << "\n"
              << "gradient  " << list(surface.at->gradient) << "\n";
}

void print_text(const Explanation& explanation) {
    std::vector<const Reading*> surfaces;
    for (const Reading& reading : explanation.program->readings) {
        if (reading.kind == StatementKind::Surface) {
            surfaces.push_back(&reading);
            continue;
        }
        std::cout << "with      " << reading.text << "\n";
        print_notes(reading);
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        print_surface(i, *surfaces[i], explanation);
    if (explanation.program->parameters.empty()) return;
    std::cout << "open      ";
    const std::vector<double>& values = explanation.parameters;
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::cout << (i == 0 ? "" : ", ") << explanation.program->parameters[i] << " = "
                  << short_number(values[i], 17);
    }
    std::cout << "  (parameters)\n";
}

int print_code(const Expr& expr, const ExplainCommand& command) {
    for (const auto& [wanted, make] :
         {std::pair{command.ir, &jit::ir}, std::pair{command.assembly, &jit::assembly}}) {
        if (!wanted) continue;
        const auto text = make(expr, {});
        if (!text) return report_run_time(text.error().message);
        std::cout << "\n" << *text;
    }
    return exit_ok;
}

}  // namespace

int run_explain(const ExplainCommand& command) {
    if (command.json && (command.ir || command.assembly)) {
        return report(
            {.reason = "--json excludes --ir and --asm; ask for them one after the other"});
    }
    const auto explanation = explained(command);
    if (!explanation) return fail(explanation.error(), command.json);
    if (command.json) {
        print_json(*explanation);
    } else {
        print_text(*explanation);
    }
    for (const Explained& surface : explanation->surfaces) {
        if (const int code = print_code(surface.drawn, command); code != exit_ok) return code;
    }
    return exit_ok;
}

}  // namespace zeroset
