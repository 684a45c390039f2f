// For tests: writes files of measured materials.
#pragma once
#include <cstring>
#include <string>
#include <vector>

#include "scene/lobes/measured_testing.h"

namespace drc::test {

// A file of tensors, as the format is defined.
class TensorWriter {
  public:
    // type: 1 for uint8, 10 for float32.
    void add(const std::string& name, std::vector<uint64_t> shape, uint8_t type, std::string data) {
        fields_.push_back({name, std::move(shape), type, std::move(data)});
    }
    void add(const std::string& name, std::vector<uint64_t> shape, const std::vector<float>& values) {
        add(name, std::move(shape), 10,
            std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)));
    }
    // Where the list of fields ends, and the data begin.
    size_t headerSize() const {
        size_t size = 12 + 2 + 4;
        for (const Field& f : fields_) size += 2 + f.name.size() + 2 + 1 + 8 + 8 * f.shape.size();
        return size;
    }
    std::string file() const {
        std::string bytes("tensor_file\0\1\0", 14);
        append(bytes, uint32_t(fields_.size()));
        uint64_t offset = headerSize();
        for (const Field& f : fields_) {
            append(bytes, uint16_t(f.name.size()));
            bytes += f.name;
            append(bytes, uint16_t(f.shape.size()));
            append(bytes, f.type);
            append(bytes, offset);
            for (const uint64_t size : f.shape) append(bytes, size);
            offset += f.data.size();
        }
        for (const Field& f : fields_) bytes += f.data;
        return bytes;
    }

  private:
    struct Field {
        std::string name;
        std::vector<uint64_t> shape;
        uint8_t type;
        std::string data;
    };
    template <typename T>
    static void append(std::string& bytes, T value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }

    std::vector<Field> fields_;
};

// The fields of a measured material, all but its spectra.
inline TensorWriter measuredFields(const MeasuredData& d) {
    const uint64_t phi = d.phi.size(), theta = d.theta.size();
    const auto side = [](int n) { return uint64_t(n); };
    TensorWriter w;
    w.add("description", {5}, 1, "a toy");
    w.add("jacobian", {1}, 1, std::string(1, d.jacobian ? '\1' : '\0'));
    w.add("theta_i", {theta}, d.theta);
    w.add("phi_i", {phi}, d.phi);
    w.add("ndf", {side(d.ndfGrid.height), side(d.ndfGrid.width)}, d.ndf);
    w.add("sigma", {side(d.sigmaGrid.height), side(d.sigmaGrid.width)}, d.sigma);
    w.add("vndf", {phi, theta, side(d.vndfGrid.height), side(d.vndfGrid.width)}, d.vndf);
    w.add("luminance", {phi, theta, side(d.lightGrid.height), side(d.lightGrid.width)}, d.luminance);
    return w;
}

// The file of a measurement with such spectra: spectrum(color, nanometres).
template <typename Spectrum>
TensorWriter measuredFile(const MeasuredData& d, const std::vector<float>& wavelengths, const Spectrum& spectrum) {
    TensorWriter w = measuredFields(d);
    w.add("wavelengths", {wavelengths.size()}, wavelengths);
    const size_t area = size_t(d.lightGrid.size());
    std::vector<float> spectra;
    for (size_t member = 0; member < d.phi.size() * d.theta.size(); ++member)
        for (const float nm : wavelengths)
            for (size_t i = 0; i < area; ++i) spectra.push_back(spectrum(d.colors[member * area + i], nm));
    w.add("spectra",
          {d.phi.size(), d.theta.size(), wavelengths.size(), uint64_t(d.lightGrid.height), uint64_t(d.lightGrid.width)},
          spectra);
    return w;
}
// The same of a grey surface.
inline TensorWriter greyMeasuredFile(const MeasuredData& d) {
    return measuredFile(d, {400, 550, 700}, [](const Rgb& color, float) { return color.y; });
}

// The same in RGB.
inline TensorWriter rgbMeasuredFile(const MeasuredData& d) {
    const size_t area = size_t(d.lightGrid.size());
    std::vector<float> values;
    for (size_t member = 0; member < d.phi.size() * d.theta.size(); ++member)
        for (int c = 0; c < 3; ++c)
            for (size_t i = 0; i < area; ++i) values.push_back(d.colors[member * area + i][c]);
    TensorWriter w = measuredFields(d);
    w.add("rgb", {d.phi.size(), d.theta.size(), 3, uint64_t(d.lightGrid.height), uint64_t(d.lightGrid.width)}, values);
    return w;
}

}  // namespace drc::test
