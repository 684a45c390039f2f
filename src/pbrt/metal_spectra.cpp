#include "pbrt/metal_spectra.h"

#include <span>
#include <string_view>

namespace drc::pbrt {
namespace {

struct Index {
    float wavelength;  // nm
    float eta, k;
};

// Silver, gold and copper: P. B. Johnson and R. W. Christy, "Optical Constants of the Noble Metals", Phys. Rev. B 6
// (1972). Chromium, cobalt, iron, nickel and titanium: the same authors, "Optical Constants of Transition Metals",
// Phys. Rev. B 9 (1974). Aluminium, every 30 nm: K. M. McPeak et al., "Plasmonic Films Can Easily Be Better: Rules and
// Recipes", ACS Photonics 2 (2015). Brass (70 % copper), every 20 nm: M. R. Querry, "Optical Constants", Contractor
// Report CRDC-CR-85034 (1985). All through the database of refractiveindex.info, which is in the public domain.
constexpr Index kSilver[] = {
    {367.9f, 0.07f, 1.657f}, {381.5f, 0.05f, 1.864f}, {397.4f, 0.05f, 2.07f},  {413.3f, 0.05f, 2.275f},
    {430.5f, 0.04f, 2.462f}, {450.9f, 0.04f, 2.657f}, {471.4f, 0.05f, 2.869f}, {495.9f, 0.05f, 3.093f},
    {520.9f, 0.05f, 3.324f}, {548.6f, 0.06f, 3.586f}, {582.1f, 0.05f, 3.858f}, {616.8f, 0.06f, 4.152f},
    {659.5f, 0.05f, 4.483f}, {704.5f, 0.04f, 4.838f}, {756.0f, 0.03f, 5.242f}, {821.1f, 0.04f, 5.727f}};
constexpr Index kAluminium[] = {{370.0f, 0.318f, 3.889f}, {400.0f, 0.375f, 4.226f}, {430.0f, 0.441f, 4.559f},
                                {460.0f, 0.515f, 4.888f}, {490.0f, 0.597f, 5.213f}, {520.0f, 0.688f, 5.536f},
                                {550.0f, 0.789f, 5.852f}, {580.0f, 0.909f, 6.165f}, {610.0f, 1.038f, 6.467f},
                                {640.0f, 1.19f, 6.759f},  {670.0f, 1.365f, 7.032f}, {700.0f, 1.56f, 7.274f},
                                {730.0f, 1.786f, 7.475f}, {760.0f, 2.054f, 7.599f}, {790.0f, 2.315f, 7.572f}};
constexpr Index kGold[] = {
    {367.9f, 1.48f, 1.895f}, {381.5f, 1.46f, 1.933f}, {397.4f, 1.47f, 1.952f}, {413.3f, 1.46f, 1.958f},
    {430.5f, 1.45f, 1.948f}, {450.9f, 1.38f, 1.914f}, {471.4f, 1.31f, 1.849f}, {495.9f, 1.04f, 1.833f},
    {520.9f, 0.62f, 2.081f}, {548.6f, 0.43f, 2.455f}, {582.1f, 0.29f, 2.863f}, {616.8f, 0.21f, 3.272f},
    {659.5f, 0.14f, 3.697f}, {704.5f, 0.13f, 4.103f}, {756.0f, 0.14f, 4.542f}, {821.1f, 0.16f, 5.083f}};
constexpr Index kCobalt[] = {
    {367.9f, 1.5f, 2.71f},  {381.5f, 1.53f, 2.82f}, {397.4f, 1.57f, 2.93f}, {413.3f, 1.61f, 3.05f},
    {430.5f, 1.67f, 3.17f}, {450.9f, 1.74f, 3.28f}, {471.4f, 1.81f, 3.41f}, {495.9f, 1.88f, 3.55f},
    {520.9f, 1.97f, 3.68f}, {548.6f, 2.05f, 3.82f}, {582.1f, 2.13f, 3.96f}, {616.8f, 2.19f, 4.11f},
    {659.5f, 2.25f, 4.27f}, {704.5f, 2.31f, 4.45f}, {756.0f, 2.4f, 4.64f},  {821.1f, 2.53f, 4.88f}};
constexpr Index kChromium[] = {
    {367.9f, 1.87f, 2.69f}, {381.5f, 1.92f, 2.74f}, {397.4f, 2.0f, 2.83f},  {413.3f, 2.08f, 2.93f},
    {430.5f, 2.19f, 3.04f}, {450.9f, 2.33f, 3.14f}, {471.4f, 2.51f, 3.24f}, {495.9f, 2.75f, 3.3f},
    {520.9f, 2.94f, 3.33f}, {548.6f, 3.18f, 3.33f}, {582.1f, 3.22f, 3.3f},  {616.8f, 3.17f, 3.3f},
    {659.5f, 3.09f, 3.34f}, {704.5f, 3.05f, 3.39f}, {756.0f, 3.08f, 3.42f}, {821.1f, 3.2f, 3.48f}};
constexpr Index kCopper[] = {
    {367.9f, 1.36f, 1.975f}, {381.5f, 1.33f, 2.045f}, {397.4f, 1.32f, 2.116f}, {413.3f, 1.28f, 2.207f},
    {430.5f, 1.25f, 2.305f}, {450.9f, 1.24f, 2.397f}, {471.4f, 1.25f, 2.483f}, {495.9f, 1.22f, 2.564f},
    {520.9f, 1.18f, 2.608f}, {548.6f, 1.02f, 2.577f}, {582.1f, 0.7f, 2.704f},  {616.8f, 0.3f, 3.205f},
    {659.5f, 0.22f, 3.747f}, {704.5f, 0.21f, 4.205f}, {756.0f, 0.24f, 4.665f}, {821.1f, 0.26f, 5.18f}};
constexpr Index kIron[] = {
    {367.9f, 2.02f, 2.43f}, {381.5f, 2.12f, 2.5f},  {397.4f, 2.24f, 2.58f}, {413.3f, 2.35f, 2.65f},
    {430.5f, 2.48f, 2.71f}, {450.9f, 2.59f, 2.77f}, {471.4f, 2.67f, 2.82f}, {495.9f, 2.74f, 2.88f},
    {520.9f, 2.86f, 2.91f}, {548.6f, 2.95f, 2.93f}, {582.1f, 2.94f, 2.99f}, {616.8f, 2.88f, 3.05f},
    {659.5f, 2.92f, 3.1f},  {704.5f, 2.86f, 3.19f}, {756.0f, 2.87f, 3.28f}, {821.1f, 2.94f, 3.39f}};
constexpr Index kNickel[] = {
    {367.9f, 1.7f, 2.4f},   {381.5f, 1.72f, 2.48f}, {397.4f, 1.72f, 2.57f}, {413.3f, 1.7f, 2.69f},
    {430.5f, 1.71f, 2.82f}, {450.9f, 1.73f, 2.95f}, {471.4f, 1.78f, 3.09f}, {495.9f, 1.82f, 3.25f},
    {520.9f, 1.85f, 3.42f}, {548.6f, 1.92f, 3.61f}, {582.1f, 1.96f, 3.8f},  {616.8f, 1.99f, 4.02f},
    {659.5f, 1.99f, 4.26f}, {704.5f, 2.06f, 4.5f},  {756.0f, 2.13f, 4.73f}, {821.1f, 2.26f, 4.97f}};
constexpr Index kTitanium[] = {
    {367.9f, 1.9f, 2.9f},   {381.5f, 1.99f, 2.93f}, {397.4f, 2.08f, 2.95f}, {413.3f, 2.14f, 2.98f},
    {430.5f, 2.21f, 3.01f}, {450.9f, 2.27f, 3.04f}, {471.4f, 2.32f, 3.1f},  {495.9f, 2.36f, 3.19f},
    {520.9f, 2.44f, 3.3f},  {548.6f, 2.54f, 3.43f}, {582.1f, 2.6f, 3.58f},  {616.8f, 2.67f, 3.72f},
    {659.5f, 2.76f, 3.84f}, {704.5f, 2.86f, 3.96f}, {756.0f, 3.0f, 4.01f},  {821.1f, 3.21f, 4.01f}};

constexpr Index kBrass[] = {
    {370.0f, 1.497f, 1.818f}, {380.0f, 1.487f, 1.818f}, {400.0f, 1.445f, 1.805f}, {420.0f, 1.350f, 1.786f},
    {440.0f, 1.191f, 1.797f}, {460.0f, 0.994f, 1.883f}, {480.0f, 0.816f, 2.046f}, {500.0f, 0.686f, 2.250f},
    {520.0f, 0.602f, 2.464f}, {540.0f, 0.549f, 2.668f}, {560.0f, 0.505f, 2.860f}, {580.0f, 0.468f, 3.059f},
    {600.0f, 0.450f, 3.253f}, {620.0f, 0.449f, 3.434f}, {640.0f, 0.444f, 3.609f}, {660.0f, 0.445f, 3.778f},
    {680.0f, 0.444f, 3.943f}, {700.0f, 0.446f, 4.106f}, {720.0f, 0.450f, 4.266f}, {740.0f, 0.455f, 4.424f},
    {760.0f, 0.458f, 4.579f}, {780.0f, 0.464f, 4.737f}, {800.0f, 0.473f, 4.890f}};

struct Metal {
    std::string_view symbol;
    std::span<const Index> indices;
};
constexpr Metal kMetals[] = {{"Ag", kSilver}, {"Al", kAluminium}, {"Au", kGold}, {"Co", kCobalt}, {"Cr", kChromium},
                             {"Cu", kCopper}, {"CuZn", kBrass},   {"Fe", kIron}, {"Ni", kNickel}, {"Ti", kTitanium}};

}  // namespace

std::optional<std::vector<SpectrumSample>> metalSpectrum(const std::string& name) {
    const std::string file = name.substr(name.find_last_of("/\\") + 1);  // the whole name if it has no folder
    for (const Metal& metal : kMetals) {
        const std::string symbol(metal.symbol);
        const bool isEta = file == symbol + ".eta.spd" || name == "metal-" + symbol + "-eta";
        const bool isK = file == symbol + ".k.spd" || name == "metal-" + symbol + "-k";
        if (!isEta && !isK) continue;
        std::vector<SpectrumSample> samples;
        for (const Index& index : metal.indices) samples.push_back({index.wavelength, isEta ? index.eta : index.k});
        return samples;
    }
    return std::nullopt;
}

}  // namespace drc::pbrt
