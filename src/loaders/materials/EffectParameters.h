#pragma once

#include <array>
#include <string_view>
#include <unordered_map>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// The <newparam>s and <setparam>s of elements that were asked before: many materials may share one effect.
class ParameterScopes {
public:
    // What the <newparam> of that sid, or the <setparam> of that ref, in the element holds.
    XmlNode value(XmlNode scope, std::string_view name);

private:
    std::unordered_map<XmlNode, std::unordered_map<std::string_view, XmlNode>> known_;
};

// The named values of an effect: what a material's <setparam>s say first, then the <newparam>s of the technique, the
// profile and the effect.
class EffectParameters {
public:
    EffectParameters(XmlNode effect, XmlNode profile, XmlNode technique, XmlNode instanceEffect,
                     ParameterScopes& known)
        : effect_(effect), scopes_{instanceEffect, technique, profile, effect}, known_(known) {}

    // The element that holds the value: <float>, <float4>, <surface>, <sampler2D>, ...; nothing where there is none.
    XmlNode value(std::string_view sid) const;

    XmlNode effect() const { return effect_; }

private:
    XmlNode effect_;
    std::array<XmlNode, 4> scopes_;
    ParameterScopes& known_;
};

}  // namespace walkcycle
