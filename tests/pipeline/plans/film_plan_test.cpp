#include "pipeline/plans/film_plan.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace zeroset::test::film_plan_test {
namespace {

FilmPlan plan_with(FilmEnd end, int frames) {
    FilmPlan plan;
    plan.frames = frames;
    plan.end = end;
    return plan;
}

TEST(FilmPlan, EndsAsItSays) {
    EXPECT_DOUBLE_EQ(progress_at(plan_with(FilmEnd::Stop, 11), 0), 0.0);
    EXPECT_DOUBLE_EQ(progress_at(plan_with(FilmEnd::Stop, 11), 10), 1.0);
    EXPECT_DOUBLE_EQ(progress_at(plan_with(FilmEnd::Loop, 10), 9), 0.9);
    EXPECT_DOUBLE_EQ(progress_at(plan_with(FilmEnd::Loop, 10), 10), 0.0);
    EXPECT_DOUBLE_EQ(progress_at(plan_with(FilmEnd::Loop, 10), -0.5), 0.95);
    EXPECT_DOUBLE_EQ(progress_at(plan_with(FilmEnd::Bounce, 10), 5), 1.0);
    EXPECT_DOUBLE_EQ(progress_at(plan_with(FilmEnd::Stop, 1), 0), 0.0);
    FilmPlan smooth = plan_with(FilmEnd::Stop, 5);
    smooth.easing = Easing::Smooth;
    EXPECT_LT(progress_at(smooth, 1), 0.2);
    EXPECT_DOUBLE_EQ(progress_at(smooth, 2), 0.5);
}

TEST(FilmPlan, ComesBackThroughTheSameFrames) {
    for (const int frames : {2, 7, 10, 180}) {
        FilmPlan plan = plan_with(FilmEnd::Bounce, frames);
        plan.easing = Easing::Smooth;
        for (int frame = 0; frame <= frames; ++frame)
            EXPECT_EQ(progress_at(plan, frame), progress_at(plan, frames - frame)) << frame;
        EXPECT_EQ(progress_at(plan, -0.25), progress_at(plan, 0.25)) << "moments of motion blur";
    }
}

TEST(FilmPlan, ATurnSeesAllOfTheBoxFromEverySide) {
    Document document = empty_document();
    document.clip = Box{{-3, -0.5, -1}, {3, 0.5, 1}};
    FilmPlan plan = plan_with(FilmEnd::Loop, 36);
    plan.turn = CameraTurn{};
    for (const double aspect : {0.4, 1.0, 16.0 / 9.0}) {
        const FilmScript script(plan, document, aspect);
        double largest = 0.0;
        for (int frame = 0; frame < plan.frames; ++frame) {
            const ViewFrame view(*script.document_at(frame).camera);
            for (unsigned corner = 0; corner < 8; ++corner) {
                glm::dvec3 point;
                for (int axis = 0; axis < 3; ++axis)
                    point[axis] = (corner >> axis & 1U) != 0 ? document.clip.hi[axis]
                                                             : document.clip.lo[axis];
                const glm::dvec3 place = view.homogeneous(point);
                ASSERT_GT(place.z, 0.0);
                largest = std::max(
                    {largest, std::abs(place.x / place.z) / aspect, std::abs(place.y / place.z)});
            }
        }
        EXPECT_LE(largest, 1.0) << aspect;
        EXPECT_GE(largest, 0.8) << aspect << ": no farther than it need be";
    }
}

TEST(FilmPlan, ATurnKeepsTheDistanceAndComesBack) {
    Document document = empty_document();
    document.camera = Camera{{3, -2, 1}, {0.5, 0, 0}, {0, 0, 1}, 0.7};
    FilmPlan plan = plan_with(FilmEnd::Loop, 8);
    plan.turn = CameraTurn{.axis = {0, 0, 2}, .degrees = 360.0};
    const FilmScript script(plan, document, 1.0);
    EXPECT_EQ(script.document_at(0).camera->eye, document.camera->eye);
    const glm::dvec3 opposite = script.document_at(4).camera->eye;
    EXPECT_NEAR(opposite.x, 0.5 - 2.5, 1e-12);
    EXPECT_NEAR(opposite.y, 2.0, 1e-12);
    EXPECT_NEAR(opposite.z, 1.0, 1e-12);
}

TEST(FilmPlan, SweepsParametersAndW) {
    FilmPlan plan = plan_with(FilmEnd::Stop, 5);
    plan.sweeps = {{"a", 1.0, 3.0}, {"w", 0.0, -40.0}};
    const FilmScript script(plan, empty_document(), 1.0);
    EXPECT_DOUBLE_EQ(slider_of(script.document_at(2), "a").value, 2.0);
    EXPECT_DOUBLE_EQ(script.document_at(4).w.value, -40.0);
}

TEST(FilmPlan, AWayHasConstantSpeedThroughItsCameras) {
    FilmPlan plan = plan_with(FilmEnd::Stop, 201);
    for (const glm::dvec3 eye : {glm::dvec3(5, 0, 0), glm::dvec3(4, 3, 1), glm::dvec3(-4, 3, 0)})
        plan.path.push_back(Camera{eye, {0, 0, 0}, {0, 0, 1}, 0.7});
    const FilmScript script(plan, empty_document(), 1.0);
    const auto eye_at = [&](double frame) { return script.document_at(frame).camera->eye; };
    EXPECT_LT(glm::distance(eye_at(0), plan.path.front().eye), 1e-9);
    EXPECT_LT(glm::distance(eye_at(200), plan.path.back().eye), 1e-9);
    const double first = glm::distance(eye_at(0), eye_at(1));
    double nearest = 1e9;
    for (int frame = 0; frame < 200; ++frame) {
        EXPECT_NEAR(glm::distance(eye_at(frame), eye_at(frame + 1)), first, 0.02 * first) << frame;
        nearest = std::min(nearest, glm::distance(eye_at(frame), plan.path[1].eye));
    }
    EXPECT_LT(nearest, first);
}

}  // namespace
}  // namespace zeroset::test::film_plan_test
