#include <gtest/gtest.h>

#include "animation/CurvedTransform.h"
#include "animation/Interpolation.h"

namespace walkcycle {
namespace {

template <typename Number>
class InterpolationTest : public testing::Test {
protected:
    static constexpr Number kRounding = sizeof(Number) == sizeof(float) ? Number(5e-7) : Number(2e-14);

    using Quaternion = glm::qua<Number>;
    static Quaternion rotatedBy(Number radians) {
        return glm::angleAxis(radians, glm::vec<3, Number>(Number(0.6), Number(0), Number(0.8)));
    }
    static void expectSame(const Quaternion& a, const Quaternion& b, Number radians) {
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], kRounding) << radians << " rad, number " << i;
    }
};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(InterpolationTest, Numbers);

// From hardly any to nearly half a circle, and on both sides of the angle where the series ends.
TYPED_TEST(InterpolationTest, slerpRotatesAtConstantSpeed) {
    for (const double radians : {0.0, 1e-7, 1e-3, 0.1, 0.39, 0.4, 0.41, 1.0, 2.0, 3.0, 3.14}) {
        const auto angle = static_cast<TypeParam>(radians);
        const Slerp way(this->rotatedBy(0), this->rotatedBy(angle));
        for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
            const auto progression = static_cast<TypeParam>(share);
            this->expectSame(way.at(progression), this->rotatedBy(angle * progression), angle);
        }
    }
}

TYPED_TEST(InterpolationTest, slerpTakesTheShortWayRound) {
    const Slerp way(this->rotatedBy(0), -this->rotatedBy(TypeParam(0.7)));
    this->expectSame(way.at(TypeParam(0.5)), this->rotatedBy(TypeParam(0.35)), TypeParam(0.7));
}

TYPED_TEST(InterpolationTest, slerpOfOppositeRotationsKeepsItsLength) {
    const Slerp way(this->rotatedBy(0), this->rotatedBy(TypeParam(3.14159265358979)));
    EXPECT_NEAR(glm::length(way.at(TypeParam(0.5))), 1.0, this->kRounding);
}

TYPED_TEST(InterpolationTest, hermiteGoesThroughItsEndsWithTheTangentsGiven) {
    const TypeParam a(2), leaving(3), b(-1), arriving(4), h(TypeParam(1e-3));
    const auto at = [&](TypeParam s) { return Hermite<TypeParam>(s).value(a, leaving, b, arriving); };
    EXPECT_EQ(at(0), a);
    EXPECT_EQ(at(1), b);
    EXPECT_NEAR((at(h) - at(0)) / h, leaving, 0.05);
    EXPECT_NEAR((at(1) - at(1 - h)) / h, arriving, 0.05);
}

// s³ is the cubic from 0 to 1 with the tangents 0 and 3; over two seconds its tangents are half as steep.
TYPED_TEST(InterpolationTest, hermiteHoldsEveryCubicExactly) {
    for (const TypeParam s : {TypeParam(0.25), TypeParam(0.5), TypeParam(0.75)}) {
        const Hermite<TypeParam> perWay(s), perSecond(s, TypeParam(2));
        EXPECT_NEAR(perWay.value(TypeParam(0), TypeParam(0), TypeParam(1), TypeParam(3)), s * s * s,
                    this->kRounding);
        EXPECT_NEAR(perSecond.value(TypeParam(0), TypeParam(0), TypeParam(1), TypeParam(1.5)), s * s * s,
                    this->kRounding);
    }
}

TYPED_TEST(InterpolationTest, thePowersOfHermiteAreTheSameCurve) {
    const TypeParam a(2), leaving(3), b(-1), arriving(4);
    const auto powers = hermitePowers(a, leaving, b, arriving);
    for (const double share : {0.0, 0.1, 0.5, 0.8, 1.0}) {
        const auto s = static_cast<TypeParam>(share);
        EXPECT_NEAR(powers[0] + s * (powers[1] + s * (powers[2] + s * powers[3])),
                    Hermite<TypeParam>(s).value(a, leaving, b, arriving), 8 * this->kRounding)
            << share;
    }
}

TYPED_TEST(InterpolationTest, aCurvedTransformKeepsItsRotationOfUnitLength) {
    BasicJointTransform<TypeParam> a, b;
    a.position = {TypeParam(1), TypeParam(0), TypeParam(0)};
    b.position = {TypeParam(3), TypeParam(0), TypeParam(0)};
    b.rotation = this->rotatedBy(2);
    const auto half = curvedTransform(a, {}, b, {}, Hermite<TypeParam>(TypeParam(0.5)));

    EXPECT_EQ(half.position.x, TypeParam(2));
    EXPECT_EQ(half.scale.y, TypeParam(1));
    this->expectSame(half.rotation, this->rotatedBy(1), 2);
}

}  // namespace
}  // namespace walkcycle
