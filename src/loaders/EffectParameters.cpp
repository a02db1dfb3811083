#include "loaders/EffectParameters.h"

namespace walkcycle {
namespace {

// A <newparam> may say other things before its value.
XmlNode valueOf(XmlNode parameter) {
    for (XmlNode child : parameter.children())
        if (!child.is("annotate") && !child.is("semantic") && !child.is("modifier")) return child;
    return {};
}

XmlNode find(XmlNode scope, const char* elementName, const char* key, std::string_view sid) {
    for (XmlNode parameter : scope.children(elementName))
        if (parameter.attribute(key) == sid) return valueOf(parameter);
    return {};
}

}  // namespace

XmlNode EffectParameters::value(std::string_view sid) const {
    if (sid.empty()) return {};
    if (const XmlNode set = find(instanceEffect_, "setparam", "ref", sid)) return set;
    for (const XmlNode scope : scopes_)
        if (const XmlNode found = find(scope, "newparam", "sid", sid)) return found;
    return {};
}

}  // namespace walkcycle
