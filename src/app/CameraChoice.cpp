#include "app/CameraChoice.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "app/ExitCode.h"
#include "app/Numbers.h"

namespace walkcycle {
namespace {

constexpr std::array<std::pair<const char*, CameraPreset>, 5> kPresets = {{{"auto", CameraPreset::Auto},
                                                                           {"front", CameraPreset::Front},
                                                                           {"side", CameraPreset::Side},
                                                                           {"top", CameraPreset::Top},
                                                                           {"iso", CameraPreset::Iso}}};
constexpr float kDefaultAngle = 30.0f;

std::optional<CameraPreset> presetNamed(const std::string& name) {
    for (const auto& [text, preset] : kPresets)
        if (name == text) return preset;
    return std::nullopt;
}

// The camera with this name; null if there is none. First the ids and names of the nodes that hold the cameras are
// compared, then the cameras' own.
const CameraInstance* instanceNamed(const Model& model, const std::string& name) {
    const auto joint = [&](const CameraInstance& i) -> const Joint& {
        return model.skeleton.joints[static_cast<std::size_t>(i.node)];
    };
    const auto camera = [&](const CameraInstance& i) -> const SceneCamera& {
        return model.cameras[static_cast<std::size_t>(i.camera)];
    };
    for (const CameraInstance& i : model.cameraInstances)
        if (joint(i).id == name) return &i;
    for (const CameraInstance& i : model.cameraInstances)
        if (joint(i).name == name) return &i;
    for (const CameraInstance& i : model.cameraInstances)
        if (camera(i).id == name) return &i;
    for (const CameraInstance& i : model.cameraInstances)
        if (camera(i).name == name) return &i;
    return nullptr;
}

std::string listCameras(const Model& model) {
    std::string list;
    for (const CameraInstance& instance : model.cameraInstances) {
        const Joint& node = model.skeleton.joints[static_cast<std::size_t>(instance.node)];
        list += "'" + (node.id.empty() ? node.name : node.id) + "', ";
    }
    for (const auto& [text, preset] : kPresets)
        list += std::string(text) + (preset == CameraPreset::Iso ? "" : ", ");
    return list;
}

glm::vec3 rotatedAboutY(const glm::vec3& v, float radians) {
    const float c = std::cos(radians), s = std::sin(radians);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

}  // namespace

void CameraChoice::declare(Arguments& arguments) {
    arguments.group("Camera");
    arguments.option("--camera", "NAME",
                     "A camera of the file, by its or its node's id or name, or front|side|top|iso|auto",
                     name_);
    const auto vector = [&](const std::string& option, const std::string& help,
                            std::optional<glm::vec3>& target) {
        arguments.option(option, "X,Y,Z", help,
                         [&target, option](const std::string& text) { target = parseVector(text, option); });
    };
    vector("--camera-position", "The position of the camera, in metres, Y up", position_);
    vector("--camera-focal-point", "The point that the camera looks at (the middle of the model)",
           focalPoint_);
    vector("--camera-view-up", "The direction that is up in the picture (0,1,0)", up_);
    arguments.option(
        "--camera-view-angle", "DEG", "The vertical field of view (30)", [this](const std::string& text) {
            angle_ = static_cast<float>(parseNumber(text, "--camera-view-angle"));
            if (!(*angle_ > 0.0f && *angle_ < 180.0f))
                throw UsageError("--camera-view-angle: '" + text + "' is not over 0 and under 180 degrees");
        });
}

void CameraChoice::check(const Model& model) const {
    if (name_.empty() || instanceNamed(model, name_) || presetNamed(name_)) return;
    throw UsageError("--camera: there is no camera '" + name_ + "'; the cameras are " + listCameras(model));
}

Camera CameraChoice::placedCamera(const AnimatedModel& model, float aspect, float orbitRadians) const {
    const Bounds& bounds = model.bounds();
    const glm::vec3 middle = bounds.empty() ? glm::vec3(0.0f) : bounds.center();
    const glm::vec3 focalPoint = focalPoint_.value_or(middle);
    const glm::vec3 position = position_.value_or(Camera::framing(bounds, aspect).position());
    return Camera::lookAt(focalPoint + rotatedAboutY(position - focalPoint, orbitRadians), focalPoint,
                          up_.value_or(glm::vec3(0, 1, 0)), angle_.value_or(kDefaultAngle), aspect, bounds);
}

Camera CameraChoice::camera(const AnimatedModel& model, float aspect, float orbitRadians) const {
    if (isPlaced()) return placedCamera(model, aspect, orbitRadians);
    const Model& data = model.model();
    if (const CameraInstance* instance = name_.empty() ? nullptr : instanceNamed(data, name_)) {
        const SceneCamera& lens = model.scene().cameras[static_cast<std::size_t>(instance->camera)];
        const glm::mat4& node = model.animator().modelTransforms()[static_cast<std::size_t>(instance->node)];
        return Camera::ofScene(lens, node, data.skeleton, aspect);
    }
    const CameraPreset preset = presetNamed(name_).value_or(CameraPreset::Auto);
    const Camera still = Camera::framing(model.bounds(), aspect, preset);
    return orbitRadians == 0.0f
               ? still
               : Camera::framingFrom(model.bounds(), aspect, rotatedAboutY(-still.direction(), orbitRadians));
}

}  // namespace walkcycle
