#include "model/Model.h"

namespace walkcycle {

std::vector<float> Model::restParameters() const {
    std::vector<float> values;
    values.reserve(parameters.size());
    for (const Parameter& parameter : parameters) values.push_back(parameter.restValue);
    return values;
}

}  // namespace walkcycle
