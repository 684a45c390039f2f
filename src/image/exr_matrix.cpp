#include "image/exr_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace drc {
namespace {

// The entries as the file stores them.
template <typename T>
std::optional<std::array<double, 16>> entriesOf(const ExrAttribute& attribute) {
    std::array<T, 16> stored;
    if (attribute.value.size() != sizeof(stored)) return {};
    std::memcpy(stored.data(), attribute.value.data(), sizeof(stored));
    std::array<double, 16> entries;
    std::copy(stored.begin(), stored.end(), entries.begin());
    return entries;
}

}  // namespace

ExrAttribute matrixAttribute(const Transform& transform) {
    std::array<float, 16> entries;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) entries[size_t(4 * row + column)] = transform.at(column, row);
    std::string bytes(sizeof(entries), '\0');
    std::memcpy(bytes.data(), entries.data(), bytes.size());
    return {"m44f", bytes};
}

std::optional<Transform> matrixIn(const ExrAttributes& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    if (found == attributes.end()) return {};
    const ExrAttribute& attribute = found->second;
    const auto entries = attribute.type == "m44f"   ? entriesOf<float>(attribute)
                         : attribute.type == "m44d" ? entriesOf<double>(attribute)
                                                    : std::nullopt;
    if (!entries || !std::ranges::all_of(*entries, [](double v) { return std::isfinite(v); })) return {};
    return Transform(*entries).transposed();
}

}  // namespace drc
