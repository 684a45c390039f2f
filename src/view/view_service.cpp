#include "view/view_service.h"

#include <Imath/half.h>
#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "base/error.h"
#include "image/auto_exposure.h"
#include "image/image_io.h"
#include "transport/seen_surface.h"

namespace drc {
namespace {

using Json = nlohmann::json;

// Greatest size of a picture that is sent, and of any other request's body, bytes.
constexpr size_t kMostPicture = 64 << 20, kMostOther = 4 << 10;
// Bounds on the side of a film that a page may ask for, pixels.
constexpr int kLeastSide = 16, kMostSide = 4096;
// Greatest number of pixels of a picture to compare with.
constexpr int64_t kMostCompared = int64_t(kMostSide) * kMostSide;

// Names of files and materials need not be UTF-8.
std::string text(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }
HttpResponse json(const Json& value) { return {200, "application/json", text(value), {}}; }
HttpResponse wrong(const std::string& what) { return {400, "text/plain; charset=utf-8", what + "\n", {}}; }
HttpResponse missing(const std::string& what) { return {404, "text/plain; charset=utf-8", what + "\n", {}}; }

Json asJson(const Vec3& v) { return {v.x, v.y, v.z}; }
Json asJson(const ViewCamera& c, const Scene& scene) {
    Json value{{"eye", asJson(c.eye)},
               {"look", asJson(c.look)},
               {"up", asJson(c.up)},
               {"mirrored", c.mirrored},
               {"pbrt", c.asPbrt(scene.origin)}};
    if (c.lens)
        value["lens"] = {{"orthographic", c.lens->orthographic},
                         {"window", c.lens->window},
                         {"radius", c.lens->radius},
                         {"focalDistance", c.lens->focalDistance}};
    return value;
}

Json asJson(const ViewPicture& picture) {
    using Kind = ViewPicture::Kind;
    const char* kind = picture.kind == Kind::Perspective ? "perspective"
                       : picture.kind == Kind::Parallel  ? "parallel"
                                                         : "panorama";
    return {{"kind", kind},
            {"width", picture.width},
            {"window", picture.window},
            {"ahead", asJson(picture.ahead)},
            {"right", asJson(picture.right)},
            {"top", asJson(picture.top)}};
}

Json asJson(const SeenSurface& seen, const Scene& scene) {
    const SurfaceName name = scene.names.at(seen.primitive->name);
    Json value{{"distance", seen.distance}, {"emits", seen.primitive->areaLight != nullptr}};
    const auto say = [&](const char* what, std::string_view words) {
        if (!words.empty()) value[what] = words;
    };
    say("material", name.material);
    say("materialKind", name.materialKind);
    say("shapeKind", name.shapeKind);
    say("meshFile", name.meshFile);
    say("file", name.file);
    if (name.line > 0) value["line"] = name.line;
    if (seen.instance != nullptr) say("object", scene.objects[size_t(seen.instance->object)].name);
    return value;
}

// Reads an array of `count` numbers from an object; false if there is none.
template <typename Numbers>
bool read(const Json& object, const char* name, size_t count, Numbers& numbers) {
    const auto found = object.find(name);
    if (found == object.end() || !found->is_array() || found->size() != count) return false;
    for (size_t i = 0; i < count; ++i) {
        if (!(*found)[i].is_number()) return false;
        numbers[int(i)] = (*found)[i].get<float>();
    }
    return true;
}
bool read(const Json& object, const char* name, Vec3& v) { return read(object, name, 3, v); }

// Reads a lens that a page or an add-on has set; false if it is not a usable one.
bool read(const Json& object, ViewLens& lens) {
    float window[4];
    if (!object.is_object() || !read(object, "window", 4, window)) return false;
    std::copy(std::begin(window), std::end(window), lens.window.begin());
    if (const auto found = object.find("orthographic"); found != object.end()) {
        if (!found->is_boolean()) return false;
        lens.orthographic = found->get<bool>();
    }
    for (const auto& [name, value] : {std::pair{"radius", &lens.radius}, {"focalDistance", &lens.focalDistance}})
        if (const auto found = object.find(name); found != object.end()) {
            if (!found->is_number()) return false;
            *value = found->get<float>();
        }
    return lens.isUsable();
}

// A whole number in a query; none if the text is anything else.
std::optional<int> numberOf(std::string_view digits) {
    if (digits.empty() || digits.size() > 6) return {};
    int value = 0;
    for (const char c : digits) {
        if (c < '0' || c > '9') return {};
        value = value * 10 + (c - '0');
    }
    return value;
}

// A share, from 0 to 1, in a query; none if the text is anything else.
std::optional<float> shareOf(std::string_view digits) {
    float value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || !(value >= 0 && value <= 1)) return {};
    return value;
}

// Encodes width, height, channels and the frame's number, as 32-bit integers, and then all values as halves, in the
// machine's order of bytes, which is little-endian wherever this program runs.
std::string encodeHalves(const Image& image, uint64_t number) {
    static_assert(std::endian::native == std::endian::little);
    const uint32_t header[] = {uint32_t(image.width()), uint32_t(image.height()), uint32_t(image.channels()),
                               uint32_t(number)};
    std::string bytes(sizeof header + image.data().size() * sizeof(Imath::half), '\0');
    std::memcpy(bytes.data(), header, sizeof header);
    std::vector<Imath::half> halves(image.data().size());
    for (size_t i = 0; i < halves.size(); ++i) halves[i] = Imath::half(std::clamp(image.data()[i], -65504.f, 65504.f));
    std::memcpy(bytes.data() + sizeof header, halves.data(), halves.size() * sizeof(Imath::half));
    return bytes;
}

}  // namespace

