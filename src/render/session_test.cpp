#include "render/session.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "base/log.h"
#include "base/state_file.h"
#include "film/sample_pass.h"
#include "integrators/integrator.h"
#include "maps/map_denoiser.h"
#include "pbrt/scene_file.h"
#include "reconstruct/surface_picture_filter.h"

namespace drc {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::vector<std::string> kIntegrators = integratorNames();

constexpr const char* kLitRoom = R"(
        Film "image" "integer xresolution" 24 "integer yresolution" 16
        LookAt 0 0 -3  0 0 0  0 1 0
        Camera "perspective" "float fov" 70
        WorldBegin
        AttributeBegin
        AreaLightSource "diffuse" "rgb L" [8 8 8]
        Translate 0 1.6 0 Shape "sphere" "float radius" .4
        AttributeEnd
        Material "plastic" "rgb Kd" [.6 .4 .3] "float roughness" .05
        Shape "sphere" "float radius" 1
        ReverseOrientation
        Material "matte"
        Shape "sphere" "float radius" 4
        WorldEnd)";

std::unique_ptr<Scene> litRoom() { return pbrt::loadPbrtString(kLitRoom, ".", {}, "s.pbrt"); }

RenderParams paramsOf(const std::string& integrator, int spp, int mapPasses = 1) {
    RenderParams params;
    params.integrator = integrator;
    params.spp = spp;
    params.mapPasses = mapPasses;
    return params;
}

struct Rendered {
    explicit Rendered(const RenderParams& params, std::unique_ptr<Scene> s = litRoom())
        : scene(std::move(s)), session(*scene, params) {}
    Rendered& finish() {
        while (session.step()) {
        }
        return *this;
    }
    std::unique_ptr<Scene> scene;
    Session session;
};

double meanOf(const Image& image) {
    double sum = 0;
    for (const float v : image.data()) sum += v;
    return sum / double(image.data().size());
}

// A sample pass that is cancelled when half of the film's rows have had it, as far as there is another one.
void stepThroughAPart(Rendered& r) {
    CancelToken cancel;
    std::atomic<bool> done{false};
    Film& film = r.session.film();
    const int passes = film.passes();
    std::jthread observer([&] {
        while (!done) {
            int rows = 0;
            for (int y = film.region().y0; y < film.region().y1; ++y) {
                const auto lock = film.lockRow(y);
                rows += film.rowPasses(y) > passes;
            }
            if (rows > 0) cancel.cancel();
        }
    });
    r.session.step(&cancel);
    done = true;
}

bool sameBits(const Film& a, const Film& b) {
    for (size_t i = 0; i < a.layerCount(); ++i)
        for (int y = a.region().y0; y < a.region().y1; ++y)
            if (!std::ranges::equal(a.layer(i).row(y), b.layer(i).row(y))) return false;
    return true;
}

