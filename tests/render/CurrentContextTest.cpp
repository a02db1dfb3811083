#include <functional>
#include <initializer_list>
#include <string>
#include <thread>

#include <gmock/gmock.h>

#include "render/CurrentContext.h"
#include "walkcycle/render/AnimatedModel.h"
#include "walkcycle/render/AnimatedModelRenderer.h"
#include "walkcycle/render/CrowdRenderer.h"
#include "walkcycle/render/Framebuffer.h"

namespace walkcycle {
namespace {

// What `make` throws on a new thread, which has no context.
std::string refusal(const std::function<void()>& make) {
    std::string what;
    std::thread([&] {
        try {
            make();
        } catch (const GraphicsError& error) {
            what = error.what();
        }
    }).join();
    return what;
}

TEST(CurrentContextTest, withoutAContextNothingThatDrawsCanBeMade) {
    for (const std::function<void()>& make : std::initializer_list<std::function<void()>>{
             [] { AnimatedModel made{Model()}; }, [] { AnimatedModelRenderer(); }, [] { CrowdRenderer(); },
             [] { Framebuffer(4, 4); }})
        EXPECT_THAT(refusal(make), testing::HasSubstr("no OpenGL context is current"));
}

}  // namespace
}  // namespace walkcycle
