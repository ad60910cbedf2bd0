#include "engine/trace/patch/patch_form.hpp"

#include "engine/interpret/interpret.hpp"
#include "engine/kernel/patch_code.hpp"
#include "engine/language/parse.hpp"
#include "engine/real/rounding.hpp"
#include "engine/taylor/patch_models.hpp"
#include "engine/trace/patch/patch_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

// Forms enclose the patch and its derivatives, against closed forms in long double.

namespace zeroset::test::patch_form_test {
namespace {

using Wide = long double;

std::shared_ptr<const PatchCode> code_of(const std::array<std::string, 3>& texts) {
    auto code = std::make_shared<PatchCode>();
    for (std::size_t i = 0; i < texts.size(); ++i) {
        code->point[i] = interpret(parse(texts[i]).value());
        code->point[i].has_double = true;
    }
    return code;
}

Uniforms no_parameters() {
    Uniforms uniforms;
    uniforms.set(0, 0.0);
    return uniforms;
}

const std::array<std::string, 3> wavy{"x*cos(3*y)", "x*sin(3*y)", "exp(x)*y + x^3"};

struct WideVector {
    std::array<Wide, 3> part;
};

WideVector value_at_place(Wide u, Wide v) {
    return {{u * std::cos(3 * v), u * std::sin(3 * v), std::exp(u) * v + u * u * u}};
}
WideVector by_u(Wide u, Wide v) {
    return {{std::cos(3 * v), std::sin(3 * v), std::exp(u) * v + 3 * u * u}};
}
WideVector by_v(Wide u, Wide v) {
    return {{-3 * u * std::sin(3 * v), 3 * u * std::cos(3 * v), std::exp(u)}};
}

TEST(PatchForms, EncloseThePatchAndItsDerivatives) {
    const PatchForms forms(code_of(wavy), no_parameters());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    for (int round = 0; round < 40; ++round) {
        const double u_radius = std::exp2(-round / 2.0);
        const double v_radius = std::exp2(-round / 2.5);
        PatchForms::Boxes boxes;
        for (UvBox& box : boxes)
            box = {
                .u = place(random), .v = place(random), .u_radius = u_radius, .v_radius = v_radius};
        PatchForms::Forms found;
        {
            const UpwardRounding upward;
            forms.evaluate(boxes, found);
        }
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const PatchForm& form = found[i];
            EXPECT_TRUE(form.continuous);
            for (int sample = 0; sample < 16; ++sample) {
                const Wide eu = share(random);
                const Wide ev = share(random);
                const Wide u = boxes[i].u + eu * u_radius;
                const Wide v = boxes[i].v + ev * v_radius;
                for (int k = 0; k < 3; ++k) {
                    const auto at = static_cast<std::size_t>(k);
                    const Wide linear = form.c[k] + form.ku[k] * eu + form.kv[k] * ev;
                    EXPECT_LE(std::abs(value_at_place(u, v).part[at] - linear), form.e[k]);
                    EXPECT_LE(std::abs(by_u(u, v).part[at] * u_radius - form.du[k]),
                              form.du_radius[k]);
                    EXPECT_LE(std::abs(by_v(u, v).part[at] * v_radius - form.dv[k]),
                              form.dv_radius[k]);
                }
            }
        }
    }
}

TEST(PatchForms, GetLinearAsBoxesGetSmall) {
    const PatchForms forms(code_of(wavy), no_parameters());
    const UpwardRounding upward;
    std::array<double, 2> errors{};
    for (std::size_t i = 0; i < errors.size(); ++i) {
        PatchForms::Boxes boxes;
        const double radius = i == 0 ? 0x1p-6 : 0x1p-10;
        boxes.fill({.u = 0.6, .v = 0.3, .u_radius = radius, .v_radius = radius});
        PatchForms::Forms found;
        forms.evaluate(boxes, found);
        errors[i] = found[0].e.z;
    }
    // By the square of the radius.
    EXPECT_LT(errors[1], errors[0] / 128.0);
}

TEST(PatchForms, KnowWhereAPoleIsNot) {
    const PatchForms forms(code_of({"x", "y", "1/x"}), no_parameters());
    const UpwardRounding upward;
    PatchForms::Boxes boxes;
    boxes.fill({.u = 0x1p-6, .v = 0.5, .u_radius = 0x1p-6, .v_radius = 0.5});
    PatchForms::Forms found;
    forms.evaluate(boxes, found);
    EXPECT_FALSE(found[0].continuous);
    // 1/x is 32 or more there, beyond the clip box.
    EXPECT_FALSE(form_within(found[0], Box::cube(2.0)));
    EXPECT_TRUE(form_within(found[0], Box::cube(40.0)));
    // On both sides of the pole it is beyond the box, too.
    boxes.fill({.u = 0.0, .v = 0.5, .u_radius = 0x1p-6, .v_radius = 0.5});
    forms.evaluate(boxes, found);
    EXPECT_FALSE(form_within(found[0], Box::cube(2.0)));
}

TEST(PatchTree, DividesAPartOnce) {
    const UpwardRounding upward;
    const PatchTree tree(code_of(wavy), no_parameters());
    PatchNode::Children* const parts = tree.parts(tree.root());
    ASSERT_NE(parts, nullptr);
    EXPECT_EQ(tree.parts(tree.root()), parts);
    EXPECT_EQ(tree.size(), 17U);
    double area = 0.0;
    for (const PatchNode& part : parts->nodes)
        area += 4.0 * part.box.u_radius * part.box.v_radius;
    EXPECT_EQ(area, 1.0);
}

TEST(PatchTree, DividesAPartIntoQuartersByModelsAlone) {
    const UpwardRounding upward;
    const PatchTree without(code_of(wavy), no_parameters());
    EXPECT_EQ(without.quarters(without.root()), nullptr);
    EXPECT_EQ(without.size(), 1U);

    std::array<Expr, 3> graphs;
    for (std::size_t i = 0; i < graphs.size(); ++i)
        graphs[i] = parse(wavy[i]).value();
    auto code = std::make_shared<PatchCode>(*code_of(wavy));
    code->modeler = patch_modeler(graphs);
    ASSERT_NE(code->modeler, nullptr);
    const PatchTree tree(code, no_parameters());
    PatchNode& part = tree.parts(tree.root())->nodes[5];
    PatchNode::Children* const quarters = tree.quarters(part);
    ASSERT_NE(quarters, nullptr);
    EXPECT_EQ(tree.quarters(part), quarters);
    ASSERT_EQ(quarters->nodes.size(), 4U);
    EXPECT_EQ(tree.size(), 21U);
    double area = 0.0;
    for (const PatchNode& node : quarters->nodes) {
        const UvBox& box = node.box;
        area += 4.0 * box.u_radius * box.v_radius;
        EXPECT_LE(std::abs(box.u - part.box.u) + box.u_radius, part.box.u_radius);
        EXPECT_LE(std::abs(box.v - part.box.v) + box.v_radius, part.box.v_radius);
        EXPECT_EQ(node.level, part.level + 1);
        ASSERT_NE(node.model, nullptr);
        const WideVector at = value_at_place(Wide{box.u}, Wide{box.v});
        for (int axis = 0; axis < 3; ++axis) {
            const auto x = static_cast<double>(at.part[static_cast<std::size_t>(axis)]);
            EXPECT_LE(std::abs(x - node.form.c[axis]), node.form.e[axis] * (1.0 + 0x1p-30));
        }
    }
    EXPECT_EQ(area, 4.0 * part.box.u_radius * part.box.v_radius);
}

/// The bounds hold for each degree, in any axes, however high it is.
TEST(PatchTree, KnowsHowLargeTheTermsOfModelsAre) {
    const UpwardRounding upward;
    std::array<Expr, 3> graphs;
    for (std::size_t i = 0; i < graphs.size(); ++i)
        graphs[i] = parse(wavy[i]).value();
    auto code = std::make_shared<PatchCode>(*code_of(wavy));
    code->modeler = patch_modeler(graphs);
    const PatchTree tree(code, no_parameters());
    int models = 0;
    for (const PatchNode& node : tree.parts(tree.root())->nodes) {
        if (node.model == nullptr) continue;
        ++models;
        std::size_t term = 0;
        for (std::size_t degree = 0; degree < node.sizes.size(); ++degree) {
            Wide sum = 0;
            for (std::size_t i = 0; i <= degree; ++i, ++term) {
                const auto square = [&](std::size_t k) {
                    const Wide of_axis{node.model->terms[k][term]};
                    return of_axis * of_axis;
                };
                sum += std::sqrt(square(0) + square(1) + square(2));
            }
            EXPECT_GE(Wide{node.sizes[degree]}, sum) << degree;
            EXPECT_LE(Wide{node.sizes[degree]}, sum * 1.00001L + 1e-37L) << degree;
        }
        EXPECT_EQ(term, patch_terms);
    }
    EXPECT_GT(models, 0);
}

TEST(PatchTree, HoldsThePatchInItsBoxes) {
    const UpwardRounding upward;
    const PatchTree tree(code_of(wavy), no_parameters());
    const std::vector<Box> boxes = tree.boxes();
    for (int i = 0; i <= 20; ++i) {
        for (int k = 0; k <= 20; ++k) {
            const WideVector at = value_at_place(i / Wide{20}, k / Wide{20});
            const bool is_held = std::ranges::any_of(boxes, [&](const Box& box) {
                bool inside = true;
                for (int axis = 0; axis < 3; ++axis) {
                    const Wide x = at.part[static_cast<std::size_t>(axis)];
                    inside = inside && x >= Wide{box.lo[axis]} && x <= Wide{box.hi[axis]};
                }
                return inside;
            });
            EXPECT_TRUE(is_held) << i << ", " << k;
        }
    }
}

}  // namespace
}  // namespace zeroset::test::patch_form_test
