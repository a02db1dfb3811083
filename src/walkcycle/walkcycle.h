#pragma once

// All of the library in one include. A program that only reads files includes the header of loadCollada instead and links
// walkcycle::loaders, which needs no OpenGL.

#include <string>

#include "animation/Animator.h"
#include "animation/CrowdPoser.h"
#include "io/File.h"
#include "io/Image.h"
#include "io/ImageWriter.h"
#include "loaders/ColladaLoader.h"
#include "model/BorrowedClips.h"
#include "model/Bounds.h"
#include "model/CpuSkinning.h"
#include "model/LimitedInfluences.h"
#include "model/Model.h"
#include "platform/HeadlessContext.h"
#include "platform/Window.h"
#include "profiles/Profile.h"
#include "render/AnimatedModel.h"
#include "render/AnimatedModelRenderer.h"
#include "render/Camera.h"
#include "render/CrowdRenderer.h"
#include "render/Framebuffer.h"

namespace walkcycle {

// Writes the picture as a PNG file, whole or not at all. Throws FileError.
inline void savePng(const Image& image, const std::string& path) {
    writeFile(path, encodePng(image));
}

}  // namespace walkcycle
