#include "animation/Rows.h"

namespace walkcycle {

void place(std::span<JointRows> palette, const glm::mat4& placement) {
    const Rows rows = load(JointRows(placement));
    for (JointRows& joint : palette) store(rows * load(joint), joint);
}

}  // namespace walkcycle
