// Paths of final gather through a cache whose answers are known, against those of the path tracer.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "math/rank_statistics.h"
#include "pbrt/scene_file.h"
#include "render/session.h"
#include "scene/chi_square.h"
#include "test_scenes.h"
#include "transport/camera_sample.h"
#include "transport/final_gather.h"
#include "transport/path_tracer.h"

namespace drc {
namespace {

// A cache that has the same answer everywhere, or none, and remembers where it was asked.
struct TestCache final : RadianceCache {
    bool accepts(const CachePoint& at) const override { return at.reach >= leastReach; }
    void prefetch(const CachePoint&) const override {}
    bool lookUp(const CachePoint& at, CacheAnswer& answer) const override {
        EXPECT_TRUE(accepts(at));
        EXPECT_NEAR(lengthSquared(at.n), 1, 1e-4);
        asked.push_back(at);
        answer = {Rgb(value), training};
        return knows;
    }
    float leastReach = 0;
    bool knows = true;
    float value = 1, training = 0;
    mutable std::vector<CachePoint> asked;
};

// The mean of many camera samples, its standard error, and what they deposited.
struct Gathered {
    Rgb mean{0.f}, error{0.f};
    std::vector<CacheDeposit> deposits;
    FinalGather::Counts counts;
    std::vector<Rgb> samples;
};

class Traced {
  public:
    explicit Traced(const std::string& text, int maxDepth = 64)
        : scene_(pbrt::loadPbrtString(text)),
          accel_(*scene_),
          lights_(*scene_),
          tracer_(*scene_, accel_, lights_, settings(maxDepth)),
          gather_(tracer_.lighting(), settings(maxDepth)) {}

    // weight: of deposits, which are added to the radiance. training: FinalGather::Sample::training.
    Gathered gather(const RadianceCache& cache, int spp, uint64_t seed = 1, float weight = 0,
                    float training = 1) const {
        Gathered g;
        sampled(g, spp, seed, [&](CameraSample& s, uint64_t number) {
            size_t i = g.deposits.size();
            FinalGather::Sample sample{.sampler = s.sampler,
                                       .cache = cache,
                                       .training = training,
                                       .seed = hash(seed, number),
                                       .deposits = g.deposits,
                                       .counts = g.counts};
            Rgb light = gather_.radiance(s.camera.ray, sample);
            for (; weight > 0 && i < g.deposits.size(); ++i) light += g.deposits[i].light * weight;
            return light;
        });
        return g;
    }
    Gathered paths(int spp, uint64_t seed = 1) const {
        Gathered g;
        sampled(g, spp, seed, [&](CameraSample& s, uint64_t) { return tracer_.radiance(s.camera.ray, s.sampler); });
        return g;
    }

  private:
    static PathSettings settings(int maxDepth) {
        PathSettings settings;
        settings.maxDepth = maxDepth;
        return settings;
    }
    template <class F>
    void sampled(Gathered& g, int spp, uint64_t seed, const F& radiance) const {
        const PixelRegion region = scene_->sensor.settings.region();
        for (int y = region.y0; y < region.y1; ++y)
            for (int x = region.x0; x < region.x1; ++x)
                for (int i = 0; i < spp; ++i) {
                    CameraSample s = cameraSample(scene_->sensor, x, y, pixelStream(seed, 1, x, y), uint32_t(i));
                    g.samples.push_back(radiance(s, region.index(x, y) * size_t(spp) + size_t(i)));
                }
        const double n = double(g.samples.size());
        for (int c = 0; c < 3; ++c) {
            double sum = 0, squares = 0;
            for (const Rgb& v : g.samples) sum += double(v[c]);
            for (const Rgb& v : g.samples) squares += (double(v[c]) - sum / n) * (double(v[c]) - sum / n);
            g.mean[c] = float(sum / n);
            g.error[c] = float(std::sqrt(squares) / n);
        }
    }

