#pragma once

// All of the library in one include. A program that only reads files includes the header of loadCollada instead and links
// walkcycle::loaders, which needs no OpenGL.

#include <string>

#include <walkcycle/animation/Animator.h>
#include <walkcycle/crowd/CrowdPoser.h>
#include <walkcycle/io/File.h>
#include <walkcycle/io/Image.h>
#include <walkcycle/loaders/ColladaLoader.h>
#include <walkcycle/model/Bounds.h>
#include <walkcycle/model/CpuSkinning.h>
#include <walkcycle/model/Influences.h>
#include <walkcycle/model/Model.h>
#include <walkcycle/platform/HeadlessContext.h>
#include <walkcycle/platform/Window.h>
#include <walkcycle/profiles/Profile.h>
#include <walkcycle/render/AnimatedModel.h>
#include <walkcycle/render/AnimatedModelRenderer.h>
#include <walkcycle/render/Camera.h>
#include <walkcycle/render/CrowdRenderer.h>
#include <walkcycle/render/Framebuffer.h>

namespace walkcycle {

// Writes the picture as a PNG file, whole or not at all. Throws FileError.
inline void savePng(const Image& image, const std::string& path) {
    writeFile(path, encodePng(image));
}

}  // namespace walkcycle
