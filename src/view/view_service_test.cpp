#include "view/view_service.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/memory.h"
#include "pbrt/scene_file.h"

namespace drc {
namespace {

using Json = nlohmann::json;
constexpr auto kLong = std::chrono::seconds(60);

// A mirror behind a disk that lets all light pass, with a lamp on its left and an instanced ball on its right; sky
// elsewhere. The camera is at the origin and looks along z.
constexpr const char* kScene = R"(Camera "perspective" "float fov" 90
Film "image" "integer xresolution" 40 "integer yresolution" 20
WorldBegin
LightSource "infinite"
MakeNamedMaterial "Walnut" "string type" "matte"
ObjectBegin "ornament"
NamedMaterial "Walnut"
Shape "sphere" "float radius" 1
ObjectEnd
AttributeBegin
Translate 4 0 5
ObjectInstance "ornament"
AttributeEnd
AttributeBegin
AreaLightSource "diffuse" "rgb L" [2 2 2]
Material "none"
Translate -4 0 5
Shape "disk" "float radius" 1
AttributeEnd
AttributeBegin
Material "none"
Translate 0 0 2
Shape "disk" "float radius" 1
AttributeEnd
Material "mirror"
Translate 0 0 8
Shape "disk" "float radius" 1
WorldEnd
)";

struct Served {
    explicit Served(const std::string& text = kScene) {
        pbrt::LoadOptions options;
        options.names = true;
        scene = pbrt::loadPbrtString(text, ".", options, "room.pbrt");
        RenderParams params;
        params.integrator = "path";
        params.spp = 3;
        params.gBuffer = params.variance = true;
        session = std::make_unique<Session>(*scene, params);
        render = std::make_unique<LiveRender>(*session, LiveRender::Callbacks{[](LayeredPicture&, bool) {}, {}});
        service = std::make_unique<ViewService>(
            *scene, session->accel(), *render,
            ViewService::Settings{
                "room", "t", [](const LiveFrame&) { return std::string(); }, {1.5f, true, View::Agx}});
        waitForSamples(3);
    }
    void waitForSamples(int samples) {
        auto frame = render->waitForFrame(0, kLong);
        while (frame->samples < samples) frame = render->waitForFrame(frame->number, kLong);
    }
    HttpResponse get(const std::string& target) {
        HttpRequest request;
        request.method = "GET";
        EXPECT_TRUE(parseTarget("/t/" + target, request));
        return service->answer(request);
    }
    HttpResponse post(const std::string& what, const std::string& body) {
        HttpRequest request;
        request.method = "POST";
        request.path = "/t/" + what;
        request.body = body;
        return service->answer(request);
    }
    Json surface(int x, int y) {
        return Json::parse(get("surface?x=" + std::to_string(x) + "&y=" + std::to_string(y)).body);
    }

