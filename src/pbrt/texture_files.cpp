#include "pbrt/texture_files.h"

#include <malloc.h>

#include <cmath>
#include <new>
#include <type_traits>

#include "image/image_io.h"
#include "pbrt/kept_contents.h"
#include "pbrt/mean_or_alpha.h"

namespace drc::pbrt {
namespace {

template <typename T>
MipPyramid<T> readPyramid(const std::string& path, const TexelReading& how) {
    ImageFile file = readTextureFile(path);
    const bool isInteger = file.isSrgbEncoded();
    const bool srgb = how.gamma == TexelGamma::Srgb || (how.gamma == TexelGamma::FromFile && isInteger);
    TexelEncoding encoding = srgb && how.power == 0 ? TexelEncoding::Srgb : TexelEncoding::Linear;
    if (how.power > 0 && isInteger)
        for (float& v : file.image.data()) v = std::pow(std::max(0.f, v), how.power);
    if (std::is_same_v<T, float> && how.number == ColorNumber::MeanOrAlpha)
        file.image = meanOrAlpha(file.image, encoding);
    return MipPyramid<T>(file.image, encoding);
}

}  // namespace

template <typename T>
std::shared_ptr<const MipPyramid<T>> TextureFiles::find(Cache<T>& cache, const std::string& path,
                                                        const TexelReading& how, const SourcePos& pos) {
    auto& entry = cache[{path, how}];
    if (entry) return entry;
    if (kept_ != nullptr) {
        const FileStamp& stamp = stamps_.try_emplace(path, path).first->second;
        if ((entry = kept_->pyramid<T>(stamp, how))) return entry;
    }
    entry = std::make_shared<MipPyramid<T>>();
    Reading& reading = *readings_.emplace_back(std::make_unique<Reading>(pos));
    tasks_.start([&reading, pyramid = entry, path, how] {
        try {
            *pyramid = readPyramid<T>(path, how);
        } catch (...) {
            reading.error = std::current_exception();
        }
    });
    return entry;
}

std::shared_ptr<const RgbPyramid> TextureFiles::color(const std::string& path, const TexelReading& how,
                                                      const SourcePos& pos) {
    return find<Rgb>(colors_, path, how, pos);
}

std::shared_ptr<const FloatPyramid> TextureFiles::scalar(const std::string& path, const TexelReading& how,
                                                         const SourcePos& pos) {
    return find<float>(scalars_, path, how, pos);
}

void TextureFiles::finish() {
    tasks_.wait();
#ifdef __GLIBC__
    // Decoded images need several times the memory of the pyramids. malloc would keep what the threads have freed in
    // their arenas, so return it to the system.
    if (!readings_.empty()) malloc_trim(0);
#endif
    for (const auto& reading : readings_) {
        if (!reading->error) continue;
        try {
            std::rethrow_exception(reading->error);
        } catch (const Error& error) {
            fail(reading->pos, error.what());
        } catch (const std::bad_alloc&) {
            fail(reading->pos, "there is not enough memory for the texture");
        }
    }
}

void TextureFiles::keepIn(KeptContents& kept) const {
    const auto keep = [&]<typename T>(const Cache<T>& cache) {
        KeptContents::Pyramids<T> pyramids;
        for (const auto& [key, pyramid] : cache)
            pyramids.emplace(std::pair(stamps_.at(key.first), key.second), pyramid);
        kept.replace<T>(std::move(pyramids));
    };
    keep(colors_);
    keep(scalars_);
}

size_t TextureFiles::bytes() const {
    size_t sum = 0;
    for (const auto& entry : colors_) sum += entry.second->bytes();
    for (const auto& entry : scalars_) sum += entry.second->bytes();
    return sum;
}

}  // namespace drc::pbrt
