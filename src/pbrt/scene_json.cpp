#include "pbrt/scene_json.h"

#include <array>
#include <map>

#include "pbrt/json_stream.h"

namespace drc::pbrt {
namespace {

// Parameters of meshes that are in a mesh's file, with one value or more for each vertex or triangle.
bool isInMeshFile(const ListedParam& param) {
    for (const std::string_view name : {"N", "P", "Pz", "indices", "st", "uv"})
        if (param.name == name) return true;
    return false;
}

class SceneJson {
  public:
    SceneJson(const SceneListing& listing, const std::vector<MeshFile>& meshes,
              const std::function<void(std::string_view)>& write)
        : listing_(listing), meshes_(meshes), json_(write) {}

    void write() {
        json_.object([&] { members(); });
        json_.finish();
    }

  private:
    void members() {
        json_.member("format", "drc-scene");
        json_.member("version", kSceneJsonVersion);
        json_.newLine();
        json_.member("dialect", std::string(nameOf(listing_.dialect.dialect)));
        member("dialect_at", listing_.dialect.where);
        json_.key("transform_times");
        numbers(listing_.transformTimes);
        one("camera", [&] {
            placed(listing_.camera);
            if (!listing_.cameraMedium.empty()) json_.member("medium", listing_.cameraMedium);
        });
        one("film", [&] { directive(listing_.film); });
        one("filter", [&] { directive(listing_.filter); });
        one("sampler", [&] { directive(listing_.sampler); });
        one("integrator", [&] { directive(listing_.integrator); });
        all("media", listing_.media, [&](const ListedDirective& medium) { directive(medium); });
        all("textures", listing_.textures, [&](const ListedTexture& texture) {
            json_.member("value", texture.isFloat ? "float" : "spectrum");
            placed(texture);
        });
        all("materials", listing_.materials, [&](const ListedDirective& material) { directive(material); });
        all("area_lights", listing_.areaLights, [&](const ListedDirective& light) { directive(light); });
        all("lights", listing_.lights, [&](const ListedPlaced& light) { placed(light); });
        all("objects", listing_.objects, [&](const ListedObject& object) {
            json_.member("name", object.name);
            member("at", object.at);
        });
        all("shapes", listing_.shapes, [&](const ListedShape& each) { shape(each); });
        all("instances", listing_.instances, [&](const ListedInstance& instance) {
            index("object", instance.object);
            member("at", instance.at);
            matrices(instance.toWorld);
        });
        json_.newLine();
        json_.key("files");
        json_.array([&] {
            for (const std::string& file : files_) json_.value(file);
        });
    }

    template <typename F>
    void one(const char* name, const F& members) {
        json_.newLine();
        json_.key(name);
        json_.object(members);
    }
    template <typename T, typename F>
    void all(const char* name, const std::vector<T>& values, const F& members) {
        json_.newLine();
        json_.key(name);
        json_.array([&] {
            for (const T& value : values) {
                json_.newLine();
                json_.object([&] { members(value); });
            }
        });
    }

    void shape(const ListedShape& shape) {
        const size_t number = size_t(&shape - listing_.shapes.data());
        const bool hasFile = number < meshes_.size() && !meshes_[number].path.empty();
        placed(shape, hasFile);
        json_.member("reverse_orientation", shape.reverseOrientation);
        json_.member("material", shape.material);
        index("area_light", shape.areaLight);
        index("object", shape.object);
        if (!shape.inside.empty()) json_.member("inside", shape.inside);
        if (!shape.outside.empty()) json_.member("outside", shape.outside);
        if (hasFile) mesh(meshes_[number]);
    }

    void mesh(const MeshFile& file) {
        json_.key("mesh");
        json_.object([&] {
            json_.member("file", file.path);
            json_.member("vertices", file.vertices);
            json_.member("triangles", file.triangles);
            json_.member("normals", file.hasNormals);
            json_.member("uvs", file.hasUvs);
            if (file.bounds.empty()) return;
            json_.key("bounds");
            json_.array([&] {
                point(file.bounds.min);
                point(file.bounds.max);
            });
        });
    }

    void directive(const ListedDirective& directive, bool hasMeshFile = false) {
        if (!directive.name.empty()) json_.member("name", directive.name);
        json_.member("type", directive.type);
        member("at", directive.at);
        json_.key("parameters");
        json_.array([&] {
            for (const ListedParam& each : directive.params) param(each, hasMeshFile && isInMeshFile(each));
        });
    }

    void placed(const ListedPlaced& placed, bool hasMeshFile = false) {
        directive(placed, hasMeshFile);
        matrices(placed.toWorld);
    }

    void param(const ListedParam& param, bool isInFile) {
        json_.object([&] {
            json_.member("type", param.typeName);
            json_.member("name", param.name);
            member("at", param.at);
            if (isInFile) return;
            json_.key("values");
            json_.array([&] {
                for (const double number : param.numbers) json_.value(number);
                for (const std::string& text : param.strings) json_.value(text);
                for (const bool truth : param.bools) json_.value(truth);
            });
            if (!param.colors.empty()) {
                json_.key("linear_rgb");
                json_.array([&] {
                    for (const Rgb& color : param.colors) point(Vec3(color.x, color.y, color.z));
                });
            }
            if (param.spectrumTexture) json_.member("spectrum_texture", *param.spectrumTexture);
            if (param.floatTexture) json_.member("float_texture", *param.floatTexture);
        });
    }

    void index(const char* name, const std::optional<size_t>& index) {
        if (index)
            json_.member(name, *index);
        else
            json_.member(name, nullptr);
    }

    // [file, line, column], the file as an index into "files"; null if there is no place.
    void member(const char* name, const SourceLocation& at) {
        if (at.empty()) return json_.member(name, nullptr);
        const auto [file, isNew] = fileIndices_.try_emplace(at.file, files_.size());
        if (isNew) files_.push_back(at.file);
        json_.key(name);
        json_.array([&] {
            json_.value(file->second);
            json_.value(at.line);
            json_.value(at.column);
        });
    }

    void matrices(const TransformSet& toWorld) {
        json_.key("to_world");
        matrix(toWorld.at[0]);
        if (!toWorld.isAnimated()) return;
        json_.key("to_world_end");
        matrix(toWorld.at[1]);
    }
    void matrix(const Transform& m) {
        json_.array([&] {
            for (int row = 0; row < 4; ++row)
                numbers(std::array<float, 4>{m.at(row, 0), m.at(row, 1), m.at(row, 2), m.at(row, 3)});
        });
    }
    void point(const Vec3& p) { numbers(std::array<float, 3>{p.x, p.y, p.z}); }
    template <size_t N>
    void numbers(const std::array<float, N>& values) {
        json_.array([&] {
            for (const float value : values) json_.value(value);
        });
    }

    const SceneListing& listing_;
    const std::vector<MeshFile>& meshes_;
    JsonStream json_;
    std::vector<std::string> files_;
    std::map<std::string, size_t> fileIndices_;
};

}  // namespace

void writeSceneJson(const SceneListing& listing, const std::vector<MeshFile>& meshes,
                    const std::function<void(std::string_view)>& write) {
    SceneJson(listing, meshes, write).write();
}

}  // namespace drc::pbrt
