#include "app/Arguments.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/Joined.h"
#include "loaders/text/Spelling.h"

namespace walkcycle {

void Arguments::positional(const std::string& name, const std::string& help, std::string& target, Need need) {
    app_.add_option(name, target, help)->option_text(" ")->required(need == Need::Required);
}

void Arguments::positionals(const std::string& name, const std::string& help,
                            std::vector<std::string>& target) {
    app_.add_option(name, target, help)->option_text("...")->required();
}

void Arguments::option(const std::string& names, const std::string& value, const std::string& help,
                       std::string& target) {
    app_.add_option(names, target, help)->option_text(value)->group(group_);
}

void Arguments::option(const std::string& names, const std::string& value, const std::string& help,
                       const std::function<void(const std::string&)>& set) {
    app_.add_option_function<std::string>(names, set, help)->option_text(value)->group(group_);
}

void Arguments::eachOption(const std::string& names, const std::string& value, const std::string& help,
                           const std::function<void(const std::string&)>& add) {
    const auto addAll = [add](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) add(text);
    };
    app_.add_option_function<std::vector<std::string>>(names, addAll, help)
        ->option_text(value)
        ->allow_extra_args(false)
        ->take_all()
        ->group(group_);
}

void Arguments::options(const std::string& names, const std::string& value, const std::string& help,
                        std::vector<std::string>& target) {
    // Without allow_extra_args(false), --anim would take the positional FILE that follows its value as a
    // second value.
    app_.add_option(names, target, help)
        ->option_text(value)
        ->allow_extra_args(false)
        ->take_all()
        ->group(group_);
}

void Arguments::choice(const std::string& names, const std::vector<std::string>& choices,
                       const std::string& help, std::string& target) {
    checkedOption(names, choices, help, [&target](const std::string& word) { target = word; });
}

void Arguments::checkedOption(const std::string& names, const std::vector<std::string>& choices,
                              const std::string& help, const std::function<void(const std::string&)>& set) {
    app_.add_option_function<std::string>(names, set, help)
        ->option_text(joined(choices, "|"))
        ->check([choices](const std::string& word) {
            if (std::find(choices.begin(), choices.end(), word) != choices.end()) return std::string();
            return "'" + word + "' is none of " + joined(choices, ", ") +
                   didYouMean(word, joined(choices, " "));
        })
        ->group(group_);
}

void Arguments::flag(const std::string& names, const std::string& help, bool& target) {
    app_.add_flag(names, target, help)->group(group_);
}

void Arguments::examples(const std::string& text) {
    app_.footer("Examples:\n" + text.substr(0, text.find_last_not_of('\n') + 1));
}

}  // namespace walkcycle
