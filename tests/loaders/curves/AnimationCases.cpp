#include <string>
#include <vector>

#include "loaders/AnimationText.h"
#include "loaders/CodeCases.h"

namespace walkcycle {
namespace {

const std::string kAnimation = "COLLADA/library_animations/animation[id=anim]/";
const std::string kSampler = kAnimation + "sampler[id=anim-sampler]";
const std::string kChannel = kAnimation + "channel";

// A node that moves sideways from second 0 to second 1.
const AnimationText kSlide{.target = "box/t.X", .times = "0 1", .values = "0 1"};

std::string boxMovedBy(const std::string& animation) {
    return boxWith("<translate sid='t'>0 0 0</translate>", animations(animation));
}

std::string boxMovedBy(const AnimationText& animation) {
    return boxMovedBy(animation.text());
}

// Sampler and channel each on a line of their own.
std::string onOwnLines(const AnimationText& animation) {
    return "<animation id='anim'>" + animation.sources() + "\n" + animation.sampler() + "\n" +
           animation.channel() + "\n</animation>";
}

std::string samplerDamaged(const AnimationText& animation) {
    return damagedAt(boxMovedBy(onOwnLines(animation)), "<sampler");
}

std::string channelDamaged(AnimationText animation, const std::string& target) {
    animation.target = target;
    return damagedAt(boxMovedBy(onOwnLines(animation)), "<channel");
}

AnimationText changed(void (*change)(AnimationText&)) {
    AnimationText animation = kSlide;
    change(animation);
    return animation;
}

// A joint that rotates a thousand times between two keys, with the few key frames that the limits leave.
CodeCase fastTurn() {
    const AnimationText spin{.target = "box/r.ANGLE", .times = "0 1", .values = "0 36000000"};
    CodeCase fast{Code::ToleranceMissed,
                  damagedAt(boxWith("<rotate sid='r'>0 0 1 0</rotate>", "\n" + animations(onOwnLines(spin))),
                            "<library_animations>"),
                  "COLLADA/library_animations"};
    return fast;
}

}  // namespace

std::vector<CodeCase> animationCases() {
    const std::string times = kAnimation + "source[id=anim-in]/float_array[id=anim-in-array]";
    const std::string words = kAnimation + "source[id=anim-how]/Name_array[id=anim-how-array]";
    const std::string clip =
        "<library_animation_clips>\n@<animation_clip id='run' start='2' end='1'><instance_animation "
        "url='#anim'/>"
        "</animation_clip></library_animation_clips>\n";
    std::string noOutput = samplerDamaged(kSlide);
    noOutput.replace(noOutput.find("semantic='OUTPUT'"), 17, "semantic='CONTINUITY'");
    std::string noWords = samplerDamaged(kSlide);
    noWords.replace(noWords.find("semantic='INTERPOLATION'"), 24, "semantic='CONTINUITY'");
    return {
        {Code::SamplerIncomplete, noOutput, kSampler},
        {Code::SamplerKeyMismatch, samplerDamaged(changed([](AnimationText& a) { a.values = "0 1 2"; })),
         kSampler},
        {Code::KeyTimesInvalid, boxMovedBy(changed([](AnimationText& a) { a.times = "1\n@0"; })), times},
        {Code::InterpolationUnknown,
         boxMovedBy(changed([](AnimationText& a) { a.interpolations = "LINEAR\n@CURVY"; })), words},
        {Code::InterpolationMissing, noWords, kSampler},
        {Code::TangentsMissing,
         samplerDamaged(changed([](AnimationText& a) { a.interpolations = "BEZIER"; })), kSampler},
        {Code::TargetNotFound, channelDamaged(kSlide, "box/gone.X"), kChannel},
        {Code::TargetNotMoved, channelDamaged(kSlide, "scene"), kChannel},
        {Code::TargetMemberUnknown, channelDamaged(kSlide, "box/t.ANGLE"), kChannel},
        {Code::TargetWidthMismatch,
         channelDamaged(changed([](AnimationText& a) { a.params = "XY", a.values = "0 0 1 1"; }), "box/t"),
         kChannel},
        {Code::ChannelDuplicateTarget,
         boxMovedBy("<animation id='anim'>" + kSlide.sources() + kSlide.sampler() + kSlide.channel() + "\n@" +
                    kSlide.channel() + "</animation>"),
         kChannel},
        {Code::ClipIncomplete,
         boxWith("<translate sid='t'>0 0 0</translate>", animations(kSlide.text()) + clip),
         "COLLADA/library_animation_clips/animation_clip[id=run]"},
        fastTurn(),
    };
}

}  // namespace walkcycle
