// Checks for tests that HTML as made by html_page.h is well-formed.
#pragma once
#include <cctype>
#include <set>
#include <string>
#include <vector>

namespace drc {

// Describes the first error in the nesting of tags, all of which must be closed as in XML; empty if there is none.
inline std::string brokenNesting(const std::string& html) {
    std::vector<std::string> open;
    for (size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at)) {
        const size_t end = html.find('>', at);
        if (end == std::string::npos) return "a tag does not end: " + html.substr(at, 60);
        const std::string tag = html.substr(at + 1, end - at - 1);
        at = end;
        if (tag.empty() || tag[0] == '!') continue;
        if (tag.find('<') != std::string::npos) return "a tag in a tag: " + tag;
        size_t quotes = 0;
        for (const char c : tag) quotes += c == '"';
        if (quotes % 2) return "an odd number of quotes: " + tag;
        const bool closes = tag[0] == '/';
        const std::string name = tag.substr(closes, tag.find_first_of(" /\n", 1) - closes);
        if (closes) {
            if (open.empty() || open.back() != name)
                return "</" + name + "> closes <" + (open.empty() ? "" : open.back());
            open.pop_back();
        } else if (tag.back() != '/') {
            open.push_back(name);
        }
    }
    return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

inline int occurrences(const std::string& text, const std::string& what) {
    int count = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) ++count;
    return count;
}

}  // namespace drc