// A bright strip across a dim sky, with a pixel filter that undershoots beside it.
TEST(Session, PicturesHaveNoLightBelowZero) {
    Rendered r(paramsOf("path", 16), pbrt::loadPbrtString(R"(
        Film "image" "integer xresolution" 24 "integer yresolution" 24
        PixelFilter "sinc"
        Camera "perspective" "float fov" 90
        WorldBegin
        LightSource "infinite" "rgb L" [.01 .01 .01]
        AreaLightSource "diffuse" "rgb L" [50 50 50] "bool twosided" "true"
        Translate 0 0 1
        Shape "trianglemesh" "point P" [-2 -.2 0 2 -.2 0 2 .2 0 -2 .2 0] "integer indices" [0 1 2 0 2 3]
        WorldEnd)"));
    const Image picture = r.finish().session.picture().beauty;
    int black = 0, dim = 0, bright = 0;
    for (const float v : picture.data()) {
        EXPECT_GE(v, 0);
        black += v == 0;
        dim += v > 0.009f && v < 0.011f;
        bright += v > 40;
    }
    EXPECT_GT(black, 50);  // where the sky alone would be grey
    EXPECT_GT(dim, 50);
    EXPECT_GT(bright, 50);
}

// Tracing indirect light along with the samples does not change them, nor their stratification.
TEST(Session, TheDirectLayerIsWhatTheDirectIntegratorGives) {
    const Image direct = Rendered(paramsOf("direct", 12)).finish().session.picture().beauty;
    Rendered maps(paramsOf("drc-maps", 12));
    LayeredPicture picture = maps.finish().session.picture();
    const Image layer = picture.part("direct");
    for (size_t i = 0; i < direct.data().size(); ++i)
        EXPECT_NEAR(layer.data()[i], direct.data()[i], 1e-5f * (1 + direct.data()[i]));
    SurfacePictureFilter(true, true).apply(picture);
    EXPECT_NE(picture.part("direct").data(), layer.data());
}

TEST(Session, LayersSumToThePicture) {
    Rendered r(paramsOf("drc-maps", 4));
    const LayeredPicture picture = r.finish().session.picture();
    const Image direct = picture.part("direct"), indirect = picture.part("indirect");
    for (size_t i = 0; i < direct.data().size(); ++i)
        EXPECT_NEAR(direct.data()[i] + indirect.data()[i], picture.beauty.data()[i], 1e-5f);
}

// Even if the time is over, every part of a picture has direct and indirect light.
TEST(Session, ABudgetThatIsOverLeavesAPicture) {
    for (const std::string integrator : {"drc", "drc-maps", "path", "bdpt"}) {
        RenderParams params = paramsOf(integrator, 5);
        params.seconds = 1e-9;
        Rendered r(params);
        EXPECT_FALSE(r.session.hasPicture());
        r.finish();
        EXPECT_TRUE(r.session.hasPicture());
        EXPECT_EQ(r.session.samplesDone(), 0);
        const LayeredPicture picture = r.session.picture();
        const Image light = traitsOf(integrator).maps ? picture.part("indirect") : picture.beauty;
        int lit = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 24; ++x) lit += luminance(light.rgb(x, y)) > 0;
        EXPECT_GT(lit, traitsOf(integrator).maps ? 24 * 16 - 1 : 24 * 16 / 2) << integrator;
    }
}

// A cancelled pass does not count as complete, but its samples count.
TEST(Session, ACancelledPassIsNotCounted) {
    Rendered r(paramsOf("path", 8));
    while (r.session.samplesDone() < 2) ASSERT_TRUE(r.session.step());
    CancelToken cancel;
    cancel.cancel();
    EXPECT_FALSE(r.session.step(&cancel));
    EXPECT_EQ(r.session.samplesDone(), 2);
    EXPECT_EQ(r.session.status(), "2 spp");
    // Some rows already have their third sample.
    r.session.film().setRowPasses(3, SamplePass::passesFor(3));
    EXPECT_EQ(r.session.samplesDone(), 2);
}

// A render that is stopped anywhere, also within a pass, and continued from a file has the same bits.
TEST(Session, GoesOnWhereItWas) {
    const TemporaryFolder folder;
    for (const std::string& integrator : kIntegrators)
        for (const bool withinAPass : {false, true}) {
            const RenderParams params = paramsOf(integrator, 8, 2);
            Rendered whole(params), first(params), second(params);
            whole.finish();
            for (int i = 0; i < 7; ++i) first.session.step();
            if (withinAPass) stepThroughAPart(first);
            first.session.save(folder.path("render"), "room");
            second.session.load(folder.path("render"), "room");
            // The one that was saved goes on, too.
            EXPECT_TRUE(sameBits(whole.session.film(), first.finish().session.film())) << integrator << withinAPass;
            EXPECT_TRUE(sameBits(whole.session.film(), second.finish().session.film())) << integrator << withinAPass;
            EXPECT_EQ(second.session.samplesDone(), 8);
        }
}

