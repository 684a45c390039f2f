#include "reconstruct/open_image_denoise.h"

#include <dlfcn.h>
#include <fmt/core.h>
#include <link.h>

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "base/parallel.h"
#include "base/parallel_time.h"

namespace drc {
namespace {

// The part of the library's C interface that is used here.
using OidnDevice = void*;
using OidnFilter = void*;
constexpr int kCpu = 1, kFloat3 = 3, kCancelled = 6;
// Bound on the memory of a filter: kMemoryPerPixel bytes for each pixel, and at least kLeastMemory MB. If it needs
// more, the library denoises overlapping tiles. At 1280x720 and a bound of 300 MB, version 2.5 used 310 MB (high with
// clean auxiliaries: 380, fast: 280); without a bound it used 510 (640, 290). At 1920x1080, a bound of 300 MB made it a
// fifth slower.
constexpr double kMemoryPerPixel = 325;
constexpr int kLeastMemory = 300;

struct QualityName {
    OidnQuality quality;
    const char* name;
    int value;         // of the filter's parameter "quality"
    int firstVersion;  // first version of the library that supports it
};
// From the best to the fastest. High is the default in every version.
constexpr QualityName kQualities[] = {{OidnQuality::High, "high", 6, 0},
                                      {OidnQuality::Balanced, "balanced", 5, 20000},
                                      {OidnQuality::Fast, "fast", 4, 20300}};

// The wanted quality, or the next better one that this version supports; in that case warns if `warn`.
const QualityName& knownQuality(OidnQuality wanted, int version, bool warn = true) {
    const QualityName* known = &kQualities[0];
    for (const QualityName& quality : kQualities) {
        if (quality.firstVersion <= version) known = &quality;
        if (quality.quality != wanted) continue;
        if (known != &quality && warn)
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
    // name: a file, or a name that the system's loader looks up.
    explicit Library(const std::string& name) {
        handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!handle) throw Error(std::string("cannot be loaded: ") + dlerror());
        link_map* loaded = nullptr;
        file = dlinfo(handle, RTLD_DI_LINKMAP, &loaded) == 0 && loaded ? loaded->l_name : name;
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
        find(setProgressMonitor, "oidnSetFilterProgressMonitorFunction");
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
        if (!symbol) throw Error(fmt::format("not Open Image Denoise: it has no function {}", name));
        function = reinterpret_cast<F*>(symbol);
    }

    void check() const {
        const char* message = nullptr;
        const int code = getDeviceError(device, &message);
        // Cancelling is no error: the caller has done it.
        if ((code != 0 && code != kCancelled) || !device)
            throw Error(fmt::format("Open Image Denoise: {}", message ? message : "no device for this processor"));
    }

    // Filters an image in place, guided by the non-empty ones of `guides`.
    void run(const char* name, Image& image, std::initializer_list<NamedImage> guides, const QualityName& quality,
             bool hdr, bool cleanAuxiliaries, const CancelToken* cancel) const {
        if (cancel && cancel->cancelled()) return;
        const auto width = size_t(image.width()), height = size_t(image.height());
        const std::unique_ptr<void, void (*)(OidnFilter)> filter(newFilter(device, "RT"), releaseFilter);
        const auto bind = [&](const char* as, const Image& bound) {
            setImage(filter.get(), as, const_cast<float*>(bound.data().data()), kFloat3, width, height, 0, 0, 0);
        };
        bind(name, image);
        bind("output", image);
        for (const NamedImage& guide : guides)
            if (!guide.image->empty()) bind(guide.name, *guide.image);
        if (hdr) setBool(filter.get(), "hdr", true);
        if (cleanAuxiliaries) setBool(filter.get(), "cleanAux", true);
        if (quality.quality != OidnQuality::High) setInt(filter.get(), "quality", quality.value);
        setInt(filter.get(), "maxMemoryMB",
               std::max(kLeastMemory, int(kMemoryPerPixel * 1e-6 * double(width * height))));
        const auto goesOn = [](void* token, double) { return !static_cast<const CancelToken*>(token)->cancelled(); };
        if (cancel) setProgressMonitor(filter.get(), goesOn, const_cast<CancelToken*>(cancel));
        commitFilter(filter.get());
        const ParallelSection section;
        executeFilter(filter.get());
        check();
    }

    void* handle = nullptr;
    std::string file;
    OidnDevice device = nullptr;
    int version = 0;
    OidnDevice (*newDevice)(int type) = nullptr;
    void (*commitDevice)(OidnDevice) = nullptr;
    int (*getDeviceError)(OidnDevice, const char** message) = nullptr;
    void (*releaseDevice)(OidnDevice) = nullptr;
    void (*setDeviceInt)(OidnDevice, const char* name, int value) = nullptr;
    int (*getDeviceInt)(OidnDevice, const char* name) = nullptr;
    OidnFilter (*newFilter)(OidnDevice, const char* type) = nullptr;
    void (*setImage)(OidnFilter, const char* name, void* data, int format, size_t width, size_t height, size_t offset,
                     size_t pixelStride, size_t rowStride) = nullptr;
    void (*setBool)(OidnFilter, const char* name, bool value) = nullptr;
    void (*setInt)(OidnFilter, const char* name, int value) = nullptr;
    void (*setProgressMonitor)(OidnFilter, bool (*goesOn)(void* user, double progress), void* user) = nullptr;
    void (*commitFilter)(OidnFilter) = nullptr;
    void (*executeFilter)(OidnFilter) = nullptr;
    void (*releaseFilter)(OidnFilter) = nullptr;
};

OpenImageDenoise::OpenImageDenoise(const OidnLibraries& libraries) {
    std::string unusable;
    for (const std::string& name : libraries.candidates) {
        try {
            library_ = std::make_unique<Library>(name);
            return;
        } catch (const Error& error) {
            if (!libraries.namedBy.empty()) throw Error(libraries.namedBy + ": " + error.what());
            // It is no fault if the loader does not know a bare name, so only paths are reported.
            if (unusable.empty() && name.find('/') != std::string::npos) unusable = name + ": " + error.what();
        }
    }
    throw Error(fmt::format("Open Image Denoise {}; {}",
                            unusable.empty() ? "was not found" : "is of no use here (" + unusable + ")",
                            kHowToGetOidn));
}
OpenImageDenoise::~OpenImageDenoise() = default;

int OpenImageDenoise::version() const { return library_->version; }

const std::string& OpenImageDenoise::file() const { return library_->file; }

void OpenImageDenoise::denoise(Image& color, const Image& albedo, const Image& normal, const OidnSettings& settings,
                               const CancelToken* cancel) const {
    const QualityName& quality = knownQuality(settings.quality, version());
    if (settings.auxiliaries != OidnAuxiliaries::Prefiltered || albedo.empty()) {
        library_->run("color", color, {{"albedo", &albedo}, {"normal", &normal}}, quality, true,
                      settings.auxiliaries == OidnAuxiliaries::Clean && !albedo.empty(), cancel);
        return;
    }
    // For prefiltering, high takes twice the time too, and makes no better pictures.
    const QualityName& prefilter = knownQuality(std::max(settings.quality, OidnQuality::Balanced), version(), false);
    Image cleanAlbedo = albedo, cleanNormal = normal;
    library_->run("albedo", cleanAlbedo, {}, prefilter, false, false, cancel);
    if (!normal.empty()) library_->run("normal", cleanNormal, {}, prefilter, false, false, cancel);
    library_->run("color", color, {{"albedo", &cleanAlbedo}, {"normal", &cleanNormal}}, quality, true, true, cancel);
}

}  // namespace drc
