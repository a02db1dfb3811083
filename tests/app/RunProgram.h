#pragma once

#include <map>
#include <string>
#include <vector>

namespace walkcycle {

struct Ran {
    int exitCode = -1;  // 128 + the signal where one ended it
    std::string out, err;
};

// Runs build/walkcycle to its end, as a shell would. `wrapper` is a program that starts it.
Ran runWalkcycle(const std::vector<std::string>& arguments, const std::string& input = "",
                 const std::map<std::string, std::string>& environment = {},
                 const std::vector<std::string>& wrapper = {});

}  // namespace walkcycle