    std::unique_ptr<Scene> scene_;
    Accel accel_;
    LightSampler lights_;
    PathTracer tracer_;
    FinalGather gather_;
};

std::string plastic() { return test::allMaterials()[2].second; }

// A floor of albedo 0.6, which fills the picture, in a box of `material`, open at the top, with a lamp.
std::string boxOnFloor(const std::string& material) {
    return "LookAt 0 0 1  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 60\n"
           "Film \"image\" \"integer xresolution\" 12 \"integer yresolution\" 8\nWorldBegin\n"
           "LightSource \"infinite\" \"rgb L\" [0.5 0.5 0.5]\n"
           "Material \"matte\" \"rgb Kd\" [0.6 0.6 0.6]\n" +
           test::quad("-2 -2 0", "2 -2 0", "2 2 0", "-2 2 0") + material + "\n" +
           test::quad("-2 2 0", "2 2 0", "2 2 2", "-2 2 2") + test::quad("-2 -2 0", "-2 -2 2", "2 -2 2", "2 -2 0") +
           test::quad("-2 -2 0", "-2 2 0", "-2 2 2", "-2 -2 2") + test::quad("2 -2 0", "2 -2 2", "2 2 2", "2 2 0") +
           "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [6 5 4]\n" +
           test::quad("-1 -1 2", "-1 1 2", "1 1 2", "1 -1 2") + "AttributeEnd\nWorldEnd\n";
}

// The greatest relative difference; zero is rounded to zero.
float difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    if (a.size() != b.size()) return kInfinity;
    float most = 0;
    for (size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a[i][c] - b[i][c]) / (std::abs(b[i][c]) + 1e-20f));
    return most;
}

// With the same random numbers; only the order of multiplications is another one.
TEST(FinalGather, WithoutAnswersItIsThePathTracer) {
    for (const auto& [name, material] : test::allMaterials())
        for (const int maxDepth : {3, 64}) {
            const Traced traced(test::room(material, 16, 12), maxDepth);
            const std::vector<Rgb> expected = traced.paths(8).samples;
            TestCache none;
            none.leastReach = kInfinity;
            const Gathered refused = traced.gather(none, 8);
            EXPECT_LT(difference(refused.samples, expected), 1e-5f) << name;
            EXPECT_TRUE(none.asked.empty());
            EXPECT_TRUE(refused.deposits.empty());
            EXPECT_GT(refused.counts.refused, 100);
            // Nor does it change the picture that paths find something out on their way.
            TestCache ignorant;
            ignorant.leastReach = 0.2f;
            ignorant.knows = false;
            ignorant.training = 1;
            const Gathered unanswered = traced.gather(ignorant, 8);
            EXPECT_LT(difference(unanswered.samples, expected), 1e-5f) << name;
            EXPECT_GT(unanswered.deposits.size(), 100u);
            EXPECT_EQ(unanswered.counts.asked, int64_t(ignorant.asked.size()));
            EXPECT_EQ(unanswered.counts.answered, 0);
        }
}

// Pearson's test of homogeneity, over bins of positions and reaches, of two samples that are independent.
double samePlaces(const std::vector<CachePoint>& a, const std::vector<CachePoint>& b) {
    std::map<int, std::pair<double, double>> bins;
    const auto binOf = [](const CachePoint& at) {
        const auto part = [](float v, float low, float high, int n) {
            return std::clamp(int((v - low) / (high - low) * float(n)), 0, n - 1);
        };
        return part(at.p.x, -2, 2, 4) + 4 * (part(at.p.y, -2, 2, 4) + 4 * part(at.p.z, 0, 3, 6)) +
               96 * (part(at.reach, 0, 6, 12) + 12 * (at.n.z > 0.5f));
    };
    for (const CachePoint& at : a) bins[binOf(at)].first += 1;
    for (const CachePoint& at : b) bins[binOf(at)].second += 1;
    const double all = double(a.size() + b.size());
    double statistic = 0;
    int used = 0;
    for (const auto& [bin, counts] : bins) {
        const double both = counts.first + counts.second;
        const double expectedA = both * double(a.size()) / all, expectedB = both * double(b.size()) / all;
        if (std::min(expectedA, expectedB) < 10) continue;
        statistic += sqr(counts.first - expectedA) / expectedA + sqr(counts.second - expectedB) / expectedB;
        ++used;
    }
    EXPECT_GT(used, 50);
    return chiSquareUpperTail(statistic, used - 1);
}

