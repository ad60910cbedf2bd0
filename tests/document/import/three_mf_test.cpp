// Tests of reading 3MF's implicit functions, in packages made here after the specification.

#include "document/import/import.hpp"
#include "document/row_program.hpp"
#include "tests/support/mpfr_number.hpp"

#include <gtest/gtest.h>
#include <zip.h>

#include <random>
#include <string>

namespace zeroset::test {
namespace {

/// A package with this model, stored in memory.
std::string package(const std::string& model) {
    zip_error_t error{};
    zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(target);
    zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
    zip_source_t* const part = zip_source_buffer(archive, model.data(), model.size(), 0);
    zip_file_add(archive, "3D/3dmodel.model", part, ZIP_FL_ENC_UTF_8);
    zip_close(archive);
    zip_source_open(target);
    zip_source_seek(target, 0, SEEK_END);
    const auto size = static_cast<std::size_t>(zip_source_tell(target));
    zip_source_seek(target, 0, SEEK_SET);
    std::string bytes(size, '\0');
    zip_source_read(target, bytes.data(), size);
    zip_source_close(target);
    zip_source_free(target);
    return bytes;
}

/// A sphere of radius 3 about (1, 0, 0), by a call of a function with a radius; in a box of [-4,
/// 4]^3 that the build moves by (10, 0, 0).
const std::string sphere_model = R"(<?xml version="1.0"?>
<model xmlns="core" xmlns:v="volumetric" xmlns:i="implicit">
<resources>
 <i:implicitfunction id="5">
  <i:in><i:vector identifier="pos"/><i:scalar identifier="radius"/></i:in>
  <i:length identifier="L"><i:in><i:vectorref identifier="A" ref="inputs.pos"/></i:in>
   <i:out><i:scalar identifier="result"/></i:out></i:length>
  <i:subtraction identifier="S"><i:in><i:scalarref identifier="A" ref="L.result"/>
   <i:scalarref identifier="B" ref="inputs.radius"/></i:in><i:out><i:scalar identifier="result"/></i:out></i:subtraction>
  <i:out><i:scalarref identifier="shape" ref="S.result"/></i:out>
 </i:implicitfunction>
 <i:implicitfunction id="6">
  <i:in><i:vector identifier="pos"/></i:in>
  <i:constant identifier="R" value="3"><i:out><i:scalar identifier="value"/></i:out></i:constant>
  <i:constvec identifier="C" x="1" y="0" z="0"><i:out><i:vector identifier="vector"/></i:out></i:constvec>
  <i:subtraction identifier="D"><i:in><i:vectorref identifier="A" ref="inputs.pos"/>
   <i:vectorref identifier="B" ref="C.vector"/></i:in><i:out><i:vector identifier="result"/></i:out></i:subtraction>
  <i:constresourceid identifier="F" resourceid="5"><i:out><i:resourceid identifier="value"/></i:out></i:constresourceid>
  <i:functioncall identifier="Call"><i:in><i:resourceref identifier="functionID" ref="F.value"/>
   <i:vectorref identifier="pos" ref="D.result"/><i:scalarref identifier="radius" ref="R.value"/></i:in>
   <i:out><i:scalar identifier="shape"/></i:out></i:functioncall>
  <i:out><i:scalarref identifier="shape" ref="Call.shape"/></i:out>
 </i:implicitfunction>
 <object id="1" type="model"><mesh><vertices>
  <vertex x="-4" y="-4" z="-4"/><vertex x="4" y="4" z="4"/></vertices><triangles/></mesh></object>
 <object id="2" type="model"><v:levelset functionid="6" channel="shape" meshid="1" meshbboxonly="true"/></object>
</resources>
<build><item objectid="2" transform="1 0 0 0 1 0 0 0 1 10 0 0"/></build>
</model>)";

TEST(ThreeMf, ImplicitFunctionsBecomeDefinitions) {
    const auto imported = read_import("ball.3mf", package(sphere_model));
    ASSERT_TRUE(imported) << imported.error();
    const ImportedDocument& ball = imported->documents[0];
    EXPECT_EQ(ball.refusal, "");
    const auto rows = read_rows(ball.document);
    ASSERT_TRUE(rows) << rows.error().reason;
    ASSERT_EQ(rows->program->surfaces.size(), 1U);
    const auto value = [&](double x, double y, double z) {
        return reference(rows->program->surfaces[0], std::array{x, y, z, 0.0}).value.nearest();
    };
    EXPECT_NEAR(value(11.0, 3.0, 0.0), 0.0, 1e-14);
    EXPECT_NEAR(value(11.0, 0.0, 0.0), -3.0, 1e-14);
    // Outside the box its walls are nearer than the sphere.
    EXPECT_NEAR(value(20.0, 0.0, 0.0), 6.0, 1e-14);
    EXPECT_LE(ball.document.clip.lo.x, 6.0);
    EXPECT_GE(ball.document.clip.hi.x, 14.0);
}

/// The function is asked at another place than that of the object: (x/2 - 2, y/2, z/2).
TEST(ThreeMf, LevelSetsMayHaveTransforms) {
    std::string moved = sphere_model;
    moved.replace(moved.find("meshbboxonly"), 0, "transform=\"0.5 0 0 0 0.5 0 0 0 0.5 -2 0 0\" ");
    moved.replace(moved.find(" transform=\"1 0"),
                  moved.rfind("/></build>") - moved.find(" transform=\"1 0"), "");
    const auto imported = read_import("ball.3mf", package(moved));
    ASSERT_TRUE(imported) << imported.error();
    EXPECT_EQ(imported->documents[0].refusal, "");
    const auto rows = read_rows(imported->documents[0].document);
    ASSERT_TRUE(rows);
    // The centre (1, 0, 0) is that of (6, 0, 0), beyond the box, whose wall at x = 4 is farther
    // from (0, 0, 0) than the ball.
    const auto value = [&](double x) {
        return reference(rows->program->surfaces[0], std::array{x, 0.0, 0.0, 0.0}).value.nearest();
    };
    EXPECT_NEAR(value(0.0), 0.0, 1e-14);
    EXPECT_NEAR(value(-2.0), 1.0, 1e-14);
    EXPECT_NEAR(value(3.0), -1.0, 1e-14);
}

TEST(ThreeMf, WhatIsNoLevelSetIsRefused) {
    EXPECT_FALSE(read_import("a.3mf", "PK"));
    EXPECT_FALSE(read_import("a.3mf", package("no xml <")));
    EXPECT_FALSE(read_import("a.3mf", package("<model/>")));
    std::string recursive = sphere_model;
    recursive.replace(recursive.find("resourceid=\"5\""), 14, "resourceid=\"6\"");
    EXPECT_FALSE(read_import("a.3mf", package(recursive)));
    std::string unknown = sphere_model;
    unknown.replace(unknown.find("i:length"), 8, "i:mesh");
    EXPECT_FALSE(read_import("a.3mf", package(unknown)));
}

TEST(ThreeMf, DamagedPackagesEnd) {
    const std::string whole = package(sphere_model);
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        std::string bytes =
            whole.substr(0, round % 2 == 0 ? random() % whole.size() : whole.size());
        for (int i = 0; i < 3 && !bytes.empty(); ++i)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        const auto imported = import_format("a.3mf")->read(bytes);
        EXPECT_TRUE(imported || !imported.error().empty());
    }
}

}  // namespace
}  // namespace zeroset::test
