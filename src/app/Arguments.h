#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
}

namespace walkcycle {

// The options of one verb, as its file declares them. Each option writes into a variable that the verb reads
// later.
class Arguments {
public:
    explicit Arguments(CLI::App& app) : app_(app) {}

    enum class Need { Required, Optional };

    // `name` as the help shows it: "FILE".
    void positional(const std::string& name, const std::string& help, std::string& target, Need need);
    void positionals(const std::string& name, const std::string& help, std::vector<std::string>& target);

    // `names` as "--output,-o"; `value` as the help shows it: "FILE". `set` gets the text of the value.
    void option(const std::string& names, const std::string& value, const std::string& help,
                std::string& target);
    void option(const std::string& names, const std::string& value, const std::string& help,
                const std::function<void(const std::string&)>& set);
    // These two may be given several times.
    void eachOption(const std::string& names, const std::string& value, const std::string& help,
                    const std::function<void(const std::string&)>& add);
    void options(const std::string& names, const std::string& value, const std::string& help,
                 std::vector<std::string>& target);
    // The value is one of `choices`; any other is an error that lists them.
    void choice(const std::string& names, const std::vector<std::string>& choices, const std::string& help,
                std::string& target);
    // The same for words that stand for values: {"once", LoopMode::Once}.
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
    void flag(const std::string& names, const std::string& help, bool& target);

    // The heading in the help of the options that follow.
    void group(const std::string& title) { group_ = title; }
    void examples(const std::string& text);  // at the end of the help

private:
    void checkedOption(const std::string& names, const std::vector<std::string>& choices,
                       const std::string& help, const std::function<void(const std::string&)>& set);

    CLI::App& app_;
    std::string group_ = "Options";
};

// A verb of the program.
struct Command {
    std::string summary;                      // one line of the help
    std::function<void(Arguments&)> declare;  // declares the options
    std::function<int()> run;                 // runs with them, and returns the exit code
    std::string name = {};                    // set by allCommands()
};

}  // namespace walkcycle