std::string randomToken() {
    std::random_device device;
    std::string token;
    for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", device());
    return token;
}

bool isToken(std::string_view text) {
    return text.size() >= 16 && text.size() <= 128 && std::ranges::all_of(text, [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
                      c == '_';
           });
}

std::vector<std::string> layersOf(const LiveFrame& frame) {
    const LayeredPicture& picture = frame.picture;
    std::vector<std::string> names{"beauty", "unfiltered"};
    if (picture.hasParts()) names.insert(names.end(), {"direct", "indirect"});
    if (picture.gBuffer) names.insert(names.end(), {"albedo", "normal", "depth"});
    if (picture.samples) names.insert(names.end(), {"variance", "samples"});
    if (frame.error) names.push_back("error");
    return names;
}

namespace {

// The image of a layer, if the frame contains it as it is; null: the layer has to be computed.
const Image* heldLayer(const LiveFrame& frame, const std::string& name) {
    const LayeredPicture& picture = frame.picture;
    if (name == "beauty") return &picture.beauty;
    if (name == "unfiltered") return &frame.unfiltered;
    if (name == "albedo") return &picture.gBuffer->albedo;
    if (name == "normal") return &picture.gBuffer->normal;
    if (name == "depth") return &picture.gBuffer->depth;
    if (name == "samples") return &*picture.samples;
    if (name == "error") return &frame.error->local;
    return nullptr;
}

}  // namespace

Image layerOf(const LiveFrame& frame, const std::string& name) {
    const std::vector<std::string> names = layersOf(frame);
    if (std::find(names.begin(), names.end(), name) == names.end()) return {};
    if (const Image* held = heldLayer(frame, name)) return *held;
    return name == "variance" ? frame.picture.variance() : frame.picture.part(name);
}

std::vector<float> layerAt(const LiveFrame& frame, const std::string& name, int x, int y) {
    std::vector<float> values;
    if (const Image* held = heldLayer(frame, name)) {
        for (int c = 0; c < held->channels(); ++c) values.push_back(held->at(x, y, c));
        return values;
    }
    const Rgb value = name == "variance" ? frame.picture.varianceAt(x, y) : frame.picture.partAt(name, x, y);
    return {value.x, value.y, value.z};
}

