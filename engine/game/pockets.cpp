#include "engine/game/pockets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "engine/core/at.h"
#include "engine/core/error_codes.h"
#include "engine/core/numbers.h"
#include "engine/physics/mechanisms/mechanism.h"
#include "engine/physics/start.h"
#include "engine/program/evaluate.h"
#include "engine/program/pose.h"
#include "engine/scene/parts/spawn.h"

namespace pinfield {
namespace {

constexpr double most_cells = 4e5;      // of the grid: on larger tables it is coarser
constexpr double longest_step = 0.1;    // of a ball that rolls downhill, in radii
constexpr double shortest_step = 0.002;
constexpr double level = 1e-3;          // slope of what counts as level
constexpr int most_steps = 20000;
constexpr int poses = 9;                // of a mover, between its end-stops
constexpr double played = 0.15;         // radii: what comes so near plays the ball

/// The table as a slow ball's centre sees it.
class Ground {
public:
    explicit Ground(const Program& program) : program_(program), r_(program.physics.ball_radius) {
        for (int m = 0; m < static_cast<int>(program.movers.size()); ++m) {
            const MoverState rest = mover_at_rest(program, m);
            for (int k = 0; k < poses; ++k)
                poses_.push_back({m, pose_of(at(program.movers, m), rest.q_min + (rest.q_max - rest.q_min) * k / (poses - 1))});
        }
    }

    double radius() const { return r_; }
    Nearest ask(const Vec2& p) const { return nearest(program_.fixed, p, ground_layer, 4 * r_); }
    bool is_free(const Vec2& p) const { return ask(p).distance >= r_; }
    bool is_drained(const Vec2& p) const {
        return std::any_of(program_.sensors.begin(), program_.sensors.end(), [&](const Sensor& s) { return drains(program_, s, p, ground_layer); });
    }
    /// Does a mover come to a ball that lies here?
    bool is_played(const Vec2& p) const {
        const double reach = (1 + played) * r_;
        return std::any_of(poses_.begin(), poses_.end(), [&](const PlacedMover& mover) {
            const Field& field = at(program_.movers, mover.index).field;
            return nearest(field, mover.pose.place_from_world(p), ground_layer, reach).distance < reach;
        });
    }
    /// Does what it lies on kick whatever touches it, however softly?
    bool is_kicked(const Vec2& p) const {
        const Nearest n = ask(p);
        if (n.solid < 0) return false;
        const int part = at(program_.fixed.solids, n.solid).part;
        return part >= 0 && kick_of(at(program_.parts, part), 0) > 0;
    }
    NodeId node_at(const Vec2& p) const {
        const Nearest n = ask(p);
        if (n.solid < 0) return {};
        const Solid& solid = at(program_.fixed.solids, n.solid);
        if (solid.part >= 0) return at(program_.parts, solid.part).origin;
        return n.leaf >= 0 ? at(program_.fixed.ops, n.leaf).origin : solid.origin;
    }

private:
    struct PlacedMover {
        int index = 0;
        Pose pose;
    };
    const Program& program_;
    double r_;
    std::vector<PlacedMover> poses_;
};

/// Out of what it overlaps by rounding or after a step along it.
Vec2 lifted(const Ground& ground, Vec2 p) {
    for (int k = 0; k < 8; ++k) {
        const Nearest n = ground.ask(p);
        const double size = length(n.gradient), missing = ground.radius() - n.distance;
        if (missing <= 0 || size == 0) break;
        p += (missing + 1e-9 * ground.radius()) / size * n.gradient;
    }
    return p;
}

/// Where a ball that starts here without speed comes to lie; nothing where it is drained, played or kicked, or does not end.
std::optional<Vec2> settled(const Ground& ground, Vec2 p) {
    const double r = ground.radius();
    double step = longest_step * r;
    for (int k = 0; k < most_steps; ++k) {
        if (ground.is_drained(p) || ground.is_played(p)) return {};
        const Vec2 below = p - Vec2(0, step);
        Vec2 next = below;
        if (!ground.is_free(below)) {
            const Nearest n = ground.ask(p);
            const double size = length(n.gradient);
            if (size == 0) return {};
            const Vec2 normal = n.gradient / size, along = Vec2(0, -1) + normal.y() * normal;
            const double slope = length(along);
            next = lifted(ground, slope < level ? p : Vec2(p + step / slope * along));
        }
        if (ground.is_free(next + Vec2(0, 1e-6 * r)) && next.y() < p.y() - 1e-3 * step) {
            p = next;
            step = std::min(1.5 * step, longest_step * r);
        } else if ((step *= 0.5) < shortest_step * r) {
            if (ground.is_kicked(p)) return {};
            return p;
        }
    }
    return {};
}

/// Does a ball that is pushed aside a little come back? Not from a ripple, nor from the top of something round.
bool holds(const Ground& ground, const Vec2& place) {
    const auto comes_back = [&](double side) {
        const Vec2 aside = lifted(ground, place + side * longest_step * ground.radius() * Vec2(1, 0));
        const std::optional<Vec2> back = settled(ground, aside);
        return back && length(*back - place) <= 0.5 * ground.radius();
    };
    return comes_back(-1) && comes_back(1);
}

/// A grid over the table, and which of its points a ball's centre can reach.
class Reach {
public:
    Reach(const Program& program, const Ground& ground)
        : step_(std::max(ground.radius() / 3, std::sqrt(program.size.x() * program.size.y() / most_cells))),
          nx_(static_cast<int>(program.size.x() / step_) + 1), ny_(static_cast<int>(program.size.y() / step_) + 1) {
        cells_.resize(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_));
        for (int y = 0; y < ny_; ++y)
            for (int x = 0; x < nx_; ++x)
                if (ground.is_free(point(x, y)) && !ground.is_drained(point(x, y))) cell(x, y) = free;
        fill(program);
    }