// What has been loaded replaces everything that a session had found out, and a file that is refused nothing.
TEST(Session, LoadsAFileWholeOrNotAtAll) {
    const TemporaryFolder folder;
    const RenderParams params = paramsOf("drc", 6);
    Rendered whole(params), saved(params), other(params), path(paramsOf("path", 6));
    whole.finish();
    for (int i = 0; i < 5; ++i) saved.session.step();
    stepThroughAPart(saved);
    saved.session.save(folder.path("a"), "room");
    const auto refusal = [&](Rendered& r, const std::string& name, const std::string& identity = "room") {
        return errorOf([&] { r.session.load(folder.path(name), identity); });
    };
    const std::string bytes = readFile(folder.path("a"));
    folder.write("short", bytes.substr(0, bytes.size() - 8));
    folder.write("picture", "P6 1 1");
    for (int i = 0; i < 3; ++i) other.session.step();
    EXPECT_THAT(refusal(other, "short"), AllOf(HasSubstr("short: the file is damaged"), Not(HasSubstr("\n"))));
    EXPECT_THAT(refusal(other, "picture"), HasSubstr("picture: not a drc render"));
    EXPECT_THAT(refusal(other, "none"), HasSubstr("none"));
    EXPECT_THAT(refusal(other, "a", "another room"), HasSubstr("a: a drc render of another scene, other settings"));
    EXPECT_THAT(refusal(path, "a"), HasSubstr("a: a drc render of another scene, other settings"));
    for (size_t at = bytes.find('\n') + 1; at < bytes.size(); at += bytes.size() / 50) {
        std::string flipped = bytes;
        flipped[at] = char(flipped[at] ^ 0x10);
        folder.write("flipped", flipped);
        EXPECT_THAT(refusal(other, "flipped"), HasSubstr("flipped: the file is damaged: its checksum is wrong")) << at;
    }
    // Files of the right checksum whose values are impossible or too few.
    const std::string header = bytes.substr(0, bytes.find('\n'));
    for (const uint32_t refined : {0u, 1u, 1000u}) {
        StateWriter forged(folder.path("forged"), header);
        forged.value(refined);
        forged.value(uint32_t(1));
        forged.value(uint64_t(1 << 14));
        forged.value(uint64_t(refined == 1 ? 1 : 0));
        for (int i = 0; i < 12; ++i) forged.value(uint64_t(0));
        forged.commit();
        EXPECT_THAT(refusal(other, "forged"), HasSubstr("forged: the file is damaged: ")) << refined;
    }
    EXPECT_TRUE(sameBits(whole.session.film(), other.finish().session.film()));
    EXPECT_EQ(refusal(other, "a"), "");
    EXPECT_TRUE(sameBits(saved.session.film(), other.session.film()));
    EXPECT_TRUE(sameBits(whole.session.film(), other.finish().session.film()));
}

// Cells are written by what they know, not the whole table that has room for a million.
TEST(Session, FilesHaveUsedCellsAlone) {
    const TemporaryFolder folder;
    Rendered drc(paramsOf("drc", 1)), path(paramsOf("path", 1));
    drc.session.save(folder.path("drc"), "room");
    path.session.save(folder.path("path"), "room");
    EXPECT_LT(readFile(folder.path("drc")).size(), readFile(folder.path("path")).size() + 1000);
}

// What is freed for the last picture does not change it.
TEST(Session, PicturesCanBeTakenAfterSamplingHasEnded) {
    for (const std::string& integrator : kIntegrators) {
        Rendered render(paramsOf(integrator, 2));
        render.finish();
        const Image before = render.session.picture().beauty;
        render.session.endSampling();
        EXPECT_EQ(before.data(), render.session.picture().beauty.data()) << integrator;
        EXPECT_EQ(render.session.samplesDone(), 2);
    }
}

