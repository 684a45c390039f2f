// Lamps and lobes under mirroring, ReverseOrientation and both: on shapes of their own, in instances and in motion. A
// mirrored sphere is a sphere.
#include <gtest/gtest.h>

#include "pictures.h"

namespace drc {
namespace {

struct Placing {
    const char *name, *text;
};
// Each is the identity or a mirroring of the unit sphere about its centre, which change nothing.
const Placing kMirrorings[] = {{"none", ""}, {"one axis", "Scale -1 1 1\n"}, {"three axes", "Scale -1 -1 -1\n"}};

std::string inWorld(const std::string& world) {
    return "Integrator \"path\" \"integer maxdepth\" 6\nLookAt 0 -4 1  0 0 0  0 0 1\n"
           "Camera \"perspective\" \"float fov\" 50\n"
           "Film \"image\" \"integer xresolution\" 16 \"integer yresolution\" 16\nWorldBegin\n" +
           world + "AttributeBegin\nMaterial \"matte\" \"rgb Kd\" [.5 .5 .5]\nTranslate 0 0 -1.5\n" +
           "Shape \"disk\" \"float radius\" 9\nAttributeEnd\nWorldEnd\n";
}

void expectSame(const std::string& expected, const std::string& seen, const std::string& integrator) {
    const auto estimateOf = [&](const std::string& text) {
        return test::estimateOfMeans(test::pictures(text, integrator, 6, 16));
    };
    const test::Estimate a = estimateOf(expected), b = estimateOf(seen);
    for (size_t c = 0; c < 3; ++c) {
        const double sigma = std::sqrt(a.variance[c] + b.variance[c]);
        EXPECT_NEAR(a.mean[c], b.mean[c], 5 * sigma + 1e-5);
        EXPECT_LT(sigma, 0.06 * a.mean[c] + 1e-5);
    }
}

constexpr const char* kIntegrators[] = {"path", "bdpt", "drc"};

TEST(Mirroring, LampsShineOutwards) {
    const auto lamp = [](const std::string& placing, const std::string& shape) {
        return inWorld("AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [1 2 3]\nScale .3 .3 .3\n" + placing +
                       shape + "AttributeEnd\n");
    };
    for (const char* shape : {"Shape \"sphere\"\n", "Shape \"cylinder\"\n"})
        for (const Placing& mirroring : kMirrorings)
            for (const char* integrator : kIntegrators) {
                SCOPED_TRACE(std::string(shape) + mirroring.name + integrator);
                expectSame(lamp("", shape), lamp(mirroring.text, shape), integrator);
            }
    // Inside out, a sphere lights nothing, mirrored or not.
    for (const Placing& mirroring : kMirrorings) {
        const auto seen = test::pictures(
            lamp(std::string("ReverseOrientation\n") + mirroring.text, "Shape \"sphere\"\n"), "path", 1, 4);
        for (const Rgb& block : seen[0]) EXPECT_EQ(block, Rgb(0.f)) << mirroring.name;
    }
}

TEST(Mirroring, GlassIsEnteredFromOutside) {
    const auto ball = [](const std::string& placing) {
        return inWorld("LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"glass\"\n" + placing);
    };
    const std::string plain = ball("AttributeBegin\nShape \"sphere\"\nAttributeEnd\n");
    for (const Placing& mirroring : kMirrorings) {
        const std::string mirrored = mirroring.text;
        const std::string variants[] = {
            "AttributeBegin\n" + mirrored + "Shape \"sphere\"\nAttributeEnd\n",
            "ObjectBegin \"o\"\n" + mirrored + "Shape \"sphere\"\nObjectEnd\nObjectInstance \"o\"\n",
            "ObjectBegin \"o\"\nShape \"sphere\"\nObjectEnd\nAttributeBegin\n" + mirrored +
                "ObjectInstance \"o\"\nAttributeEnd\n",
            // In motion, about its own axis.
            "AttributeBegin\n" + mirrored +
                "ActiveTransform EndTime Rotate 40 0 0 1 ActiveTransform All\nShape \"sphere\"\nAttributeEnd\n"};
        for (const std::string& variant : variants)
            for (const char* integrator : kIntegrators) {
                SCOPED_TRACE(std::string(integrator) + variant);
                expectSame(plain, ball(variant), integrator);
            }
    }
}

}  // namespace
}  // namespace drc