    /// Calls f with the reached points below which nothing is free.
    template <class F>
    void each_lowest(F&& f) const {
        for (int y = 0; y < ny_; ++y)
            for (int x = 0; x < nx_; ++x)
                if (cell(x, y) == reached && !is_free(x - 1, y - 1) && !is_free(x, y - 1) && !is_free(x + 1, y - 1)) f(point(x, y));
    }

private:
    enum Cell : unsigned char { solid, free, reached };

    Vec2 point(int x, int y) const { return {x * step_, y * step_}; }
    Cell& cell(int x, int y) { return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x)]; }
    Cell cell(int x, int y) const { return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x)]; }
    bool is_free(int x, int y) const { return x >= 0 && y >= 0 && x < nx_ && y < ny_ && cell(x, y) != solid; }

    void fill(const Program& program) {
        std::deque<std::pair<int, int>> front;
        const auto enter = [&](int x, int y) {
            if (!is_free(x, y) || cell(x, y) == reached) return;
            cell(x, y) = reached;
            front.emplace_back(x, y);
        };
        bool spawns = false;
        for (const Part& part : program.parts) {
            if (!part.is<parts::Spawn>() || (part.layers & ground_layer) == 0) continue;
            spawns = true;
            const Vec2 p = part.world_from_part.offset / step_;
            for (int dx = 0; dx < 2; ++dx)
                for (int dy = 0; dy < 2; ++dy) enter(static_cast<int>(std::floor(p.x())) + dx, static_cast<int>(std::floor(p.y())) + dy);
        }
        for (int y = 0; y < ny_ && !spawns; ++y)
            for (int x = 0; x < nx_; ++x) enter(x, y);
        for (; !front.empty(); front.pop_front()) {
            const auto [x, y] = front.front();
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy) enter(x + dx, y + dy);
        }
    }

    double step_ = 0;
    int nx_ = 0, ny_ = 0;
    std::vector<Cell> cells_;
};

Pocket pocket_at(const Ground& ground, const Vec2& place) {
    Pocket pocket{place, {}};
    for (const double aside : {0.0, -0.1, 0.1}) {
        const NodeId node = ground.node_at(place + aside * ground.radius() * Vec2(1, 0));
        if (node && std::find(pocket.nodes.begin(), pocket.nodes.end(), node) == pocket.nodes.end()) pocket.nodes.push_back(node);
    }
    return pocket;
}

/// Found twice, or places of one level floor.
bool is_same(const Pocket& a, const Pocket& b, double r) {
    const Vec2 apart = a.place - b.place;
    const bool shared = std::any_of(a.nodes.begin(), a.nodes.end(), [&](NodeId n) { return std::find(b.nodes.begin(), b.nodes.end(), n) != b.nodes.end(); });
    return length(apart) < 0.5 * r || (shared && std::fabs(apart.y()) < 0.01 * r);
}

}  // namespace

std::vector<Pocket> pockets_of(const Program& program) {
    std::vector<Pocket> pockets;
    if (program.physics.gravity.y() >= 0) return pockets;
    const Ground ground(program);
    Reach(program, ground).each_lowest([&](const Vec2& from) {
        const std::optional<Vec2> place = settled(ground, from);
        if (!place || !holds(ground, *place)) return;
        Pocket pocket = pocket_at(ground, *place);
        const auto same = [&](const Pocket& other) { return is_same(pocket, other, ground.radius()); };
        if (std::none_of(pockets.begin(), pockets.end(), same)) pockets.push_back(std::move(pocket));
    });
    return pockets;
}

Diagnostics pocket_warnings(const Program& program, const Scene& scene) {
    Diagnostics out;
    for (const Pocket& pocket : pockets_of(program)) {
        std::vector<std::string> names;
        for (const NodeId id : pocket.nodes)
            if (scene.find(id)) names.push_back(id == scene.table().id ? "the table's edge" : scene.path(id));
        const Node* node = pocket.nodes.empty() ? nullptr : scene.find(pocket.nodes.front());
        out.push_back(diagnose(Code::pocket, node ? node->key : Place{},
                               fmt::format("a slow ball comes to rest at [{}, {}], where nothing plays it: {} {}", to_text(pocket.place.x(), 3),
                                           to_text(pocket.place.y(), 3), names.size() > 1 ? "between" : "on", fmt::join(names, " and ")),
                               "tilt it, close it, or put a drain there"));
    }
    return out;
}

}  // namespace pinfield
