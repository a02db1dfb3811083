#pragma once

#include <string>
#include <vector>

namespace walkcycle::house {

// What is wrong with the includes of one file of src, one sentence each: a folder that points the wrong way,
// or a library where it has no business. `path` is relative to the working copy ("include/walkcycle/model/Model.h").
std::vector<std::string> layeringFaults(const std::string& path, const std::string& text);

}  // namespace walkcycle::house
