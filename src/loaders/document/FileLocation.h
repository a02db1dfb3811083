#pragma once

#include <string>

namespace walkcycle {

// A place in a file, for messages: "model.dae:653, COLLADA/library_geometries/geometry[id=body]".
struct FileLocation {
    std::string file;
    int line = 0;             // 0: the file as a whole
    std::string elementPath;  // empty if there is no element
    std::string elementName;  // messages about elements of one name are counted together
};

}  // namespace walkcycle
