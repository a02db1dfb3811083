#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/LoadText.h"
#include "loaders/materials/TexCoordBinding.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Which of a mesh's sets a diffuse picture takes that asks for `name`, and what is said.
struct Bound {
    explicit Bound(const std::string& name, const std::vector<int>& sets, const std::string& inputs = "",
                   Primitive primitive = Primitive::Triangles)
        : load("<COLLADA><instance_material id='m'>" + inputs + "</instance_material></COLLADA>") {
        MeshData mesh;
        for (const int number : sets) mesh.texCoordSets.push_back({number, {}});
        Material material;
        material.slot(Slot::Diffuse).texture = 0;
        material.slot(Slot::Diffuse).texCoordName = name;
        MeshPart part;
        part.primitive = primitive;
        PartMaterial bound;
        bound.texCoordSets.fill(-1);
        bindTexCoords(material, load.byId("m"), mesh, part, load.context, bound);
        set = bound.texCoordSets[static_cast<std::size_t>(Slot::Diffuse)];
        said = codes(load.diagnostics.all());
    }
    TestLoad load;
    int set = -1;
    std::vector<std::string> said;
};

TEST(TexCoordBindingTest, theNumberAtTheNamesEndSaysWhichSetIsMeant) {
    EXPECT_EQ(Bound("UVSET1", {0, 1}).set, 1);
    EXPECT_EQ(Bound("CHANNEL3", {1, 3}).set, 1);
    EXPECT_EQ(Bound("1", {0, 1}).set, 1);
    EXPECT_EQ(Bound("map:1", {5, 7}).set, 1) << "no set has that number: the second one";
    EXPECT_EQ(Bound("map9", {5, 7}).set, 0);
    EXPECT_EQ(Bound("map", {5, 7}).set, 0);
    EXPECT_EQ(Bound("", {5, 7}).set, 0);
    EXPECT_EQ(Bound("UV99999999999", {5, 7}).set, 0);
}

TEST(TexCoordBindingTest, aBindingCountsBeforeTheName) {
    const std::string to = "<bind_vertex_input semantic='UVSET1' input_semantic='TEXCOORD'";
    EXPECT_EQ(Bound("UVSET1", {0, 1}, to + " input_set='0'/>").set, 0);
    EXPECT_EQ(Bound("UVSET1", {1, 0}, to + "/>").set, 1) << "without a number, set 0 is meant";
    const Bound odd("UVSET1", {1, 0}, to + " input_set='one'/>");
    EXPECT_EQ(odd.set, 1);
    EXPECT_THAT(odd.said, ElementsAre("WC0210"));
    EXPECT_EQ(Bound("UVSET1", {0, 1}, "<bind_vertex_input semantic='OTHER' input_set='0'/>").set, 1);
}

TEST(TexCoordBindingTest, linesNeedNoTextureCoordinates) {
    EXPECT_THAT(Bound("UV", {}).said, ElementsAre("WC0613"));
    EXPECT_THAT(Bound("UV", {}, "", Primitive::Lines).said, IsEmpty());
}

}  // namespace
}  // namespace walkcycle
