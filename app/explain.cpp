#include "app/commands.hpp"
#include "app/text.hpp"
#include "engine/expr/interpret.hpp"
#include "jit/compile.hpp"

#include <nlohmann/json.hpp>

#include <iostream>

namespace zeroset {
namespace {

using Json = nlohmann::ordered_json;

/// f and its gradient at the point of --at.
struct ValueAt {
    std::array<double, 4> point{};
    double value = 0.0;
    std::array<double, 3> gradient{};
};

OrInputError<std::optional<ValueAt>> value_of(const Expr& expr, const ExplainCommand& command) {
    if (!command.at) return std::nullopt;
    const auto commas = std::ranges::count(*command.at, ',');
    const auto numbers = read_numbers("--at", *command.at, commas == 3 ? 4 : 3);
    if (!numbers) return std::unexpected(numbers.error());
    ValueAt result;
    std::ranges::copy(*numbers, result.point.begin());
    const Dual<double> f = value_at(expr, result.point);
    result.value = f.value;
    for (std::size_t i = 0; i < 3; ++i)
        result.gradient[i] = f.slope[i].value_or(0.0);
    return result;
}

/// One line; bytes that are no UTF-8 become replacement characters.
void print(const Json& json) {
    std::cout << json.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
}

int fail(const InputError& error, bool as_json) {
    if (!as_json) return report(error);
    const Json column = error.column ? Json(*error.column) : Json(nullptr);
    print(Json{{"ok", false}, {"error", error.reason}, {"column", column}});
    return exit_wrong_input;
}

void print_json(const Expr& expr, const std::optional<ValueAt>& at) {
    const std::vector<std::string> parameters(expr.parameters().begin(), expr.parameters().end());
    const Json json{{"ok", true},
                    {"canonical", expr.canonical()},
                    {"value", at ? Json(at->value) : Json(nullptr)},
                    {"gradient", at ? Json(at->gradient) : Json(nullptr)},
                    {"parameters", parameters},
                    {"nodes", expr.nodes().size()}};
    print(json);
}

void print_text(const Expr& expr, const std::optional<ValueAt>& at) {
    std::cout << "read as   " << expr.canonical() << " = 0\n"
              << "graph     " << expr.nodes().size() << " nodes\n";
    if (!at) return;
    const auto list = [](const auto& numbers) {
        std::string text;
        for (const double number : numbers) {
            text += (text.empty() ? "" : ", ") + short_number(number, 17);
        }
        return text;
    };
    std::cout << "at        " << list(at->point) << "  (x, y, z, w)\n"
              << "f         " << short_number(at->value, 17) << "\n"
              << "gradient  " << list(at->gradient) << "\n";
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
        return report({"--json excludes --ir and --asm; ask for them one after the other"});
    }
    const auto text = read_equation(command.equation);
    if (!text) return fail(text.error(), command.json);
    const auto expr = read_formula(*text);
    if (!expr) return fail(expr.error(), command.json);
    const auto at = value_of(*expr, command);
    if (!at) return fail(at.error(), command.json);
    if (command.json) {
        print_json(*expr, *at);
    } else {
        print_text(*expr, *at);
    }
    return print_code(*expr, command);
}

}  // namespace zeroset
