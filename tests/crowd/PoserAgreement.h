#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "crowd/PlainPoser.h"
#include "walkcycle/crowd/CrowdPoser.h"

namespace walkcycle {

// The largest difference of any two numbers of two palettes.
inline double difference(const std::vector<JointRows>& a, const std::vector<JointRows>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int n = 0; n < 12; ++n) {
            const double apart = std::abs(a[i].rows[n / 4][n % 4] - b[i].rows[n / 4][n % 4]);
            if (!(apart <= largest)) largest = apart;
        }
    return largest;
}

// The largest number of any bind matrix: a palette entry is the difference of numbers of that size.
inline double sizeOf(const Skin& skin) {
    double size = 1.0;
    for (const glm::mat4& bind : skin.bindMatrices)
        for (int n = 0; n < 16; ++n) size = std::max<double>(size, std::abs(bind[n / 4][n % 4]));
    return size;
}

// Holds the two against each other at a thousand moments of the clip, before it and after it, and at every key.
inline void expectFastAgreesWithPlain(const Skeleton& skeleton, const Animation& clip, const Skin& skin) {
    PlainPoser plain(skeleton, clip, skin);
    CrowdPoser fast(skeleton, clip, skin, 1);
    ASSERT_EQ(fast.paletteSize(), plain.paletteSize());
    EXPECT_EQ(fast.lengthInSeconds(), plain.lengthInSeconds());
    std::vector<double> times;
    for (int i = -200; i < 1200; ++i) times.push_back(clip.lengthInSeconds() * i / 1000.0);
    for (const Channel& channel : clip.channels) {
        for (const KeyFrame& key : channel.keyFrames) times.push_back(key.seconds - clip.startSeconds);
        for (const MatrixKeyFrame& key : channel.matrixKeyFrames)
            times.push_back(key.seconds - clip.startSeconds);
    }
    std::vector<JointRows> ofPlain(plain.paletteSize()), ofFast(fast.paletteSize());
    double largest = 0.0, at = 0.0;
    for (const double seconds : times) {
        plain.pose(seconds, ofPlain);
        fast.poseOne(seconds, ofFast);
        const double found = difference(ofFast, ofPlain);
        if (!(found <= largest)) largest = found, at = seconds;
    }
    EXPECT_LE(largest, 1e-6 * sizeOf(skin)) << "at " << at << " s";
}

}  // namespace walkcycle
