#include "engine/interpret/interpret.hpp"
#include "engine/kernel/form_cells.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "jit/compile.hpp"
#include "tests/support/interpreter_codes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Tests of the depths at which forms on rays report that a switch may change
// (FormBatchOf::cut_from).

namespace zeroset::test::cut_test {
namespace {

constexpr std::size_t cells = batch_multiple;

template <class Real>
struct CutBatch {
    FormCells<Real, cells> forms;
    std::array<Real, cells> from, to;

    /// Evaluates the kernel's form on the x axis from x = 0 to 2.
    explicit CutBatch(const Kernel& kernel) {
        const UpwardRounding upward;
        FrustumOf<Real> frustum{};
        frustum.right[1] = frustum.up[2] = frustum.forward[0] = 1;
        for (std::size_t k = 0; k < 3; ++k)
            frustum.size[k] = frustum.direction_size[k] = 4;
        forms.u.fill(Real{0});
        forms.v.fill(Real{0});
        forms.s.fill(Real{1});
        forms.s_radius.fill(Real{1});
        from.fill(7);
        to.fill(7);
        Uniforms uniforms;
        uniforms.set(0, 0.0);
        FormBatchOf<Real> batch = forms.batch(cells, frustum, uniforms.boxes<Real>());
        batch.cut_from = from.data();
        batch.cut_to = to.data();
        kernel.ray_form(batch);
    }
};

std::vector<std::pair<std::string, Kernel>> kernels_of(std::string_view text) {
    const auto expr = parse(text);
    EXPECT_TRUE(expr) << text;
    std::vector<std::pair<std::string, Kernel>> kernels;
    for (const auto& [name, code] : interpreter_codes()) {
        Kernel kernel = interpret(*expr);
        kernel.in_float.ray_form.call = code->in_float.ray_form;
        kernel.in_double.ray_form.call = code->in_double.ray_form;
        kernels.emplace_back(name, std::move(kernel));
    }
    for (const int lanes : {4, 8, 16}) {
        auto kernel = jit::compile(*expr, {.lanes = lanes, .with_double = true});
        if (kernel) kernels.emplace_back(std::to_string(lanes) + " lanes", std::move(*kernel));
    }
    return kernels;
}

template <class Real>
class Cuts : public testing::Test {
protected:
    /// Expects a narrow bracket around x as the first place where a switch of the text may change.
    static void expect_at(std::string_view text, double x) {
        for (const auto& [name, kernel] : kernels_of(text)) {
            const CutBatch<Real> batch(kernel);
            for (std::size_t i = 0; i < cells; ++i) {
                EXPECT_LE(static_cast<double>(batch.from[i]), x - 1.0) << text << " " << name;
                EXPECT_GE(static_cast<double>(batch.to[i]), x - 1.0) << text << " " << name;
                EXPECT_LT(batch.to[i] - batch.from[i], 1e-4) << text << " " << name;
            }
        }
    }
    static void expect_none(std::string_view text) {
        for (const auto& [name, kernel] : kernels_of(text)) {
            const CutBatch<Real> batch(kernel);
            EXPECT_GT(batch.from[0], batch.to[0]) << text << " " << name;
        }
    }
};
using Types = testing::Types<float, double>;
struct Names {
    template <class Real>
    static std::string GetName(int /*index*/) {
        return sizeof(Real) == 4 ? "Float" : "Double";
    }
};
TYPED_TEST_SUITE(Cuts, Types, Names);

TYPED_TEST(Cuts, AreWhereAConditionChanges) {
    this->expect_at("if(x < 0.3, y, z)", 0.3);
    this->expect_at("if(0.7 <= x, y, z)", 0.7);
    this->expect_at("if(abs(x - 4) < 2.5, 1, 0) + y", 1.5);
    this->expect_at("if(!(x < 0.3) && y < 1, y, z)", 0.3);
}

TYPED_TEST(Cuts, AreWhereAStepIs) {
    this->expect_at("sign(x - 1.1)", 1.1);
    this->expect_at("floor(x/1.5) + y", 1.5);
    this->expect_at("ceil(x/1.5 + 0.2) + y", 1.2);
    this->expect_at("round(x/1.8) + y", 0.9);
    this->expect_at("mod(x + 0.4, 1.6)", 1.2);
}

TYPED_TEST(Cuts, AreWhereAnAngleIsCut) { this->expect_at("atan2(x - 0.4, -1 - y)", 0.4); }

TYPED_TEST(Cuts, AreTheFirst) {
    this->expect_at("if(x < 1.7, 1, 0) + if(x < 0.6, 1, 0) + if(x < 0.9, 1, 0)", 0.6);
}

TYPED_TEST(Cuts, AreNowhereElse) {
    this->expect_none("if(x < 5, y, z)");
    this->expect_none("if(y < 0.3, x, z)");
    this->expect_none("if(y < z + 1, x, z) + floor(y + 0.5) x");
}

}  // namespace
}  // namespace zeroset::test::cut_test