    std::unique_ptr<Scene> scene;
    std::unique_ptr<Session> session;
    std::unique_ptr<LiveRender> render;
    std::unique_ptr<ViewService> service;
};

// The column that shows a point at depth z of the film's middle row, whose half width is 20 pixels at 90 degrees.
int columnOf(float x, float z) { return int(20 + 10 * x / z); }

TEST(ViewService, NamesTheSurfaceOfAPixel) {
    Served served;
    Json ball = served.surface(columnOf(4, 5), 10);
    EXPECT_EQ(ball["samples"], 3);
    EXPECT_EQ(ball["surface"]["material"], "Walnut");
    EXPECT_EQ(ball["surface"]["materialKind"], "matte");
    EXPECT_EQ(ball["surface"]["shapeKind"], "sphere");
    EXPECT_EQ(ball["surface"]["object"], "ornament");
    EXPECT_EQ(ball["surface"]["file"], "room.pbrt");
    EXPECT_EQ(ball["surface"]["line"], 8);
    EXPECT_EQ(ball["surface"]["emits"], false);
    EXPECT_NEAR(double(ball["surface"]["distance"]), std::hypot(4, 5) - 1, 0.1);
    EXPECT_FALSE(ball.contains("layers"));

    Json lamp = served.surface(columnOf(-4, 5), 10);
    EXPECT_EQ(lamp["surface"]["emits"], true);
    EXPECT_EQ(lamp["surface"]["shapeKind"], "disk");
    EXPECT_FALSE(lamp["surface"].contains("object"));

    // Through the disk that lets all light pass.
    Json mirror = served.surface(20, 10);
    EXPECT_EQ(mirror["surface"]["materialKind"], "mirror");
    EXPECT_FALSE(mirror["surface"].contains("material"));
    EXPECT_NEAR(double(mirror["surface"]["distance"]), 8, 0.1);

    EXPECT_TRUE(served.surface(20, 0)["surface"].is_null());
}

TEST(ViewService, TellsAllLayersOfAPixelWithItsSurface) {
    Served served;
    Json pixel = Json::parse(served.get("pixel?x=" + std::to_string(columnOf(4, 5)) + "&y=10").body);
    EXPECT_EQ(pixel["surface"]["material"], "Walnut");
    EXPECT_EQ(pixel["samples"], 3);
    for (const char* layer : {"beauty", "unfiltered", "albedo", "normal", "depth", "variance", "samples"})
        EXPECT_TRUE(pixel["layers"].contains(layer)) << layer;
    for (const char* wrong : {"surface", "surface?x=40&y=0", "surface?x=0&y=20", "surface?x=-1&y=0", "pixel?x=1"})
        EXPECT_EQ(served.get(wrong).status, 400) << wrong;
}

// The surface is that of the picture that is shown, whatever its camera, its size and the part of the film.
TEST(ViewService, NamesWhatTheShownFrameShows) {
    std::string text = kScene;
    text.insert(text.find("\nWorldBegin"), "  \"float cropwindow\" [0.5 1 0 1]");
    Served served(text);
    EXPECT_EQ(served.surface(columnOf(4, 5) - 20, 10)["surface"]["material"], "Walnut");
    EXPECT_EQ(served.get("surface?x=20&y=10").status, 400);

    Served moved;
    const Json camera{{"eye", {0, 0, 0}}, {"look", {4, 0, 5}}, {"up", {0, 1, 0}}, {"width", 80}, {"height", 40}};
    ASSERT_EQ(moved.post("camera", camera.dump()).status, 200);
    auto frame = moved.render->waitForFrame(0, kLong);
    while (frame->view == 0) frame = moved.render->waitForFrame(frame->number, kLong);
    EXPECT_EQ(moved.surface(40, 20)["surface"]["material"], "Walnut");
}

// What a drag holds on to: the point that a place of the picture shows, in the renderer's space.
TEST(ViewService, TellsThePointAtAPlace) {
    Served served;
    const auto at = [&](const char* place) { return Json::parse(served.get(place).body)["point"]; };
    const Json ball = at("point?x=0.7&y=0.5");
    EXPECT_NEAR(std::hypot(double(ball[0]) - 4, double(ball[1]), double(ball[2]) - 5), 1, 1e-3);
    EXPECT_LT(double(ball[2]), 5);
    EXPECT_NEAR(double(at("point?x=0.5&y=0.5")[2]), 8, 1e-3);
    EXPECT_TRUE(at("point?x=0.5&y=0").is_null());
    for (const char* wrong : {"point", "point?x=0.5", "point?x=1.1&y=0", "point?x=-0.1&y=0", "point?x=nan&y=0",
                              "point?x=0.5a&y=0", "point?x=&y=0", "point?x=1e-1&y=inf"})
        EXPECT_EQ(served.get(wrong).status, 400) << wrong;
    // Of a part of the film: the same places are others.
    std::string text = kScene;
    text.insert(text.find("\nWorldBegin"), "  \"float cropwindow\" [0.5 1 0 1]");
    Served cropped(text);
    EXPECT_NEAR(double(Json::parse(cropped.get("point?x=0.4&y=0.5").body)["point"][0]), double(ball[0]), 1e-3);
}

// Pages are told of the camera that one of them has set, with a number that rises.
TEST(ViewService, TellsPagesOfTheCamera) {
    Served served;
    const Json home = Json::parse(served.get("state").body)["home"];
    EXPECT_EQ(home["picture"]["kind"], "perspective");
    EXPECT_NEAR(double(home["picture"]["width"]), 4, 1e-3);
    EXPECT_EQ(Json::parse(served.service->frameEvent())["camera"]["number"], 0);
    Json camera = home;
    camera["eye"] = {1, 0, 0};
    for (int i = 1; i < 3; ++i) {
        const Json answer = Json::parse(served.post("camera", camera.dump()).body);
        EXPECT_EQ(answer["number"], i);
        const Json event = Json::parse(served.service->frameEvent());
        EXPECT_EQ(event["camera"], answer);
        EXPECT_EQ(event["camera"]["eye"], (Json{1, 0, 0}));
        EXPECT_EQ(Json::parse(served.get("state").body)["camera"], answer);
    }
    EXPECT_EQ(served.post("camera", "{}").status, 400);
    EXPECT_EQ(Json::parse(served.service->frameEvent())["camera"]["number"], 2);
    // Another program is another run.
    EXPECT_NE(Json::parse(served.get("state").body)["run"], Json::parse(Served().get("state").body)["run"]);
}

TEST(ViewService, KnowsWhatCanBeAToken) {
    EXPECT_TRUE(isToken(randomToken()));
    EXPECT_TRUE(isToken("abcXYZ-_01234567"));
    EXPECT_TRUE(isToken(std::string(128, 'a')));
    for (const std::string& wrong :
         {std::string(), std::string("abcdefghijklmno"), std::string(129, 'a'), std::string("abcdefghijklmno/"),
          std::string("abcdefghijklmno "), std::string("../abcdefghijklm"), std::string("abcdefghijklmn%41"),
          std::string("abcdefghijklmn\xc3\xa4"), std::string(17, '\0')})
        EXPECT_FALSE(isToken(wrong)) << wrong;
}

// A lens narrows the picture to what is beside its middle; the next camera without one has the scene's again.
TEST(ViewService, TakesALens) {
    Served served;
    const auto shown = [&](const Json& camera) {
        const uint64_t before = Json::parse(served.get("state").body)["view"];
        const HttpResponse answer = served.post("camera", camera.dump());
        EXPECT_EQ(answer.status, 200) << answer.body;
        auto frame = served.render->waitForFrame(0, kLong);
        while (frame->view == before) frame = served.render->waitForFrame(frame->number, kLong);
        return Json::parse(answer.body);
    };
    const Json home = Json::parse(served.get("state").body)["home"];
    const std::string middle = served.surface(20, 10)["surface"].dump();
    const float x = 4.f / 5;
    Json camera = home;
    camera["lens"] = {{"window", {x - 0.01f, x + 0.01f, -0.01f, 0.01f}}};
    const Json answer = shown(camera);
    EXPECT_FLOAT_EQ(answer["lens"]["window"][1], x + 0.01f);
    EXPECT_THAT(answer["pbrt"].get<std::string>(), testing::HasSubstr("Camera \"perspective\""));
    for (const int column : {1, 20, 38}) EXPECT_EQ(served.surface(column, 10)["surface"]["material"], "Walnut");
    EXPECT_FALSE(shown(home).contains("lens"));
    EXPECT_EQ(served.surface(20, 10)["surface"].dump(), middle);

    for (const char* wrong :
         {"1", "null", "[]", "{}", R"({"window": [0, 1, 0]})", R"({"window": [0, 1, 0, "1"]})",
          R"({"window": [1, 0, 0, 1]})", R"({"window": [0, 1, 0, 1e300]})",
          R"({"window": [0, 1, 0, 1], "orthographic": 1})", R"({"window": [0, 1, 0, 1], "radius": -1})",
          R"({"window": [0, 1, 0, 1], "focalDistance": "far"})"}) {
        camera["lens"] = Json::parse(wrong);
        const HttpResponse refused = served.post("camera", camera.dump());
        EXPECT_EQ(refused.status, 400) << wrong;
        EXPECT_THAT(refused.body, testing::StartsWith("a lens must have a window")) << wrong;
    }
}

TEST(ViewService, TellsHowThePageShowsPicturesAtFirst) {
    const Json display = Json::parse(Served().get("state").body)["display"];
    EXPECT_EQ(display, Json({{"exposure", 1.5}, {"auto", true}, {"view", "agx"}}));
}

TEST(ViewService, TakesAPartOfThePicture) {
    Served served;
    EXPECT_TRUE(Json::parse(served.get("state").body)["focus"].is_null());
    EXPECT_EQ(served.post("focus", R"({"x0": 0.5, "y0": 0, "x1": 1, "y1": 0.5})").status, 200);
    while (Json::parse(served.get("state").body)["focus"].is_null()) std::this_thread::yield();
    Json state = Json::parse(served.get("state").body);
    EXPECT_EQ(state["focus"], (Json{20, 0, 40, 10}));
    EXPECT_EQ(served.post("focus", "null").status, 200);
    while (!Json::parse(served.get("state").body)["focus"].is_null()) std::this_thread::yield();
    for (const char* wrong :
         {"", "[]", "{}", "true", R"({"x0": 0, "y0": 0, "x1": 1})", R"({"x0": 0, "y0": 0, "x1": 1.5, "y1": 1})",
          R"({"x0": 0.5, "y0": 0, "x1": 0.5, "y1": 1})", R"({"x0": "0", "y0": 0, "x1": 1, "y1": 1})"})
        EXPECT_EQ(served.post("focus", wrong).status, 400) << wrong;
    EXPECT_EQ(served.get("focus").status, 405);
}

// Names in files need not be UTF-8, and JSON must.
TEST(ViewService, AnswersWithNamesInOtherEncodings) {
    std::string text = kScene;
    for (size_t at = text.find("Walnut"); at != std::string::npos; at = text.find("Walnut", at + 1))
        text.replace(at, 6, "Nu\xdf");
    Served served(text);
    EXPECT_EQ(served.surface(columnOf(4, 5), 10)["surface"]["material"], "Nu\xef\xbf\xbd");
}

// A page that asks for more than there is memory for is told so, and the view goes on.
TEST(ViewService, RefusesSizesBeyondTheMemory) {
    Served served;
    const std::string camera = R"({"eye": [0, 0, 0], "look": [0, 0, 5], "up": [0, 1, 0], "width": )";
    {
        // Nearly all that claims may use.
        const MemoryClaim held(0.85 * double(availableMemory()), "a test");
        const HttpResponse refused = served.post("camera", camera + "4096, \"height\": 4096}");
        if (availableMemory() < (uint64_t(40) << 30)) {
            EXPECT_EQ(refused.status, 400);
            EXPECT_THAT(refused.body, testing::HasSubstr("a picture of 4096 x 4096 pixels needs"));
        }
    }
    EXPECT_EQ(served.post("camera", camera + "40, \"height\": 30}").status, 200);
    const uint64_t view = served.render->frame()->view;
    auto frame = served.render->frame();
    while (frame->view == view && frame->picture.beauty.height() != 30)
        frame = served.render->waitForFrame(frame->number, kLong);
    EXPECT_EQ(served.render->state().error, "");
}

TEST(ViewService, ValuesOfAPixelAreThoseOfTheLayers) {
    const Served served;
    const auto frame = served.render->frame();
    for (const std::string& name : layersOf(*frame)) {
        const Image image = layerOf(*frame, name);
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(17, 5), std::pair(39, 19)}) {
            std::vector<float> values;
            for (int c = 0; c < image.channels(); ++c) values.push_back(image.at(x, y, c));
            EXPECT_EQ(layerAt(*frame, name, x, y), values) << name;
        }
    }
}

}  // namespace
}  // namespace drc