// 1, 2 or 8 threads.
TEST(Session, TheNumberOfThreadsMakesNoDifference) {
    for (const std::string& integrator : kIntegrators) {
        setThreadCount(1);
        const RenderParams params = paramsOf(integrator, 8, 2);
        Rendered one(params);
        one.finish();
        for (const int threads : {2, 8}) {
            setThreadCount(threads);
            EXPECT_TRUE(sameBits(one.session.film(), Rendered(params).finish().session.film()))
                << integrator << ", " << threads << " threads";
        }
        setThreadCount(0);
    }
}

// Samples 0 to 1 and 2 to 5, rendered separately, add up to samples 0 to 5, to the bit.
TEST(Session, ShardsAddUpToTheWhole) {
    for (const std::string integrator : {"path", "bdpt", "direct"}) {
        Rendered whole(paramsOf(integrator, 6)), a(paramsOf(integrator, 2));
        RenderParams rest = paramsOf(integrator, 4);
        rest.firstSample = 2;
        Rendered b(rest);
        b.finish().session.film().add(a.finish().session.film());
        EXPECT_TRUE(sameBits(whole.finish().session.film(), b.session.film())) << integrator;
        EXPECT_EQ(b.session.samplesDone(), 6);
        EXPECT_EQ(whole.session.picture().beauty.data(), b.session.picture().beauty.data());
    }
}

TEST(Session, ACameraChangeIsAsIfItHadBeenTheFirst) {
    const auto elsewhere = [] {
        std::string text = kLitRoom;
        text.replace(text.find("LookAt 0 0 -3"), 13, "LookAt 1 0 -2");
        return pbrt::loadPbrtString(text, ".", {}, "s.pbrt");
    };
    for (const std::string& integrator : kIntegrators) {
        Rendered there(paramsOf(integrator, 3), elsewhere()), moved(paramsOf(integrator, 3));
        moved.finish();
        const Accel* accel = &moved.session.accel();
        const PathTracer* tracer = &moved.session.tracer();
        std::unique_ptr<Scene> other = elsewhere();
        const FilmGeometry film = other->sensor.settings.film;
        moved.session.setCamera(other->sensor.camera, film);
        EXPECT_EQ(moved.session.samplesDone(), 0);
        EXPECT_EQ(accel, &moved.session.accel());
        EXPECT_EQ(tracer, &moved.session.tracer());
        EXPECT_TRUE(sameBits(there.finish().session.film(), moved.finish().session.film())) << integrator;
    }
}

TEST(Session, ACameraChangeMayChangeTheSize) {
    Rendered r(paramsOf("path", 2));
    r.finish();
    const FilmGeometry film{10, 6};
    r.session.setCamera(r.scene->sensor.camera->withFilm(film), film);
    EXPECT_EQ(r.finish().session.picture().beauty.width(), 10);
}

TEST(Session, PicturesCanBeTakenBesideSteps) {
    for (const std::string& integrator : kIntegrators) {
        Rendered r(paramsOf(integrator, 40, 2));
        std::atomic<bool> done{false};
        std::jthread steps([&] {
            r.finish();
            done = true;
        });
        int taken = 0;
        while (!done || taken == 0) {
            const LayeredPicture picture = r.session.snapshot();
            for (const float v : picture.beauty.data()) ASSERT_TRUE(std::isfinite(v));
            ++taken;
        }
    }
}

