#include "generator_writer.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <utility>

#include "base/error.h"
#include "generator_textures.h"

namespace drc::interior {
namespace {

constexpr const char* kSkyFile = "textures/sky.pfm";

class Text {
  public:
    template <typename... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
        text_ += '\n';
    }
    template <typename Range, typename Write>
    void list(const char* name, const Range& range, Write write) {
        text_ += "  \"";
        text_ += name;
        text_ += "\" [";
        size_t onLine = 0;
        for (const auto& x : range) {
            text_ += onLine++ % 8 == 7 ? "\n   " : " ";
            write(text_, x);
        }
        text_ += " ]\n";
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

// Seven significant digits: fewer would open seams between walls.
void append(std::string& s, float x) { fmt::format_to(std::back_inserter(s), "{:.7g}", x == 0 ? 0.f : x); }
void append(std::string& s, const Vec3& v) {
    append(s, v.x);
    s += ' ';
    append(s, v.y);
    s += ' ';
    append(s, v.z);
}
std::string str(const Vec3& v) {
    std::string s;
    append(s, v);
    return s;
}
std::string str(const Rgb& c) { return fmt::format("{:.5g} {:.5g} {:.5g}", c.x, c.y, c.z); }

void writeMesh(Text& out, const Mesh& m, const Draft& draft, const World& world) {
    const Material& material = draft.materials[static_cast<size_t>(m.material)];
    out.line("NamedMaterial \"{}\"", material.name);
    out.line("Shape \"trianglemesh\"");
    if (!material.alpha.empty()) out.line("  \"texture alpha\" [ \"{}\" ]", material.alpha);
    out.list("integer indices", m.indices,
             [](std::string& s, int i) { fmt::format_to(std::back_inserter(s), "{}", i); });
    out.list("point P", m.p, [&](std::string& s, const Vec3& p) { append(s, world.point(p)); });
    if (m.smooth) {
        out.list("normal N", m.n, [&](std::string& s, const Vec3& n) {
            const Vec3 w = world.vector(n);
            fmt::format_to(std::back_inserter(s), "{:.4f} {:.4f} {:.4f}", w.x, w.y, w.z);
        });
    }
    out.list("float uv", m.uv,
             [](std::string& s, const Vec2& t) { fmt::format_to(std::back_inserter(s), "{:.5g} {:.5g}", t.x, t.y); });
}

void writeEmitter(Text& out, const Emitter& e, const Draft& draft, const World& world) {
    out.line("AttributeBegin");
    out.line("NamedMaterial \"{}\"", draft.materials[static_cast<size_t>(e.material)].name);
    out.line("AreaLightSource \"diffuse\" \"rgb L\" [ {} ]", str(e.radiance));
    switch (e.shape) {
        case EmitterShape::Quad:
            // Without normals, since those would determine the emitting side.
            out.line("Shape \"trianglemesh\" \"integer indices\" [ 0 1 2 0 2 3 ]");
            out.line("  \"point P\" [ {} {} {} {} ]", str(world.point(e.center - e.u - e.v)),
                     str(world.point(e.center + e.u - e.v)), str(world.point(e.center + e.u + e.v)),
                     str(world.point(e.center - e.u + e.v)));
            break;
        case EmitterShape::Sphere:
            out.line("Translate {}", str(world.point(e.center)));
            out.line("Shape \"sphere\" \"float radius\" [ {:.6g} ]", e.radius * world.scale);
            break;
        case EmitterShape::Disk: {
            // pbrt's disk is in the plane z = 0 and faces +z.
            const Vec3 z = world.vector(e.normal);
            const Vec3 x = normalize(cross(std::abs(z.x) < 0.7f ? Vec3(1, 0, 0) : Vec3(0, 1, 0), z));
            const Vec3 y = cross(z, x);
            out.line("ConcatTransform [ {} 0 {} 0 {} 0 {} 1 ]", str(x), str(y), str(z), str(world.point(e.center)));
            out.line("Shape \"disk\" \"float radius\" [ {:.6g} ]", e.radius * world.scale);
            break;
        }
    }
    out.line("AttributeEnd");
}

// Lengths inside stay in metres; the transformation scales them.
void writePlacement(Text& out, const Placement& frame, const World& world) {
    const auto axis = [&](const Vec3& v) { return str(world.vector(frame.vector(v)) * world.scale); };
    out.line("ConcatTransform [ {} 0 {} 0 {} 0 {} 1 ]", axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1}),
             str(world.point(frame.origin)));
}

void writeShape(Text& out, const Shape& s, const Draft& draft, const World& world) {
    out.line("AttributeBegin");
    out.line("NamedMaterial \"{}\"", draft.materials[static_cast<size_t>(s.material)].name);
    writePlacement(out, s.frame, world);
    out.line("Shape {}", s.parameters);
    out.line("AttributeEnd");
}

void writeSky(Text& out, const Draft& draft, const World& world) {
    if (draft.skyImage.radiance.empty()) {
        out.line("LightSource \"infinite\" \"rgb L\" [ {} ]", str(draft.sky));
        return;
    }
    const auto axis = [&](const Vec3& v) { return str(world.vector(v)); };
    out.line("AttributeBegin");
    out.line("ConcatTransform [ {} 0 {} 0 {} 0 0 0 0 1 ]", axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1}));
    out.line("LightSource \"infinite\" \"rgb L\" [ {} ] \"string mapname\" [ \"{}\" ]", str(draft.sky), kSkyFile);
    out.line("AttributeEnd");
}