ViewService::ViewService(const Scene& scene, const Accel& accel, LiveRender& render, Settings settings)
    : scene_(scene),
      accel_(accel),
      render_(render),
      settings_(std::move(settings)),
      home_([&] {
          float distance = 0;
          render.between([&](const Session& session) { distance = session.distance(); });
          return ViewCamera::of(*scene.sensor.camera, distance);
      }()),
      film_(scene.sensor.settings.film),
      picture_([&] {
          ViewPicture picture;
          render.between([&](const Session& session) {
              picture = ViewPicture::of(*scene.sensor.camera, home_, session.film().region());
          });
          return picture;
      }()),
      run_(randomToken()),
      camera_(home_) {}

HttpAdmission ViewService::admit(const HttpRequest& header) const {
    // Compared in constant time, so that the time reveals nothing of the token.
    const std::string prefix = "/" + settings_.token + "/";
    unsigned difference = header.path.size() < prefix.size();
    for (size_t i = 0; i < std::min(prefix.size(), header.path.size()); ++i)
        difference |= unsigned(prefix[i] ^ header.path[i]);
    if (difference != 0)
        return {0, HttpResponse{403, "text/plain; charset=utf-8", "open the address that drc view printed\n", {}}};
    const std::string what = header.path.substr(prefix.size());
    const bool isPost = header.method == "POST";
    if (what == "camera" || what == "focus" || what == "pause" || what == "compare") {
        if (!isPost)
            return {0, HttpResponse{405, "text/plain; charset=utf-8", "this is for POST\n", {{"Allow", "POST"}}}};
    } else if (isPost) {
        return {0, missing("there is nothing of this name to post to")};
    }
    return {what == "compare" ? kMostPicture : kMostOther, {}};
}

HttpResponse ViewService::answer(const HttpRequest& request) {
    if (HttpAdmission admission = admit(request); admission.refusal) return std::move(*admission.refusal);
    const std::string what = request.path.substr(settings_.token.size() + 2);
    if (what.empty()) return page();
    if (what == "state") return state();
    if (what == "events") {
        HttpResponse response;
        response.events = true;
        return response;
    }
    if (what == "frame") return picture(request);
    if (what == "pixel" || what == "surface") return pixel(request, what == "pixel");
    if (what == "point") return point(request);
    if (what == "exposure") {
        const auto frame = render_.frame();
        return frame ? json({{"stops", autoExposure(frame->picture.beauty)}})
                     : HttpResponse{503, "text/plain; charset=utf-8", "there is no picture yet\n", {}};
    }
    if (what == "save.exr") {
        const auto frame = render_.frame();
        if (!frame) return {503, "text/plain; charset=utf-8", "there is no picture yet\n", {}};
        return {200,
                "image/x-exr",
                settings_.encodeExr(*frame),
                {{"Content-Disposition", "attachment; filename=\"drc.exr\""}}};
    }
    if (what == "camera") return setCamera(request);
    if (what == "focus") return setFocus(request);
    if (what == "compare") return compare(request);
    if (what == "pause") {
        if (request.body != "true" && request.body != "false") return wrong("the body must be true or false");
        render_.pause(request.body == "true");
        return json({{"paused", request.body == "true"}});
    }
    return missing("there is nothing of this name");
}

HttpResponse ViewService::page() const {
    // The page may load nothing from elsewhere, and no other page may show it.
    return {200,
            "text/html; charset=utf-8",
            std::string(viewerPage()),
            {{"Content-Security-Policy",
              "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src blob: data:; "
              "connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"}}};
}

