#include <string>

#include "app/Commands.h"
#include "walkcycle/platform/HeadlessContext.h"
#include "walkcycle/platform/NoGraphicsDevice.h"

namespace walkcycle {

std::string versionText() {
    std::string text = std::string("walkcycle ") + WALKCYCLE_VERSION + "\n" + WALKCYCLE_LIBRARIES + "\n";
    try {
        const HeadlessContext context;
        return text + context.description();
    } catch (const NoGraphicsDevice& error) {
        return text + "no OpenGL: " + error.what();
    }
}

}  // namespace walkcycle
