#include "loaders/LoadText.h"
#include "loaders/TestFiles.h"
#include "walkcycle/loaders/LoadError.h"

namespace walkcycle {
namespace {

TEST(LoadErrorTest, theReasonIsWhatWasSaidLast) {
    try {
        loadText("<COLLADA version='2.0'/>");
        FAIL() << "there is nothing to show";
    } catch (const LoadError& error) {
        EXPECT_GT(error.diagnostics.size(), 1u);
        EXPECT_EQ(error.reason().code, "WC0701");
        EXPECT_EQ(error.what(), toString(error.reason()));
        EXPECT_FALSE(error.cancelled());
    }
}

TEST(LoadErrorTest, cancellingIsToldFromAFileThatIsWrong) {
    LoadOptions options;
    options.cancelled = [] { return true; };
    try {
        loadText("no document at all", options);
        FAIL() << "it was cancelled";
    } catch (const LoadError& error) {
        EXPECT_TRUE(error.cancelled());
        EXPECT_EQ(error.reason().code, info(Code::Cancelled).id);
        EXPECT_EQ(error.reason().file, "test.dae");
    }
}

}  // namespace
}  // namespace walkcycle
