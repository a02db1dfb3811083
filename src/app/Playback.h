#pragma once

namespace walkcycle {

enum class LoopMode { Once, Loop, PingPong };

// Where a viewer stands in a clip: its own clock, which a person can stop, turn back and step.
class Playback {
public:
    LoopMode mode = LoopMode::Loop;
    double speed = 1.0;
    bool paused = false;

    // Starts a clip of this length; `seconds` into it.
    void start(double lengthInSeconds, double seconds = 0.0);

    // Lets time go by, unless it is paused.
    void advance(double seconds);

    // Moves by one step of 1/30 s, forwards or back, and pauses.
    void step(int direction);

    double time() const;  // within the clip, 0 to its length
    bool atEnd() const;   // playing once, and done

private:
    double length_ = 0.0;
    double clock_ = 0.0;  // keeps counting; ping-pong is two lengths there and back
};

}  // namespace walkcycle
