#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/ExitCode.h"
#include "app/FramePattern.h"
#include "app/JointKeys.h"
#include "app/JsonText.h"
#include "app/Numbers.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;

TEST(NumbersTest, numbersAreReadWholeOrNotAtAll) {
    EXPECT_EQ(parseNumber("-1.5e2", "--x"), -150.0);
    EXPECT_EQ(parseNumber("+2", "--x"), 2.0);
    for (const char* bad : {"", "1x", "1,5", "nan", "inf", "1e999", " 1"})
        EXPECT_THROW(parseNumber(bad, "--x"), UsageError) << bad;
    EXPECT_THAT(parseNumbers("0,0.5,-1", "--x"), ElementsAre(0.0, 0.5, -1.0));
    EXPECT_THROW(parseNumbers("0,,1", "--x"), UsageError);
    EXPECT_THROW(parseNumbers("0,", "--x"), UsageError);
}

TEST(NumbersTest, sizesTakeUnits) {
    EXPECT_EQ(parseSize("20k", "--x"), 20480u);
    EXPECT_EQ(parseSize("2G", "--x"), std::uint64_t{2} << 30);
    EXPECT_THROW(parseSize("99999999999G", "--x"), UsageError);
    EXPECT_THROW(parseSize("k", "--x"), UsageError);
}

TEST(NumbersTest, coloursAreHexadecimal) {
    EXPECT_EQ(parseColor("#ff0080", "--x"), glm::vec3(1.0f, 0.0f, 128.0f / 255.0f));
    EXPECT_EQ(parseColor("f0f", "--x"), glm::vec3(1.0f, 0.0f, 1.0f));
    for (const char* bad : {"", "#", "#12", "#12345g", "#1234567"})
        EXPECT_THROW(parseColor(bad, "--x"), UsageError) << bad;
}

TEST(FramePatternTest, framesAreNumberedWithLeadingZeros) {
    EXPECT_EQ(FramePattern("a_{frame:04}.png").name(7), "a_0007.png");
    EXPECT_EQ(FramePattern("a_{frame}.png").name(12345), "a_12345.png");
    EXPECT_EQ(FramePattern("a.png").name(3), "a.png");
    EXPECT_FALSE(FramePattern("a{x}.png").hasFrame());
    for (const char* bad : {"{frame", "{frame:}", "{frame:x}", "{frame:99}", "{framed}"})
        EXPECT_THROW(FramePattern{bad}, UsageError) << bad;
}

TEST(JointKeysTest, eachJointHasAKeyOfItsOwn) {
    Skeleton skeleton;
    const auto add = [&](const char* id, const char* name, int parent) {
        skeleton.joints.push_back({.name = name, .id = id, .sid = "", .parent = parent});
    };
    add("root", "Root", kNoParent);
    add("arm", "Arm", 0);
    add("", "Arm", 0);
    add("arm", "Arm", 2);
    add("arm", "Arm", 2);
    EXPECT_THAT(jointKeys(skeleton), ElementsAre("root", "arm", "Arm", "root/Arm/arm", "root/Arm/arm[2]"));
}

TEST(JsonTextTest, textIsEscapedAndNumbersAreFinite) {
    JsonText json;
    json.string("a\"b\\c\nd\xC3\xA4");
    json.raw(",");
    json.number(0.1f);
    json.raw(",");
    json.number(1.0 / 0.0);
    EXPECT_EQ(json.take(), "\"a\\\"b\\\\c\\u000ad\xC3\xA4\",0.1,0");
}

TEST(JsonTextTest, bytesThatAreNoUtf8StillGiveValidJson) {
    JsonText json;
    json.string("L\xE4ufer");
    EXPECT_EQ(json.take(), "\"L\\u00e4ufer\"");
}

}  // namespace
}  // namespace walkcycle
