#include "engine/physics/mechanisms/flipper.h"

#include <algorithm>

#include "engine/core/trig.h"

namespace pinfield {

MoverState flipper_at_rest(const parts::Flipper& flipper, double scale) {
    MoverState s;
    s.q = radians(flipper.rest);
    const double raised = radians(flipper.rest + flipper.swing);
    s.q_min = raised < s.q ? raised : s.q;
    s.q_max = raised < s.q ? s.q : raised;
    const double rod = scale * (flipper.length + flipper.radius_tip);
    s.inverse_inertia = 3 / (flipper.mass * rod * rod);
    return s;
}

namespace {

/// Angular acceleration of the drive, its ramp `drive_time` seconds old.
double drive_of(const parts::Flipper& flipper, const MoverState& s, double drive_time) {
    const double upward = flipper.swing < 0 ? -1 : 1, full = radians(flipper.strength);
    if (!s.driven) return -upward * full * flipper.return_ratio;
    const double raised = upward > 0 ? s.q_max : s.q_min;
    double share = drive_time < flipper.ramp ? drive_time / flipper.ramp : 1.0;
    if (std::fabs(raised - s.q) <= radians(flipper.end_angle)) share *= flipper.end_torque;
    return upward * full * share;
}

}  // namespace

void drive_flipper(const parts::Flipper& flipper, MoverState& s, double step) {
    s.acceleration = drive_of(flipper, s, s.drive_time + 0.5 * step);
    if (s.driven) s.drive_time += step;
    const bool leans = s.rate == 0 && ((s.q == s.q_max && s.acceleration > 0) || (s.q == s.q_min && s.acceleration < 0));
    if (leans) s.acceleration = 0;
}

double flipper_leaning(const parts::Flipper& flipper, const MoverState& s) {
    const double drive = drive_of(flipper, s, s.drive_time);
    return s.q == s.q_max ? std::max(0.0, drive) : s.q == s.q_min ? std::max(0.0, -drive) : 0.0;
}

void flipper_hits_stop(const parts::Flipper& flipper, MoverState& s, double step) {
    const double speed = std::fabs(s.rate), e = flipper.stop_bounce;
    const double push = s.q >= s.q_max ? s.acceleration : -s.acceleration;  // > 0: the drive presses against the stop
    // All the rebounds of a train under constant acceleration take 2 e speed / (push (1 - e)).
    const bool settles = push > 0 ? 2 * e * speed <= push * (1 - e) * step : e == 0 || speed == 0;
    s.rate = settles ? 0.0 : -e * s.rate;
    if (settles && push > 0) s.acceleration = 0;
}

}  // namespace pinfield
