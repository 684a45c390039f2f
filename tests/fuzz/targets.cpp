#include "fuzz/targets.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "base/error.h"
#include "base/log.h"
#include "image/exr_reader.h"
#include "image/image_format.h"
#include "image/image_io.h"
#include "image/radiance_hdr.h"
#include "image/tga.h"
#include "maps/example_shard.h"
#include "neural/safetensors.h"
#include "pbrt/fourier_file.h"
#include "pbrt/measured_file.h"
#include "pbrt/ply_reader.h"
#include "pbrt/scene_file.h"
#include "pbrt/tokenizer.h"
#include "view/view_service.h"

namespace drc::fuzz {
namespace {

// A file in memory, for readers that take a path.
class MemoryFile {
  public:
    explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", 0)) {
        if (descriptor_ < 0 || write(descriptor_, bytes.data(), bytes.size()) != ssize_t(bytes.size()))
            throw std::runtime_error("cannot make a file in memory");
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  private:
    int descriptor_;
};

// A few bytes of runs may stand for a large picture, which is no finding of the fuzzer's: what is in proportion to the
// size that a header names is bounded by this one.
EncodedImage smallPicture(std::string_view bytes) { return {bytes, "fuzz", 1 << 20}; }

}  // namespace

void tokenizer(std::string_view bytes) {
    const auto source = pbrt::Source::fromText(std::string(bytes), "fuzz.pbrt", "");
    pbrt::Tokenizer tokens(*source);
    try {
        for (;;) {
            const pbrt::Token token = tokens.next();
            if (token.kind == pbrt::TokenKind::End) break;
            (void)token.describe();
            (void)token.pos.location();
            if (token.kind == pbrt::TokenKind::Number) (void)token.number();
            if (token.kind == pbrt::TokenKind::String) (void)token.value();
        }
    } catch (const Error&) {
    }
}

std::string confined(std::string_view scene) {
    std::string text(scene);
    std::replace(text.begin(), text.end(), '/', '_');
    return text;
}

void parser(std::string_view bytes) {
    try {
        // Subdivision and curves take time in proportion to the triangles and pieces they make, which is not a fault to
        // find.
        const pbrt::LoadOptions options{.subdividedTriangles = 1e5, .curvePieces = 100'000};
        (void)pbrt::loadPbrtString(confined(bytes), "/nonexistent", options, "fuzz.pbrt");
    } catch (const Error&) {
    }
}

void ply(std::string_view bytes) {
    const MemoryFile file(bytes);
    try {
        (void)pbrt::readPly(file.path());
    } catch (const Error&) {
    }
}

void fourier(std::string_view bytes) {
    const MemoryFile file(bytes);
    try {
        const FourierTable table(pbrt::readFourierFile(file.path()));
        for (const float outgoing : {-0.6f, 0.f, 0.9f}) {
            const auto direction = table.sample(outgoing, 0.3f, Vec2(0.6f, 0.8f));
            if (direction) (void)table.evaluate(direction->incident, outgoing, std::cos(direction->azimuth));
        }
    } catch (const Error&) {
    }
}

void measured(std::string_view bytes) {
    const MemoryFile file(bytes);
    try {
        const MeasuredTable table(pbrt::readMeasuredFile(file.path()));
        const auto wi = table.sample(Vec3(0.6f, 0, 0.8f), Vec2(0.6f, 0.8f));
        if (wi) (void)table.evaluate(Vec3(0.6f, 0, 0.8f), *wi);
    } catch (const Error&) {
    }
}

void safetensors(std::string_view bytes) {
    const MemoryFile file(bytes);
    try {
        const SafetensorsFile read(file.path());
        (void)read.contentHash();
        for (const auto& [name, tensor] : read.tensors()) (void)tensor.toFloat();
    } catch (const Error&) {
    }
}

void examples(std::string_view bytes) {
    const MemoryFile file(bytes);
    try {
        const ExampleShard shard(file.path());
        TrainingExample example;
        for (int i = 0; i < shard.count(); ++i) shard.load(i, 0, shard.inputs(), example);
    } catch (const Error&) {
    }
}

void tga(std::string_view bytes) {
    try {
        (void)hasTgaHeader(bytes);
        (void)decodeTga(smallPicture(bytes));
    } catch (const Error&) {
    }
}

void hdr(std::string_view bytes) {
    try {
        (void)decodeRadianceHdr(smallPicture(bytes));
    } catch (const Error&) {
    }
}

void picture(std::string_view bytes) {
    try {
        (void)foreignFormatOf(bytes);
        (void)decodeImage(smallPicture(bytes));
    } catch (const Error&) {
    }
}

namespace {

// A live view that rests.
struct RestingView {
    std::unique_ptr<Scene> scene = pbrt::loadPbrtString(
        "Camera \"perspective\"\nFilm \"image\" \"integer xresolution\" 16 \"integer yresolution\" 16\nWorldBegin\n"
        "LightSource \"infinite\"\nTranslate 0 0 3\nShape \"sphere\"\nWorldEnd\n");
    RenderParams params = [] {
        RenderParams p;
        p.integrator = "path";
        p.spp = 2;
        p.gBuffer = p.variance = true;
        return p;
    }();
    Session session{*scene, params};
    LiveRender render{session, {[](LayeredPicture&, bool) {}, {}}};
    ViewService service{
        *scene, session.accel(), render, {"scene", "t", [](const LiveFrame&) { return std::string("exr"); }}};
};

}  // namespace

void view(std::string_view bytes) {
    static RestingView resting;
    const size_t end = std::min(bytes.find('\n'), bytes.size());
    HttpRequest request;
    request.method = bytes.starts_with('P') ? "POST" : "GET";
    if (bytes.empty() || !parseTarget(bytes.substr(1, std::max<size_t>(end, 1) - 1), request)) return;
    request.body = bytes.substr(std::min(bytes.size(), end + 1));
    if (request.path == "/t/compare") return picture(request.body);
    const HttpResponse response = resting.service.answer(request);
    if (response.status < 200 || response.status > 599) throw std::logic_error("no status of HTTP's");
}

}  // namespace drc::fuzz
