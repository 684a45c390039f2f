// The CIE 1931 2-degree colour matching functions, 380 to 780 nm.
#pragma once
#include <array>
#include <cstddef>

namespace drc::pbrt {

inline constexpr int kCieFirst = 380, kCieLast = 780, kCieStep = 5;  // nm
inline constexpr int kCieCount = (kCieLast - kCieFirst) / kCieStep + 1;

struct CieEntry {
    float x, y, z;
};
extern const std::array<CieEntry, kCieCount> kCie;

// Interpolates linearly between the entries; 0 outside the table.
CieEntry cieAt(float nanometres);

}  // namespace drc::pbrt
