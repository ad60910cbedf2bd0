#pragma once

#include "engine/blobs/blobs.hpp"
#include "engine/scene/scene.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/voxel_scenes.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

// Scenes of soft balls at random.

namespace zeroset::test {

struct Cloud {
    int count = 150;
    double least = 0.08, largest = 0.2;
    double hollow = 0.1;  ///< the share of balls that take away
    double scale = 1;
    glm::dvec3 middle{0.0};
};

inline std::vector<Blob> balls_of(const Cloud& cloud, std::uint64_t seed = 5) {
    RandomNumbers random(seed);
    std::vector<Blob> balls;
    for (int n = 0; n < cloud.count; ++n) {
        Blob ball;
        for (int i = 0; i < 3; ++i) {
            ball.center[static_cast<std::size_t>(i)] =
                cloud.middle[i] + cloud.scale * random.uniform(-1, 1);
        }
        ball.radius = cloud.scale * random.uniform(cloud.least, cloud.largest);
        ball.strength = random.uniform(0, 1) < cloud.hollow ? -random.uniform(0.2, 1)
                                                            : random.uniform(0.6, 1.5);
        balls.push_back(ball);
    }
    return balls;
}

inline Expr level_of(const std::shared_ptr<const Field>& field, double level) {
    ExprBuilder nodes;
    const NodeId f = nodes.look_up(field, nodes.variable(0), nodes.variable(1), nodes.variable(2));
    return nodes.finish(nodes.apply(Op::Subtract, f, nodes.constant(level)));
}

/// Two scenes of a surface: one whose kernel tells what field it is, and one of a formula.
struct Both {
    Scene balls, beams;
};
inline Both both_of(BlobKind kind, const Cloud& cloud, double level) {
    const Expr f = level_of(blobs_field(kind, balls_of(cloud), "test"), level);
    const double reach = 1.2 * cloud.scale;
    const Box box{cloud.middle - reach, cloud.middle + reach};
    Both both{.balls = {{{.kernel = kernel_with_level(f)}}, box, {}},
              .beams = {{{.kernel = interpret(f)}}, box, {}}};
    both.balls.uniforms.set(0, 0.0);
    both.beams.uniforms.set(0, 0.0);
    return both;
}

}  // namespace zeroset::test
