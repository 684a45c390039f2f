#include "reconstruct/layer_filter.h"

#include <gtest/gtest.h>

#include <random>

#include "film/film_testing.h"

namespace drc {
namespace {

constexpr PixelRegion kRegion{10, 20, 50, 50};

// Noisy samples of a wall (x below 30) and a floor (the rest), lit by `light`, with a chequered albedo.
struct Scene {
    static bool wall(int x) { return x < 30; }
    static Rgb albedo(int x, int y) { return (x / 2 + y / 2) % 2 ? Rgb(0.8f, 0.6f, 0.4f) : Rgb(0.1f, 0.2f, 0.3f); }
    static Rgb light(int x) { return wall(x) ? Rgb(1, 2, 3) : Rgb(5, 4, 3); }
};

// The film of such a scene's samples.
std::vector<FilmLayerSpec> layersOfTest() {
    std::vector<FilmLayerSpec> layers{
        {.name = "samples", .groups = LayerFilter::kGroups, .storage = FilmLayerSpec::Storage::Single}};
    LobeGBuffer::addSpecs(layers, 100);
    return layers;
}

struct FilteredFilm {
    std::unique_ptr<Film> film = std::make_unique<Film>(test::filmSettings(kRegion), layersOfTest());
    FilmLayer& samples = film->layer(0);

