#pragma once

#include <array>
#include <string_view>

#include "loaders/XmlNode.h"

namespace walkcycle {

// The named values of an effect: what a material's <setparam>s say first, then the <newparam>s of the technique, the
// profile and the effect.
class EffectParameters {
public:
    EffectParameters(XmlNode effect, XmlNode profile, XmlNode technique, XmlNode instanceEffect)
        : effect_(effect), instanceEffect_(instanceEffect), scopes_{technique, profile, effect} {}

    // The element that holds the value: <float>, <float4>, <surface>, <sampler2D>, ...; nothing where there is none.
    XmlNode value(std::string_view sid) const;

    XmlNode effect() const { return effect_; }

private:
    XmlNode effect_;
    XmlNode instanceEffect_;
    std::array<XmlNode, 3> scopes_;
};

}  // namespace walkcycle
