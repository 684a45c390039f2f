#include "render/picture_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/atomic_file.h"
#include "base/distinct_files.h"
#include "base/error.h"
#include "base/log.h"
#include "base/numbered_path.h"
#include "base/regular_file.h"
#include "base/rescued_file.h"
#include "base/write_probe.h"
#include "image/image_layers.h"
#include "image/premultiply.h"

namespace drc {
namespace {

namespace fs = std::filesystem;

// Samples per pixel of a picture that this program wrote; -1: unknown.
int samplesOf(const std::string& path) {
    try {
        const ExrMetadata metadata = readExrMetadata(path);
        const auto spp = metadata.find("drc:spp");
        return spp == metadata.end() ? -1 : std::atoi(spp->second.c_str());
    } catch (const Error&) {
        return -1;
    }
}

// Whether one of the files, which were written together, may be a better picture than one of `samples` samples per
// pixel. The metadata of an EXR file applies to all of them.
bool mayBeBetter(const std::vector<std::string>& paths, int samples) {
    bool exists = false;
    for (const std::string& path : paths) {
        if (!isRegularFile(path)) continue;
        exists = true;
        if (outputKind(path) != OutputKind::Exr) continue;
        const int old = samplesOf(path);
        if (old >= 0 && old < samples) return false;
    }
    return exists;
}

// The objects that a picture shows.
std::set<uint32_t> objectsIn(const SurfaceLayers& surfaces) {
    std::set<uint32_t> objects;
    for (const float number : surfaces.object.data()) objects.insert(uint32_t(number));
    return objects;
}

// The layers of --aovs beyond the inputs of denoisers.
void addForCompositing(std::vector<ExrLayer>& layers, const LayeredPicture& picture) {
    if (picture.surfaces) {
        layers.push_back({kPositionLayer, &picture.surfaces->position});
        layers.push_back({kDepthLayer, &picture.surfaces->depth});
        layers.push_back({kObjectIndexLayer, &picture.surfaces->object});
        layers.push_back({kMaterialIndexLayer, &picture.surfaces->material});
    }
    for (size_t half = 0; half < 2; ++half) {
        if (picture.halves) layers.push_back({kHalfLayers[half], &picture.halves->halves[half]});
        if (picture.directHalves) layers.push_back({kDirectHalfLayers[half], &picture.directHalves->halves[half]});
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
    try {
        probeWriting(path);
    } catch (const Error& error) {
        throw Error(option + (option.ends_with(':') ? " " : ": ") + error.what());
    }
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
            addForCompositing(layers, picture);
            if (picture.error) layers.push_back({kErrorLayer, &*picture.error});
        }
        ExrStorage storage;
        if (geometry_) {
            FrameGeometry geometry = *geometry_;
            if (!aovs_ || !picture.surfaces)
                geometry.objects = {};
            else if (geometry.objects.size() > ObjectPlacements::kMostWritten)
                geometry.objects = geometry.objects.only(objectsIn(*picture.surfaces));
            storage.attributes = attributesOf(geometry);
        }
        files.push_back(encodeExr(layers, metadata, window, storage));
    }
    return files;
}

void PictureWriter::write(const std::vector<std::string>& files) {
    for (size_t i = 0; i < files.size(); ++i) {
        std::string& path = outputs_[i];
        try {
            writeFileAtomically(path, files[i]);
        } catch (const Error& error) {
            allInPlace_ = false;
            const std::string rescued = writeRescued(path, files[i], rescueFolders(path, scene_));
            logError(fmt::format("{}; {}", error.what(),
                                 rescued.empty() ? "nor can it be written under another name, beside the scene, or in "
                                                   "the folder for temporary files"
                                                 : "the picture is in " + rescued));
            path = rescued;
        }
    }
    std::erase(outputs_, "");
}

void PictureWriter::divertFromBetterPictures(int samples) {
    std::vector<std::string*> diverted;
    if (mayBeBetter(outputs_, samples))
        for (std::string& path : outputs_)
            if (isRegularFile(path)) diverted.push_back(&path);
    if (diverted.empty()) return;
    for (int number = 1;; ++number) {
        std::vector<std::string> names;
        for (const std::string* path : diverted)
            names.push_back(numberedPath(fs::path(*path).parent_path().string(), *path, "interrupted", number));
        const bool taken = std::ranges::any_of(names, [&](const std::string& name) {
            return std::ranges::any_of(outputs_, [&](const std::string& other) { return isSameFile(name, other); });
        });
        if (taken || mayBeBetter(names, samples)) continue;
        for (size_t i = 0; i < names.size(); ++i) *diverted[i] = names[i];
        return;
    }
}

}  // namespace drc
