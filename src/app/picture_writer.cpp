#include "app/picture_writer.h"

#include <cstdlib>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/error.h"
#include "image/image_layers.h"
#include "image/premultiply.h"

namespace drc {
namespace {

// Samples a pixel of a picture that this program wrote; -1: unknown.
int samplesOf(const std::string& path) {
    try {
        const ExrMetadata metadata = readExrMetadata(path);
        const auto spp = metadata.find("drc:spp");
        return spp == metadata.end() ? -1 : std::atoi(spp->second.c_str());
    } catch (const Error&) {
        return -1;
    }
}

}  // namespace

OutputKind outputKind(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = char(std::tolower(c));
    if (extension == ".exr") return OutputKind::Exr;
    if (extension == ".png") return OutputKind::Png;
    throw Error("-o " + path + ": pictures are written as .exr or .png");
}

void checkOutput(const std::string& option, const std::string& path) {
    const auto folder = std::filesystem::absolute(path).parent_path();
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw Error(option + " " + path + ": there is no folder " + folder.string());
}

PngTexts pngTexts(const ExrMetadata& metadata) {
    PngTexts texts;
    for (const auto& [key, text] : metadata)
        if (key != "drc:command" && key != "drc:image_command" && !text.empty()) texts[key] = text;
    return texts;
}

std::vector<std::string> PictureWriter::encode(const LayeredPicture& picture, const ExrMetadata& given) const {
    const float stops = exposureOf(display_, picture.beauty);
    ExrMetadata metadata = given;
    metadata.merge(displayMetadata(display_.view, stops));
    const PixelRegion& region = picture.film->region();
    const ExrWindow window{region.x0, region.y0, settings_.film.width, settings_.film.height};
    std::vector<std::string> files;
    for (const std::string& path : outputs_) {
        if (outputKind(path) == OutputKind::Png) {
            // PNG's colours are not premultiplied.
            const Image* alpha = picture.alpha ? &*picture.alpha : nullptr;
            const Image straight = alpha ? unpremultiplied(picture.beauty, *alpha) : Image();
            files.push_back(encodePng(viewed(alpha ? straight : picture.beauty, display_.view, stops), path,
                                      pngTexts(metadata), alpha));
            continue;
        }
        const Image both = picture.alpha ? withAlpha(picture.beauty, *picture.alpha) : Image();
        std::vector<ExrLayer> layers{{"", picture.alpha ? &both : &picture.beauty}};
        const bool parts = picture.hasParts();
        const Image direct = parts ? picture.part("direct") : Image(),
                    indirect = parts ? picture.part("indirect") : Image();
        if (parts) layers.insert(layers.end(), {{"direct", &direct}, {"indirect", &indirect}});
        Image variance;
        if (aovs_) {  // under the names that Blender's Cycles uses
            variance = picture.variance();
            layers.push_back({"Denoising Albedo", &picture.gBuffer->albedo});
            layers.push_back({"Denoising Normal", &picture.gBuffer->normal});
            layers.push_back({"Denoising Depth", &picture.gBuffer->depth});
            layers.push_back({kVarianceLayer, &variance});
            layers.push_back({kSampleCountLayer, &*picture.samples});
            if (picture.error) layers.push_back({kErrorLayer, &*picture.error});
        }
        files.push_back(encodeExr(layers, metadata, window));
    }
    return files;
}

void PictureWriter::write(const std::vector<std::string>& files) const {
    for (size_t i = 0; i < files.size(); ++i) writeFileAtomically(outputs_[i], files[i]);
}

void PictureWriter::divertFromBetterPictures(int samples) {
    // The metadata of an EXR holds for the files that were written with it.
    bool worse = false;
    for (const std::string& path : outputs_)
        if (std::filesystem::is_regular_file(path) && outputKind(path) == OutputKind::Exr) {
            const int old = samplesOf(path);
            worse |= old >= 0 && old < samples;
        }
    for (std::string& path : outputs_) {
        if (!std::filesystem::is_regular_file(path) || worse) continue;
        const std::filesystem::path p(path);
        path = (p.parent_path() / (p.stem().string() + ".interrupted" + p.extension().string())).string();
    }
}

}  // namespace drc
