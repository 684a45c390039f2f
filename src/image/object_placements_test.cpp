#include "image/object_placements.h"

#include <gmock/gmock.h>

#include "base/folder_testing.h"

namespace drc {
namespace {

using testing::HasSubstr;

const Transform kPlace = Transform::translate(Vec3(1, 2, 3)) * Transform::rotate(30, Vec3(0, 1, 0));

TEST(ObjectPlacements, ComeBackFromTheirAttribute) {
    ObjectPlacements placements;
    placements.add(70000, kPlace * kPlace);
    placements.add(3, kPlace);
    placements.add(4, Transform());
    EXPECT_EQ(placements.size(), 2);  // the identity needs no memory
    const ObjectPlacements read = ObjectPlacements::in({{ObjectPlacements::kAttribute, placements.attribute()}});
    EXPECT_EQ(read.size(), 2);
    for (int i = 0; i < 12; ++i) EXPECT_FLOAT_EQ(read.of(3).at(i / 4, i % 4), kPlace.at(i / 4, i % 4));
    EXPECT_TRUE(read.of(4).isIdentity());
    EXPECT_TRUE(read.of(5).isIdentity());
    EXPECT_NEAR(read.of(70000).point(Vec3(0.f)).x, (kPlace * kPlace).point(Vec3(0.f)).x, 1e-6f);
    EXPECT_EQ(read.only({3, 4}).size(), 1);
    EXPECT_EQ(ObjectPlacements::in({}).size(), 0);
}

TEST(ObjectPlacements, AreMergedInOrder) {
    ObjectPlacements odd, even;
    odd.add(1, kPlace);
    odd.add(3, kPlace);
    even.add(2, kPlace * kPlace);
    const ObjectPlacements all = odd.with(even);
    EXPECT_EQ(all.size(), 3);
    EXPECT_EQ(all.of(2).point(Vec3(0.f)).x, even.of(2).point(Vec3(0.f)).x);
}

TEST(ObjectPlacements, RefuseADamagedAttribute) {
    ObjectPlacements placements;
    placements.add(3, kPlace);
    const ExrAttribute sound = placements.attribute();
    const auto complaint = [](const ExrAttribute& attribute) {
        return errorOf([&] { ObjectPlacements::in({{ObjectPlacements::kAttribute, attribute}}); });
    };
    EXPECT_EQ(complaint(sound), "");
    EXPECT_THAT(complaint({sound.type, sound.value.substr(4)}), HasSubstr("drc:objects is damaged"));
    EXPECT_THAT(complaint({sound.type, sound.value + sound.value}), HasSubstr("damaged"));  // an object twice
    EXPECT_THAT(complaint({"string", sound.value}), HasSubstr("damaged"));
    ExrAttribute infinite = sound;
    infinite.value.replace(8, 4, std::string("\0\0\x80\x7f", 4));
    EXPECT_THAT(complaint(infinite), HasSubstr("damaged"));
}

}  // namespace
}  // namespace drc
