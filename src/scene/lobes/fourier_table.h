// A measured or simulated BSDF as a table over both zenith angles, each entry of which is a Fourier series in the
// difference of the azimuths (PBR 3e, section 8.6; Jakob et al., "A Comprehensive Framework for Rendering Layered
// Materials", 2014).
//
// Directions are named as in the files: `incident` is the cosine (to the normal) of the direction in which light
// travels towards the surface, `outgoing` that of the direction in which it leaves. Light is reflected where their
// signs differ, and transmitted where they agree. `azimuth` is the difference of the azimuths of both directions, zero
// if the light goes straight on.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "math/catmull_rom.h"
#include "scene/lobes/lobe.h"

namespace drc {

// The series of f |incident| for every pair of cosines: sum over k of a_k cos(k azimuth).
struct FourierSeries {
    // From -1 to 1, ascending. 0 may occur twice, once for each side of the surface.
    std::vector<float> cosines;
    // For each pair of cosines, at [outgoing * cosines.size() + incident]: the position of its series in
    // `coefficients`, and the number of coefficients per channel. The coefficients of all channels are stored one
    // channel after the other.
    std::vector<uint32_t> offsets, orders;
    std::vector<float> coefficients;  // finite
    int channels = 1;                 // 1: luminance. 3: luminance, red, blue (the files' order)
    float eta = 1;                    // index of refraction below the surface, relative to that above
};

class FourierTable {
  public:
    explicit FourierTable(FourierSeries series);
    // Memory, in bytes, that a table of this many cosines needs in addition to its series.
    static double bytesBeside(double cosines) { return cosines * cosines * 3 * sizeof(float); }

    struct Value {
        Rgb fCosine{0.f};   // f times |incident|, without the scaling of radiance by refraction
        float density = 0;  // pdf of sample(), per unit of incident cosine and azimuth
    };
    Value evaluate(float incident, float outgoing, float cosAzimuth) const;

    struct Direction {
        float incident, azimuth;
    };
    // Samples a direction roughly in proportion to the luminance of f |incident|. None if no light leaves in direction
    // `outgoing`.
    std::optional<Direction> sample(float outgoing, float u0, const Vec2& u) const;

    // Directional albedo, without the scaling of radiance by refraction.
    Rgb albedo(float outgoing) const;
    float eta() const { return series_.eta; }
    bool reflects() const { return reflects_; }
    bool transmits() const { return transmits_; }
    // The smallest equivalentAlpha() over reflection, transmission and outgoing cosines, grazing ones excepted.
    float alpha() const { return alpha_; }

  private:
    // sample() draws from a density that cannot be negative, unlike the interpolated series: the bilinear interpolation
    // of the series at the four pairs of cosines around a place, after each has been raised by a constant. The constant
    // makes up for dips of the series below zero, and gives a little density to pairs that splines reach and linear
    // interpolation does not. The density is therefore known exactly, whatever a file contains.
    //
    // Rows: the two outgoing nodes around one outgoing cosine, between which sample() chooses.
    struct Rows {
        SplineWeights at;
        float first, second;  // unnormalised probability of each row: linear weight times total()
    };
    Rows rowsAt(float outgoing) const;
    float total(int outgoing) const { return 2 * kPi * cumulative_[pair(outgoing, nodes_.size() - 1)]; }

    size_t pair(int outgoing, int incident) const {
        return size_t(outgoing) * size_t(nodes_.size()) + size_t(incident);
    }
    const float* series(size_t pair) const { return &series_.coefficients[series_.offsets[pair]]; }
    float mean(size_t pair) const { return series_.orders[pair] > 0 ? *series(pair) : 0; }
    float sampledMean(size_t pair) const { return mean(pair) + raise_[pair]; }
    float sampleIncident(int outgoing, float u, int& segment, float& t) const;
    float sampleAzimuth(size_t pair, float u) const;
    // -1 or 1: the side of the surface that a node belongs to; 0: both.
    int sideOf(int node) const;
    bool isPossible(int incidentSide, int outgoingSide) const {
        const int product = incidentSide * outgoingSide;
        return product == 0 || (product < 0 ? reflects_ : transmits_);
    }
    void findSides();
    void integrateAlbedo();
    struct Extremes;
    std::vector<Extremes> findExtremes() const;
    void findAlpha(const std::vector<Extremes>& extremes);
    void raise(const std::vector<Extremes>& extremes);
    void accumulate();

    FourierSeries series_;
    SplineNodes nodes_;
    std::vector<float> raise_;       // [pair]: constant by which its series is raised for sampling
    std::vector<float> cumulative_;  // [pair]: integral of sampledMean() over its row, up to its incident cosine
    std::vector<Rgb> albedo_;        // per outgoing cosine
    bool reflects_ = false, transmits_ = false;
    float alpha_ = kDiffuseAlpha;
};

}  // namespace drc