    void add(int x, int y, int i, const Rgb& value, const Rgb& albedo, const Vec3& position, const Vec3& normal) {
        SampleLayers s;
        s.albedo = s.broadAlbedo = albedo;
        s.position = position;
        s.normal = normal;
        s.pixelSize = 1;
        LobeGBuffer::add(*film, 1, x, y, s, 1, true);
        samples.add(x, y, groupOf(x, y, i), value, 1);
    }
    // A sample that met no surface.
    void addNothing(int x, int y, int i) {
        LobeGBuffer::add(*film, 1, x, y, {}, 1, true);
        samples.add(x, y, groupOf(x, y, i), Rgb(0.f), 1);
    }
    static int groupOf(int x, int y, int i) { return (i ^ (x & 1) ^ (2 * (y & 1))) % LayerFilter::kGroups; }
    void correct(Image& layer) const { LayerFilter(LobeGBuffer(*film), LobeKind::Broad).correct(layer, samples); }
    Image smooth() const { return LayerFilter(LobeGBuffer(*film), LobeKind::All).smooth(samples); }
};

template <typename F>
void forEachPixel(F&& f) {
    for (int y = kRegion.y0; y < kRegion.y1; ++y)
        for (int x = kRegion.x0; x < kRegion.x1; ++x) f(x, y);
}

FilteredFilm traced(int samples, float outlier = 0, unsigned seed = 1) {
    FilteredFilm film;
    std::mt19937 rng(seed);
    std::exponential_distribution<float> noise(1);
    for (int i = 0; i < samples; ++i)
        forEachPixel([&](int x, int y) {
            const Rgb albedo = Scene::albedo(x, y);
            Rgb value = albedo * Scene::light(x) * noise(rng);
            if (outlier > 0 && x == 20 && y == 35 && i == 3) value = Rgb(outlier);
            const bool wall = Scene::wall(x);
            film.add(x, y, i, value, albedo, wall ? Vec3(0, float(y), float(30 - x)) : Vec3(float(x - 30), float(y), 0),
                     wall ? Vec3(1, 0, 0) : Vec3(0, 0, 1));
        });
    return film;
}

// A white floor with a sample for each of `samples` values: light(x, y, i).
template <typename F>
FilteredFilm floorUnder(int samples, F&& light) {
    FilteredFilm film;
    for (int i = 0; i < samples; ++i)
        forEachPixel([&](int x, int y) {
            film.add(x, y, i, Rgb(light(x, y, i)), Rgb(1.f), Vec3(float(x), float(y), 0), Vec3(0, 0, 1));
        });
    return film;
}

Image layer(float scale) {
    Image image(kRegion.width(), kRegion.height());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.setRgb(x, y, Scene::albedo(x + 10, y + 20) * Scene::light(x + 10) * scale);
    return image;
}

double relativeError(const Image& image) {
    const Image truth = layer(1);
    double sum = 0;
    for (size_t i = 0; i < truth.data().size(); ++i) sum += std::abs(image.data()[i] / truth.data()[i] - 1);
    return sum / double(truth.data().size());
}

TEST(LayerFilter, CorrectionRemovesASmoothErrorWithoutNoiseOrLeaks) {
    Image image = layer(0.7f);
    EXPECT_NEAR(relativeError(image), 0.3, 1e-5);
    traced(64).correct(image);
    // The samples have a relative error of 1/8 in each pixel, and a filter across the edge would mix light that differs
    // fivefold.
    EXPECT_LT(relativeError(image), 0.03);
}

// Samples on every fourth row and column alone, as a first look has them: the others are lit as their surface is, with
// their own albedo, and not as their neighbour on the lattice.
TEST(LayerFilter, PixelsWithoutSamplesAreLitAsTheirSurface) {
    FilteredFilm film = traced(1);
    film.samples = FilmLayer(kRegion, film.samples.spec());
    forEachPixel([&](int x, int y) {
        if ((x - kRegion.x0) % 4 == 0 && (y - kRegion.y0) % 4 == 0)
            for (int g = 0; g < LayerFilter::kGroups; ++g)
                film.samples.add(x, y, g, Scene::albedo(x, y) * Scene::light(x), 1);
    });
    EXPECT_LT(relativeError(LayerFilter(LobeGBuffer(*film.film), LobeKind::Broad).smooth(film.samples)), 0.02);
}

TEST(LayerFilter, CorrectionLeavesARightLayerNearlyAsItIs) {
    Image image = layer(1);
    traced(16).correct(image);
    EXPECT_LT(relativeError(image), 0.02);
}

TEST(LayerFilter, CorrectionMakesNoBlotchOfOneBrightPath) {
    Image image = layer(1);
    traced(16, 1e5f).correct(image);
    EXPECT_LT(relativeError(image), 0.03);
}

// Sometimes two of the groups agree by chance.
TEST(LayerFilter, CorrectionMakesNoDotOfTwoBrightPaths) {
    const Image truth = layer(1);
    Image image = truth;
    FilteredFilm film = traced(16);
    for (const int group : {0, 1}) film.samples.add(20, 35, group, Rgb(50), 1);
    const double sampled = film.samples.mean(20, 35).y / truth.rgb(10, 15).y - 1;
    film.correct(image);
    const double shown = image.rgb(10, 15).y / truth.rgb(10, 15).y - 1;
    RecordProperty("share", std::to_string(shown / sampled));
    EXPECT_GT(sampled, 3);
    EXPECT_LT(shown, 0.1 * sampled);
}

// This pixel has no neighbours on its surface, and only one in many of its paths is bright: that the others agree
// proves nothing.
TEST(LayerFilter, CorrectionLeavesAPixelAlone) {
    FilteredFilm film;
    for (int i = 0; i < 64; ++i)
        forEachPixel([&](int x, int y) {
            const bool alone = x == 35 && y == 40;
            const Rgb albedo = Scene::albedo(x, y);
            film.add(x, y, i, albedo * Scene::light(x) * (alone ? 0.1f + 0.01f * float(i % 7) : 1.f), albedo,
                     Vec3(float(x), float(y), alone ? 100.f : 0.f), Vec3(0, 0, 1));
        });
    Image image = layer(1);
    film.correct(image);
    EXPECT_LT(relativeError(image), 1e-4);
}

// With one or two samples a pixel, the groups' means are known only from the averages around it.
TEST(LayerFilter, CorrectionGainsFromTheFirstSamplesOn) {
    for (const int samples : {1, 2, 3}) {
        Image image = layer(0.7f);
        traced(samples).correct(image);
        EXPECT_LT(relativeError(image), 0.15) << samples;
    }
    Image image = layer(0.7f);
    FilteredFilm film = traced(1);
    film.samples = FilmLayer(kRegion, film.samples.spec());
    film.correct(image);
    EXPECT_EQ(image.data(), layer(0.7f).data());
}

TEST(LayerFilter, CorrectionMakesNoBlotchOfOneBrightPathAmongFew) {
    Image image = layer(1);
    FilteredFilm film = traced(1);
    film.samples.add(20, 35, 0, Rgb(1e5f), 1);
    film.correct(image);
    EXPECT_LT(relativeError(image), 0.1);
}

TEST(LayerFilter, SmoothsNoiseButNeitherEdgesNorTextures) {
    const FilteredFilm film = traced(64);
    EXPECT_GT(relativeError(film.samples.image()), 0.09);
    EXPECT_LT(relativeError(film.smooth()), 0.02);
}

// The mean of a single picture changes by about half a per cent, in either direction.
TEST(LayerFilter, SmoothingKeepsTheMean) {
    double before = 0, after = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const FilteredFilm film = traced(16, 0, seed);
        const Image raw = film.samples.image(), smooth = film.smooth();
        for (size_t i = 0; i < raw.data().size(); ++i) before += raw.data()[i], after += smooth.data()[i];
    }
    EXPECT_NEAR(after / before, 1, 0.004);
}

// A bar of shadow two pixels wide on a sunlit floor, of which the G-buffer shows nothing.
TEST(LayerFilter, SmoothingLeavesNoLightInNarrowShadows) {
    std::mt19937 rng(1);
    std::exponential_distribution<float> noise(1);
    const auto shaded = [](int x) { return x == 34 || x == 35; };
    const FilteredFilm film = floorUnder(32, [&](int x, int, int) { return (shaded(x) ? 0.02f : 1.f) * noise(rng); });
    const Image smooth = film.smooth();
    double shadow = 0, sun = 0;
    for (int y = 0; y < smooth.height(); ++y) {
        for (const int x : {34, 35}) shadow += smooth.rgb(x - kRegion.x0, y).y / (2 * smooth.height());
        for (const int x : {33, 36}) sun += smooth.rgb(x - kRegion.x0, y).y / (2 * smooth.height());
    }
    RecordProperty("shadow", std::to_string(shadow));
    RecordProperty("sun", std::to_string(sun));
    EXPECT_NEAR(shadow, 0.02, 0.004);
    EXPECT_NEAR(sun, 1, 0.1);
}

// The same as for corrections.
TEST(LayerFilter, SmoothingMakesNoDotOfTwoBrightPaths) {
    const Image truth = layer(1);
    FilteredFilm film = traced(16);
    for (const int group : {0, 1}) film.samples.add(20, 35, group, Rgb(50), 1);
    const double sampled = film.samples.mean(20, 35).y / truth.rgb(10, 15).y - 1;
    const double shown = film.smooth().rgb(10, 15).y / truth.rgb(10, 15).y - 1;
    RecordProperty("share", std::to_string(shown / sampled));
    EXPECT_GT(sampled, 3);
    EXPECT_LT(shown, 0.1 * sampled);
}

TEST(LayerFilter, SmoothingLeavesWhatHasNoNoise) {
    const Image truth = layer(1);
    FilteredFilm film;
    for (int i = 0; i < 4; ++i)
        forEachPixel([&](int x, int y) {
            film.add(x, y, i, truth.rgb(x - kRegion.x0, y - kRegion.y0), Rgb(0.5f), Vec3(float(x), float(y), 0),
                     Vec3(0, 0, 1));
        });
    EXPECT_LT(relativeError(film.smooth()), 1e-5);
}

TEST(LayerFilter, SmoothingKeepsTheEdgeOfAShadow) {
    std::mt19937 rng(2);
    std::normal_distribution<float> noise(0, 0.2f);
    const auto truth = [](int x) { return x < 31 ? 0.1f : 1.f; };
    const Image smooth = floorUnder(16, [&](int x, int, int) { return truth(x) + noise(rng); }).smooth();
    double error = 0, atEdge = 0;
    forEachPixel([&](int x, int y) {
        const double e = std::abs(double(smooth.rgb(x - kRegion.x0, y - kRegion.y0).y) - truth(x));
        error += e / double(kRegion.count());
        if (x == 30 || x == 31) atEdge += e / (2 * kRegion.height());
    });
    EXPECT_LT(error, 0.02);  // of the samples' mean: 0.04
    EXPECT_LT(atEdge, 0.05);
}

// Four samples that differ much, but whose mean is exact, as stratified samples may be: the variance between the groups
// overestimates the noise, and would hide most of the faint stripes.
TEST(LayerFilter, SmoothingKeepsDetailsThatGroupsTogetherKnow) {
    const auto truth = [](int x) { return 1 + 0.05f * std::sin(float(x)); };
    const auto light = [&](int x, int y, int i) {
        return truth(x) + std::array{-0.6f, -0.2f, 0.2f, 0.6f}[size_t(i + 3 * x + 5 * y) % 4];
    };
    const Image smooth = floorUnder(4, light).smooth();
    double error = 0, difference = 0;
    forEachPixel([&](int x, int y) {
        error += std::abs(smooth.rgb(x - kRegion.x0, y - kRegion.y0).y - truth(x));
        difference += std::abs(truth(x) - 1);
    });
    RecordProperty("error", std::to_string(error / difference));
    EXPECT_LT(error, 0.5 * difference);  // if the groups are believed: 0.8
}

// A floor of which one half has none of the layer's lobes: light from the other half must not spread there.
TEST(LayerFilter, SmoothingGivesNothingToWhatDoesNotScatter) {
    FilteredFilm film;
    for (int i = 0; i < 4; ++i)
        forEachPixel([&](int x, int y) {
            const bool black = x < 30;
            film.add(x, y, i, Rgb(black ? 0.f : float(1 + (i + x) % 3)), Rgb(black ? 0.f : 0.5f),
                     Vec3(float(x), float(y), 0), Vec3(0, 0, 1));
        });
    const Image smooth = film.smooth();
    forEachPixel([&](int x, int y) {
        const float v = smooth.rgb(x - kRegion.x0, y - kRegion.y0).y;
        EXPECT_EQ(v > 0, x >= 30) << x << " " << y;
    });
}

// In a column of pixels every other sample meets a lamp or the sky. The other samples tell which surface it is, and the
// column is averaged along that.
TEST(LayerFilter, SmoothsPixelsThatShowTheirSurfaceInPart) {
    for (const bool sky : {false, true}) {
        FilteredFilm film;
        std::mt19937 rng(4);
        std::exponential_distribution<float> noise(1);
        for (int i = 0; i < 64; ++i)
            forEachPixel([&](int x, int y) {
                const float light = noise(rng);
                if (x == 35 && (i / LayerFilter::kGroups) % 2) {
                    if (sky)
                        film.addNothing(x, y, i);
                    else
                        film.add(x, y, i, Rgb(0.f), Rgb(0.f), Vec3(float(x), float(y), 90), Vec3(1, 0, 0));
                } else {
                    film.add(x, y, i, Rgb(0.5f * light), Rgb(0.5f), Vec3(float(x), float(y), 40), Vec3(0, 0, 1));
                }
            });
        const auto errorAtEdge = [](const Image& image) {
            double sum = 0;
            for (int y = 0; y < kRegion.height(); ++y) sum += std::abs(image.rgb(35 - kRegion.x0, y).y / 0.25 - 1);
            return sum / kRegion.height();
        };
        EXPECT_GT(errorAtEdge(film.samples.image()), 0.1);
        RecordProperty(sky ? "sky" : "lamp", std::to_string(errorAtEdge(film.smooth())));
        EXPECT_LT(errorAtEdge(film.smooth()), 0.01) << sky;
    }
}

// A noisy floor of light 1 with a column of edge pixels, which have no neighbours on their own surface. One of them has
// the given multiple of the light, sample by sample.
template <typename F>
FilteredFilm edgeOnFloor(int samples, unsigned seed, F&& light) {
    FilteredFilm film;
    std::mt19937 rng(seed);
    std::exponential_distribution<float> noise(1);
    for (int i = 0; i < samples; ++i)
        forEachPixel([&](int x, int y) {
            const Rgb albedo(x == 35 ? 0.8f : 0.4f);
            film.add(x, y, i, albedo * (noise(rng) * (x == 35 && y == 40 ? light(i) : 1.f)), albedo,
                     Vec3(float(x), float(y), x == 35 ? float(100 * y) : 0.f), Vec3(0, 0, 1));
        });
    return film;
}

// The dot becomes less bright, and no light is lost.
TEST(LayerFilter, EdgesShareADotOfOneBrightPath) {
    constexpr int kFilms = 12;
    double before = 0, after = 0, sampled = 0, shown = 0;
    for (unsigned seed = 1; seed <= kFilms; ++seed) {
        const FilteredFilm film = edgeOnFloor(64, seed, [](int i) { return i == 5 ? 300.f : 1.f; });
        const Image raw = film.samples.image(), smooth = film.smooth();
        for (int y = 0; y < raw.height(); ++y) {
            before += raw.rgb(25, y).y;
            after += smooth.rgb(25, y).y;
        }
        sampled += raw.rgb(25, 20).y / 0.8 - 1;
        shown += smooth.rgb(25, 20).y / 0.8 - 1;
    }
    RecordProperty("share", std::to_string(shown / sampled));
    RecordProperty("kept", std::to_string(after / before));
    EXPECT_GT(sampled / kFilms, 2);
    EXPECT_LT(shown / sampled, 0.6);
    EXPECT_NEAR(after / before, 1, 0.02);
}

TEST(LayerFilter, EdgesAreAveragedAlongThemselves) {
    const FilteredFilm film = edgeOnFloor(64, 1, [](int) { return 1.f; });
    const auto error = [](const Image& image) {
        double sum = 0;
        for (int y = 0; y < image.height(); ++y) sum += std::abs(image.rgb(25, y).y / 0.8 - 1) / image.height();
        return sum;
    };
    RecordProperty("error", std::to_string(error(film.smooth())));
    EXPECT_LT(error(film.smooth()), 0.85 * error(film.samples.image()));
}

TEST(LayerFilter, EdgesKeepWhatAllOfTheirSamplesShow) {
    const Image smooth = edgeOnFloor(256, 1, [](int) { return 5.f; }).smooth();
    RecordProperty("bright", std::to_string(smooth.rgb(25, 20).y / 0.8));
    EXPECT_NEAR(smooth.rgb(25, 20).y / 0.8, 5, 0.5);
    EXPECT_NEAR(smooth.rgb(25, 21).y / 0.8, 1, 0.1);
}

// Edge pixels have no surface to be averaged along, but each other: the maps' error all along the edge is known from
// the samples of a pixel's neighbours there, and the floor on either side does not count.
TEST(LayerFilter, CorrectionRemovesAnErrorAllAlongAnEdge) {
    std::mt19937 rng(5);
    std::exponential_distribution<float> noise(1);
    FilteredFilm film;
    for (int i = 0; i < 256; ++i)
        forEachPixel([&](int x, int y) {
            const Rgb albedo(x == 35 ? 0.8f : 0.4f);
            film.add(x, y, i, albedo * noise(rng), albedo, Vec3(float(x), float(y), x == 35 ? float(100 * y) : 0.f),
                     Vec3(0, 0, 1));
        });
    Image image(kRegion.width(), kRegion.height());
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) image.setRgb(x, y, x == 25 ? Rgb(2 * 0.8f) : Rgb(0.4f));
    film.correct(image);
    double atEdge = 0, beside = 0;
    for (int y = 0; y < image.height(); ++y) {
        atEdge += image.rgb(25, y).y / 0.8 / image.height();
        for (const int x : {24, 26}) beside += image.rgb(x, y).y / 0.4 / (2 * image.height());
    }
    RecordProperty("edge", std::to_string(atEdge));
    EXPECT_LT(atEdge, 1.2);  // of an error of 1 before
    EXPECT_GT(atEdge, 0.95);
    EXPECT_NEAR(beside, 1, 0.01);
}