// PFM, whose first row is the lowest one.
std::string encodePfm(const SkyImage& image) {
    std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
    for (int y = image.height - 1; y >= 0; --y) {
        const Rgb* row = image.radiance.data() + static_cast<size_t>(y) * static_cast<size_t>(image.width);
        for (int x = 0; x < image.width; ++x) {
            const float rgb[3] = {row[x].x, row[x].y, row[x].z};
            bytes.append(reinterpret_cast<const char*>(rgb), sizeof rgb);
        }
    }
    return bytes;
}

void writeShapelessLights(Text& out, const Draft& draft, const World& world) {
    if (!isBlack(draft.sky)) writeSky(out, draft, world);
    if (!isBlack(draft.sun)) {
        out.line("LightSource \"distant\" \"rgb L\" [ {} ] \"point from\" [ {} ] \"point to\" [ 0 0 0 ]",
                 str(draft.sun), str(world.vector(draft.sunFrom)));
    }
    for (const Draft::Point& p : draft.points) {
        // Irradiance falls with the squared distance, which depends on the units.
        out.line("LightSource \"point\" \"rgb I\" [ {} ] \"point from\" [ {} ]",
                 str(p.intensity * (world.scale * world.scale)), str(world.point(p.at)));
    }
}

void writeFile(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw Error({path.string()}, "could not be written; is the disk full, or the directory read-only?");
}

}  // namespace

Vec3 World::vector(const Vec3& v) const {
    const Vec3 w = frame.vector(v);
    return yUp ? Vec3(w.x, w.z, -w.y) : w;
}

Vec3 World::point(const Vec3& p) const {
    const Vec3 w = frame.point(p);
    return (yUp ? Vec3(w.x, w.z, -w.y) : w) * scale;
}

std::string toPbrt(const Draft& draft, const World& world, const FilmSize& film, const std::string& title) {
    Text out;
    out.line("# {}", title);
    out.line("# {}", draft.summary);
    out.line("LookAt {}  {}  {}", str(world.point(draft.eye)), str(world.point(draft.look)),
             str(world.vector({0, 0, 1})));
    out.line("Camera \"perspective\" \"float fov\" [ {:.5g} ]", draft.fov);
    out.line(
        "Film \"image\" \"integer xresolution\" [ {} ] \"integer yresolution\" [ {} ] \"string filename\" [ "
        "\"scene.exr\" ]",
        film.width, film.height);
    out.line("Sampler \"sobol\" \"integer pixelsamples\" [ 64 ]");
    out.line("PixelFilter \"triangle\" \"float xwidth\" [ 1 ] \"float ywidth\" [ 1 ]");
    out.line("Integrator \"path\" \"integer maxdepth\" [ 65 ]");
    out.line("WorldBegin");
    writeShapelessLights(out, draft, world);
    for (const Texture& t : draft.textures) out.line("Texture \"{}\" \"{}\" {}", t.name, t.type, t.parameters);
    for (const Material& m : draft.materials) out.line("MakeNamedMaterial \"{}\" {}", m.name, m.parameters);
    for (const Mesh& m : draft.meshes) writeMesh(out, m, draft, world);
    for (const Sphere& s : draft.spheres) {
        out.line("AttributeBegin");
        out.line("NamedMaterial \"{}\"", draft.materials[static_cast<size_t>(s.material)].name);
        out.line("Translate {}", str(world.point(s.center)));
        out.line("Shape \"sphere\" \"float radius\" [ {:.6g} ]", s.radius * world.scale);
        out.line("AttributeEnd");
    }
    for (const Shape& s : draft.shapes) writeShape(out, s, draft, world);
    for (const Emitter& e : draft.emitters) writeEmitter(out, e, draft, world);
    out.line("WorldEnd");
    return out.take();
}

void writeScene(const std::filesystem::path& directory, const Draft& draft, const std::string& pbrt) {
    std::error_code failure;
    std::filesystem::create_directories(directory / "textures", failure);
    if (failure) throw Error({directory.string()}, "the directory could not be made: " + failure.message());
    writeFile(directory / "scene.pbrt", pbrt);
    if (!draft.skyImage.radiance.empty()) writeFile(directory / kSkyFile, encodePfm(draft.skyImage));
    for (const Texture& t : draft.textures) {
        if (!t.file.empty()) writeFile(directory / t.file, encodeTga(t));
    }
}

}  // namespace drc::interior
