#include <map>

#include "app/command.h"
#include "base/log.h"
#include "pbrt/scene_file.h"
#include "transport/light_sampler.h"

namespace drc {
namespace {

void printInfo(const std::string& path) {
    const auto start = std::chrono::steady_clock::now();
    const auto scene = pbrt::loadPbrtFile(path);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const RenderSettings& s = scene->sensor.settings;
    const PixelRegion region = s.region();
    const Bounds bounds = scene->bounds();
    const Vec3 low = bounds.min + scene->origin, high = bounds.max + scene->origin;
    size_t emitters = 0, masked = 0, shapes = 0;
    std::map<const Material*, int> materials;
    const auto count = [&](const std::vector<Primitive>& primitives) {
        for (const Primitive& p : primitives) {
            emitters += p.areaLight != nullptr;
            masked += p.alpha != nullptr;
            shapes += p.shape != nullptr;
            ++materials[p.material.get()];
        }
    };
    count(scene->primitives);
    for (const ObjectDefinition& object : scene->objects) count(object.primitives);
    size_t infinite = 0;
    for (const LightPtr& light : scene->lights) infinite += light->isInfinite();

    fmt::print("{}\n", path);
    fmt::print("  film        {} x {} pixels", s.film.width, s.film.height);
    if (region.count() != size_t(s.film.width) * size_t(s.film.height))
        fmt::print(", of which [{}, {}) x [{}, {}) is rendered", region.x0, region.x1, region.y0, region.y1);
    fmt::print("\n  integrator  {} (maxdepth {}), {} spp, sampler {}\n", s.integrator, s.maxDepth, s.samplesPerPixel,
               s.sampler);
    fmt::print("  geometry    {} triangles in {} meshes, {} other shapes, {} with alpha\n", scene->triangleCount(),
               scene->primitives.size() - shapes, shapes, masked);
    fmt::print("  objects     {}, {} instances\n", scene->objects.size(), scene->instances.size());
    fmt::print("  materials   {} in use\n", materials.size());
    fmt::print("  lights      {}: {} emitting surfaces, {} environments, {} others\n", scene->lights.size(), emitters,
               infinite, scene->lights.size() - emitters - infinite);
    if (!bounds.empty())
        fmt::print("  bounds      ({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g})\n", low.x, low.y, low.z, high.x, high.y,
                   high.z);
    fmt::print("  read in     {:.2f} s, {} warnings\n", seconds, warningCount());
}

}  // namespace

void addInfoCommand(CLI::App& app) {
    auto* command = app.add_subcommand("info", "Print what a scene file contains");
    auto path = std::make_shared<std::string>();
    command->add_option("SCENE", *path, "Scene file, pbrt-v3 or pbrt-v4")->required();
    command->footer("Example: drc info scene.pbrt");
    command->callback([path] { printInfo(*path); });
}

}  // namespace drc
