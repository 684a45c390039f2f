#include "pbrt/texture_files.h"

#include "pbrt/decoded_image.h"

namespace drc::pbrt {

template <typename T>
std::shared_ptr<const MipPyramid<T>> TextureFiles::find(Cache<T>& cache, const std::string& path, TexelGamma gamma,
                                                        const SourcePos& pos) {
    auto& entry = cache[{path, gamma}];
    if (entry) return entry;
    try {
        DecodedImage image = readAsStored(path);
        const bool srgb = gamma == TexelGamma::Srgb || (gamma == TexelGamma::FromFile && image.isSrgbEncoded);
        entry = std::make_shared<MipPyramid<T>>(TexelImage{image.width, image.height, std::move(image.texels)},
                                                srgb ? TexelEncoding::Srgb : TexelEncoding::Linear);
    } catch (const Error& error) {
        fail(pos, error.what());
    }
    return entry;
}

std::shared_ptr<const RgbPyramid> TextureFiles::color(const std::string& path, TexelGamma gamma, const SourcePos& pos) {
    return find<Rgb>(colors_, path, gamma, pos);
}

std::shared_ptr<const FloatPyramid> TextureFiles::scalar(const std::string& path, TexelGamma gamma,
                                                         const SourcePos& pos) {
    return find<float>(scalars_, path, gamma, pos);
}

}  // namespace drc::pbrt
