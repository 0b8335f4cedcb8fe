#include "engine/physics/mechanisms/flipper.h"

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

void drive_flipper(const parts::Flipper& flipper, MoverState& s, double step) {
    const double upward = flipper.swing < 0 ? -1 : 1, full = radians(flipper.strength);
    const double raised = upward > 0 ? s.q_max : s.q_min;
    if (s.driven) {
        const double middle = s.drive_time + 0.5 * step;
        double share = middle < flipper.ramp ? middle / flipper.ramp : 1.0;
        if (std::fabs(raised - s.q) <= radians(flipper.end_angle)) share *= flipper.end_torque;
        s.acceleration = upward * full * share;
        s.drive_time += step;
    } else {
        s.acceleration = -upward * full * flipper.return_ratio;
    }
    const bool leans = s.rate == 0 && ((s.q == s.q_max && s.acceleration > 0) || (s.q == s.q_min && s.acceleration < 0));
    if (leans) s.acceleration = 0;
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
