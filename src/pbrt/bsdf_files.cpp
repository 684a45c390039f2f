#include "pbrt/bsdf_files.h"

#include "pbrt/fourier_file.h"
#include "pbrt/measured_file.h"

namespace drc::pbrt {

std::shared_ptr<const FourierTable> BsdfFiles::fourier(const std::string& path, const SourcePos& pos) {
    auto& entry = fourier_[path];
    if (!entry) entry = placedAt(pos, [&] { return std::make_shared<const FourierTable>(readFourierFile(path)); });
    return entry;
}

std::shared_ptr<const MeasuredTable> BsdfFiles::measured(const std::string& path, const SourcePos& pos) {
    auto& entry = measured_[path];
    if (!entry) entry = placedAt(pos, [&] { return std::make_shared<const MeasuredTable>(readMeasuredFile(path)); });
    return entry;
}

}  // namespace drc::pbrt
