#include "pbrt/measured_file.h"

#include <fmt/core.h>

#include "base/memory.h"
#include "pbrt/spectrum.h"
#include "pbrt/tensor_file.h"

namespace drc::pbrt {
namespace {

using Type = TensorFile::Type;

class MeasuredFile {
  public:
    explicit MeasuredFile(const std::string& path) : file_(path), path_(path) {}

    MeasuredData read() {
        // Spectra are reduced to RGB while they are read. Only the RGB values and the tables of the warps stay in
        // memory.
        const bool spectral = file_.has("spectra") || !file_.has("rgb");
        const std::string colors = spectral ? "spectra" : "rgb";
        const TensorFile::Field& spectra = file_.field(colors, Type::Float32, 5);
        const double warped = double(file_.field("vndf", Type::Float32, 4).count) +
                              double(file_.field("luminance", Type::Float32, 4).count);
        const uint64_t bands = spectra.shape[2];
        const double pixels = double(spectra.count) / double(std::max<uint64_t>(1, bands));
        const MemoryClaim claim(SquareWarp::bytes(warped) + pixels * sizeof(Rgb), "the BSDF file '" + path_ + "'");

        MeasuredData d;
        d.theta = axis("theta_i");
        d.phi = axis("phi_i");
        constexpr float kTolerance = 1e-3f;
        if (d.theta.front() < -kTolerance || d.theta.back() > kPi / 2 + kTolerance)
            file_.bad(fmt::format("has zenith angles from {:g} to {:g}; they must be radians from 0 to pi / 2",
                                  d.theta.front(), d.theta.back()));
        const TensorFile::Field& jacobian = file_.field("jacobian", Type::UInt8, 1);
        if (jacobian.count != 1)
            file_.bad(fmt::format("has a field 'jacobian' of {} values, not of 1", jacobian.count));
        d.jacobian = jacobian.bytes[0] != 0;
        d.ndf = table("ndf", 2, d, d.ndfGrid);
        d.sigma = table("sigma", 2, d, d.sigmaGrid);
        d.vndf = table("vndf", 4, d, d.vndfGrid);
        d.luminance = table("luminance", 4, d, d.lightGrid);
        d.colors = readColors(colors, d, spectral ? bandsOf(bands) : std::vector<Rgb>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
        return d;
    }

  private:
    std::vector<float> axis(const std::string& name) const {
        std::vector<float> values = file_.floats(name, 1);
        if (values.empty()) file_.bad(fmt::format("has a field '{}' without values", name));
        for (size_t i = 1; i < values.size(); ++i)
            if (!(values[i] > values[i - 1]))
                file_.bad(fmt::format("has values of '{}' that do not ascend: {:g} (number {}) after {:g}", name,
                                      values[i], i, values[i - 1]));
        return values;
    }

    // A table over the unit square; if it has four dimensions, one such table for each phi and theta.
    std::vector<float> table(const std::string& name, size_t dimensions, const MeasuredData& d,
                             SquareGrid& grid) const {
        std::vector<float> values = file_.floats(name, dimensions);
        const std::vector<uint64_t>& shape = file_.field(name, Type::Float32, dimensions).shape;
        if (dimensions == 4 && (shape[0] != d.phi.size() || shape[1] != d.theta.size())) failShape(name, shape, d);
        grid = gridOf(name, shape[dimensions - 1], shape[dimensions - 2]);
        for (size_t i = 0; i < values.size(); ++i)
            if (values[i] < 0) file_.bad(fmt::format("has a negative value in '{}' (number {})", name, i));
        return values;
    }
    SquareGrid gridOf(const std::string& name, uint64_t width, uint64_t height) const {
        constexpr uint64_t kMost = 1 << 15;
        if (width < 2 || height < 2 || width > kMost || height > kMost)
            file_.bad(fmt::format("has a field '{}' with tables of {} x {} values; both must be 2 to {}", name, height,
                                  width, kMost));
        return {int(width), int(height)};
    }
    [[noreturn]] void failShape(const std::string& name, const std::vector<uint64_t>& shape,
                                const MeasuredData& d) const {
        file_.bad(fmt::format("has a field '{}' of {} values for {} azimuths and {} zenith angles", name,
                              TensorFile::shapeText(shape), d.phi.size(), d.theta.size()));
    }

    // The weight of each band of the spectra in RGB.
    std::vector<Rgb> bandsOf(uint64_t count) const {
        const std::vector<float> wavelengths = axis("wavelengths");
        if (wavelengths.size() != count)
            file_.bad(fmt::format("has {} wavelengths for spectra of {}", wavelengths.size(), count));
        return reflectanceWeights(wavelengths);
    }

    std::vector<Rgb> readColors(const std::string& name, const MeasuredData& d, const std::vector<Rgb>& bands) const {
        const TensorFile::Field& f = file_.field(name, Type::Float32, 5);
        const uint64_t height = f.shape[3], width = f.shape[4];
        if (f.shape[0] != d.phi.size() || f.shape[1] != d.theta.size() || f.shape[2] != bands.size())
            failShape(name, f.shape, d);
        if (width != uint64_t(d.lightGrid.width) || height != uint64_t(d.lightGrid.height))
            file_.bad(fmt::format("has a field '{}' with tables of {} x {} values, and a 'luminance' of {} x {}", name,
                                  height, width, d.lightGrid.height, d.lightGrid.width));
        const uint64_t area = width * height, members = f.shape[0] * f.shape[1];
        std::vector<Rgb> colors(size_t(members * area), Rgb(0.f));
        for (uint64_t m = 0; m < members; ++m)
            for (uint64_t b = 0; b < bands.size(); ++b)
                for (uint64_t i = 0; i < area; ++i) {
                    const uint64_t index = (m * bands.size() + b) * area + i;
                    const float value = TensorFile::floatAt(f, index);
                    if (!std::isfinite(value))
                        file_.bad(fmt::format("has a value in '{}' (number {}) that is not finite", name, index));
                    colors[size_t(m * area + i)] += bands[size_t(b)] * value;
                }
        // Saturated colours may be outside Rec. 709.
        for (Rgb& c : colors) c = clampNonNegative(c);
        return colors;
    }

    TensorFile file_;
    std::string path_;
};

}  // namespace

MeasuredData readMeasuredFile(const std::string& path) { return MeasuredFile(path).read(); }

}  // namespace drc::pbrt
