#include "engine/physics/mechanisms/plunger.h"

namespace pinfield {

MoverState plunger_at_rest(const parts::Plunger& plunger, double scale) {
    MoverState s;
    s.q_min = -scale * plunger.stroke;
    s.q_max = 0;
    return s;
}

bool drive_plunger(const parts::Plunger& plunger, MoverState& s) {
    s.acceleration = 0;
    bool let_go = false;
    if (s.driven) {
        s.launch_rate = 0;
        s.rate = s.q > s.q_min ? s.q_min / plunger.pull_time : 0.0;
    } else if (s.q < s.q_max) {
        if (s.launch_rate == 0) {
            s.launch_rate = plunger.speed * (s.q / s.q_min);
            let_go = true;
        }
        s.rate = s.launch_rate;
    } else {
        s.rate = s.launch_rate = 0;
    }
    return let_go;
}

}  // namespace pinfield
