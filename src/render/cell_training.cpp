#include "render/cell_training.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "cells/cell_size.h"

namespace drc {
namespace {

using Clock = Schedule::Clock;

// The longer side of the films, pixels.
constexpr int kSide = 320;
// Training ends when a round over all cameras leaves more than this share of the error, after so many rounds at least.
// Independent deposits would leave 0.89 of it in the fourth round and 0.97 in the sixteenth.
constexpr double kHardlyFalls = 0.97;
constexpr int kLeastRounds = 4, kMostRounds = 64;

FilmGeometry smallFilm(FilmGeometry film) {
    const int longer = std::max(film.width, film.height);
    if (longer <= kSide) return film;
    film.width = std::max(1, film.width * kSide / longer);
    film.height = std::max(1, film.height * kSide / longer);
    return film;
}

float medianDistance(Session& session, const std::vector<Sensor>& sensors) {
    std::vector<float> distances;
    for (const Sensor& sensor : sensors) {
        session.setCamera(sensor.camera, sensor.settings.film);
        if (session.distance() > 0) distances.push_back(session.distance());
    }
    if (distances.empty()) throw Error("the cameras see no surface that radiance cells could be of");
    const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

}  // namespace

CellCollection trainCells(const Scene& scene, const std::vector<Sensor>& given, RenderParams params,
                          const CellTraining& training) {
    const auto start = Clock::now();
    std::vector<Sensor> sensors = given;
    for (Sensor& sensor : sensors) {
        const FilmGeometry film = smallFilm(sensor.settings.film);
        sensor.camera = sensor.camera->withFilm(film);
        sensor.settings.film = film;
        // All that a camera sees is trained.
        sensor.settings.pixelBounds.reset();
        std::copy_n(std::begin({0.f, 1.f, 0.f, 1.f}), 4, sensor.settings.cropWindow);
    }
    params.cells = params.trainCells = true;
    params.freezeCells = params.gBuffer = params.parts = params.variance = params.independentHalves = false;
    params.denoise = Denoise::Off;
    params.seconds = 0;
    params.spp = 1;
    // Parts, and rounds within them, have samples of their own.
    const int most = training.spp.value_or(training.seconds > 0 ? std::numeric_limits<int>::max() : kMostRounds);
    constexpr int kSamplesOfPart = 1 << 20;
    // Samples of a focus have indices from 2^31 on.
    static_assert(int64_t(CellTraining::kMostParts) * kSamplesOfPart < int64_t(1) << 31);
    const int first = training.part * kSamplesOfPart;
    params.firstSample = first;
    Session session(scene, sensors[0], params);
    if (params.cellSize == 0) session.setCellSize(cellSizeFor(medianDistance(session, sensors)));
    session.setCamera(sensors[0].camera, sensors[0].settings.film);

    const auto share = [&](int round, size_t visited) {
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        const double bySamples = (round + double(visited) / double(sensors.size())) / most;
        return std::min(1.0, training.seconds > 0 ? std::max(bySamples, seconds / training.seconds) : bySamples);
    };
    double before = 1;
    for (int round = 0; round < std::min(most, kSamplesOfPart); ++round) {
        for (size_t i = 0; i < sensors.size(); ++i) {
            session.setFirstSample(first + round);
            session.moveCamera(sensors[i].camera, sensors[i].settings.film);
            while (session.step(training.cancel)) {
            }
            if (training.visited) training.visited(share(round, i + 1), session.cells()->error());
            const bool isOver = share(round, i + 1) >= 1 && training.seconds > 0;
            if (isOver || (training.cancel && training.cancel->cancelled()))
                return session.cells()->collect(scene.origin);
        }
        const double error = session.cells()->error();
        if (!training.spp && training.seconds == 0 && round + 1 >= kLeastRounds && error > kHardlyFalls * before) break;
        before = error;
    }
    return session.cells()->collect(scene.origin);
}

}  // namespace drc
