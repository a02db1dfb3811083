#include "app/Graphics.h"

#include "walkcycle/platform/NoGraphicsDevice.h"

namespace walkcycle {

Graphics::Graphics(const std::string& backend) {
    std::string reason;
    if (backend != "glfw") {
        try {
            headless_.emplace();
            return;
        } catch (const NoGraphicsDevice& error) {
            if (backend == "egl") throw;
            reason = error.what();
        }
    }
    try {
        window_ = std::make_unique<Window>("walkcycle", 16, 16, Window::Visibility::Hidden);
    } catch (const NoGraphicsDevice& error) {
        throw NoGraphicsDevice(reason.empty() ? error.what() : reason + "; " + error.what());
    }
}

std::string Graphics::description() const {
    return headless_ ? headless_->description() : window_->description();
}

}  // namespace walkcycle
