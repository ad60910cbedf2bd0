// Tests of reading 3MF's implicit functions, in packages made here after the specification.

#include "document/import/import.hpp"
#include "document/row_program.hpp"
#include "tests/support/mpfr_number.hpp"

#include <gtest/gtest.h>
#include <zip.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace zeroset::test::three_mf_test {
namespace {

/// A part of a package: its name and its text.
struct Part {
    std::string name, text;
};

/// A package with these parts, stored in memory.
std::string package(const std::vector<Part>& parts) {
    zip_error_t error{};
    zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(target);
    zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
    for (const auto& [name, text] : parts) {
        zip_source_t* const part = zip_source_buffer(archive, text.data(), text.size(), 0);
        zip_file_add(archive, name.c_str(), part, ZIP_FL_ENC_UTF_8);
    }
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

std::string package(const std::string& model) { return package({{"3D/3dmodel.model", model}}); }

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

/// The sphere's model with one text in place of another.
std::string with(const std::string& text, const std::string& other) {
    std::string model = sphere_model;
    model.replace(model.find(text), text.size(), other);
    return model;
}

std::string why_refused(const std::string& model) {
    const auto imported = read_import("a.3mf", package(model));
    return imported ? std::string() : imported.error();
}

TEST(ThreeMf, WhatIsLostSaysWhy) {
    EXPECT_EQ(why_refused(with("functionid=\"6\"", "functionid=\"77\"")),
              "object 2: there is no implicit function 77 before it; it is left out");
    std::string unknown = with("<i:length", "<i:warp");
    unknown.replace(unknown.find("</i:length"), 10, "</i:warp");
    EXPECT_EQ(why_refused(unknown), "object 2: nodes warp are not taken over; it is left out");
    EXPECT_EQ(why_refused(with("ref=\"R.value\"", "ref=\"Q.value\"")),
              "object 2: Call refers to Q.value, which has no value; it is left out");
    EXPECT_EQ(why_refused(with("ref=\"S.result\"", "ref=\"T.result\"")),
              "object 2: function 5 has no output shape; it is left out");
    EXPECT_EQ(
        why_refused(with("meshid=\"1\"", "meshid=\"9\"")),
        "object 2: it has no mesh that bounds it, or a transform that is no matrix; it is left "
        "out");
}

TEST(ThreeMf, WhatIsNotUsedMayBeUnknown) {
    EXPECT_EQ(why_refused(with("<i:out><i:scalar identifier=\"shape\"/></i:out></i:functioncall>",
                               "<i:out><i:scalar identifier=\"shape\"/><i:vector "
                               "identifier=\"color\"/></i:out></i:functioncall>")),
              "");
    EXPECT_EQ(why_refused(with("<i:constant", "<i:warp identifier=\"W\"/><i:constant")), "");
}

/// The level set is that of `nodes`, which end with a node r.
ImportedDocument level_set(const std::string& nodes) {
    const auto imported = read_import("a.3mf", package(R"(<model><resources>
 <implicitfunction id="6"><in><vector identifier="pos"/></in>)" +
                                                       nodes + R"(
  <out><scalarref identifier="shape" ref="r.result"/></out></implicitfunction>
 <object id="1"><mesh><vertices><vertex x="-9" y="-9" z="-9"/><vertex x="9" y="9" z="9"/></vertices>
 </mesh></object>
 <object id="2"><levelset functionid="6" channel="shape" meshid="1" meshbboxonly="true"/></object>
</resources><build><item objectid="2"/></build></model>)"));
    EXPECT_TRUE(imported) << imported.error();
    if (!imported) return {.name = {}};
    EXPECT_EQ(imported->documents[0].refusal, "");
    return imported->documents[0];
}

double level(const ImportedDocument& set, double x, double y, double z) {
    const auto rows = read_rows(set.document);
    if (!rows) return std::nan("");
    return reference(rows->program->surfaces[0], std::array{x, y, z, 0.0}).value.nearest();
}

std::string input(const std::string& identifier, const std::string& from) {
    return "<ref identifier=\"" + identifier + "\" ref=\"" + from + "\"/>";
}

/// "<kind identifier='name'><in>...</in></kind>" with these inputs.
std::string node(const std::string& kind, const std::string& name, const std::string& inputs) {
    return "<" + kind + " identifier=\"" + name + "\"><in>" + inputs + "</in></" + kind + ">";
}

/// x + 10 y + 100 z of the vector v, divided by 100.
const std::string sum_of_v = R"(<constvec identifier="w" x="0.01" y="0.1" z="1"/>)" +
                             node("dot", "r", input("A", "v.result") + input("B", "w.vector"));

TEST(ThreeMf, MatricesAreComposed) {
    // Rows 1 2 3 4, 0 1 4 5, 5 6 0 6: at (1, 2, 3) they give 18, 19, 23.
    std::string elements;
    std::string inputs;
    const std::array<int, 16> m{1, 2, 3, 4, 0, 1, 4, 5, 5, 6, 0, 6, 0, 0, 0, 1};
    for (std::size_t i = 0; i < m.size(); ++i) {
        const std::string name = std::to_string(i / 4) + std::to_string(i % 4);
        elements +=
            "<constant identifier=\"c" + name + "\" value=\"" + std::to_string(m[i]) + "\"/>";
        inputs += input("m" + name, "c" + name + ".value");
    }
    const std::string matrix = elements + node("composematrix", "m", inputs);
    const std::string at = input("B", "inputs.pos");
    const auto composed = level_set(
        matrix + node("matvecmultiplication", "v", input("A", "m.result") + at) + sum_of_v);
    EXPECT_NEAR(level(composed, 1, 2, 3), 0.18 + 1.9 + 23.0, 1e-12);
    // The inverse leads back.
    const auto back = level_set(
        matrix + node("inverse", "i", input("A", "m.result")) +
        node("matrixvectormultiplication", "p", input("A", "m.result") + at) +
        node("matvecmultiplication", "v", input("A", "i.result") + input("B", "p.result")) +
        sum_of_v);
    EXPECT_NEAR(level(back, 1, 2, 3), 0.01 + 0.2 + 3.0, 1e-12);
    EXPECT_NEAR(level(back, -4, 7, 0.5), -0.04 + 0.7 + 0.5, 1e-12);
}

TEST(ThreeMf, MatricesAreMadeOfRowsAndColumns) {
    const std::string vectors =
        R"(<constvec identifier="a" x="1" y="0" z="5"/><constvec identifier="b" x="2" y="1" z="6"/>
<constvec identifier="c" x="3" y="4" z="0"/><constvec identifier="d" x="4" y="5" z="6"/>)";
    const std::string inputs = input("A", "a.vector") + input("B", "b.vector") +
                               input("C", "c.vector") + input("D", "d.vector");
    const std::string at = input("B", "inputs.pos");
    const auto columns =
        level_set(vectors + node("matrixfromcolumns", "m", inputs) +
                  node("matvecmultiplication", "v", input("A", "m.result") + at) + sum_of_v);
    EXPECT_NEAR(level(columns, 1, 2, 3), 0.18 + 1.9 + 23.0, 1e-12);
    // A fourth row moves nothing.
    const auto rows =
        level_set(vectors + node("matrixfromrows", "m", inputs) +
                  node("matvecmultiplication", "v", input("A", "m.result") + at) + sum_of_v);
    EXPECT_NEAR(level(rows, 1, 2, 3), 0.16 + 2.2 + 11.0, 1e-12);
    const auto turned =
        level_set(vectors + node("matrixfromrows", "m", inputs) +
                  node("transpose", "t", input("A", "m.result")) +
                  node("matvecmultiplication", "v", input("A", "t.result") + at) + sum_of_v);
    EXPECT_NEAR(level(turned, 1, 2, 3), 0.18 + 1.9 + 23.0, 1e-12);
}

TEST(ThreeMf, NodesMayStandInAnyOrder) {
    const std::string sum = node("addition", "r", input("A", "d.x") + input("B", "d.y"));
    const std::string parts = node("decomposevector", "d", input("A", "inputs.pos"));
    EXPECT_NEAR(level(level_set(sum + parts), 1, 2, 3), 3.0, 1e-12);
    // Nodes that lead back to themselves have no value.
    std::string loop = with("ref=\"D.result\"", "ref=\"E.result\"");
    loop.insert(
        loop.find("<i:subtraction identifier=\"D\""),
        node("abs", "E", input("A", "G.result")) + node("abs", "G", input("A", "E.result")));
    EXPECT_EQ(why_refused(loop),
              "object 2: G refers to E.result, which has no value; it is left out");
    // Inputs that a node of an unknown kind lacks do not matter.
    std::string unknown = with("ref=\"D.result\"", "ref=\"M.result\"");
    unknown.insert(unknown.find("<i:constant"), node("mesh", "M", input("A", "")));
    EXPECT_EQ(why_refused(unknown), "object 2: nodes mesh are not taken over; it is left out");
}

TEST(ThreeMf, NodesNeedTheirInputs) {
    const auto with_node = [](const std::string& kind, const std::string& inputs) {
        std::string model = with("ref=\"D.result\"", "ref=\"N.result\"");
        model.insert(model.find("<i:constant"), node(kind, "N", inputs));
        return why_refused(model);
    };
    for (const std::string kind : {"addition", "inverse", "composematrix", "atan2", "clamp"})
        EXPECT_EQ(
            with_node(kind, input("A", "inputs.pos")),
            "object 2: " + kind + " lacks an input, or has one of another type; it is left out");
    EXPECT_EQ(with_node("log10", input("A", "inputs.pos")), "");
}

TEST(ThreeMf, ArcsHaveTwoNames) {
    for (const std::string prefix : {"a", "arc"}) {
        const auto set =
            level_set(node("decomposevector", "p", input("A", "inputs.pos")) +
                      node(prefix + "sin", "s", input("A", "p.x")) +
                      node(prefix + "cos", "c", input("A", "p.y")) +
                      node(prefix + "tan", "t", input("A", "p.z")) +
                      node(prefix + "tan2", "u", input("A", "p.x") + input("B", "p.z")) +
                      node("addition", "sc", input("A", "s.result") + input("B", "c.result")) +
                      node("addition", "tu", input("A", "t.result") + input("B", "u.result")) +
                      node("addition", "r", input("A", "sc.result") + input("B", "tu.result")));
        EXPECT_NEAR(level(set, 0.5, 0.25, -2.0),
                    std::asin(0.5) + std::acos(0.25) + std::atan(-2.0) + std::atan2(0.5, -2.0),
                    1e-12);
    }
}

/// Packages of several models, as of the production extension, name their root.
TEST(ThreeMf, TheModelIsThatOfTheRelationships) {
    const std::string empty = "<model><resources/><build/></model>";
    const std::string relations =
        R"(<Relationships><Relationship Target="/Metadata/a.png" Type="http://x/thumbnail"/>
<Relationship Target="/3D/Root.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>)";
    for (const std::string name : {"_rels/.rels", "_RELS/.rels"}) {
        const auto imported = read_import("a.3mf", package({{"3D/a.model", empty},
                                                            {"3d/root.model", sphere_model},
                                                            {"3D/z.model", empty},
                                                            {name, relations}}));
        EXPECT_TRUE(imported) << imported.error();
    }
    EXPECT_TRUE(read_import(
        "a.3mf",
        package({{"_rels/.rels", relations}, {"other.model", sphere_model}, {"z.model", empty}})));
    EXPECT_FALSE(read_import("a.3mf", package(std::vector<Part>{{"_rels/.rels", relations}})));
}

/// A mesh whose volume has a boundary, and names of nodes, as the extension's drafts had them.
TEST(ThreeMf, DraftsAreRead) {
    const std::string nodes =
        node("decomposevector", "p", input("A", "inputs.pos")) +
        R"(<constvec identifier="w" x="2" y="0" z="0"/>)" +
        node("dotproduct", "d", input("A", "inputs.pos") + input("B", "w.vector")) +
        node("sinus", "s", input("A", "p.y")) + node("cosinus", "c", input("A", "p.z")) +
        node("addition", "sc", input("A", "s.result") + input("B", "c.result")) +
        node("addition", "r", input("A", "sc.result") + input("B", "d.result"));
    for (const std::string tag : {"boundary", "levelset"}) {
        const auto imported = read_import(
            "a.3mf",
            package(
                R"(<model><resources><implicitfunction id="6"><in><vector identifier="pos"/></in>)" +
                nodes +
                R"(<out><scalarref identifier="shape" ref="r.result"/></out></implicitfunction>
<object id="1"><mesh><vertices><vertex x="-9" y="-9" z="-9"/><vertex x="9" y="9" z="9"/></vertices>
<triangles/><volumedata><)" +
                tag + R"( functionid="6" channel="shape"/></volumedata></mesh></object>
</resources><build><item objectid="1"/></build></model>)"));
        ASSERT_TRUE(imported) << imported.error();
        EXPECT_NEAR(level(imported->documents[0], 0.5, 0.25, -2.0),
                    std::sin(0.25) + std::cos(-2.0) + 1.0, 1e-12);
    }
}

TEST(ThreeMf, WhatHasNoValueIsNamed) {
    const auto zero = [](const std::string& value) {
        std::string model = with("ref=\"R.value\"", "ref=\"Half.result\"");
        model.insert(
            model.find("<i:constvec"),
            "<i:constant identifier=\"None\" value=\"" + value + "\"/>" +
                node("division", "Half", input("A", "R.value") + input("B", "None.value")));
        return why_refused(model);
    };
    EXPECT_EQ(zero("2"), "");
    EXPECT_EQ(zero("0"), "object 2: node Half divides by 0; it is left out");
    EXPECT_EQ(zero("-0.0"), "object 2: node Half divides by 0; it is left out");
    std::string image = with("functionid=\"6\"", "functionid=\"7\"");
    image.insert(image.find("<object"), "<v:functionfromimage3d id=\"7\" image3did=\"8\"/>");
    EXPECT_EQ(why_refused(image),
              "object 2: function 7 is made of an image, which is not taken over; it is left out");
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
        const auto imported = import_format("a.3mf")->read(bytes, {});
        EXPECT_TRUE(imported || !imported.error().empty());
    }
}

}  // namespace
}  // namespace zeroset::test::three_mf_test