std::vector<CachePoint> placesOf(const std::vector<CacheDeposit>& deposits) {
    std::vector<CachePoint> places;
    for (const CacheDeposit& d : deposits) places.push_back(d.at);
    return places;
}

// If deposits came from other points than look-ups, cells near corners, for example, would know the light of the
// middle of the room.
TEST(FinalGather, DepositsAreMadeWhereLookUpsAre) {
    // Paths so short that the second vertex alone asks; and on their way on, no vertex makes deposits that would not.
    const Traced traced(test::room(plastic(), 16, 12), 8);
    TestCache cache;
    cache.leastReach = 2.5f;
    cache.training = 0.3f;
    const Gathered looked = traced.gather(cache, 150, 1), trained = traced.gather(cache, 500, 2);
    ASSERT_GT(looked.deposits.size(), 1000u);
    for (const CacheDeposit& d : trained.deposits) ASSERT_TRUE(cache.accepts(d.at));
    const size_t first = size_t(looked.counts.asked);
    const std::vector<CachePoint> places(cache.asked.begin(), cache.asked.begin() + std::ptrdiff_t(first));
    EXPECT_GT(samePlaces(places, placesOf(trained.deposits)), test::kChiSquareLevel);
    EXPECT_NEAR(double(trained.deposits.size()) / double(trained.counts.asked), 0.3, 0.01);
    // Of pixels with many camera samples, each as seldom as it has less weight in the picture.
    const Gathered seldom = traced.gather(cache, 500, 4, 0, 0.25f);
    EXPECT_GT(samePlaces(places, placesOf(seldom.deposits)), test::kChiSquareLevel);
    EXPECT_NEAR(double(seldom.deposits.size()) / double(seldom.counts.asked), 0.3 / 4, 0.003);
    // The test can tell: points of a smaller reach are others.
    cache.leastReach = 1.5f;
    EXPECT_LT(samePlaces(places, placesOf(traced.gather(cache, 300, 3).deposits)), 1e-6);
}

// Where all light is 1, so is what a path sees of it, whatever lobes are answered for and whether the path trains.
TEST(FinalGather, ATrueAnswerKeepsTheFurnaceWhite) {
    const std::pair<const char*, const char*> materials[] = {
        {"matte", R"(Material "matte" "rgb Kd" [0.5 0.5 0.5])"},
        {"mirror and matte", R"(MakeNamedMaterial "a" "string type" "mirror" "rgb Kr" [0.4 0.4 0.4]
            MakeNamedMaterial "b" "string type" "matte" "rgb Kd" [0.6 0.6 0.6]
            Material "mix" "string namedmaterial1" "a" "string namedmaterial2" "b" "rgb amount" [0.5 0.5 0.5])"},
        {"uber", R"(Material "uber" "rgb Kd" [0.375 0.375 0.375] "rgb Ks" [0 0 0] "rgb opacity" [0.8 0.8 0.8])"}};
    for (const auto& [name, material] : materials)
        for (const float training : {0.f, 0.25f, 1.f}) {
            // Of the walls, too, where they let no light out.
            std::string text = test::furnace(0.5f, 12, 8);
            const std::string walls = R"(Material "matte" "rgb Kd" [0.500000 0.500000 0.500000])";
            ASSERT_NE(text.find(walls), std::string::npos);
            if (std::string(name) != "uber") text = test::respelt(text, walls, material);
            const std::string ball = std::string(material) + "\nShape \"sphere\"";
            const Traced traced(test::respelt(text, "Shape \"sphere\"", ball));
            TestCache cache;
            cache.leastReach = 0.2f;
            cache.training = training;
            const Gathered g = traced.gather(cache, 400);
            EXPECT_GT(g.counts.answered, 20'000);
            EXPECT_EQ(g.deposits.empty(), training == 0);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(g.mean[c], 1, 4.5f * g.error[c] + 1e-4f) << name << training;
                EXPECT_LT(g.error[c], 0.004f);
            }
            // What is found out is the same truth.
            double light = 0, factor = 0, squares = 0;
            for (const CacheDeposit& d : g.deposits) {
                light += double(d.light.x);
                factor += double(d.viewFactor.x);
                squares += sqr(double(d.light.x - d.viewFactor.x));
            }
            if (g.deposits.empty()) continue;
            EXPECT_NEAR(light / factor, 1, 4.5 * std::sqrt(squares) / factor) << name << training;
            EXPECT_LT(std::sqrt(squares) / factor, 0.03);
        }
}

