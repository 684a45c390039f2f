// A measured or simulated BSDF as a table over both zenith angles, each entry of which is a Fourier series in the
// difference of the azimuths (PBR 3e, section 8.6; Jakob et al., "A Comprehensive Framework for Rendering Layered
// Materials", 2014).
//
// Directions are named as in the files: `incident` is the cosine of the direction in which the light travels towards
// the surface, `outgoing` of the one in which it leaves, both to the normal. Light is reflected where their signs
// differ, and transmitted where they agree. The azimuth is that between the two, zero if the light goes straight on.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "math/catmull_rom.h"
#include "scene/lobes/lobe.h"

namespace drc {

// The series of f |incident| for every pair of cosines: sum over k of a_k cos(k azimuth).
struct FourierSeries {
    // From -1 to 1, ascending. 0 may be there twice, for the two sides of the surface.
    std::vector<float> cosines;
    // For each pair of cosines, [outgoing * cosines.size() + incident]: where the coefficients of its series begin, and
    // how many there are per channel. The channels follow each other.
    std::vector<uint32_t> offsets, orders;
    std::vector<float> coefficients;  // finite
    int channels = 1;                 // 1: luminance. 3: luminance, red, blue (the files' order)
    float eta = 1;                    // index of refraction below the surface, relative to that above
};

class FourierTable {
  public:
    explicit FourierTable(FourierSeries series);
    // Memory that a table of so many cosines needs beside its series.
    static double bytesBeside(double cosines) { return cosines * cosines * 3 * sizeof(float); }

    struct Value {
        Rgb fCosine{0.f};   // f times |incident|, without the scaling of radiance by refraction
        float density = 0;  // of sample(), per unit of incident cosine and azimuth
    };
    Value evaluate(float incident, float outgoing, float cosAzimuth) const;

    struct Direction {
        float incident, azimuth;
    };
    // Chooses a direction about in proportion to the luminance of f |incident|. None: no light leaves that way.
    std::optional<Direction> sample(float outgoing, float u0, const Vec2& u) const;

    // Share of the light that is scattered, without the scaling of radiance.
    Rgb albedo(float outgoing) const;
    float eta() const { return series_.eta; }
    bool reflects() const { return reflects_; }
    bool transmits() const { return transmits_; }
    // The least equivalentAlpha() of both sides.
    float alpha() const { return alpha_; }

  private:
    // Samples are not taken from the interpolated series itself, which may be negative, but from a mixture that cannot
    // be: of the four pairs of cosines around a place, with the weights of linear interpolation, each with its series
    // raised by a constant. The latter makes up for dips of the series below zero and spreads a little light to pairs
    // that splines reach and linear interpolation does not. So the density is known exactly, whatever a file contains.
    //
    // The weights of that interpolation, and of the rows' totals, for one outgoing cosine.
    struct Rows {
        SplineWeights at;
        float first, second;  // of the two rows: weight times total
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
    std::vector<float> raise_;       // of each pair's series, for sampling
    std::vector<float> cumulative_;  // of each pair: integral of the sampled means of its row up to its incident cosine
    std::vector<Rgb> albedo_;        // of each outgoing cosine
    bool reflects_ = false, transmits_ = false;
    float alpha_ = kDiffuseAlpha;
};

}  // namespace drc
