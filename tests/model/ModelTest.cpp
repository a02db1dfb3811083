#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

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

// An Animator refuses a temporary Animation, and so that of a temporary model.
static_assert(std::is_same_v<decltype(std::declval<Model>().animation("walk")), Animation>);
static_assert(std::is_same_v<decltype(std::declval<const Model&>().animation("walk")), const Animation&>);

TEST(ModelTest, theClipOfATemporaryModelIsACopy) {
    const auto made = [] {
        Model model;
        model.animations.resize(1);
        model.animations[0].name = "walk";
        model.animations[0].endSeconds = 2.0;
        return model;
    };
    EXPECT_EQ(made().animation("walk").lengthInSeconds(), 2.0);
    EXPECT_THROW(made().animation("run"), NoSuchClip);
}

}  // namespace
}  // namespace walkcycle
