#include "render/open_image_denoise.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "base/parallel.h"

namespace drc {
namespace {

// The part of its C interface that is used here.
using Device = void*;
using Filter = void*;
constexpr int kCpu = 1, kFloat3 = 3;

struct QualityName {
    OidnQuality quality;
    const char* name;
    int value;         // of the filter's parameter "quality"
    int firstVersion;  // of the library that knows it
};
// From the best to the fastest. High is the default in every version.
constexpr QualityName kQualities[] = {{OidnQuality::High, "high", 6, 0},
                                      {OidnQuality::Balanced, "balanced", 5, 20000},
                                      {OidnQuality::Fast, "fast", 4, 20300}};

// The wanted quality, or the next better one that this version knows.
const QualityName& knownQuality(OidnQuality wanted, int version) {
    const QualityName* known = &kQualities[0];
    for (const QualityName& quality : kQualities) {
        if (quality.firstVersion <= version) known = &quality;
        if (quality.quality != wanted) continue;
        if (known != &quality)
            logWarning(fmt::format("Open Image Denoise {}.{} has no quality '{}', which came with {}.{}: '{}' instead",
                                   version / 10000, version / 100 % 100, quality.name, quality.firstVersion / 10000,
                                   quality.firstVersion / 100 % 100, known->name));
        break;
    }
    return *known;
}

struct NamedImage {
    const char* name;
    const Image* image;
};

}  // namespace

struct OpenImageDenoise::Library {
    explicit Library(const std::string& path) {
        std::vector<std::string> names{path};
        if (path.empty()) names = {"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1", "libOpenImageDenoise.so"};
        std::string reason;
        for (const std::string& name : names) {
            handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
            if (handle) break;
            if (reason.empty()) reason = dlerror();
        }
        if (!handle)
            throw Error(
                fmt::format("Open Image Denoise cannot be loaded ({}): get it from openimagedenoise.org and name "
                            "its libOpenImageDenoise.so with --oidn-library",
                            reason));
        find(newDevice, "oidnNewDevice");
        find(commitDevice, "oidnCommitDevice");
        find(getDeviceError, "oidnGetDeviceError");
        find(releaseDevice, "oidnReleaseDevice");
        find(setDeviceInt, "oidnSetDeviceInt", "oidnSetDevice1i");
        find(getDeviceInt, "oidnGetDeviceInt", "oidnGetDevice1i");
        find(newFilter, "oidnNewFilter");
        find(setImage, "oidnSetSharedFilterImage");
        find(setBool, "oidnSetFilterBool", "oidnSetFilter1b");
        find(setInt, "oidnSetFilterInt", "oidnSetFilter1i");
        find(commitFilter, "oidnCommitFilter");
        find(executeFilter, "oidnExecuteFilter");
        find(releaseFilter, "oidnReleaseFilter");
        device = newDevice(kCpu);
        if (device) {
            setDeviceInt(device, "numThreads", threadCount());
            commitDevice(device);
        }
        check();
        version = getDeviceInt(device, "version");
    }
    ~Library() {
        if (device) releaseDevice(device);
        // The library is never unloaded, because its threads keep running.
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    template <class F>
    void find(F*& function, const char* name, const char* older = nullptr) {
        void* symbol = dlsym(handle, name);
        if (!symbol && older) symbol = dlsym(handle, older);
        if (!symbol) throw Error(fmt::format("--oidn-library: not Open Image Denoise: it has no function {}", name));
        function = reinterpret_cast<F*>(symbol);
    }

    void check() const {
        const char* message = nullptr;
        if (getDeviceError(device, &message) != 0 || !device)
            throw Error(fmt::format("Open Image Denoise: {}", message ? message : "no device for this processor"));
    }

    // inputs: the first is the image to be filtered.
    Image run(std::initializer_list<NamedImage> inputs, const QualityName& quality, bool hdr,
              bool cleanAuxiliaries) const {
        const Image& first = *inputs.begin()->image;
        const auto width = size_t(first.width()), height = size_t(first.height());
        Image output(first.width(), first.height());
        const std::unique_ptr<void, void (*)(Filter)> filter(newFilter(device, "RT"), releaseFilter);
        const auto bind = [&](const char* name, const Image& image) {
            setImage(filter.get(), name, const_cast<float*>(image.data().data()), kFloat3, width, height, 0, 0, 0);
        };
        for (const NamedImage& input : inputs) bind(input.name, *input.image);
        bind("output", output);
        if (hdr) setBool(filter.get(), "hdr", true);
        if (cleanAuxiliaries) setBool(filter.get(), "cleanAux", true);
        if (quality.quality != OidnQuality::High) setInt(filter.get(), "quality", quality.value);
        commitFilter(filter.get());
        executeFilter(filter.get());
        check();
        return output;
    }

    void* handle = nullptr;
    Device device = nullptr;
    int version = 0;
    Device (*newDevice)(int type) = nullptr;
    void (*commitDevice)(Device) = nullptr;
    int (*getDeviceError)(Device, const char** message) = nullptr;
    void (*releaseDevice)(Device) = nullptr;
    void (*setDeviceInt)(Device, const char* name, int value) = nullptr;
    int (*getDeviceInt)(Device, const char* name) = nullptr;
    Filter (*newFilter)(Device, const char* type) = nullptr;
    void (*setImage)(Filter, const char* name, void* data, int format, size_t width, size_t height, size_t offset,
                     size_t pixelStride, size_t rowStride) = nullptr;
    void (*setBool)(Filter, const char* name, bool value) = nullptr;
    void (*setInt)(Filter, const char* name, int value) = nullptr;
    void (*commitFilter)(Filter) = nullptr;
    void (*executeFilter)(Filter) = nullptr;
    void (*releaseFilter)(Filter) = nullptr;
};

OpenImageDenoise::OpenImageDenoise(const std::string& library) : library_(std::make_unique<Library>(library)) {}
OpenImageDenoise::~OpenImageDenoise() = default;

int OpenImageDenoise::version() const { return library_->version; }

Image OpenImageDenoise::denoised(const Image& color, const Image& albedo, const Image& normal,
                                 const OidnSettings& settings) const {
    const QualityName& quality = knownQuality(settings.quality, version());
    if (!settings.prefilter)
        return library_->run({{"color", &color}, {"albedo", &albedo}, {"normal", &normal}}, quality, true, false);
    const Image cleanAlbedo = library_->run({{"albedo", &albedo}}, quality, false, false);
    const Image cleanNormal = library_->run({{"normal", &normal}}, quality, false, false);
    return library_->run({{"color", &color}, {"albedo", &cleanAlbedo}, {"normal", &cleanNormal}}, quality, true, true);
}

}  // namespace drc