TEST(LayerFilter, SmoothsFromTheFirstSampleOn) {
    for (const int samples : {1, 2, 3}) {
        const FilteredFilm film = traced(samples);
        EXPECT_GT(relativeError(film.samples.image()), 0.35) << samples;
        EXPECT_LT(relativeError(film.smooth()), 0.1) << samples;
    }
}

TEST(LayerFilter, SmoothingOfTheFirstSamplesKeepsTheMean) {
    const FilteredFilm film = floorUnder(1, [](int x, int y, int) { return (x * 7 + y * 13) % 5 == 0 ? 5.f : 0.f; });
    double sum = 0;
    const Image smooth = film.smooth();
    for (const float v : smooth.data()) sum += v;
    EXPECT_NEAR(sum / double(smooth.data().size()), 1, 0.02);
}

// A group without samples at a pixel and around it is left out.
TEST(LayerFilter, GroupsWithoutSamplesDoNotDarken) {
    FilteredFilm film = floorUnder(1, [](int, int, int) { return 2.f; });
    film.samples = FilmLayer(kRegion, film.samples.spec());
    forEachPixel([&](int x, int y) { film.samples.add(x, y, 1 + x % 2, Rgb(2.f), 1); });
    const Image smooth = film.smooth();
    for (const float v : smooth.data()) EXPECT_NEAR(v, 2, 1e-4);
}

}  // namespace
}  // namespace drc
