#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
}

namespace walkcycle {

// Declares the positional arguments and options of one verb. Each writes its value into a variable, or calls a
// function, when the command line is parsed. (The parser behind it is CLI11, which only Arguments.cpp and Program.cpp
// know.)
class Arguments {
public:
    explicit Arguments(CLI::App& app) : app_(app) {}

    enum class Need { Required, Optional };

    // An argument without a name before it: one, or one or more. `name` is its name in the help: "FILE".
    void positional(const std::string& name, const std::string& help, std::string& target, Need need);
    void positionals(const std::string& name, const std::string& help, std::vector<std::string>& target);

    // An option with a value. `names` are like "--output,-o"; `value` is the value's name in the help: "FILE". `set` is
    // called with the text of the value, and throws UsageError if the text is wrong.
    void option(const std::string& names, const std::string& value, const std::string& help,
                std::string& target);
    void option(const std::string& names, const std::string& value, const std::string& help,
                const std::function<void(const std::string&)>& set);
    // Options that may be given several times: `add` is called for each, or each is appended to `target`.
    void eachOption(const std::string& names, const std::string& value, const std::string& help,
                    const std::function<void(const std::string&)>& add);
    void options(const std::string& names, const std::string& value, const std::string& help,
                 std::vector<std::string>& target);
    // An option whose value is one of `choices`; for any other the message lists them.
    void choice(const std::string& names, const std::vector<std::string>& choices, const std::string& help,
                std::string& target);
    // The same if each word stands for a value: {"once", LoopMode::Once}.
    template <typename Value>
    void choiceOf(const std::string& names, const std::vector<std::pair<std::string, Value>>& choices,
                  const std::string& help, Value& target) {
        std::vector<std::string> words;
        for (const auto& [word, value] : choices) words.push_back(word);
        checkedOption(names, words, help, [choices, &target](const std::string& wanted) {
            for (const auto& [word, value] : choices)
                if (word == wanted) target = value;
        });
    }
    // An option without a value, which sets `target` to true.
    void flag(const std::string& names, const std::string& help, bool& target);

    // Sets the heading in the help for the options that follow.
    void group(const std::string& title) { group_ = title; }
    // Sets the examples at the end of the help, one per line.
    void examples(const std::string& text);

private:
    void checkedOption(const std::string& names, const std::vector<std::string>& choices,
                       const std::string& help, const std::function<void(const std::string&)>& set);

    CLI::App& app_;
    std::string group_ = "Options";
};

// A verb of the program.
struct Command {
    std::string summary;                      // one line of the help
    std::function<void(Arguments&)> declare;  // declares the arguments and options
    std::function<int()> run;                 // is called after the parsing; returns the exit code
    std::string name = {};                    // set by allCommands()
};

}  // namespace walkcycle
