#include "view/tev_picture.h"

#include <gmock/gmock.h>

namespace drc::tev {
namespace {

using testing::ElementsAre;

// Two layers of the region [3, 6) x [2, 4): in each value the column, the row and the channel can be read.
Picture numbered() {
    Picture picture{{{"", Image(3, 2)}, {"depth", Image(3, 2, {"Z"})}}, {3, 2, 6, 4}, {10, 5}};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) {
            const float place = float(100 * (x + 3) + 10 * (y + 2));
            for (int c = 0; c < 3; ++c) picture.layers[0].image.at(x, y, c) = place + float(c);
            picture.layers[1].image.at(x, y, 0) = place + 9;
        }
    return picture;
}

TEST(TevPicture, HasTheValuesOfAPixelTogether) {
    const Picture picture = numbered();
    EXPECT_THAT(channelNames(picture), ElementsAre("R", "G", "B", "depth.Z"));
    EXPECT_THAT(channelNames(picture.layers[1]), ElementsAre("depth.Z"));
    EXPECT_THAT(valuesOf(picture, picture.layers[0], {4, 2, 6, 3}), ElementsAre(420, 421, 422, 520, 521, 522));
    EXPECT_THAT(valuesOf(picture, picture.layers[0], {5, 2, 6, 4}), ElementsAre(520, 521, 522, 530, 531, 532));
    EXPECT_THAT(valuesOf(picture, picture.layers[1], {5, 2, 6, 4}), ElementsAre(529, 539));
}

TEST(TevPicture, TilesCoverEachPixelOnce) {
    for (const PixelRegion& region : {PixelRegion{0, 0, 1, 1}, {5, 7, 300, 200}, {128, 0, 384, 128}}) {
        std::vector<int> times(region.count());
        for (const PixelRegion& tile : tilesOf(region)) {
            EXPECT_LE(tile.width(), 128);
            EXPECT_LE(tile.height(), 128);
            for (int y = tile.y0; y < tile.y1; ++y)
                for (int x = tile.x0; x < tile.x1; ++x) ++times[region.index(x, y)];
        }
        EXPECT_THAT(times, testing::Each(1));
    }
    EXPECT_EQ(tilesOf({0, 0, 256, 129}).size(), 4u);
}

TEST(TevPicture, HasTheLayersThatThereAre) {
    RenderSettings settings;
    settings.film = {4, 3};
    LayeredPicture picture;
    picture.film = std::make_shared<Film>(settings, std::vector<FilmLayerSpec>{{.name = "light"}});
    const auto light = [](float value) {
        Image image(4, 3);
        std::ranges::fill(image.data(), value);
        return image;
    };
    picture.layers = {
        {"a", "direct", light(1), light(.5f)}, {"b", "direct", light(2), {}}, {"c", "indirect", light(4), {}}};
    picture.compose();
    EXPECT_THAT(
        channelNames(pictureOf(picture, settings.film)),
        ElementsAre("R", "G", "B", "direct.R", "direct.G", "direct.B", "indirect.R", "indirect.G", "indirect.B"));
    picture.samples = Image(4, 3, {"X"});
    picture.gBuffer = {light(0), Image(4, 3, {"X", "Y", "Z"}), Image(4, 3, {"Z"})};
    for (PictureLayer& layer : picture.layers) layer.part.clear();
    const Picture shown = pictureOf(picture, settings.film);
    EXPECT_THAT(channelNames(shown),
                ElementsAre("R", "G", "B", "variance.R", "variance.G", "variance.B", "samples.X", "albedo.R",
                            "albedo.G", "albedo.B", "normal.X", "normal.Y", "normal.Z", "depth.Z"));
    EXPECT_THAT(valuesOf(shown, shown.layers[0], {3, 2, 4, 3}), ElementsAre(7, 7, 7));
    EXPECT_THAT(valuesOf(shown, shown.layers[1], {3, 2, 4, 3}), ElementsAre(.5f, .5f, .5f));
}

TEST(TevPicture, APreviewIsBeautyAndSamples) {
    Preview preview{Image(2, 1), {}, Image(2, 1, {"X"})};
    preview.beauty.setRgb(1, 0, {3, 4, 5});
    preview.samples.at(1, 0, 0) = 6;
    const PixelRegion region{7, 2, 9, 3};
    Picture shown = pictureOf(preview, region, {20, 10});
    EXPECT_EQ(shown.region, region);
    EXPECT_THAT(channelNames(shown), ElementsAre("R", "G", "B", "samples.X"));
    EXPECT_THAT(valuesOf(shown, shown.layers[0], {8, 2, 9, 3}), ElementsAre(3, 4, 5));
    EXPECT_THAT(valuesOf(shown, shown.layers[1], {8, 2, 9, 3}), ElementsAre(6));
    preview.alpha = Image(2, 1, {"A"});
    preview.alpha->at(1, 0, 0) = .5f;
    shown = pictureOf(preview, region, {20, 10});
    EXPECT_THAT(channelNames(shown), ElementsAre("R", "G", "B", "A", "samples.X"));
    EXPECT_THAT(valuesOf(shown, shown.layers[0], {8, 2, 9, 3}), ElementsAre(3, 4, 5, .5f));
}

}  // namespace
}  // namespace drc::tev
