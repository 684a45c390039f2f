// Options that take one of a few words, each of which stands for a value.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace drc {

template <class T>
CLI::Option* addChoice(CLI::App& command, const std::string& name, T& value,
                       const std::vector<std::pair<std::string, T>>& choices, const std::string& description) {
    std::vector<std::string> names;
    for (const auto& choice : choices) names.push_back(choice.first);
    return command
        .add_option_function<std::string>(
            name,
            [&value, choices](const std::string& text) {
                for (const auto& [choice, meaning] : choices)
                    if (choice == text) value = meaning;
            },
            description)
        ->check(CLI::IsMember(names));
}

}  // namespace drc
