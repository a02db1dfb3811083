#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "loaders/LoadText.h"
#include "walkcycle/loaders/LoadOptions.h"

namespace walkcycle {
namespace {

using ::testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const std::string kDocument = collada(triangle() + scene("<node><instance_geometry url='#mesh'/></node>"));

// What the load says of the options; "" where it takes them.
std::string refusal(const LoadOptions& options) {
    try {
        loadText(kDocument, options);
    } catch (const InvalidOption& error) {
        return error.what();
    }
    return "";
}

TEST(LoadOptionsTest, aToleranceIsANumberOverZero) {
    LoadOptions options;
    for (const double wrong : {0.0, -1e-4, kNaN, kInfinity}) {
        options.tolerance = wrong;
        EXPECT_THAT(refusal(options), testing::AllOf(HasSubstr("LoadOptions::tolerance is "),
                                                     HasSubstr("must be a number over 0")))
            << wrong;
    }
    options.tolerance = 1e-9;
    EXPECT_EQ(refusal(options), "");
}

TEST(LoadOptionsTest, aUnitIsOneThatADocumentCouldHave) {
    LoadOptions options;
    for (const double wrong : {0.0, -1.0, kNaN, kInfinity, 1e-13, 1e13}) {
        options.metersPerUnit = wrong;
        EXPECT_THAT(refusal(options), HasSubstr("LoadOptions::metersPerUnit is ")) << wrong;
    }
    for (const double right : {1e-12, 0.0254, 1e12}) {
        options.metersPerUnit = right;
        EXPECT_EQ(refusal(options), "") << right;
    }
}

TEST(LoadOptionsTest, noLimitIsOverTheMostThatItCanBe) {
    for (const LimitInfo& limit : kLimits) {
        if (limit.most == UINT64_MAX) continue;
        LoadOptions options;
        options.limits.*limit.value = limit.most;
        EXPECT_EQ(refusal(options), "") << limit.name;
        ++(options.limits.*limit.value);
        EXPECT_THAT(refusal(options), HasSubstr("LoadOptions::limits." + std::string(limit.name) + " is "));
    }
}

TEST(LoadOptionsTest, aQuirkThatDoesNotExistIsRefusedWithTheNearestName) {
    LoadOptions options;
    options.quirks["spaced-names"] = true;
    EXPECT_EQ(refusal(options), "");
    options.quirks["spaced-name"] = true;
    EXPECT_EQ(refusal(options),
              "LoadOptions::quirks is {spaced-name: on}; it must name quirks that exist: there is no quirk "
              "'spaced-name'; perhaps 'spaced-names' is meant");
}

TEST(LoadOptionsTest, nothingIsReadBeforeTheOptionsAreRight) {
    LoadOptions options;
    options.tolerance = kNaN;
    EXPECT_THROW(loadCollada("/nowhere/at/all.dae", options), std::invalid_argument);
}

}  // namespace
}  // namespace walkcycle