// A path that trains is sampled otherwise, but shows the same picture, also where the answer is for a part of the lobes
// only.
TEST(FinalGather, TrainingDoesNotChangeThePicture) {
    for (const auto& [name, material] : test::allMaterials()) {
        // All of the room.
        const Traced traced(
            test::respelt(test::room(material, 12, 8), "Material \"matte\" \"rgb Kd\" [0.6 0.6 0.6]", material));
        TestCache cache;
        cache.leastReach = 0.5f;
        cache.value = 2;
        const Gathered plain = traced.gather(cache, 150, 1);
        cache.training = 1;
        const Gathered training = traced.gather(cache, 150, 2);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(training.mean[c], plain.mean[c], 4.5f * std::hypot(training.error[c], plain.error[c])) << name;
    }
}

// What an answer stands for is what deposits are samples of: with a cache whose answer is black, the light that paths
// lose is that of the deposits, times the albedo of the floor that the camera sees. Also where the answer is for a
// part of the lobes, and with paths of few vertices.
TEST(FinalGather, DepositsAreTheLightThatAnswersStandFor) {
    for (const auto& [name, material] : test::allMaterials()) {
        // Those without specular lobes: behind a mirror, the weight is another one.
        if (std::ranges::count(std::vector<std::string>{"matte", "oren_nayar", "plastic", "smooth_plastic", "substrate",
                                                        "translucent", "disney"},
                               name) == 0)
            continue;
        for (const int maxDepth : {2, 3, 10}) {
            const Traced traced(boxOnFloor(material), maxDepth);
            TestCache black;
            black.leastReach = 0.5f;
            black.value = 0;
            black.training = 1;
            const Gathered both = traced.gather(black, 150, 1, 0.6f), paths = traced.paths(150, 2);
            EXPECT_GT(both.deposits.size(), 1000u);
            for (int c = 0; c < 3; ++c) {
                const float error = std::hypot(both.error[c], paths.error[c]);
                EXPECT_NEAR(both.mean[c], paths.mean[c], 4.5f * error) << name << maxDepth;
            }
            // Without the deposits, the test would tell.
            EXPECT_LT(traced.gather(black, 150).mean.x, paths.mean.x - 6 * paths.error.x) << name << maxDepth;
        }
    }
}

// What a pass has deposited is gone once it is committed, and the table of cells is bounded (radiance_cells_test.cpp).
TEST(Invariant5, MemoryDoesNotGrowWithPassesOfFinalGather) {
    const auto scene = pbrt::loadPbrtString(test::room(plastic(), 48, 32));
    RenderParams params;
    params.integrator = "drc";
    params.spp = 256;
    Stats stats;
    Session session(*scene, params, &stats);
    while (session.samplesDone() < 64) session.step();
    const size_t before = mallinfo2().uordblks;
    const int64_t cells = stats.count("cells/bytes");
    while (session.step()) {
    }
    EXPECT_EQ(session.samplesDone(), 256);
    // A pass deposits more than that.
    EXPECT_LT(double(mallinfo2().uordblks), double(before) + 64 * 1024);
    EXPECT_EQ(stats.count("cells/bytes"), cells);
}

}  // namespace
}  // namespace drc
