#include "walkcycle/model/Model.h"

namespace walkcycle {

std::vector<float> Model::restParameters() const {
    std::vector<float> values;
    values.reserve(parameters.size());
    for (const Parameter& parameter : parameters) values.push_back(parameter.restValue);
    return values;
}

Animation Model::animation(std::string_view name) && {
    return static_cast<const Model&>(*this).animation(name);
}

const Animation& Model::animation(std::string_view name) const& {
    std::string names;
    for (const Animation& one : animations) {
        if (one.name == name) return one;
        names.append(names.empty() ? "'" : ", '").append(one.name).append("'");
    }
    throw NoSuchClip("there is no clip '" + std::string(name) + "'; " +
                     (names.empty() ? "nothing in '" + file + "' moves" : "there are " + names));
}

}  // namespace walkcycle
