#include "app/memory_table.h"

#include <algorithm>
#include <set>

namespace drc {
namespace {

template <typename T>
int64_t bytesOf(const std::vector<T>& values) {
    return int64_t(values.capacity() * sizeof(T));
}

}  // namespace

int64_t meshBytes(const Scene& scene) {
    int64_t sum = 0;
    std::set<const TriangleMesh*> seen;
    const auto add = [&](const std::vector<Primitive>& primitives) {
        for (const Primitive& p : primitives)
            if (const TriangleMesh* m = p.mesh.get(); m != nullptr && seen.insert(m).second)
                sum += bytesOf(m->positions) + bytesOf(m->normals) + bytesOf(m->uvs) + bytesOf(m->tangents) +
                       bytesOf(m->indices);
    };
    add(scene.primitives);
    for (const ObjectDefinition& object : scene.objects) add(object.primitives);
    return sum;
}

void MemoryTable::note(Rows rows) {
    const int64_t peak = processMemory().peak;
    if (peak <= peak_) return;
    peak_ = peak;
    rows_ = {{"program and libraries", program_},
             {"geometry", geometry_},
             {"accelerator", memoryUse(MemoryUse::Accelerator)},
             {"textures", memoryUse(MemoryUse::Textures)}};
    rows_.insert(rows_.end(), rows.begin(), rows.end());
}

void MemoryTable::afterBuilding(const Scene& scene) {
    geometry_ = meshBytes(scene);
    note({});
}

void MemoryTable::afterRendering(const Session& session, const Stats& stats) {
    const Film& film = session.film();
    film_ = int64_t(film.bytesPerPixel() * film.region().count());
    note({{"film", film_}, {"radiance cells", stats.count("cells/bytes")}});
}

void MemoryTable::afterFinishing() {
    note({{"film", film_},
          {"finishing the picture", std::max<int64_t>(0, processMemory().peak - beforeFinishing_.resident)}});
}

void MemoryTable::report(Stats& stats) const {
    if (peak_ == 0) return;
    const auto set = [&](const std::string& name, int64_t bytes) {
        const int64_t megabytes = (bytes + 500'000) / 1'000'000;
        if (megabytes > 0) stats.set("memory, MB/" + name, megabytes);
    };
    int64_t rest = peak_;
    for (const auto& [name, bytes] : rows_) {
        set(name, bytes);
        rest -= bytes;
    }
    set("other", rest);
    set("total, at the peak", peak_);
}

}  // namespace drc