TEST(Session, KnowsHowNoisyItIs) {
    const auto noisy = [](const std::string& integrator, int spp, uint64_t seed) {
        RenderParams params = paramsOf(integrator, spp);
        params.seed = seed;
        params.variance = true;
        Rendered r(params);
        LayeredPicture picture = r.finish().session.picture();
        picture.film = nullptr;
        return picture;
    };
    const auto variance = [&](const LayeredPicture& p) {
        double sum = 0;
        for (const PictureLayer& layer : p.layers)
            if (layer.variance) sum += meanOf(*layer.variance);
        return sum;
    };
    for (const std::string integrator : {"path", "bdpt", "direct"}) {
        const LayeredPicture few = noisy(integrator, 16, 1), other = noisy(integrator, 16, 2),
                             many = noisy(integrator, 64, 3);
        for (const float n : few.samples->data()) EXPECT_EQ(n, 16);
        EXPECT_NEAR(variance(many) / variance(few), 0.25, 0.12) << integrator;
        if (integrator == "bdpt") continue;  // its splats are not counted
        double squares = 0;
        for (size_t i = 0; i < few.beauty.data().size(); ++i)
            squares +=
                double(few.beauty.data()[i] - other.beauty.data()[i]) * (few.beauty.data()[i] - other.beauty.data()[i]);
        const double measured = squares / double(few.beauty.data().size()) / 2;
        // Sobol points have less variance than independent ones, which the estimate assumes.
        EXPECT_LT(measured, 1.5 * variance(few));
        EXPECT_GT(measured, 0.1 * variance(few));
    }
    EXPECT_GT(variance(noisy("drc-maps", 16, 1)), 0);
}

// The G-buffer is recorded by the samples themselves, which are the same with and without it.
TEST(Session, TheGBufferChangesNothing) {
    for (const std::string& integrator : kIntegrators) {
        RenderParams params = paramsOf(integrator, 8);
        const Image plain = Rendered(params).finish().session.picture().beauty;
        params.gBuffer = true;
        Rendered r(params);
        const LayeredPicture picture = r.finish().session.picture();
        EXPECT_EQ(picture.beauty.data(), plain.data()) << integrator;
        ASSERT_TRUE(picture.gBuffer) << integrator;
        // The ball ahead, two units away; its glossy lobe adds a little to the diffuse albedo.
        EXPECT_NEAR(picture.gBuffer->depth.at(12, 8, 0), 2, 0.02) << integrator;
        EXPECT_NEAR(picture.gBuffer->normal.at(12, 8, 2), -1, 0.02) << integrator;
        EXPECT_GT(picture.gBuffer->albedo.at(12, 8, 0), 0.55f) << integrator;
        EXPECT_LT(picture.gBuffer->albedo.at(12, 8, 2), 0.5f) << integrator;
    }
}

// A sample of emission that is not finite is left out; it must not turn the emission layer negative. Two lamps without
// a surface, one behind the other before a wall: each radiance is finite, their sum is not.
TEST(Session, EmissionThatOverflowsTakesNothingFromOtherLight) {
    const auto scene = [] {
        const std::string lamp =
            "Shape \"trianglemesh\" \"point P\" [-.01 -.01 0 .01 -.01 0 .01 .01 0 -.01 .01 0] "
            "\"integer indices\" [0 1 2 0 2 3]\n";
        return pbrt::loadPbrtString(
            "Film \"image\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
            "Camera \"perspective\" \"float fov\" 1\nWorldBegin\n"
            "AttributeBegin\nMaterial \"none\"\n"
            "AreaLightSource \"diffuse\" \"rgb L\" [3e38 3e38 3e38] \"bool twosided\" \"true\"\n"
            "Translate 0 0 .5\n" +
            lamp + "Translate 0 0 .1\n" + lamp +
            "AttributeEnd\nMaterial \"matte\"\nTranslate 0 0 2\nScale 100 100 100\n" + lamp + "WorldEnd\n");
    };
    Rendered r(paramsOf("drc-maps", 4), scene());
    const LayeredPicture picture = r.finish().session.picture();
    EXPECT_EQ(meanOf(r.session.picture().layers[0].mean), 0);  // emission
    const Image direct = picture.part("direct");
    for (const float v : direct.data()) EXPECT_GE(v, 0);
    EXPECT_GT(meanOf(direct), 1e20);
}

