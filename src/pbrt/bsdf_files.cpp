#include "pbrt/bsdf_files.h"

#include "pbrt/fourier_file.h"

namespace drc::pbrt {

std::shared_ptr<const FourierTable> BsdfFiles::fourier(const std::string& path, const SourcePos& pos) {
    auto& entry = fourier_[path];
    if (!entry) entry = placedAt(pos, [&] { return std::make_shared<const FourierTable>(readFourierFile(path)); });
    return entry;
}

}  // namespace drc::pbrt
