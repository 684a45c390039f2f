// "Did you mean ...?" for misspelt names.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace drc {

// "; did you mean 'x'?" with the candidate closest to the name; "" if none is close.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace drc
