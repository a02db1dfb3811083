#include <string>
#include <string_view>

#include <gmock/gmock.h>

#include "walkcycle/model/Model.h"

namespace walkcycle {
namespace {

using ::testing::HasSubstr;

std::string whyNot(const Model& model, std::string_view name) {
    try {
        model.animation(name);
    } catch (const NoSuchClip& error) {
        return error.what();
    }
    return "it is there";
}

TEST(ModelTest, aClipIsFoundByNameAndAMissingOneNamesThoseThatAreThere) {
    Model model;
    model.file = "hero.dae";
    EXPECT_THAT(whyNot(model, "walk"), HasSubstr("nothing in 'hero.dae' moves"));
    model.animations.resize(2);
    model.animations[0].name = "hero";
    model.animations[1].name = "walk";
    EXPECT_EQ(&model.animation("walk"), &model.animations[1]);
    EXPECT_EQ(whyNot(model, "run"), "there is no clip 'run'; there are 'hero', 'walk'");
}

}  // namespace
}  // namespace walkcycle
