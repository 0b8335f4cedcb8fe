#include "engine/physics/event.h"

#include <array>

#include "engine/core/at.h"

namespace pinfield {

namespace {

struct Words {
    std::string_view name, meaning;
};

constexpr std::array<Words, event_kinds> words{{
    {"hit", "a ball begins to touch something, at this speed: however often it bounces, one touch is one hit"},
    {"kick", "a part kicks a ball, by this speed"},
    {"ball_hit", "two balls begin to touch, at this speed"},
    {"drain", "a drain takes a ball"},
    {"press", "an input of a part is pressed"},
    {"release", "an input of a part is let go"},
    {"end_stop", "a flipper or plunger meets its end-stop, its farthest point at this speed; once a stroke"},
    {"launch", "a plunger is let go: its rod has this speed"},
    {"quarantine", "a ball's numbers are not finite: it is taken out"},
    {"jam", "a ball is caught between a plunger and something that does not yield either"},
    {"held_back", "a ball cannot start yet: the node is in its place, or another ball"},
    {"leave", "a touch is over: its hardest approach had this speed"},
    {"flood", "one ball's hits and kicks in a tick were too many: the rest is not told; the node is the first left out"},
    {"stuck", "a ball hardly moved for three seconds, and no flipper or plunger that is played touches it"},
}};

}  // namespace

std::string_view name(EventKind kind) { return at(words, kind).name; }
std::string_view meaning(EventKind kind) { return at(words, kind).meaning; }

}  // namespace pinfield
