#include "papers/along_rays/csg_parts.hpp"
#include "pipeline/formula.hpp"
#include "pipeline/picture_request.hpp"
#include "pipeline/prepare.hpp"
#include "tests/support/formulas.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

// The parts of solids that a picture's formula is made of, for the tracer by their roots.

namespace zeroset::test::csg_code_test {
namespace {

/// The parts of the surface of a formula in a picture of it.
const std::vector<Kernel>& parts_of(const Formula& formula) {
    PictureRequest request;
    request.formula = std::make_shared<const Formula>(formula);
    request.colors = std::make_shared<const ColorFormulas>();
    request.clip = Box::cube(2);
    request.size_px = {8, 8};
    request.surfaces.emplace_back();
    request.uniforms = {0.0};
    const Scene scene = scene_of(request);
    return scene.surfaces[0].kernel.memory->of<CsgParts>()->kernels();
}

TEST(CsgCode, IsThatOfThePartsOfSolids) {
    const Formula solid =
        compile_formula("max(x^2 + y^2 + z^2 - 1, -min(x - y^2, z + 0.2)) = 0.1").value();
    EXPECT_EQ(parts_of(solid).size(), 3U);
    const Formula deep = with_double(solid);
    ASSERT_EQ(parts_of(deep).size(), 3U);
    EXPECT_TRUE(parts_of(deep)[0].has_double);
}

TEST(CsgCode, IsNoneWhereFIsNoTreeOfParts) {
    EXPECT_TRUE(parts_of(compile_formula("x^2 + y^2 + z^2 = 1").value()).empty());
    EXPECT_TRUE(parts_of(compile_formula("sin(max(x, y)) = z").value()).empty());
}

}  // namespace
}  // namespace zeroset::test::csg_code_test
