#include "loaders/quirks/Extras.h"

namespace walkcycle {

std::vector<XmlNode> extraTechniques(XmlNode owner) {
    std::vector<XmlNode> techniques;
    for (XmlNode extra : owner.children("extra"))
        for (XmlNode technique : extra.children("technique")) techniques.push_back(technique);
    return techniques;
}

}  // namespace walkcycle
