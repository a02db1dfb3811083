#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/LoadText.h"

namespace walkcycle {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;

std::string fixtureOf(const QuirkInfo& quirk) {
    return WALKCYCLE_FIXTURES "/quirks/" + std::string(quirk.name) + ".dae";
}

// The quirk's own fixture, read as its tool says, with the quirk and without it.
struct Readings {
    explicit Readings(Quirk quirk)
        : automatic(loadCollada(fixtureOf(infoOf(quirk)))),
          on(readWith(infoOf(quirk), true)),
          off(readWith(infoOf(quirk), false)) {}
    Model automatic, on, off;

private:
    static Model readWith(const QuirkInfo& quirk, bool isOn) {
        LoadOptions options;
        options.quirks[std::string(quirk.name)] = isOn;
        return loadCollada(fixtureOf(quirk), options);
    }
};

TEST(QuirksTest, eachFixtureIsReadWithItsQuirkByDefaultAndSaysSoOnce) {
    for (const QuirkInfo& quirk : kQuirks) {
        const Readings read(quirk.quirk);
        const std::vector<std::string> said = codes(read.on.diagnostics);
        EXPECT_EQ(codes(read.automatic.diagnostics), said) << quirk.name;
        if (quirk.code.empty()) continue;
        EXPECT_EQ(std::count(said.begin(), said.end(), quirk.code), 1) << quirk.name;
        EXPECT_THAT(codes(read.off.diagnostics), Not(Contains(std::string(quirk.code)))) << quirk.name;
        for (const Diagnostic& one : read.on.diagnostics)
            if (one.code == quirk.code) {
                EXPECT_EQ(one.severity, Severity::Info) << quirk.name;
            }
    }
}

TEST(QuirksTest, theMessageNamesTheQuirkThatCanBeSwitchedOff) {
    const Readings read(Quirk::ExtraVisibility);
    EXPECT_THAT(
        read.on.diagnostics,
        Contains(AllOf(Field(&Diagnostic::message, HasSubstr("(quirk extra-visibility)")),
                       Field(&Diagnostic::cure, HasSubstr("switch the quirk extra-visibility off")))));
}

TEST(QuirksTest, skinByNode) {
    const Readings read(Quirk::SkinByNode);
    EXPECT_THAT(posed(read.automatic)[0], isAt(0, 5, 0));
    EXPECT_THAT(posed(read.on)[0], isAt(0, 5, 0));
    EXPECT_THAT(posed(read.off)[0], isAt(0, 0, 0));
}

TEST(QuirksTest, invertedTransparency) {
    const Readings read(Quirk::InvertedTransparency);
    EXPECT_FLOAT_EQ(read.automatic.materials.at(0).transparency, 0.75f);
    EXPECT_FLOAT_EQ(read.on.materials.at(0).transparency, 0.75f);
    EXPECT_FLOAT_EQ(read.off.materials.at(0).transparency, 0.25f);
}

TEST(QuirksTest, zeroTransparency) {
    const Readings read(Quirk::ZeroTransparency);
    EXPECT_FALSE(read.on.materials.at(0).transparent);
    EXPECT_TRUE(read.off.materials.at(0).transparent);
    EXPECT_FLOAT_EQ(read.off.materials.at(0).transparency, 0.0f);
}

TEST(QuirksTest, spacedNames) {
    const Readings read(Quirk::SpacedNames);
    EXPECT_THAT(read.on.skins.at(0).joints, ElementsAre(0, 1, 2));  // the last one is the skin's own node
    EXPECT_THAT(codes(read.off.diagnostics), Contains("WC0401"));
}

TEST(QuirksTest, jointsByAnyName) {
    const Readings read(Quirk::JointsByAnyName);
    EXPECT_THAT(read.on.skins.at(0).joints, ElementsAre(0, 1, 2));
    EXPECT_THAT(read.off.skins.at(0).joints, Each(2)) << "all of it stays with the skin's node";
    EXPECT_THAT(codes(read.off.diagnostics), Contains("WC0401"));
}

TEST(QuirksTest, morphWeightsByController) {
    const Readings read(Quirk::MorphWeightsByController);
    EXPECT_THAT(posed(read.on, 0.5)[0], isAt(0, 1, 0));
    EXPECT_TRUE(read.off.animations.empty() || posed(read.off, 0.5)[0].y == 0.0f);
    EXPECT_THAT(codes(read.off.diagnostics), Contains("WC0507"));
}

TEST(QuirksTest, forgottenStride) {
    const Readings read(Quirk::ForgottenStride);
    EXPECT_THAT(posed(read.on, 0.5)[0], isAt(2, 0, 0));
    EXPECT_THAT(codes(read.off.diagnostics), Contains("WC0502"));
}

TEST(QuirksTest, singleNumberTangents) {
    const Readings read(Quirk::SingleNumberTangents);
    EXPECT_NEAR(exactLocal(read.on, 0.5)[3].x, 1.0, 1e-9);
    EXPECT_NEAR(exactLocal(read.off, 0.5)[3].x, 4.0, 1e-9);
    EXPECT_THAT(codes(read.off.diagnostics), Contains("WC0506"));
}

TEST(QuirksTest, extraInfinity) {
    const Readings read(Quirk::ExtraInfinity);
    EXPECT_NEAR(exactLocal(read.on, 2.25)[3].x, 1.0, 1e-9);
    EXPECT_NEAR(exactLocal(read.off, 2.25)[3].x, 4.0, 1e-9);
}

TEST(QuirksTest, extraVisibility) {
    const Readings read(Quirk::ExtraVisibility);
    EXPECT_THAT(read.on.nodeVisible, ElementsAre(false));
    EXPECT_THAT(read.off.nodeVisible, ElementsAre(true));
}

TEST(QuirksTest, extraDoubleSided) {
    const Readings read(Quirk::ExtraDoubleSided);
    EXPECT_TRUE(read.on.materials.at(0).doubleSided && read.on.meshes.at(0).doubleSided);
    EXPECT_FALSE(read.off.materials.at(0).doubleSided || read.off.meshes.at(0).doubleSided);
}

TEST(QuirksTest, extraBump) {
    const Readings read(Quirk::ExtraBump);
    EXPECT_TRUE(read.on.materials.at(0).slot(Slot::Bump).present);
    EXPECT_FALSE(read.off.materials.at(0).slot(Slot::Bump).present);
}

TEST(QuirksTest, textureNamesImage) {
    const Readings read(Quirk::TextureNamesImage);
    EXPECT_EQ(read.on.materials.at(0).slot(Slot::Diffuse).texture, 0);
    EXPECT_EQ(read.off.materials.at(0).slot(Slot::Diffuse).texture, -1);
    EXPECT_THAT(codes(read.off.diagnostics), Contains("WC0608"));
}

TEST(QuirksTest, materialBySymbol) {
    const Readings read(Quirk::MaterialBySymbol);
    EXPECT_EQ(read.on.instances.at(0).materials.at(0).material, 0);
    EXPECT_EQ(read.off.instances.at(0).materials.at(0).material, -1);
    EXPECT_THAT(codes(read.off.diagnostics), Contains("WC0602"));
}

TEST(QuirksTest, texCoordByNumber) {
    const Readings read(Quirk::TexCoordByNumber);
    const auto set = [](const Model& model) {
        return model.instances.at(0).materials.at(0).texCoordSets.at(static_cast<std::size_t>(Slot::Diffuse));
    };
    EXPECT_EQ(set(read.on), 1);
    EXPECT_EQ(set(read.off), 0);
}

// A test above for each: the fixtures of a folder that no row names would be read by nobody.
TEST(QuirksTest, eachFixtureIsOfAQuirk) {
    std::size_t files = 0;
    for (const auto& file : std::filesystem::directory_iterator(WALKCYCLE_FIXTURES "/quirks")) {
        EXPECT_TRUE(findQuirk(file.path().stem().string())) << file.path();
        ++files;
    }
    EXPECT_EQ(files, kQuirkCount);
}

}  // namespace
}  // namespace walkcycle
