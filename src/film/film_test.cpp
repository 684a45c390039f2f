#include "film/film.h"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>
#include <thread>

#include "base/atomic_file.h"
#include "base/folder_testing.h"
#include "film/film_testing.h"
#include "film/sample_pass.h"

namespace drc {
namespace {

using testing::HasSubstr;

constexpr PixelRegion kRegion{10, 20, 26, 32};

std::vector<FilmLayerSpec> layers() {
    return {{.name = "exact", .groups = 2},
            {.name = "single", .storage = FilmLayerSpec::Storage::Single},
            {.name = "splats", .weighted = false}};
}

// Adds a sample that differs from that of any other number.
void sample(Film& film, int number) {
    for (int y = kRegion.y0; y < kRegion.y1; ++y) {
        const auto lock = film.lockRow(y);
        for (int x = kRegion.x0; x < kRegion.x1; ++x) {
            film.layer("exact").add(x, y, number % 2, Rgb(float(x), 0.1f * float(y), float(number)), 1);
            film.layer("single").add(x, y, 0, Rgb(float(number)), 1);
            film.layer(2).splat(x, y, Rgb(0.25f));
        }
        film.setRowPasses(y, SamplePass::passesFor(SamplePass::wholeSamples(film.rowPasses(y)) + 1));
    }
}

bool sameBits(const Film& a, const Film& b) {
    for (size_t i = 0; i < a.layerCount(); ++i)
        for (int y = a.region().y0; y < a.region().y1; ++y)
            if (!std::ranges::equal(a.layer(i).row(y), b.layer(i).row(y))) return false;
    return a.passes() == b.passes() && a.mapPasses() == b.mapPasses();
}

struct TestFilm : Film {
    TestFilm() : Film(test::filmSettings(kRegion), layers()) {}
};

TEST(Film, LayersHaveNames) {
    TestFilm film;
    EXPECT_TRUE(film.has("single"));
    EXPECT_FALSE(film.has("double"));
    EXPECT_EQ(&film.layer("splats"), &film.layer(2));
    EXPECT_THROW(film.layer("double"), std::out_of_range);
    EXPECT_EQ(film.bytesPerPixel(), 2 * 40 + 20 + 24);
}

TEST(Film, SumsInAnyOrderAreTheFilmOfAllSamples) {
    TestFilm all, a, b, c;
    for (int i = 0; i < 6; ++i) sample(all, i);
    for (const int i : {0, 1}) sample(a, i);
    for (const int i : {2, 5}) sample(b, i);
    for (const int i : {4, 3}) sample(c, i);
    a.add(c);
    b.add(a);
    EXPECT_TRUE(sameBits(all, b));
    EXPECT_FALSE(sameBits(all, a));
    b.clear();
    EXPECT_TRUE(sameBits(b, TestFilm()));
}

TEST(Film, OnlyFilmsOfOneKindAddUp) {
    TestFilm film;
    Film other(test::filmSettings(kRegion), {{.name = "exact", .groups = 2}});
    EXPECT_THROW(film.add(other), Error);
    Film smaller(test::filmSettings({10, 20, 26, 31}), layers());
    EXPECT_THROW(film.add(smaller), Error);
}

TEST(Film, SnapshotsOfAPartHaveItsPixels) {
    TestFilm film;
    sample(film, 3);
    const PixelRegion part{12, 25, 15, 27};
    const auto snapshot = film.snapshot(part);
    EXPECT_EQ(snapshot->region(), part);
    EXPECT_EQ(snapshot->layer(0).mean(14, 26), film.layer(0).mean(14, 26));
    EXPECT_EQ(snapshot->layer("splats").sum(12, 25, 1), 0.25);
    sample(film, 4);
    EXPECT_EQ(snapshot->layer("single").mean(12, 25), Rgb(3.f));
}

// Every row of a snapshot has either all samples of a pass or none of them.
TEST(Film, SnapshotsAreSafeBesideSamples) {
    TestFilm film;
    std::atomic<bool> done{false};
    std::jthread writer([&] {
        for (int i = 0; i < 300; ++i) sample(film, 0);
        done = true;
    });
    int torn = 0, snapshots = 0;
    while (!done || snapshots == 0) {
        const auto s = film.snapshot();
        ++snapshots;
        for (int y = kRegion.y0; y < kRegion.y1; ++y)
            for (int x = kRegion.x0; x < kRegion.x1; ++x) {
                const int samples = SamplePass::wholeSamples(s->rowPasses(y));
                torn += s->layer(0).expected(x, y) != samples || s->layer(0).sum(x, y, 0) != double(samples) * x;
            }
    }
    EXPECT_EQ(torn, 0);
}

class FilmFile : public FolderTest {};

TEST_F(FilmFile, ComesBackAsItWas) {
    TestFilm film, other;
    for (int i = 0; i < 3; ++i) sample(film, i);
    film.setMapPasses(7);
    film.save(path("a.film"), "scene");
    other.load(path("a.film"), "scene");
    EXPECT_TRUE(sameBits(film, other));
    // The loaded film continues as if it had never been saved.
    sample(film, 3);
    sample(other, 3);
    EXPECT_TRUE(sameBits(film, other));
}

TEST_F(FilmFile, OfSomethingElseIsRefusedAndChangesNothing) {
    TestFilm film;
    sample(film, 0);
    film.save(path("a.film"), "scene");
    TestFilm other;
    sample(other, 1);
    const auto before = other.snapshot();
    EXPECT_THAT(errorOf([&] { other.load(path("a.film"), "another"); }),
                HasSubstr("a.film: a drc film of another scene, other settings or another version"));
    Film smaller(test::filmSettings({10, 20, 26, 31}), layers());
    EXPECT_THAT(errorOf([&] { smaller.load(path("a.film"), "scene"); }), HasSubstr("another scene"));
    folder_.write("b.film", "P6 1 1");
    EXPECT_THAT(errorOf([&] { other.load(path("b.film"), "scene"); }), HasSubstr("b.film: not a drc film"));
    EXPECT_THAT(errorOf([&] { other.load(path("none.film"), "scene"); }), HasSubstr("none.film"));
    std::string bytes = readFile(path("a.film"));
    folder_.write("short.film", bytes.substr(0, bytes.size() - 5));
    EXPECT_THAT(errorOf([&] { other.load(path("short.film"), "scene"); }), HasSubstr("damaged"));
    for (const size_t at : {bytes.size() / 2, bytes.size() - 3, bytes.find('\n') + 1}) {
        std::string flipped = bytes;
        flipped[at] = char(flipped[at] ^ 0x10);
        folder_.write("flipped.film", flipped);
        EXPECT_THAT(errorOf([&] { other.load(path("flipped.film"), "scene"); }), HasSubstr("checksum")) << at;
    }
    EXPECT_TRUE(sameBits(*before, other));
}

}  // namespace
}  // namespace drc