std::string ViewService::frameEvent() const {
    const std::lock_guard inOrder(eventMutex_);
    const auto frame = render_.frame();
    const LiveState state = render_.state();
    Json event{{"serial", ++serial_}, {"paused", state.paused}, {"done", state.done}, {"focus", nullptr}};
    if (state.focus) event["focus"] = {state.focus->x0, state.focus->y0, state.focus->x1, state.focus->y1};
    if (!state.error.empty()) event["error"] = state.error;
    if (frame)
        event.update({{"number", frame->number},
                      {"samples", frame->samples},
                      {"share", frame->share},
                      {"seconds", frame->seconds},
                      {"view", frame->view},
                      {"focusSamples", frame->focusSamples},
                      {"status", frame->status}});
    const LiveError* error = frame ? frame->error.get() : nullptr;
    {
        const std::lock_guard lock(mutex_);
        event["camera"] = asJson(camera_, scene_);
        event["camera"]["number"] = cameraNumber_;
    }
    event["error estimate"] =
        error ? Json{{"whole", error->whole}, {"samples", error->samples}, {"slope", error->slope}} : Json();
    return text(event);
}

HttpResponse ViewService::state() const {
    const auto frame = render_.frame();
    Json value = Json::parse(frameEvent());
    value["title"] = settings_.title;
    value["film"] = {film_.width, film_.height};
    value["run"] = run_;
    value["home"] = asJson(home_, scene_);
    value["home"]["picture"] = asJson(picture_);
    value["display"] = {{"exposure", settings_.display.exposure},
                        {"auto", settings_.display.autoExposure},
                        {"view", viewName(settings_.display.view)}};
    value["layers"] = frame ? layersOf(*frame) : std::vector<std::string>{"beauty"};
    const std::lock_guard lock(mutex_);
    value["reference"] = reference_ != nullptr;
    return json(value);
}

HttpResponse ViewService::picture(const HttpRequest& request) const {
    const std::string name(request.parameter("layer"));
    if (name == "reference") {
        std::shared_ptr<const Image> reference;
        {
            const std::lock_guard lock(mutex_);
            reference = reference_;
        }
        if (!reference) return missing("no picture to compare with has been given");
        return {200, "application/octet-stream", encodeHalves(*reference, 0), {}};
    }
    const auto frame = render_.frame();
    if (!frame) return {503, "text/plain; charset=utf-8", "there is no picture yet\n", {}};
    const Image image = layerOf(*frame, name.empty() ? "beauty" : name);
    if (image.empty()) return missing("the picture has no layer of this name");
    return {200, "application/octet-stream", encodeHalves(image, frame->number), {}};
}

HttpResponse ViewService::pixel(const HttpRequest& request, bool withLayers) const {
    const std::optional<int> x = numberOf(request.parameter("x")), y = numberOf(request.parameter("y"));
    const auto frame = render_.frame();
    if (!frame) return {503, "text/plain; charset=utf-8", "there is no picture yet\n", {}};
    const Image& beauty = frame->picture.beauty;
    if (!x || !y || *x >= beauty.width() || *y >= beauty.height()) return wrong("x and y must be in the picture");
    Json value{{"x", *x}, {"y", *y}, {"surface", nullptr}};
    const PixelRegion& region = frame->picture.film->region();
    const Vec2 centre(float(region.x0 + *x) + 0.5f, float(region.y0 + *y) + 0.5f);
    if (const auto seen = seenSurface(accel_, *frame->camera, centre)) value["surface"] = asJson(*seen, scene_);
    if (frame->picture.samples) value["samples"] = frame->picture.samples->at(*x, *y, 0);
    if (!withLayers) return json(value);
    for (const std::string& name : layersOf(*frame)) {
        Json& values = value["layers"][name] = Json::array();
        for (const float v : layerAt(*frame, name, *x, *y)) values.push_back(std::isfinite(v) ? Json(v) : Json());
    }
    return json(value);
}

