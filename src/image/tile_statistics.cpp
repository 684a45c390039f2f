#include "image/tile_statistics.h"

#include <algorithm>
#include <cmath>

namespace drc {
namespace {

struct Tile {
    double sum = 0;
    int count = 0;
};

class Tiles {
  public:
    Tiles(const Plane& values, int side)
        : nx_(across(values.width, side)), ny_(across(values.height, side)), tiles_(size_t(nx_) * size_t(ny_)) {
        for (int y = 0; y < values.height; ++y)
            for (int x = 0; x < values.width; ++x) {
                const float value = values.at(x, y);
                if (std::isnan(value)) continue;
                Tile& tile = tiles_[index(x * nx_ / values.width, y * ny_ / values.height)];
                tile.sum += value;
                ++tile.count;
            }
        for (const Tile& tile : tiles_) sum_ += tile.sum, count_ += tile.count;
    }

    double sum() const { return sum_; }
    double count() const { return count_; }

    // Variance of sum(), from the differences between neighbouring tiles.
    double variance() const {
        double variance = 0, weight = 0;
        for (int y = 0; y < ny_; ++y)
            for (int x = 0; x < nx_; ++x) {
                const Tile& tile = tiles_[index(x, y)];
                double ofValue = 0;
                int pairs = 0;
                for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
                    if (x + dx < 0 || x + dx >= nx_ || y + dy < 0 || y + dy >= ny_) continue;
                    const Tile& other = tiles_[index(x + dx, y + dy)];
                    if (tile.count == 0 || other.count == 0) continue;
                    // For independent values of variance v, Var(difference of means) = v (1 / n + 1 / m).
                    const double n = tile.count, m = other.count;
                    const double difference = tile.sum / n - other.sum / m;
                    ofValue += difference * difference * n * m / (n + m);
                    ++pairs;
                }
                if (pairs == 0) continue;
                variance += tile.count * ofValue / pairs;
                weight += tile.count;
            }
        return weight > 0 ? variance * count_ / weight : std::numeric_limits<double>::quiet_NaN();
    }

    double squares() const {
        double squares = 0;
        for (const Tile& tile : tiles_) squares += tile.sum * tile.sum;
        return squares;
    }

  private:
    static int across(int pixels, int side) { return std::max(1, int(std::lround(double(pixels) / side))); }
    size_t index(int x, int y) const { return size_t(y) * size_t(nx_) + size_t(x); }

    int nx_, ny_;
    std::vector<Tile> tiles_;
    double sum_ = 0, count_ = 0;
};

}  // namespace

int tileSide(int width, int height) {
    constexpr double kTiles = 64;
    return std::clamp(int(std::sqrt(double(width) * height / kTiles)), 8, 32);
}

Estimate meanOverTiles(const Plane& values, int side) {
    const Tiles tiles(values, side);
    if (tiles.count() == 0) return {};
    return {tiles.sum() / tiles.count(), std::sqrt(tiles.variance()) / tiles.count()};
}

double standardErrorOfZero(const Plane& values, int side) {
    const Tiles tiles(values, side);
    return std::sqrt(tiles.squares()) / tiles.count();  // 0 / 0 is NaN
}

}  // namespace drc