// --clamp, and the film's maxsampleluminance, hold for every integrator.
TEST(Session, NoSampleIsBrighterThanTheClamp) {
    constexpr float kClamp = 0.5f;
    for (const std::string& integrator : kIntegrators)
        for (const bool byFile : {false, true}) {
            RenderParams params = paramsOf(integrator, 1);
            if (!byFile) params.clamp = kClamp;
            std::unique_ptr<Scene> scene = litRoom();
            if (byFile) scene->sensor.settings.maxSampleLuminance = kClamp;
            Rendered r(params, std::move(scene));
            const LayeredPicture picture = r.finish().session.picture();
            float most = 0;
            const auto look = [&](const Image& image) {
                for (int y = 0; y < 16; ++y)
                    for (int x = 0; x < 24; ++x) most = std::max(most, luminance(image.rgb(x, y)));
            };
            if (traitsOf(integrator).maps)
                look(picture.part("direct"));
            else if (integrator == "bdpt")
                look(picture.layers[0].mean);  // without splats, each of which is bounded by itself
            else
                look(picture.beauty);
            EXPECT_LE(most, kClamp * 1.0001f) << integrator << byFile;  // the lamp has 8
            EXPECT_GT(most, 0.9f * kClamp) << integrator << byFile;
        }
}

// A film takes at most 64 bytes a pixel for paths, without the G-buffer and variance.
TEST(Session, FilmsAreSmall) {
    for (const std::string& integrator : kIntegrators) {
        if (traitsOf(integrator).maps) continue;
        EXPECT_LE(Rendered(paramsOf(integrator, 1)).session.film().bytesPerPixel(), 64u) << integrator;
    }
    EXPECT_LE(Rendered(paramsOf("drc-maps", 1)).session.film().bytesPerPixel(), 624u);
}

// A film of the largest size that a file may ask for: no machine has terabytes for all of it, and every machine has
// memory for a part.
TEST(Session, PicturesBeyondTheMemoryAreRefused) {
    const std::string text =
        "Film \"image\" \"integer xresolution\" 65536 \"integer yresolution\" 65536\n"
        "WorldBegin\nShape \"sphere\"\nWorldEnd\n";
    const auto errorFor = [](Scene& scene) {
        return drc::errorOf([&] { const Session session(scene, paramsOf("path", 1)); });
    };
    const auto scene = pbrt::loadPbrtString(text, ".", {}, "s.pbrt");
    EXPECT_THAT(
        errorFor(*scene),
        AllOf(StartsWith("s.pbrt:1:6: a picture of 65536 x 65536 pixels needs about 1120.0 GiB of memory, and "),
              HasSubstr("choose a smaller --resolution, or a part of it by --crop")));
    const float part[4] = {0.5f, 0.501f, 0.5f, 0.501f};
    std::copy(part, part + 4, scene->sensor.settings.cropWindow);
    EXPECT_EQ(errorFor(*scene), "");
    // Settings from the command line are not reported as a fault of the file.
    const auto other = pbrt::loadPbrtString(text, ".", {FilmGeometry{60000, 60000}}, "s.pbrt");
    EXPECT_THAT(errorFor(*other), StartsWith("a picture of 60000 x 60000 pixels needs"));
}

// A camera whose film does not fit leaves the session as it was.
TEST(Session, CamerasBeyondTheMemoryAreRefused) {
    for (const std::string& integrator : kIntegrators) {
        Rendered whole(paramsOf(integrator, 2)), r(paramsOf(integrator, 2));
        r.session.step();
        const FilmGeometry film{65536, 65536};
        const std::shared_ptr<const Camera> camera = r.scene->sensor.camera->withFilm(film);
        EXPECT_THAT(drc::errorOf([&] { r.session.setCamera(camera, film); }), HasSubstr("65536 x 65536 pixels needs"));
        EXPECT_THAT(drc::errorOf([&] { r.session.moveCamera(camera, film); }), HasSubstr("65536 x 65536 pixels needs"));
        EXPECT_TRUE(sameBits(whole.finish().session.film(), r.finish().session.film())) << integrator;
    }
}

