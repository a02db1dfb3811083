#include "loaders/materials/EffectParameters.h"

namespace walkcycle {
namespace {

// The value of a <newparam> may follow other elements.
XmlNode valueOf(XmlNode parameter) {
    for (XmlNode child : parameter.children())
        if (!child.is("annotate") && !child.is("semantic") && !child.is("modifier")) return child;
    return {};
}

}  // namespace

XmlNode ParameterScopes::value(XmlNode scope, std::string_view name) {
    const auto [entry, isNew] = known_.try_emplace(scope);
    if (isNew)
        for (XmlNode parameter : scope.children()) {
            if (parameter.is("newparam"))
                entry->second.try_emplace(parameter.attribute("sid"), valueOf(parameter));
            if (parameter.is("setparam"))
                entry->second.try_emplace(parameter.attribute("ref"), valueOf(parameter));
        }
    const auto found = entry->second.find(name);
    return found == entry->second.end() ? XmlNode() : found->second;
}

XmlNode EffectParameters::value(std::string_view sid) const {
    if (sid.empty()) return {};
    for (const XmlNode scope : scopes_)
        if (const XmlNode found = scope ? known_.value(scope, sid) : XmlNode()) return found;
    return {};
}

}  // namespace walkcycle
