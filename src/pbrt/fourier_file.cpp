#include "pbrt/fourier_file.h"

#include <fmt/core.h>

#include <bit>
#include <cstring>

#include "base/error.h"
#include "base/memory.h"
#include "pbrt/mapped_file.h"

namespace drc::pbrt {
namespace {

static_assert(std::endian::native == std::endian::little, "the file is little-endian");

constexpr std::string_view kMagic("SCATFUN\x01", 8);

// The header of 56 bytes after the magic word.
struct Header {
    int32_t flags, cosines, coefficients, mostOrders, channels, bases;
    int32_t metadata, parameters, parameterValues;
    float eta;
    float alpha[2], unused[2];
};
static_assert(sizeof(Header) == 56);

class FourierFile {
  public:
    explicit FourierFile(const std::string& path) : path_(path), file_(path, "BSDF file", limits::kBsdfBytes) {}

    FourierSeries read() {
        if (size() < kMagic.size() || file_.text().substr(0, kMagic.size()) != kMagic)
            bad("is of another kind: it does not begin with 'SCATFUN' and the version 1");
        at_ = kMagic.size();
        if (size() < at_ + sizeof(Header))
            bad(fmt::format("is cut short: its header takes {} bytes, and it has {}", at_ + sizeof(Header), size()));
        Header h;
        take(&h, 1);
        check(h);

        const uint64_t n = uint64_t(h.cosines), pairs = n * n;
        // In the file's order: cosines; a cumulative table, which is skipped because FourierTable computes its own;
        // offset and number of orders for each pair; coefficients.
        const uint64_t needed = at_ + 4 * (n + pairs + 2 * pairs + uint64_t(h.coefficients));
        if (size() < needed) bad(fmt::format("is cut short: its tables end at byte {}, and it has {}", needed, size()));
        const double bytes = double(size()) + FourierTable::bytesBeside(double(n));
        const MemoryClaim claim(bytes, "the BSDF file '" + path_ + "'");

        FourierSeries s;
        s.channels = h.channels;
        s.eta = h.eta;
        s.cosines.resize(n);
        take(s.cosines.data(), n);
        checkCosines(s.cosines);
        at_ += 4 * pairs;
        readPairs(h, s);
        s.coefficients.resize(size_t(h.coefficients));
        take(s.coefficients.data(), s.coefficients.size());
        for (size_t i = 0; i < s.coefficients.size(); ++i)
            if (!std::isfinite(s.coefficients[i]))
                bad(fmt::format("has a coefficient (number {}) that is not finite", i));
        return s;
    }

  private:
    [[noreturn]] void bad(const std::string& what) const { throw Error({path_, 0, 0}, "the BSDF file " + what); }
    uint64_t size() const { return file_.text().size(); }
    template <typename T>
    void take(T* to, size_t count) {
        std::memcpy(to, file_.text().data() + at_, count * sizeof(T));
        at_ += count * sizeof(T);
    }

    void check(const Header& h) const {
        if (h.flags != 1) bad(fmt::format("has the flags {}; only 1, a table of f |cos|, is supported", h.flags));
        if (h.bases != 1) bad(fmt::format("has {} basis functions; only 1 is supported", h.bases));
        if (h.channels != 1 && h.channels != 3) bad(fmt::format("has {} channels, not 1 or 3", h.channels));
        if (h.cosines < 2) bad(fmt::format("has {} zenith cosines; it needs at least 2", h.cosines));
        if (h.coefficients < 0) bad(fmt::format("has {} coefficients", h.coefficients));
        if (h.mostOrders < 0) bad(fmt::format("has series of up to {} orders", h.mostOrders));
        if (!(std::isfinite(h.eta) && h.eta > 0))
            bad(fmt::format("has the index of refraction {:g}, which must be positive", h.eta));
    }

    // Checks the zenith cosines, and sets the first and the last to exactly -1 and 1.
    void checkCosines(std::vector<float>& cosines) const {
        constexpr float kTolerance = 1e-3f;
        for (size_t i = 0; i < cosines.size(); ++i) {
            if (!std::isfinite(cosines[i])) bad(fmt::format("has a zenith cosine (number {}) that is not finite", i));
            if (i == 0) continue;
            // Zero may appear twice, if the two sides of the surface differ.
            const bool doubled = cosines[i] == 0 && cosines[i - 1] == 0 && !(i > 1 && cosines[i - 2] == 0);
            if (!(cosines[i] > cosines[i - 1]) && !doubled)
                bad(fmt::format("has zenith cosines that do not ascend: {:g} (number {}) after {:g}", cosines[i], i,
                                cosines[i - 1]));
        }
        if (!(std::abs(cosines.front() + 1) < kTolerance && std::abs(cosines.back() - 1) < kTolerance))
            bad(fmt::format("has zenith cosines from {:g} to {:g}; they must run from -1 to 1", cosines.front(),
                            cosines.back()));
        cosines.front() = -1;
        cosines.back() = 1;
    }

    void readPairs(const Header& h, FourierSeries& s) {
        const size_t pairs = s.cosines.size() * s.cosines.size();
        s.offsets.reserve(pairs);
        s.orders.reserve(pairs);
        uint64_t sum = 0;
        for (size_t i = 0; i < pairs; ++i) {
            int32_t place[2];  // offset, orders
            take(place, 2);
            if (place[1] < 0 || place[1] > h.mostOrders)
                bad(fmt::format("has a series (number {}) of {} orders; its header says at most {}", i, place[1],
                                h.mostOrders));
            const uint64_t length = uint64_t(place[1]) * uint64_t(h.channels);
            if (place[1] > 0 && (place[0] < 0 || uint64_t(place[0]) + length > uint64_t(h.coefficients)))
                bad(fmt::format("has a series (number {}) that lies outside of its {} coefficients", i,
                                h.coefficients));
            s.offsets.push_back(place[1] > 0 ? uint32_t(place[0]) : 0);
            s.orders.push_back(uint32_t(place[1]));
            sum += length;
        }
        // Series may share coefficients. The limit keeps a small file from causing long computations.
        constexpr uint64_t kMostShared = 16;
        if (sum > kMostShared * uint64_t(h.coefficients))
            bad(fmt::format("has series of {} terms in all, which is too many for {} coefficients", sum,
                            h.coefficients));
    }

    std::string path_;
    MappedFile file_;
    uint64_t at_ = 0;
};

}  // namespace

FourierSeries readFourierFile(const std::string& path) { return FourierFile(path).read(); }

}  // namespace drc::pbrt