TEST(Session, UnknownIntegratorsAreNamed) {
    EXPECT_THAT(drc::errorOf([&] { Rendered r(paramsOf("photon", 1)); }),
                AllOf(HasSubstr("no integrator 'photon'"), HasSubstr("drc, drc-maps, path, bdpt, direct")));
}

// A black picture is hardly ever what was wanted.
TEST(Session, WarnsOnceOfPicturesThatCanOnlyBeBlack) {
    const auto warningsOf = [](const std::string& world) {
        auto scene = pbrt::loadPbrtString("Camera \"perspective\"\nWorldBegin\n" + world + "WorldEnd\n");
        forgetWarnings();
        const Rendered rendered(paramsOf("path", 1), std::move(scene));
        return warningCount();
    };
    const std::string seen = "Shape \"sphere\" \"float radius\" 5\n";
    const std::string behind = "Translate 0 0 -5 Shape \"sphere\" Identity\n";
    const std::string lamp = "LightSource \"point\"\n", sky = "LightSource \"infinite\"\n";
    EXPECT_EQ(warningsOf(seen), 1) << "no lights";
    EXPECT_EQ(warningsOf(behind), 1) << "no lights";
    EXPECT_EQ(warningsOf(behind + lamp), 1) << "nothing is seen";
    EXPECT_EQ(warningsOf(behind + "LightSource \"distant\"\n"), 1) << "nothing is seen";
    EXPECT_EQ(warningsOf(seen + lamp), 0);
    EXPECT_EQ(warningsOf(behind + sky), 0);
    EXPECT_EQ(warningsOf("AreaLightSource \"diffuse\"\n" + seen), 0);
    EXPECT_EQ(warningsOf("AreaLightSource \"diffuse\"\nMaterial \"none\"\n" + seen), 0);
}

// A session that moves its camera, and one whose integrator leaves media out, take nothing from a third one.
TEST(Session, SeveralShareAScene) {
    std::string text = kLitRoom;
    text.insert(text.find("WorldBegin") + 10,
                "\nMakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.1 .2 .3] "
                "\"rgb sigma_s\" [.1 .1 .1]\nMediumInterface \"fog\" \"fog\"\n");
    text.insert(0, "MakeNamedMedium \"air\" \"string type\" \"homogeneous\"\nMediumInterface \"\" \"air\"\n");
    const auto load = [&] { return pbrt::loadPbrtString(text, ".", {}, "s.pbrt"); };
    const auto render = [](const Scene& scene, const std::string& integrator, bool move) {
        auto session = std::make_unique<Session>(scene, paramsOf(integrator, 4));
        if (move) {
            const FilmGeometry film{30, 20};
            session->setCamera(scene.sensor.camera->withFilm(film), film);
        }
        while (session->step()) {
        }
        return session;
    };
    const std::pair<const char*, bool> ways[] = {{"path", false}, {"drc", true}, {"bdpt", false}, {"drc", false}};
    const std::unique_ptr<const Scene> shared = load();
    ASSERT_FALSE(shared->media.empty());
    std::vector<std::unique_ptr<Session>> together(std::size(ways));
    {
        std::vector<std::jthread> threads;
        for (size_t i = 0; i < std::size(ways); ++i)
            threads.emplace_back([&, i] { together[i] = render(*shared, ways[i].first, ways[i].second); });
    }
    for (size_t i = 0; i < std::size(ways); ++i) {
        const std::unique_ptr<const Scene> own = load();
        EXPECT_TRUE(sameBits(together[i]->film(), render(*own, ways[i].first, ways[i].second)->film()))
            << ways[i].first;
    }
    EXPECT_FALSE(shared->media.empty());
}

}  // namespace
}  // namespace drc
