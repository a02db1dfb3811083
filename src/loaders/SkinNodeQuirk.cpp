#include "loaders/SkinNodeQuirk.h"

namespace walkcycle {

bool nodePlacesSkin(std::string_view authoringTool, SkinNode choice) {
    if (choice != SkinNode::Auto) return choice == SkinNode::Apply;
    return authoringTool.find("ColladaMaya") != std::string_view::npos ||
           authoringTool.find("Softimage") != std::string_view::npos;
}

}  // namespace walkcycle
