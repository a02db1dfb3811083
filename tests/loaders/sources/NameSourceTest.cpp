#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/LoadText.h"
#include "loaders/sources/Source.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Names {
    explicit Names(const std::string& text) : load("<COLLADA>" + text + "</COLLADA>") {
        const auto source = load.sources.names(load.byId("s"), isIdref);
        if (source) values = source->values;
    }
    TestLoad load;
    bool isIdref = false;
    std::vector<std::string> values;
};

TEST(NameSourceTest, theArraysOf15HoldNamesToo) {
    for (const char* kind : {"Name_array", "SIDREF_array", "token_array", "IDREF_array"}) {
        const Names names(nameSource("s", "hip knee", kind));
        EXPECT_THAT(names.values, ElementsAre("hip", "knee")) << kind;
        EXPECT_EQ(names.isIdref, std::string_view(kind) == "IDREF_array");
        EXPECT_THAT(names.load.diagnostics.all(), IsEmpty());
    }
}

TEST(NameSourceTest, aCountThatIsNoNumberDoesNotMatter) {
    std::string text = nameSource("s", "hip knee");
    text.replace(text.find("count=\"2\""), 9, "count=\"x\"");
    const Names names(text);
    EXPECT_THAT(names.values, ElementsAre("hip", "knee"));
    EXPECT_THAT(codes(names.load.diagnostics.all()), ElementsAre("WC0204"));
}

TEST(NameSourceTest, numbersMayBeWhole) {
    std::string text = floatSource("s", "1 2 3", "X");
    for (std::size_t at; (at = text.find("float_array")) != text.npos;) text.replace(at, 11, "int_array");
    TestLoad load("<COLLADA>" + text + "</COLLADA>");
    EXPECT_THAT(load.sources.floats(load.byId("s"), NumberFaults::Error)->values, ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace walkcycle
