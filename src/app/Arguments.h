#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace walkcycle {

// The options of one verb, as its page declares them: each writes into a variable that the verb reads later.
class Arguments {
public:
    explicit Arguments(CLI::App& app) : app_(app) {}

    enum class Need { Required, Optional };

    // `name` is what the help calls it: "FILE".
    void positional(const std::string& name, const std::string& help, std::string& target, Need need);
    void positionals(const std::string& name, const std::string& help, std::vector<std::string>& target);

    // `names` as "--output,-o"; `value` is what the help calls the value: "FILE".
    void option(const std::string& names, const std::string& value, const std::string& help,
                std::string& target);
    void option(const std::string& names, const std::string& value, const std::string& help,
                const std::function<void(const std::string&)>& set);
    // May be given several times.
    void eachOption(const std::string& names, const std::string& value, const std::string& help,
                    const std::function<void(const std::string&)>& add);
    void options(const std::string& names, const std::string& value, const std::string& help,
                 std::vector<std::string>& target);
    // One of `choices`; anything else is an error that lists them.
    void choice(const std::string& names, const std::vector<std::string>& choices, const std::string& help,
                std::string& target);
    void flag(const std::string& names, const std::string& help, bool& target);

    // Options from here on stand under this heading in the help.
    void group(const std::string& title) { group_ = title; }
    void examples(const std::string& text);

private:
    CLI::App& app_;
    std::string group_ = "Options";
};

// A verb of the program: declares its options, then runs with them and gives the exit code.
struct Command {
    std::string name;
    std::string summary;
    std::function<void(Arguments&)> declare;
    std::function<int()> run;
};

}  // namespace walkcycle
