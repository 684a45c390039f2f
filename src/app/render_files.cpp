#include "app/render_files.h"

#include "render/picture_writer.h"
#include "scene/film_output.h"

namespace drc {

DistinctFiles filesOf(const RenderOptions& o) {
    DistinctFiles files;
    const auto reads = [&](const std::string& what, const std::string& path) {
        if (!path.empty() && path != "-") files.reads(what, path);
    };
    const auto writes = [&](const std::string& what, const std::string& path) {
        if (!path.empty()) files.writes(what, path);
    };
    reads("the scene", o.scene);
    reads("--frames", o.frames);
    reads("--weights", o.weights);
    if (namesCellsFile(o)) reads("--cells", o.cells);
    reads("--oidn-library", o.oidnLibrary);
    // The checkpoint that the render resumes from may be replaced by a new one.
    if (!isSameFile(o.resume, o.checkpoint)) reads("--resume", o.resume);
    for (const std::string& path : o.outputs) writes("-o", path);
    writes("--timing", o.timing);
    writes("--checkpoint", o.checkpoint);
    return files;
}

void keepFrom(const std::vector<std::string>& filesOfScene, DistinctFiles files) {
    for (const std::string& path : filesOfScene) files.reads("the scene's file", path);
}

std::unique_ptr<Scene> loadScene(RenderOptions& o, pbrt::KeptContents* kept) {
    pbrt::LoadOptions options = o.overrides.loadOptions();
    options.kept = kept;
    auto scene = o.overrides.load(o.scene, options);
    if (o.outputs.empty()) {
        o.outputs = filmOutputs(scene->sensor.settings);
        for (const std::string& path : o.outputs) checkOutput("-o", path);
    }
    keepFrom(scene->files, filesOf(o));
    return scene;
}

}  // namespace drc
