#include <gtest/gtest.h>

#include "io/Uri.h"

namespace walkcycle {
namespace {

TEST(UriTest, escapesAreDecodedInPathAndFragment) {
    const Uri uri = parseUri("../maps/skin%20a.png#arm%23left");
    EXPECT_EQ(uri.scheme, "");
    EXPECT_EQ(uri.path, "../maps/skin a.png");
    EXPECT_EQ(uri.fragment, "arm#left");
}

TEST(UriTest, aFragmentAloneMeansTheSameDocument) {
    const Uri uri = parseUri("#Armature_mixamorig:Hips");
    EXPECT_EQ(uri.scheme, "");
    EXPECT_EQ(uri.path, "");
    EXPECT_EQ(uri.fragment, "Armature_mixamorig:Hips");
}

TEST(UriTest, fileUrisGiveThePathTheyMean) {
    EXPECT_EQ(parseUri("file:///home/ana/skin.png").path, "/home/ana/skin.png");
    EXPECT_EQ(parseUri("FILE://localhost/home/skin.png").path, "/home/skin.png");
    EXPECT_EQ(parseUri("file:///C:/maps/skin.png").path, "C:/maps/skin.png");
    EXPECT_EQ(parseUri("file://C:\\maps\\skin.png").path, "C:/maps/skin.png");
    EXPECT_EQ(parseUri("file:skin.png").path, "skin.png");
    EXPECT_EQ(parseUri("file://skin.png").path, "skin.png") << "an exporter's habit, not a host";
}

TEST(UriTest, escapedBackSlashesSeparateFoldersToo) {
    EXPECT_EQ(parseUri("maps%5Cskin.png").path, "maps/skin.png");
}

TEST(UriTest, aDriveLetterIsNoScheme) {
    const Uri uri = parseUri("C:\\maps\\skin.png");
    EXPECT_EQ(uri.scheme, "");
    EXPECT_EQ(uri.path, "C:/maps/skin.png");
}

TEST(UriTest, otherSchemesAreNamedSoThatTheyCanBeRefused) {
    EXPECT_EQ(parseUri("HTTP://example.org/skin.png").scheme, "http");
    EXPECT_EQ(parseUri("data:image/png;base64,AAAA").scheme, "data");
}

TEST(UriTest, whiteSpaceAroundIsNotPartOfIt) {
    EXPECT_EQ(parseUri(" \n skin.png \t").path, "skin.png");
    EXPECT_EQ(parseUri("   ").path, "");
}

TEST(UriTest, aBrokenEscapeStaysAsItIs) {
    EXPECT_EQ(percentDecode("100%"), "100%");
    EXPECT_EQ(percentDecode("%4"), "%4");
    EXPECT_EQ(percentDecode("%zz%41"), "%zzA");
    EXPECT_EQ(percentDecode("%%41"), "%A");
}

TEST(UriTest, bytesBeyondAsciiAreKeptAndDecoded) {
    EXPECT_EQ(percentDecode("L%C3%A4ufer"), "Läufer");
    EXPECT_EQ(parseUri("Läufer.png").path, "Läufer.png");
}

}  // namespace
}  // namespace walkcycle