HttpResponse ViewService::point(const HttpRequest& request) const {
    const std::optional<float> x = shareOf(request.parameter("x")), y = shareOf(request.parameter("y"));
    const auto frame = render_.frame();
    if (!frame) return {503, "text/plain; charset=utf-8", "there is no picture yet\n", {}};
    if (!x || !y) return wrong("x and y must be from 0 to 1 across the picture");
    const PixelRegion& region = frame->picture.film->region();
    const Vec2 film(float(region.x0) + *x * float(region.width()), float(region.y0) + *y * float(region.height()));
    const auto seen = seenSurface(accel_, *frame->camera, film);
    return json({{"point", seen ? asJson(seen->point) : Json()}});
}

HttpResponse ViewService::setCamera(const HttpRequest& request) {
    const Json object = Json::parse(request.body, nullptr, false);
    ViewCamera camera = home_;
    if (!object.is_object() || !read(object, "eye", camera.eye) || !read(object, "look", camera.look) ||
        !read(object, "up", camera.up))
        return wrong("the body must have eye, look and up, of three numbers each");
    if (const auto lens = object.find("lens"); lens != object.end() && !read(*lens, camera.lens.emplace()))
        return wrong(
            "a lens must have a window of four numbers, left < right and bottom < top, and may have "
            "orthographic, true or false, a radius from 0 on and a focalDistance above 0");
    if (!camera.isUsable()) return wrong("this camera looks nowhere");
    FilmGeometry film = film_;
    const auto side = [&](const char* name, int& value) {
        const auto found = object.find(name);
        if (found == object.end()) return true;
        if (!found->is_number_integer() || found->get<double>() < kLeastSide || found->get<double>() > kMostSide)
            return false;
        value = found->get<int>();
        return true;
    };
    if (!side("width", film.width) || !side("height", film.height))
        return wrong(fmt::format("width and height must be whole numbers from {} to {}", kLeastSide, kMostSide));
    try {
        render_.requireMemory(film);
    } catch (const Error& error) {
        return wrong(error.what());
    }
    const auto moving = object.find("moving");
    const bool isMoving = moving != object.end() && moving->is_boolean() && moving->get<bool>();
    Json answer = asJson(camera, scene_);
    // Under one lock, so that pages are told of the camera that was set last.
    const std::lock_guard lock(mutex_);
    camera_ = camera;
    answer["number"] = ++cameraNumber_;
    render_.setCamera([this, camera, film] { return camera.place(*scene_.sensor.camera, film); }, film, isMoving);
    return json(answer);
}

HttpResponse ViewService::setFocus(const HttpRequest& request) {
    const Json object = Json::parse(request.body, nullptr, false);
    if (object.is_null()) {
        render_.setFocus({});
        return json(nullptr);
    }
    PicturePart part;
    const auto edge = [&](const char* name, double& value) {
        const auto found = object.find(name);
        if (found == object.end() || !found->is_number()) return false;
        value = found->get<double>();
        return value >= 0 && value <= 1;
    };
    if (!object.is_object() || !edge("x0", part.x0) || !edge("y0", part.y0) || !edge("x1", part.x1) ||
        !edge("y1", part.y1) || part.x0 >= part.x1 || part.y0 >= part.y1)
        return wrong("the body must be null, or have x0 < x1 and y0 < y1, from 0 to 1 across the picture");
    render_.setFocus(part);
    return json({{"x0", part.x0}, {"y0", part.y0}, {"x1", part.x1}, {"y1", part.y1}});
}

HttpResponse ViewService::compare(const HttpRequest& request) {
    try {
        auto image = std::make_shared<const Image>(
            linearRgbOf(decodeImage({request.body, "the picture to compare with", kMostCompared})));
        const Json size{{"width", image->width()}, {"height", image->height()}};
        const std::lock_guard lock(mutex_);
        reference_ = std::move(image);
        return json(size);
    } catch (const Error& error) {
        return wrong(error.what());
    }
}

}  // namespace drc
