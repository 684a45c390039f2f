// Helpers for tests of the pbrt front end.
#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

#include "base/folder_testing.h"
#include "base/log.h"
#include "pbrt/scene_file.h"

namespace drc::pbrt {

// The text of the Error that a scene called "s.pbrt" causes.
inline std::string errorOfScene(const std::string& text, const std::string& directory = ".") {
    return errorOf([&] { loadPbrtString(text, directory, {}, "s.pbrt"); });
}
// Like errorOfScene(), with the text placed between WorldBegin (line 1) and WorldEnd, so that it begins on line 2.
inline std::string errorOfWorld(const std::string& text, const std::string& directory = ".") {
    return errorOfScene("WorldBegin\n" + text + "\nWorldEnd\n", directory);
}
inline std::unique_ptr<Scene> loadWorld(const std::string& text, const std::string& directory = ".") {
    return loadPbrtString("WorldBegin\n" + text + "\nWorldEnd\n", directory, {}, "s.pbrt");
}
// Like loadWorld(), but for pbrt-v4: the film and WorldBegin are on line 1, and the text runs to the end of the file.
inline std::unique_ptr<Scene> loadWorldV4(const std::string& text, const std::string& directory = ".") {
    return loadPbrtString("Film \"rgb\" WorldBegin\n" + text + "\n", directory, {}, "s.pbrt");
}
// Everything that f prints to standard error.
inline std::string saidBy(const std::function<void()>& f) {
    forgetWarnings();
    testing::internal::CaptureStderr();
    f();
    return testing::internal::GetCapturedStderr();
}
inline std::string warningsOfScene(const std::string& text, const std::string& directory = ".") {
    return saidBy([&] { loadPbrtString(text, directory, {}, "s.pbrt"); });
}
inline std::string warningsOfWorld(const std::string& text, const std::string& directory = ".") {
    return saidBy([&] { loadWorld(text, directory); });
}
inline std::string warningsOfWorldV4(const std::string& text, const std::string& directory = ".") {
    return saidBy([&] { loadWorldV4(text, directory); });
}
inline std::string errorOfWorldV4(const std::string& text, const std::string& directory = ".") {
    return errorOf([&] { loadWorldV4(text, directory); });
}

// The albedo of a primitive's material, seen along the normal at the origin of all texture coordinates.
inline Rgb albedoOf(const Primitive& primitive) {
    Bsdf bsdf(Frame(), Vec3(0, 0, 1));
    TextureContext at;
    at.n = Vec3(0, 0, 1);
    primitive.material->addLobes(at, Rgb(1.f), bsdf);
    return bsdf.albedo(Vec3(0, 0, 1));
}

}  // namespace drc::pbrt
