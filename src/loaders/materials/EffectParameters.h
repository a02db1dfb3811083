#pragma once

#include <array>
#include <string_view>
#include <unordered_map>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// The <newparam>s and <setparam>s of each element, indexed on the first use: many materials may share an
// effect.
class ParameterScopes {
public:
    // The value element of the <newparam> with this sid, or of the <setparam> with this ref, in `scope`.
    XmlNode value(XmlNode scope, std::string_view name);

private:
    std::unordered_map<XmlNode, std::unordered_map<std::string_view, XmlNode>> known_;
};

// The parameters of an effect as a material uses it (COLLADA 1.4.1, chapter 7). The <setparam>s of the
// material win, then the <newparam>s of the technique, of the profile, and of the effect.
class EffectParameters {
public:
    EffectParameters(XmlNode effect, XmlNode profile, XmlNode technique, XmlNode instanceEffect,
                     ParameterScopes& known)
        : effect_(effect), scopes_{instanceEffect, technique, profile, effect}, known_(known) {}

    // The element that holds the value: <float>, <float4>, <surface>, <sampler2D>, ...; nothing if there is
    // no such parameter.
    XmlNode value(std::string_view sid) const;

    XmlNode effect() const { return effect_; }

private:
    XmlNode effect_;
    std::array<XmlNode, 4> scopes_;
    ParameterScopes& known_;
};

}  // namespace walkcycle
