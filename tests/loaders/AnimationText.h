#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/text/Words.h"
#include "walkcycle/animation/Animator.h"

namespace walkcycle {

// An <animation> of one channel, to be changed piece by piece.
struct AnimationText {
    std::string target{}, times{}, values{};
    std::string params = "X";               // one letter per number of a value; "M": matrices
    std::string interpolations = "LINEAR";  // one word stands for all keys
    std::string inTangents{}, outTangents{}, tangentParams = "XY";
    std::string id = "anim";
    std::string inputExtra{};  // inside the INPUT source, after its accessor

    std::string sources() const {
        std::string words = interpolations;
        if (words.find(' ') == words.npos)
            for (std::size_t i = 1; i < splitWords(times).size(); ++i) words += " " + interpolations;
        std::string input = floatSource(id + "-in", times, "T");
        input.insert(input.rfind("</source>"), inputExtra);
        return input +
               (params == "M" ? matrixSource(id + "-out", values)
                              : floatSource(id + "-out", values, params)) +
               nameSource(id + "-how", words) + tangentSource("-it", inTangents) +
               tangentSource("-ot", outTangents);
    }
    std::string sampler() const {
        return "<sampler id='" + id + "-sampler'>" + input("INPUT", "-in") + input("OUTPUT", "-out") +
               input("INTERPOLATION", "-how") + (inTangents.empty() ? "" : input("IN_TANGENT", "-it")) +
               (outTangents.empty() ? "" : input("OUT_TANGENT", "-ot")) + "</sampler>";
    }
    std::string channel() const { return "<channel source='#" + id + "-sampler' target='" + target + "'/>"; }
    std::string text() const {
        return "<animation id='" + id + "'>" + sources() + sampler() + channel() + "</animation>";
    }

private:
    std::string input(const std::string& semantic, const std::string& source) const {
        return "<input semantic='" + semantic + "' source='#" + id + source + "'/>";
    }
    std::string tangentSource(const std::string& name, const std::string& numbers) const {
        return numbers.empty() ? "" : floatSource(id + name, numbers, tangentParams);
    }
};

inline std::string animations(const std::string& body) {
    return "<library_animations>" + body + "</library_animations>";
}

// A scene of one node "box" that shows the triangle; `stack` are its transform elements.
inline std::string boxWith(const std::string& stack, const std::string& libraries) {
    return collada(triangle() + libraries +
                   scene("<node id='box'>" + stack + "<instance_geometry url='#mesh'/></node>"));
}

// A joint's world transform by the keyframes of the whole timeline, and by the file's own curves.
inline glm::mat4 keyed(const Model& model, double seconds, std::size_t joint = 0, std::size_t clip = 0) {
    Animator animator(model.skeleton);
    animator.doAnimation(model.animations.at(clip));
    animator.sampleAt(seconds);
    return animator.modelTransforms()[joint];
}

inline glm::dmat4 exactLocal(const Model& model, double seconds, std::size_t joint = 0) {
    std::vector<glm::dmat4> locals(model.skeleton.joints.size());
    std::vector<double> parameters(model.parameters.size());
    model.exactMotion->evaluate(seconds, locals, parameters);
    return locals[joint];
}

inline double apart(const glm::mat4& a, const glm::mat4& b) {
    double most = 0.0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            most = std::max(most, std::abs(double(a[column][row]) - double(b[column][row])));
    return most;
}

// The largest difference between keyframes and curves of a root joint, looked at densely.
inline double largestError(const Model& model) {
    const Animation& clip = model.animations.at(0);
    double most = 0.0;
    for (int i = 0; i <= 997; ++i) {
        const double t = clip.startSeconds + clip.lengthInSeconds() * i / 997.0;
        most = std::max(most, apart(keyed(model, t), glm::mat4(exactLocal(model, t))));
    }
    return most;
}

}  // namespace walkcycle
